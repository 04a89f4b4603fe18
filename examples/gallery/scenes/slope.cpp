#include "../scenes.hpp"

namespace lvsm::gallery
{

Scene makeSlope()
{
    constexpr float kHalfWidth = 2.2f;
    constexpr float kLength = 26.0f;
    constexpr float kRise = 5.0f;
    constexpr glm::vec3 kConcrete{0.66f, 0.65f, 0.62f};
    const auto heightAt = [](float z)
    {
        return kRise * -z / kLength;
    };
    Scene scene;
    scene.id = "slope";
    scene.title = "A long slanted receiver";
    scene.description =
        "A ramp that rises away from the viewer under a low light: each texel of the shadow map is long on it, and far "
        "away many lie in one pixel. What a filter takes for occluders may be the ramp itself.";
    addGround(scene.mesh, kGroundHalfWidth, kGroundColour);
    addQuad(scene.mesh, {-kHalfWidth, 0, 0}, {kHalfWidth, 0, 0}, {kHalfWidth, kRise, -kLength},
            {-kHalfWidth, kRise, -kLength}, kConcrete, Object::Ground);
    for (int i = 0; i < 9; ++i)
    {
        const float z = -1.0f - 2.9f * static_cast<float>(i);
        const float y = heightAt(z);
        for (const float x : {-1.9f, 1.9f})
        {
            addBox(scene.mesh, {{x - 0.06f, y - 0.3f, z - 0.06f}, {x + 0.06f, y + 1.1f, z + 0.06f}},
                   {0.50f, 0.32f, 0.24f});
        }
        // Boards across, close over the ramp.
        addBox(scene.mesh, {{-1.2f, y + 0.25f, z - 0.5f}, {0.4f, y + 0.29f, z - 0.2f}}, {0.40f, 0.47f, 0.55f});
    }
    scene.camera = {{0.5f, 2.4f, 4.6f}, {-0.1f, 1.35f, -6.0f}, 34.0f};
    scene.focus = {{-kHalfWidth, 0.0f, -kLength}, {kHalfWidth, kRise + 1.1f, 1.0f}};
    scene.lightDirection = glm::normalize(glm::vec3(-0.75f, -0.50f, 0.42f));
    scene.lights = {LightKind::Directional};
    scene.cuts = {{0, 1.0f, -6.5f}, {0, 2.0f, -13.0f}, {0, 3.5f, -19.5f}};
    return scene;
}

} // namespace lvsm::gallery
