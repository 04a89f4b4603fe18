#include "mesh.hpp"

#include <cmath>

#include <glm/gtc/constants.hpp>

namespace lvsm::gallery
{
namespace
{

constexpr int kBarSides = 10;

glm::vec3 anyPerpendicular(glm::vec3 axis)
{
    const glm::vec3 helper = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    return glm::normalize(glm::cross(axis, helper));
}

} // namespace

glm::vec3 Box::corner(int index) const
{
    return {(index & 1) != 0 ? high.x : low.x, (index & 2) != 0 ? high.y : low.y, (index & 4) != 0 ? high.z : low.z};
}

void addTriangle(Mesh& mesh, const glm::vec3 (&corners)[3], const glm::vec3 (&normals)[3], glm::vec3 colour,
                 Object object)
{
    const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float area = glm::length(across);
    if (!(area > 0.0f))
        return;
    const glm::vec3 face = across / area;
    for (int i = 0; i < 3; ++i)
    {
        const glm::vec3 normal = glm::dot(normals[i], normals[i]) > 0.0f ? normals[i] : face;
        mesh.push_back({corners[i], normal, face, colour, static_cast<float>(object), {}});
    }
}

void addQuad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, glm::vec3 colour, Object object)
{
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    addTriangle(mesh, {a, b, c}, {normal, normal, normal}, colour, object);
    addTriangle(mesh, {a, c, d}, {normal, normal, normal}, colour, object);
}

void addCutOut(Mesh& mesh, glm::vec3 stem, glm::vec3 along, glm::vec3 across, glm::vec3 colour)
{
    const std::size_t first = mesh.size();
    addQuad(mesh, stem - across, stem + 2.0f * along - across, stem + 2.0f * along + across, stem + across, colour,
            Object::Thin);
    for (std::size_t i = first; i < mesh.size(); ++i)
    {
        const glm::vec3 from = mesh[i].position - (stem + along);
        mesh[i].place = {glm::dot(from, along) / glm::dot(along, along),
                         glm::dot(from, across) / glm::dot(across, across)};
    }
}

void addBox(Mesh& mesh, const Box& box, glm::vec3 colour)
{
    // Corner numbers of the six sides, seen anticlockwise from outside.
    constexpr int sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& side : sides)
    {
        addQuad(mesh, box.corner(side[0]), box.corner(side[1]), box.corner(side[2]), box.corner(side[3]), colour);
    }
}

void addBar(Mesh& mesh, glm::vec3 from, glm::vec3 to, float radiusFrom, float radiusTo, glm::vec3 colour)
{
    const glm::vec3 axis = glm::normalize(to - from);
    const glm::vec3 right = anyPerpendicular(axis);
    const glm::vec3 up = glm::cross(axis, right);
    const auto outwards = [&](int side)
    {
        const float angle = glm::two_pi<float>() * static_cast<float>(side) / kBarSides;
        return right * std::cos(angle) + up * std::sin(angle);
    };
    for (int side = 0; side < kBarSides; ++side)
    {
        const glm::vec3 n0 = outwards(side);
        const glm::vec3 n1 = outwards(side + 1);
        const glm::vec3 a = from + n0 * radiusFrom;
        const glm::vec3 b = from + n1 * radiusFrom;
        const glm::vec3 c = to + n1 * radiusTo;
        const glm::vec3 d = to + n0 * radiusTo;
        addTriangle(mesh, {a, b, c}, {n0, n1, n1}, colour);
        addTriangle(mesh, {a, c, d}, {n0, n1, n0}, colour);
    }
}

void addGround(Mesh& mesh, float halfWidth, glm::vec3 colour)
{
    const float w = halfWidth;
    addQuad(mesh, {-w, 0, w}, {w, 0, w}, {w, 0, -w}, {-w, 0, -w}, colour, Object::Ground);
}

} // namespace lvsm::gallery
