#include "scenes.hpp"

#include "tree.hpp"

namespace lvsm::gallery
{
namespace
{

constexpr float kGroundHalfWidth = 40.0f;
constexpr glm::vec3 kGround{0.62f, 0.60f, 0.56f};
constexpr glm::vec3 kWood{0.60f, 0.43f, 0.27f};
constexpr glm::vec3 kPaint{0.80f, 0.79f, 0.75f};

void addBenchLeg(Mesh& mesh, float x)
{
    addBox(mesh, {{x - 0.04f, 0.0f, -0.2f}, {x + 0.04f, 0.5f, 0.2f}}, kWood);
}

} // namespace

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
    addGround(scene.mesh, kGroundHalfWidth, kGround);
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

Scene makeBench(unsigned treeSeed)
{
    const Box seat{{-0.9f, 0.5f, -0.24f}, {0.9f, 0.56f, 0.24f}};
    Scene scene;
    scene.id = "bench";
    scene.title = "A tree over a bench";
    scene.description =
        "The situation of the paper's figure 3. The tree is far above the bench and the bench close to the ground: the "
        "ratio that makes variance shadow maps bleed most. Inside the bench's shadow the ground must be evenly dark.";
    addGround(scene.mesh, kGroundHalfWidth, kGround);
    addBox(scene.mesh, seat, kWood);
    addBenchLeg(scene.mesh, -0.7f);
    addBenchLeg(scene.mesh, 0.7f);
    addTree(scene.mesh, {-1.1f, 0.0f, -1.7f}, treeSeed);
    scene.camera = {{1.3f, 1.75f, 4.4f}, {-0.15f, 0.45f, 0.0f}, 32.0f};
    scene.focus = {{-3.1f, 0.0f, -3.0f}, {2.4f, 5.5f, 2.0f}};
    scene.lightDirection = glm::normalize(glm::vec3(0.12f, -1.0f, 0.34f));
    scene.shield = Shield{"the bench", seat};
    scene.lights = {LightKind::Spot, LightKind::Directional};
    scene.cuts = {{0, 1.7f, 0}, {0, 0.65f, 0}, {0, 0.4f, 0}};
    return scene;
}

Scene makeFence(const Mesh& model, const std::string& modelName)
{
    constexpr int kPickets = 13;
    constexpr float kSpacing = 0.22f;
    constexpr float kFenceX = -1.0f;
    Scene scene;
    scene.id = "fence";
    scene.title = "A model behind a fence";
    scene.description = "The model (" + modelName +
                        ") stands on the ground with a fence between it and the light: many thin occluders over a "
                        "curved receiver that shadows itself.";
    addGround(scene.mesh, kGroundHalfWidth, kGround);
    scene.mesh.insert(scene.mesh.end(), model.begin(), model.end());
    for (int i = 0; i < kPickets; ++i)
    {
        const float z = kSpacing * static_cast<float>(i - kPickets / 2);
        addBox(scene.mesh, {{kFenceX, 0.0f, z - 0.05f}, {kFenceX + 0.03f, 1.1f, z + 0.05f}}, kPaint);
    }
    const float halfLength = kSpacing * kPickets * 0.5f;
    for (const float y : {0.3f, 0.8f})
    {
        addBox(scene.mesh, {{kFenceX - 0.04f, y, -halfLength}, {kFenceX, y + 0.08f, halfLength}}, kPaint);
    }
    scene.camera = {{1.1f, 1.55f, 4.6f}, {0.05f, 0.45f, 0.0f}, 28.0f};
    scene.focus = {{-1.1f, 0.0f, -1.5f}, {1.6f, 1.1f, 1.5f}};
    scene.lightDirection = glm::normalize(glm::vec3(0.85f, -0.52f, -0.42f));
    scene.lights = {LightKind::Directional};
    scene.furtherLights = {LightKind::Spot};
    scene.cuts = {{-0.9f, 0.5f, 0}, {-0.5f, 0.5f, 0}, {0.1f, 0.5f, 0}};
    return scene;
}

} // namespace lvsm::gallery
