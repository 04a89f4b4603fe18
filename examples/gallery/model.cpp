#include "model.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace lvsm::gallery
{
namespace
{

constexpr glm::vec3 kModelColour{0.72f, 0.68f, 0.62f};

glm::vec3 toGlm(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

bool isFinite(glm::vec3 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void addMesh(Mesh& mesh, const aiMesh& source)
{
    for (unsigned face = 0; face < source.mNumFaces; ++face)
    {
        const unsigned* corner = source.mFaces[face].mIndices;
        glm::vec3 positions[3];
        glm::vec3 normals[3];
        bool usable = true;
        for (int i = 0; i < 3; ++i)
        {
            positions[i] = toGlm(source.mVertices[corner[i]]);
            normals[i] = toGlm(source.mNormals[corner[i]]);
            usable = usable && isFinite(positions[i]) && isFinite(normals[i]);
        }
        if (usable)
            addTriangle(mesh, positions, normals, kModelColour);
    }
}

Box bounds(const Mesh& mesh)
{
    constexpr float kLargest = std::numeric_limits<float>::max();
    Box box{glm::vec3(kLargest), glm::vec3(-kLargest)};
    for (const Vertex& vertex : mesh)
    {
        box.low = glm::min(box.low, vertex.position);
        box.high = glm::max(box.high, vertex.position);
    }
    return box;
}

void standOnGround(Mesh& mesh, float height, float width)
{
    const Box box = bounds(mesh);
    const glm::vec3 size = box.high - box.low;
    const float scale = std::min(height / std::max(size.y, 1e-6f), width / std::max({size.x, size.z, 1e-6f}));
    const glm::vec3 foot{box.centre().x, box.low.y, box.centre().z};
    for (Vertex& vertex : mesh)
        vertex.position = (vertex.position - foot) * scale;
}

} // namespace

support::Result<Mesh> loadModel(const std::string& path, float height, float width)
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
        importer.ReadFile(path, aiProcess_Triangulate | aiProcess_GenSmoothNormals | aiProcess_PreTransformVertices |
                                    aiProcess_SortByPType | aiProcess_JoinIdenticalVertices);
    if (scene == nullptr)
        return failure(importer.GetErrorString());

    Mesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
    {
        if (scene->mMeshes[i]->HasNormals())
            addMesh(mesh, *scene->mMeshes[i]);
    }
    if (mesh.empty())
        return failure("it holds no triangles");
    standOnGround(mesh, height, width);
    return mesh;
}

} // namespace lvsm::gallery
