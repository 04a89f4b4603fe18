#include <random>

#include "../scenes.hpp"
#include "../tree.hpp"

namespace lvsm::gallery
{
namespace
{

constexpr glm::vec3 kPaint{0.80f, 0.79f, 0.75f};
constexpr glm::vec3 kGrass{0.34f, 0.46f, 0.20f};
constexpr int kBlades = 80000;
constexpr float kHalfWidth = 6.0f;
constexpr float kFenceZ = 2.4f;

void addFence(Mesh& mesh)
{
    constexpr float kSpacing = 0.2f;
    const int pickets = static_cast<int>(2.0f * kHalfWidth / kSpacing);
    for (int i = 0; i < pickets; ++i)
    {
        const float x = -kHalfWidth + kSpacing * static_cast<float>(i);
        addBox(mesh, {{x, 0.0f, kFenceZ}, {x + 0.11f, 1.1f, kFenceZ + 0.025f}}, kPaint);
    }
    for (const float y : {0.3f, 0.85f})
        addBox(mesh, {{-kHalfWidth, y, kFenceZ - 0.04f}, {kHalfWidth, y + 0.08f, kFenceZ}}, kPaint);
}

void addGrass(Mesh& mesh)
{
    std::mt19937 random(3);
    // The C++ standard leaves the distributions open, and the grass must be the same everywhere.
    const auto uniform = [&]
    {
        return static_cast<float>(random() >> 8) * 0x1p-24f;
    };
    for (int i = 0; i < kBlades; ++i)
    {
        const float x = kHalfWidth * (2.0f * uniform() - 1.0f);
        const float z = kFenceZ - 0.1f - 6.0f * uniform();
        const float height = 0.04f + 0.07f * uniform();
        const float lean = 0.08f * (uniform() - 0.5f);
        const float turn = 6.2831853f * uniform();
        const glm::vec3 foot{x, 0.0f, z};
        const glm::vec3 side = 0.008f * glm::vec3(glm::cos(turn), 0.0f, glm::sin(turn));
        const glm::vec3 tip = foot + glm::vec3(lean, height, lean);
        const glm::vec3 middle = 0.5f * (foot + tip) + 0.008f * glm::vec3(0, 1, 0);
        addQuad(mesh, foot - side, foot + side, middle + 0.7f * side, tip, kGrass * (0.75f + 0.5f * uniform()),
                Object::Thin);
    }
}

} // namespace

Scene makeYard()
{
    Scene scene;
    scene.id = "yard";
    scene.title = "A yard behind a fence";
    scene.description =
        "Trees, grass and a fence of more than 300,000 triangles: thin occluders at every distance, and "
        "receivers that are smaller than a texel.";
    addGround(scene.mesh, kGroundHalfWidth, kGroundColour);
    addFence(scene.mesh);
    addGrass(scene.mesh);
    for (unsigned i = 0; i < 13; ++i)
    {
        const float x = -5.4f + 0.9f * static_cast<float>(i);
        const float z = i % 2 == 0 ? -2.6f : -4.1f;
        addTree(scene.mesh, {x, 0.0f, z}, 20 + i);
    }
    scene.camera = {{2.6f, 2.2f, 7.6f}, {-0.3f, 0.95f, 0.0f}, 34.0f};
    scene.focus = {{-4.0f, 0.0f, -4.0f}, {4.0f, 5.2f, 4.0f}};
    scene.lightDirection = glm::normalize(glm::vec3(0.35f, -0.8f, 0.62f));
    scene.lights = {LightKind::Directional};
    scene.furtherLights = {LightKind::Spot};
    scene.cuts = {{0, 2.4f, -2}, {0, 1.2f, 0}, {0, 0.2f, 1}};
    return scene;
}

} // namespace lvsm::gallery
