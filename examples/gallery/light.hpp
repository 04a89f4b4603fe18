#ifndef LVSM_GALLERY_LIGHT_HPP
#define LVSM_GALLERY_LIGHT_HPP

#include <array>
#include <string>
#include <vector>

#include <lvsm/passes_depth.hpp>

#include "scenes.hpp"

namespace lvsm::gallery
{

constexpr int kCubeFaces = 6;

/// How a light sees one map or one face of a cube, as shaders/light.glsl has it.
struct Face
{
    glm::mat4 viewProjection;
    /// The far plane at texture coordinates (u, v) is corner + u across + v down.
    glm::vec4 corner;
    glm::vec4 across;
    glm::vec4 down;
};

/// The uniform block of shaders/light.glsl.
struct LightBlock
{
    /// Of a light that has one in xyz, with w = 1, or any point of a directional light's plane.
    glm::vec4 position;
    glm::vec4 direction;
    /// Distances where depth is 0 and 1, and cosines where the spot's edge is dark and where it is bright.
    glm::vec4 range;
    /// How many faces, the tangent of half a cube face's angle, and the distance of the far plane.
    glm::vec4 shape;
    std::array<Face, kCubeFaces> faces;
};

struct Light
{
    std::string id;
    std::string title;
    LightBlock block;
    int mapSize;
    /// What the depth buffers of its faces hold.
    DepthBlock depths;

    bool isSpot() const { return block.position.w > 0.0f; }
    int faceCount() const { return static_cast<int>(block.shape.x); }
    glm::vec3 towards(glm::vec3 point) const;
    float metresPerDepth() const { return block.range.y - block.range.x; }
    /// Depth of a point in the light's metric, not clamped.
    float depthOf(glm::vec3 point) const;
};

/// The lights that the scene names, and with `all` the further ones, fitted to its focus. mapSize: texels along a side
/// of their maps; a cube's faces have half of it.
std::vector<Light> makeLights(const Scene& scene, int mapSize, bool all);

/// The scene's directional light, its direction turned about the vertical by an angle in radians.
Light makeTurnedLight(const Scene& scene, int mapSize, float angle);

} // namespace lvsm::gallery

#endif
