#include "scenes_mesh.hpp"

namespace lvsm::quality
{
namespace
{

const std::string kGlmark = "/usr/share/glmark2/models/";
const std::string kAssimp = "/usr/share/assimp/models/";

struct NamedLight
{
    const char* name;
    bool spot;
    float elevation; // degrees above the horizon
    float azimuth;
};

// From steep to grazing.
constexpr NamedLight kLights[] = {{"steep", false, 68.0f, 35.0f},
                                  {"oblique", false, 38.0f, 20.0f},
                                  {"grazing", false, 14.0f, 50.0f},
                                  {"spot", true, 45.0f, -30.0f}};

support::Result<Mesh> bunnies()
{
    support::Result<Mesh> bunny = loadModel(kGlmark + "bunny.obj");
    if (!bunny)
        return bunny;
    Mesh mesh;
    addGround(mesh, {-2.2f, -1.8f}, {2.2f, 1.8f});
    place(mesh, *bunny, {-0.9f, 0.0f, -0.2f}, 1.0f, 20.0f);
    place(mesh, *bunny, {0.6f, 0.0f, 0.1f}, 0.8f, -60.0f);
    place(mesh, *bunny, {0.1f, 0.0f, -1.1f}, 0.6f, 130.0f);
    addFence(mesh, {-1.9f, 0.0f, 0.8f}, 3.8f, 0.7f);
    return mesh;
}

support::Result<Mesh> herd(Random& random)
{
    support::Result<Mesh> horse = loadModel(kGlmark + "horse.3ds");
    if (!horse)
        return horse;
    Mesh mesh;
    addGround(mesh, {-3.4f, -2.6f}, {3.4f, 2.6f});
    for (int row = 0; row < 4; ++row)
    {
        for (int column = 0; column < 5; ++column)
        {
            const glm::vec3 foot{1.2f * (static_cast<float>(column) - 2.0f) + random.uniform(-0.25f, 0.25f), 0.0f,
                                 1.2f * (static_cast<float>(row) - 1.5f) + random.uniform(-0.25f, 0.25f)};
            const float scale = random.uniform(0.6f, 1.1f);
            place(mesh, *horse, foot, scale, random.uniform(-50.0f, 50.0f));
        }
    }
    return mesh;
}

support::Result<Mesh> machine()
{
    support::Result<Mesh> engine = loadModel(kAssimp + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
    if (!engine)
        return engine;
    Mesh mesh;
    addGround(mesh, {-2.6f, -2.0f}, {2.6f, 2.0f});
    place(mesh, *engine, {-0.3f, 0.0f, -0.7f}, 1.2f, 25.0f);
    place(mesh, *engine, {0.5f, 0.0f, 0.9f}, 0.7f, -70.0f);
    place(mesh, *engine, {-1.4f, 0.0f, 1.0f}, 0.5f, 160.0f);
    return mesh;
}

Mesh trees(Random& random)
{
    constexpr float kHalfWidth = 3.0f;
    constexpr float kHeight = 0.8f;
    Mesh mesh;
    addHill(mesh, kHalfWidth, kHeight);
    for (int i = 0; i < 14; ++i)
    {
        const glm::vec2 at{random.uniform(-2.5f, 2.5f), random.uniform(-2.5f, 2.5f)};
        addTree(mesh, {at.x, hillHeight(at, kHalfWidth, kHeight), at.y}, random.uniform(0.9f, 1.7f), random);
    }
    return mesh;
}

Mesh street(Random& random)
{
    Mesh mesh;
    addGround(mesh, {-4.0f, -2.2f}, {4.0f, 2.2f});
    for (const float side : {-1.0f, 1.0f})
    {
        for (int house = 0; house < 6; ++house)
        {
            const float x = 1.3f * (static_cast<float>(house) - 2.5f);
            const float height = random.uniform(0.7f, 2.0f);
            const float depth = random.uniform(0.6f, 0.9f);
            const float z = side > 0.0f ? 0.8f : -0.8f - depth;
            addBox(mesh, {x - 0.55f, 0.0f, z}, {x + 0.55f, height, z + depth});
            addBox(mesh, {x - 0.1f, height, z + 0.2f}, {x + 0.1f, height + 0.25f, z + 0.4f});
            for (float y = 0.45f; y < height - 0.1f; y += 0.4f)
            {
                const float front = side > 0.0f ? z - 0.12f : z + depth;
                addBox(mesh, {x - 0.35f, y, front}, {x + 0.35f, y + 0.05f, front + 0.12f});
            }
        }
        for (int lamp = 0; lamp < 7; ++lamp)
        {
            const float x = 1.2f * (static_cast<float>(lamp) - 3.0f);
            addBox(mesh, {x - 0.02f, 0.0f, 0.5f * side - 0.02f}, {x + 0.02f, 0.8f, 0.5f * side + 0.02f});
            addBox(mesh, {x - 0.06f, 0.8f, 0.5f * side - 0.06f}, {x + 0.06f, 0.9f, 0.5f * side + 0.06f});
        }
    }
    for (int car = 0; car < 5; ++car)
    {
        const glm::vec3 at{random.uniform(-3.3f, 3.0f), 0.0f, random.uniform(-0.35f, 0.1f)};
        addBox(mesh, at + glm::vec3(0.0f, 0.06f, 0.0f), at + glm::vec3(0.5f, 0.17f, 0.2f));
        addBox(mesh, at + glm::vec3(0.1f, 0.17f, 0.02f), at + glm::vec3(0.4f, 0.27f, 0.18f));
        for (const float x : {0.05f, 0.35f})
        {
            addBox(mesh, at + glm::vec3(x, 0.0f, 0.0f), at + glm::vec3(x + 0.1f, 0.1f, 0.2f));
        }
    }
    return mesh;
}

} // namespace

const std::vector<std::string>& worldNames()
{
    static const std::vector<std::string> names{"bunnies", "herd", "machine", "trees", "street"};
    return names;
}

const std::vector<std::string>& lightNames()
{
    static const std::vector<std::string> names = []
    {
        std::vector<std::string> list;
        for (const NamedLight& light : kLights)
            list.emplace_back(light.name);
        return list;
    }();
    return names;
}

support::Result<Mesh> world(const std::string& name, unsigned seed)
{
    Random random(seed);
    if (name == "bunnies")
        return bunnies();
    if (name == "herd")
        return herd(random);
    if (name == "machine")
        return machine();
    if (name == "trees")
        return trees(random);
    return street(random);
}

support::Result<Mesh> modelWorld(const std::string& path)
{
    support::Result<Mesh> model = loadModel(path);
    if (!model)
        return model;
    Mesh mesh;
    addGround(mesh, {-1.6f, -1.4f}, {1.6f, 1.4f});
    place(mesh, *model, {0.0f, 0.0f, -0.2f}, 1.0f, 0.0f);
    addFence(mesh, {-1.4f, 0.0f, 0.7f}, 2.8f, 0.7f);
    return mesh;
}

Light meshLight(const Mesh& mesh, const std::string& lightName, int size, float turned)
{
    const NamedLight* chosen = &kLights[0];
    for (const NamedLight& light : kLights)
    {
        if (lightName == light.name)
            chosen = &light;
    }
    return chosen->spot ? Light::spot(mesh, chosen->elevation, chosen->azimuth + turned, size)
                        : Light::directional(mesh, chosen->elevation, chosen->azimuth + turned, size);
}

Scene meshScene(const std::string& worldName, const Mesh& mesh, const std::string& lightName, int size)
{
    return {worldName + "-" + lightName, depthPeel(mesh, meshLight(mesh, lightName, size), size), true};
}

} // namespace lvsm::quality
