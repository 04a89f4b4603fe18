#include "models.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace lvsm::quality
{
namespace
{

bool isFinite(glm::vec3 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void addMesh(Mesh& mesh, const aiMesh& source)
{
    for (unsigned face = 0; face < source.mNumFaces; ++face)
    {
        const aiFace& indices = source.mFaces[face];
        if (indices.mNumIndices != 3)
            continue;
        Triangle triangle{{}, false};
        bool usable = true;
        for (unsigned i = 0; i < 3; ++i)
        {
            const aiVector3D& v = source.mVertices[indices.mIndices[i]];
            triangle.corners[i] = glm::vec3(v.x, v.y, v.z);
            usable = usable && isFinite(triangle.corners[i]);
        }
        if (usable)
            mesh.push_back(triangle);
    }
}

double signedVolume(const Mesh& mesh)
{
    double volume = 0.0;
    for (const Triangle& t : mesh)
    {
        volume += glm::dot(glm::dvec3(t.corners[0]), glm::cross(glm::dvec3(t.corners[1]), glm::dvec3(t.corners[2])));
    }
    return volume;
}

void standOnGround(Mesh& mesh)
{
    glm::vec3 low(1e30f);
    glm::vec3 high(-1e30f);
    for (const Triangle& triangle : mesh)
    {
        for (const glm::vec3& corner : triangle.corners)
        {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    }
    const glm::vec3 size = high - low;
    const float scale = 1.0f / std::max({size.y, 0.1f * size.x, 0.1f * size.z, 1e-20f});
    const glm::vec3 foot{0.5f * (low.x + high.x), low.y, 0.5f * (low.z + high.z)};
    for (Triangle& triangle : mesh)
    {
        for (glm::vec3& corner : triangle.corners)
            corner = (corner - foot) * scale;
    }
}

} // namespace

support::Result<Mesh> loadModel(const std::string& path)
{
    const auto failure = [&](const std::string& reason)
    {
        return support::Failure{"cannot read the model '" + path + "': " + reason};
    };
    if (!std::filesystem::is_regular_file(path))
        return failure("there is no such file");

    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene =
        importer.ReadFile(path, aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_SortByPType);
    if (scene == nullptr)
        return failure(importer.GetErrorString());

    Mesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        addMesh(mesh, *scene->mMeshes[i]);
    if (mesh.empty())
        return failure("it holds no triangles");
    standOnGround(mesh);
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
