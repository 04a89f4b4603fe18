#ifndef LVSM_GALLERY_LIGHT_HPP
#define LVSM_GALLERY_LIGHT_HPP

#include <string>
#include <vector>

#include "scenes.hpp"

namespace lvsm::gallery
{

/// The uniform block of shaders/light.glsl.
struct LightBlock
{
    glm::mat4 viewProjection;
    glm::mat4 inverseViewProjection;
    /// xyz: of a spot light, or any point of a directional light's plane; w: 1 for a spot light.
    glm::vec4 position;
    glm::vec4 direction;
    /// Distances where depth is 0 and 1, and cosines where the spot's edge is dark and where it is bright.
    glm::vec4 range;
};

struct Light
{
    std::string id;
    std::string title;
    LightBlock block;

    bool isSpot() const { return block.position.w > 0.0f; }
    glm::vec3 towards(glm::vec3 point) const;
    float metresPerDepth() const { return block.range.y - block.range.x; }
};

/// A spot and a directional light, fitted to the scene's focus.
std::vector<Light> makeLights(const Scene& scene);

} // namespace lvsm::gallery

#endif
