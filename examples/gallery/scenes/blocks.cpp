#include "../scenes.hpp"

namespace lvsm::gallery
{

Scene makeBlocks()
{
    // Close to the ground, above it, and very far above it, each over the next.
    const Box slab{{-1.1f, 0.10f, -0.8f}, {1.1f, 0.16f, 0.9f}};
    const Box low{{-0.5f, 0.60f, -0.5f}, {0.7f, 0.75f, 0.1f}};
    Scene scene;
    scene.id = "blocks";
    scene.title = "Overlapping blocks";
    scene.description =
        "Blocks over blocks over the ground, from a hand's breadth to twelve metres above it: the shadows of the high "
        "ones fall on the low ones, whose own shadows must stay dark beneath.";
    addGround(scene.mesh, kGroundHalfWidth, kGroundColour);
    addBox(scene.mesh, slab, {0.72f, 0.56f, 0.38f});
    addBox(scene.mesh, low, {0.58f, 0.34f, 0.30f});
    addBox(scene.mesh, {{0.9f, 0.0f, -1.3f}, {1.3f, 0.9f, -0.9f}}, {0.45f, 0.55f, 0.42f});
    for (int i = 0; i < 6; ++i)
    {
        const float x = -1.9f + 0.75f * static_cast<float>(i);
        const float y = i % 2 == 0 ? 6.0f : 12.0f;
        addBox(scene.mesh, {{x, y, -5.2f}, {x + 0.34f, y + 0.3f, 1.2f}}, {0.30f, 0.45f, 0.62f});
    }
    scene.camera = {{2.2f, 2.1f, 4.2f}, {0.05f, 0.18f, 0.05f}, 32.0f};
    scene.focus = {{-2.0f, 0.0f, -1.9f}, {2.2f, 12.3f, 2.0f}};
    scene.lightDirection = glm::normalize(glm::vec3(0.10f, -1.0f, 0.16f));
    scene.shield = Shield{"the lowest block", slab};
    scene.lights = {LightKind::Directional};
    scene.furtherLights = {LightKind::Spot};
    scene.cuts = {{0, 3.0f, 0}, {0, 0.4f, 0}, {0, 0.05f, 0}};
    return scene;
}

} // namespace lvsm::gallery
