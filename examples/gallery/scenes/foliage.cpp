#include <random>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include "../scenes.hpp"

namespace lvsm::gallery
{
namespace
{

constexpr glm::vec3 kLeaf{0.30f, 0.44f, 0.18f};
constexpr glm::vec3 kIron{0.28f, 0.29f, 0.30f};
constexpr int kLeaves = 230;

class Vine
{
public:
    Vine(Mesh& mesh, unsigned seed) : m_mesh(mesh), m_random(seed) {}

    void addLeafWithin(const Box& box)
    {
        const glm::vec3 share{uniform(), uniform(), uniform()};
        const glm::vec3 stem = glm::mix(box.low, box.high, share);
        const float turn = glm::two_pi<float>() * uniform();
        const float lean = 0.9f * (uniform() - 0.5f);
        const float size = 0.16f + 0.14f * uniform();
        const glm::quat rotation = glm::angleAxis(turn, glm::vec3(0, 1, 0)) * glm::angleAxis(lean, glm::vec3(0, 0, 1));
        const glm::vec3 along = rotation * glm::vec3(size, 0, 0);
        const glm::vec3 across = rotation * glm::vec3(0, 0, 0.42f * size);
        addCutOut(m_mesh, stem, along, across, kLeaf * (0.8f + 0.4f * uniform()));
    }

private:
    // The C++ standard leaves the distributions open, and the leaves must be the same everywhere.
    float uniform() { return static_cast<float>(m_random() >> 8) * 0x1p-24f; }

    Mesh& m_mesh;
    std::mt19937 m_random;
};

} // namespace

Scene makeFoliage()
{
    const Box table{{-0.7f, 0.62f, -0.45f}, {0.7f, 0.66f, 0.45f}};
    Scene scene;
    scene.id = "foliage";
    scene.title = "Leaves on a pergola";
    scene.description =
        "Leaves that an alpha test cuts out of rectangles, over a table over the ground: small holes at every depth.";
    addGround(scene.mesh, kGroundHalfWidth, kGroundColour);
    addBox(scene.mesh, table, {0.74f, 0.72f, 0.68f});
    addBar(scene.mesh, {0, 0, 0}, {0, 0.62f, 0}, 0.05f, 0.04f, kIron);
    for (const float x : {-1.6f, 1.6f})
    {
        for (const float z : {-1.1f, 1.1f})
            addBar(scene.mesh, {x, 0, z}, {x, 2.3f, z}, 0.04f, 0.04f, kIron);
        addBar(scene.mesh, {x, 2.3f, -1.3f}, {x, 2.3f, 1.3f}, 0.03f, 0.03f, kIron);
    }
    for (int i = 0; i < 7; ++i)
    {
        const float z = -1.2f + 0.4f * static_cast<float>(i);
        addBar(scene.mesh, {-1.7f, 2.36f, z}, {1.7f, 2.36f, z}, 0.02f, 0.02f, kIron);
    }
    Vine vine(scene.mesh, 5);
    for (int i = 0; i < kLeaves; ++i)
        vine.addLeafWithin({{-1.6f, 2.2f, -1.2f}, {1.5f, 2.7f, 1.2f}});
    scene.camera = {{2.6f, 2.0f, 4.6f}, {0.0f, 0.9f, 0.0f}, 34.0f};
    scene.focus = {{-2.0f, 0.0f, -1.5f}, {2.4f, 2.75f, 1.9f}};
    scene.lightDirection = glm::normalize(glm::vec3(0.22f, -1.0f, 0.15f));
    scene.shield = Shield{"the table", table};
    scene.lights = {LightKind::Directional};
    scene.furtherLights = {LightKind::Spot, LightKind::Lamp};
    scene.lamp = {0.3f, 3.2f, -0.4f};
    scene.cuts = {{0, 2.0f, 0}, {0, 0.9f, 0}, {0, 0.5f, 0}};
    return scene;
}

} // namespace lvsm::gallery
