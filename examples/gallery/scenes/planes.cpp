#include "../scenes.hpp"

namespace lvsm::gallery
{

Scene makePlanes()
{
    const Box planeA{{-2.2f, 2.6f, -1.6f}, {-0.1f, 2.64f, 0.6f}};
    const Box planeB{{-1.0f, 0.55f, -0.7f}, {1.0f, 0.59f, 0.7f}};
    Scene scene;
    scene.id = "planes";
    scene.title = "Three planes";
    scene.description =
        "The situation of the paper's figure 2. The edge of plane A, at the top left, casts a soft shadow on plane B; "
        "plane B hides the ground C entirely, so that no trace of A's edge may show inside B's shadow.";
    addGround(scene.mesh, kGroundHalfWidth, kGroundColour);
    addBox(scene.mesh, planeA, {0.30f, 0.45f, 0.62f});
    addBox(scene.mesh, planeB, {0.75f, 0.55f, 0.35f});
    scene.camera = {{2.5f, 3.7f, 6.0f}, {-0.25f, 1.15f, 0.0f}, 33.0f};
    scene.focus = {{-2.3f, 0.0f, -1.7f}, {2.0f, 2.7f, 2.4f}};
    scene.lightDirection = glm::normalize(glm::vec3(0.15f, -1.0f, 0.45f));
    scene.shield = Shield{"plane B", planeB};
    scene.lights = {LightKind::Directional, LightKind::Lamp};
    scene.furtherLights = {LightKind::Spot};
    scene.lamp = {-0.3f, 3.6f, -0.3f};
    scene.cuts = {{0, 2.5f, 0}, {0, 0.7f, 0}, {0, 0.4f, 0}};
    return scene;
}

} // namespace lvsm::gallery
