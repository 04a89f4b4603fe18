#include "scenes.hpp"

#include <cmath>

#include "models.hpp"

namespace lvsm::papers
{

using quality::addBox;
using quality::Mesh;

namespace
{

void addBall(Mesh& mesh, glm::vec3 middle, float radius)
{
    constexpr int kAround = 40, kDown = 20;
    const auto point = [&](int around, int down)
    {
        const float a = 6.2831853f * static_cast<float>(around % kAround) / kAround;
        const float d = 3.1415927f * static_cast<float>(down) / kDown;
        return middle + radius * glm::vec3(std::sin(d) * std::sin(a), std::cos(d), std::sin(d) * std::cos(a));
    };
    for (int down = 0; down < kDown; ++down)
    {
        for (int around = 0; around < kAround; ++around)
            quality::addQuad(mesh, point(around, down), point(around, down + 1), point(around + 1, down + 1),
                             point(around + 1, down), false);
    }
}

} // namespace

Setup planes()
{
    const Box a{{-1.5f, 3.2f, -1.0f}, {0.05f, 3.24f, 0.9f}};
    const Box b{{-0.75f, 0.75f, -0.6f}, {0.85f, 0.79f, 0.6f}};
    Mesh mesh;
    quality::addGround(mesh, {-2.2f, -1.8f}, {2.2f, 1.8f});
    addBox(mesh, a.low, a.high);
    addBox(mesh, b.low, b.high);
    return {mesh, {76.0f, 190.0f}, false, {17.0f, 10.0f}, {0.12f, 0.36f, 0.88f, 0.94f}, b};
}

Setup bench()
{
    const Box seat{{-0.8f, 0.54f, -0.22f}, {0.8f, 0.6f, 0.22f}};
    Mesh mesh;
    quality::Random random(3);
    quality::addGround(mesh, {-2.0f, -1.7f}, {2.0f, 1.7f});
    quality::addTree(mesh, {-0.1f, 0.0f, -0.9f}, 4.4f, random);
    addBox(mesh, seat.low, seat.high);
    for (const float x : {-0.65f, 0.65f})
        addBox(mesh, {x - 0.04f, 0.0f, -0.18f}, {x + 0.04f, seat.low.y, 0.18f});
    return {mesh, {74.0f, 190.0f}, false, {20.0f, 12.0f}, {0.2f, 0.56f, 0.8f, 0.96f}, seat};
}

Setup blocks()
{
    Mesh mesh;
    quality::Random random(5);
    quality::addGround(mesh, {-3.2f, -2.6f}, {3.2f, 2.6f});
    const auto slab = [&](float low, float high, float least, float most)
    {
        const float x = random.uniform(-2.4f, 2.4f);
        const float z = random.uniform(-1.9f, 1.9f);
        const float y = random.uniform(low, high);
        const float width = random.uniform(least, most);
        const float depth = random.uniform(least, most);
        addBox(mesh, {x - width, y, z - depth}, {x + width, y + 0.05f, z + depth});
    };
    for (int i = 0; i < 14; ++i)
        slab(3.2f, 4.6f, 0.1f, 0.4f);
    for (int i = 0; i < 26; ++i)
        slab(0.15f, 0.7f, 0.15f, 0.5f);
    return {mesh, {68.0f, 205.0f}, false, {34.0f, 30.0f}, {0.1f, 0.3f, 0.9f, 0.98f}, {}};
}

Setup yard()
{
    Mesh mesh, fence;
    quality::Random random(9);
    quality::addGround(mesh, {-3.4f, -2.8f}, {3.4f, 2.8f});
    quality::addFence(fence, {-2.6f, 0.0f, 0.0f}, 5.2f, 0.8f);
    place(mesh, fence, {0.0f, 0.0f, 2.1f}, 1.0f, 0.0f);
    place(mesh, fence, {0.0f, 0.0f, -2.3f}, 1.0f, 180.0f);
    place(mesh, fence, {2.6f, 0.0f, 0.0f}, 0.82f, 90.0f);
    addBox(mesh, {-2.2f, 0.0f, -2.0f}, {-0.7f, 1.3f, -0.7f});
    addBox(mesh, {-2.35f, 1.3f, -2.15f}, {-0.55f, 1.42f, -0.55f});
    addBox(mesh, {-1.0f, 1.42f, -1.6f}, {-0.8f, 1.8f, -1.4f});
    quality::addTree(mesh, {1.5f, 0.0f, -1.0f}, 2.4f, random);
    quality::addTree(mesh, {-1.8f, 0.0f, 1.1f}, 1.6f, random);
    addBox(mesh, {0.2f, 0.42f, 0.5f}, {1.3f, 0.47f, 1.1f});
    for (const float x : {0.26f, 1.2f})
    {
        for (const float z : {0.56f, 1.0f})
            addBox(mesh, {x, 0.0f, z}, {x + 0.04f, 0.42f, z + 0.04f});
    }
    return {mesh, {46.0f, 135.0f}, false, {30.0f, 20.0f}, {0.05f, 0.24f, 0.95f, 0.92f}, {}};
}

Setup room(bool spot)
{
    Mesh mesh;
    quality::addGround(mesh, {-2.6f, -1.6f}, {2.6f, 2.4f});
    addBox(mesh, {-2.6f, 0.0f, -1.7f}, {2.6f, 2.2f, -1.6f});
    addBall(mesh, {-0.3f, 0.75f, 0.0f}, 0.6f);
    addBall(mesh, {0.15f, 1.3f, 0.1f}, 0.22f);
    addBall(mesh, {-0.75f, 1.3f, 0.1f}, 0.22f);
    addBox(mesh, {1.0f, 0.0f, -0.5f}, {1.03f, 1.1f, 0.5f});
    return {mesh, {42.0f, -35.0f}, spot, {20.0f, 15.0f}, {0.06f, 0.1f, 0.94f, 0.94f}, {}};
}

quality::Light lightOf(const Setup& setup, int size)
{
    const Direction& d = setup.light;
    return setup.spot ? quality::Light::spot(setup.mesh, d.elevation, d.azimuth, size)
                      : quality::Light::directional(setup.mesh, d.elevation, d.azimuth, size);
}

float splitBehindShield(const Setup& setup)
{
    const quality::Light light = lightOf(setup, 1);
    double farthest = 0.0, nearest = 1.0;
    for (int i = 0; i < 8; ++i)
    {
        const glm::bvec3 high((i & 1) != 0, (i & 2) != 0, (i & 4) != 0);
        const glm::dvec3 corner(glm::mix(setup.shield.low, setup.shield.high, high));
        const glm::dvec3 along = light.ray(light.texel(corner).x, light.texel(corner).y).direction;
        farthest = std::max(farthest, light.depth(corner));
        nearest = std::min(nearest, light.depth(corner - along * (corner.y / along.y)));
    }
    return static_cast<float>(0.5 * (farthest + nearest));
}

} // namespace lvsm::papers
