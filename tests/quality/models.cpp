#include "models.hpp"

#include <cmath>
#include <utility>

#include "model_file.hpp"

namespace lvsm::quality
{
namespace
{

double signedVolume(const Mesh& mesh)
{
    double volume = 0.0;
    for (const Triangle& t : mesh)
    {
        volume += glm::dot(glm::dvec3(t.corners[0]), glm::cross(glm::dvec3(t.corners[1]), glm::dvec3(t.corners[2])));
    }
    return volume;
}

} // namespace

support::Result<Mesh> loadModel(const std::string& path)
{
    const auto model = support::loadModel(path, 1.0f, 10.0f);
    if (!model)
        return support::Failure{model.error()};
    Mesh mesh;
    for (const support::ModelTriangle& t : *model)
        mesh.push_back({{t.corners[0], t.corners[1], t.corners[2]}, false});
    if (signedVolume(mesh) < 0.0)
    {
        for (Triangle& triangle : mesh)
            std::swap(triangle.corners[1], triangle.corners[2]);
    }
    return mesh;
}

void place(Mesh& mesh, const Mesh& model, glm::vec3 foot, float scale, float turn)
{
    const float angle = glm::radians(turn);
    const float c = scale * std::cos(angle);
    const float s = scale * std::sin(angle);
    for (Triangle triangle : model)
    {
        for (glm::vec3& p : triangle.corners)
            p = foot + glm::vec3(c * p.x + s * p.z, scale * p.y, c * p.z - s * p.x);
        mesh.push_back(triangle);
    }
}

void addQuad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, bool twoSided)
{
    mesh.push_back({{a, b, c}, twoSided});
    mesh.push_back({{a, c, d}, twoSided});
}

void addBox(Mesh& mesh, glm::vec3 low, glm::vec3 high)
{
    // Corner numbers of the six sides, anticlockwise from outside; bit 0 is x, bit 1 y, bit 2 z.
    constexpr int sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    const auto corner = [&](int i)
    {
        return glm::vec3((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z);
    };
    for (const auto& s : sides)
        addQuad(mesh, corner(s[0]), corner(s[1]), corner(s[2]), corner(s[3]), false);
}

void addGround(Mesh& mesh, glm::vec2 low, glm::vec2 high)
{
    addQuad(mesh, {low.x, 0, high.y}, {high.x, 0, high.y}, {high.x, 0, low.y}, {low.x, 0, low.y}, false);
}

void addFence(Mesh& mesh, glm::vec3 from, float length, float height)
{
    constexpr float kPost = 0.03f;
    constexpr float kSpacing = 0.11f;
    for (float x = 0.0f; x < length; x += kSpacing)
    {
        addBox(mesh, from + glm::vec3(x, 0, 0), from + glm::vec3(x + kPost, height, kPost));
    }
    for (const float rail : {0.3f, 0.8f})
    {
        const float y = rail * height;
        addBox(mesh, from + glm::vec3(0, y, kPost), from + glm::vec3(length, y + kPost, 1.5f * kPost));
    }
}

} // namespace lvsm::quality
