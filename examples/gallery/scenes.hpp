#ifndef LVSM_GALLERY_SCENES_HPP
#define LVSM_GALLERY_SCENES_HPP

#include <optional>
#include <string>
#include <vector>

#include "mesh.hpp"

namespace lvsm::gallery
{

struct Camera
{
    glm::vec3 eye;
    glm::vec3 target;
    float fieldOfView;
};

/// Something solid between the light and the ground. All the ground in its full shadow should be dark, so any
/// visibility that a technique reports there is light bleeding.
struct Shield
{
    std::string name;
    Box box;
};

enum class LightKind
{
    Spot,
    Directional,
    /// Shines all around.
    Lamp
};

struct Scene
{
    std::string id;
    std::string title;
    std::string description;
    Mesh mesh;
    Camera camera;
    /// What the lights must cover.
    Box focus;
    /// The way the directional light travels, unit length; the spot light comes from the same side.
    glm::vec3 lightDirection;
    std::optional<Shield> shield;
    /// What it is shown under, and what more with --full.
    std::vector<LightKind> lights;
    std::vector<LightKind> furtherLights;
    /// Where the lamp hangs.
    glm::vec3 lamp{0.0f};
    /// Where a person would part three of four layers.
    std::vector<glm::vec3> cuts;
    /// Whether the directional light is also shown as it moves.
    bool isTurned = false;
};

constexpr float kGroundHalfWidth = 40.0f;
constexpr glm::vec3 kGroundColour{0.62f, 0.60f, 0.56f};

// Each in a file of its own, in the folder scenes.

/// The paper's figure 2: plane A over plane B over the ground C.
Scene makePlanes();

/// The paper's figure 3: a tree, grown from a seed, over a bench over the ground.
Scene makeBench(unsigned treeSeed);

/// Blocks over blocks, some very far above.
Scene makeBlocks();

/// More than 300,000 triangles.
Scene makeYard();

/// Leaves of an alpha test.
Scene makeFoliage();

/// A long ramp under a low light.
Scene makeSlope();

/// The user's model on the ground.
Scene makeUserModel(const Mesh& model, const std::string& name);

} // namespace lvsm::gallery

#endif
