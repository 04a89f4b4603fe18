#include <cmath>

#include "models.hpp"

namespace lvsm::quality
{
namespace
{

constexpr int kHillSteps = 48;
constexpr int kBarSides = 7;
constexpr int kBoughs = 9;
constexpr int kLeaves = 420;

void addBar(Mesh& mesh, glm::vec3 from, glm::vec3 to, float radiusFrom, float radiusTo)
{
    const glm::vec3 axis = glm::normalize(to - from);
    const glm::vec3 helper = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 side = glm::normalize(glm::cross(axis, helper));
    const glm::vec3 other = glm::cross(axis, side);
    const auto outwards = [&](int i)
    {
        const float angle = 6.2831853f * static_cast<float>(i) / kBarSides;
        return side * std::cos(angle) + other * std::sin(angle);
    };
    for (int i = 0; i < kBarSides; ++i)
    {
        const glm::vec3 a = outwards(i);
        const glm::vec3 b = outwards(i + 1);
        addQuad(mesh, from + a * radiusFrom, from + b * radiusFrom, to + b * radiusTo, to + a * radiusTo, false);
    }
}

glm::vec3 anyDirection(Random& random)
{
    const float y = random.uniform(-1.0f, 1.0f);
    const float around = random.uniform(0.0f, 6.2831853f);
    const float level = std::sqrt(1.0f - y * y);
    return {level * std::cos(around), y, level * std::sin(around)};
}

} // namespace

float hillHeight(glm::vec2 point, float halfWidth, float height)
{
    const glm::vec2 p = point / halfWidth;
    return height * (std::exp(-3.0f * glm::dot(p, p)) + 0.06f * std::sin(7.0f * p.x) * std::cos(6.0f * p.y));
}

void addHill(Mesh& mesh, float halfWidth, float height)
{
    const auto point = [&](int ix, int iz)
    {
        const glm::vec2 p = halfWidth * (2.0f * glm::vec2(ix, iz) / static_cast<float>(kHillSteps) - 1.0f);
        return glm::vec3(p.x, hillHeight(p, halfWidth, height), p.y);
    };
    for (int z = 0; z < kHillSteps; ++z)
    {
        for (int x = 0; x < kHillSteps; ++x)
        {
            addQuad(mesh, point(x, z), point(x, z + 1), point(x + 1, z + 1), point(x + 1, z), false);
        }
    }
}

void addTree(Mesh& mesh, glm::vec3 foot, float height, Random& random)
{
    const glm::vec3 top = foot + glm::vec3(0, 0.7f * height, 0);
    const glm::vec3 crown = foot + glm::vec3(0, 0.66f * height, 0);
    const float radius = 0.34f * height;
    addBar(mesh, foot - glm::vec3(0, 0.05f * height, 0), top, 0.035f * height, 0.015f * height);
    for (int i = 0; i < kBoughs; ++i)
    {
        const glm::vec3 from = glm::mix(foot, top, random.uniform(0.5f, 0.95f));
        addBar(mesh, from, crown + 0.8f * radius * anyDirection(random), 0.014f * height, 0.005f * height);
    }
    for (int i = 0; i < kLeaves; ++i)
    {
        // One draw a statement: compilers differ in which of two in one expression comes first.
        const glm::vec3 outwards = anyDirection(random);
        const glm::vec3 middle = crown + radius * std::cbrt(random.uniform(0.05f, 1.0f)) * outwards;
        const glm::vec3 along = 0.05f * height * anyDirection(random);
        const glm::vec3 across = 0.5f * glm::cross(along, anyDirection(random));
        addQuad(mesh, middle - along, middle - across, middle + along, middle + across, true);
    }
}

} // namespace lvsm::quality
