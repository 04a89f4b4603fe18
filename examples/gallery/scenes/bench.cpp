#include "../scenes.hpp"
#include "../tree.hpp"

namespace lvsm::gallery
{
namespace
{

constexpr glm::vec3 kWood{0.60f, 0.43f, 0.27f};

void addBenchLeg(Mesh& mesh, float x)
{
    addBox(mesh, {{x - 0.04f, 0.0f, -0.2f}, {x + 0.04f, 0.5f, 0.2f}}, kWood);
}

} // namespace

Scene makeBench(unsigned treeSeed)
{
    const Box seat{{-0.9f, 0.5f, -0.24f}, {0.9f, 0.56f, 0.24f}};
    Scene scene;
    scene.id = "bench";
    scene.title = "A tree over a bench";
    scene.description =
        "The situation of the paper's figure 3. The tree is far above the bench and the bench close to the ground: the "
        "ratio that makes variance shadow maps bleed most. Inside the bench's shadow the ground must be evenly dark.";
    addGround(scene.mesh, kGroundHalfWidth, kGroundColour);
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
    scene.isTurned = true;
    return scene;
}

} // namespace lvsm::gallery
