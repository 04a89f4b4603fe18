#include "model_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <sys/resource.h>
#include <unistd.h>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <glm/geometric.hpp>

namespace lvsm::support
{
namespace
{

using Model = std::vector<ModelTriangle>;

// While it lives, the process gets no more memory than this beside what it has: a file may promise more vertices than any
// machine holds, and then the allocation has to fail and not the machine.
class MemoryLimit
{
public:
    MemoryLimit()
    {
        constexpr rlim_t kMost = rlim_t{4} << 30;
        getrlimit(RLIMIT_AS, &m_before);
        rlimit limited = m_before;
        limited.rlim_cur = std::min(m_before.rlim_cur, addressSpace() + kMost);
        setrlimit(RLIMIT_AS, &limited);
    }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
    ~MemoryLimit() { setrlimit(RLIMIT_AS, &m_before); }

private:
    static rlim_t addressSpace()
    {
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    }

    rlimit m_before{};
};

glm::vec3 toGlm(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

bool isFinite(glm::vec3 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void addMesh(Model& model, const aiMesh& source)
{
    for (unsigned face = 0; face < source.mNumFaces; ++face)
    {
        const aiFace& indices = source.mFaces[face];
        if (indices.mNumIndices != 3)
            continue;
        ModelTriangle triangle{};
        bool usable = true;
        for (unsigned i = 0; i < 3; ++i)
        {
            triangle.corners[i] = toGlm(source.mVertices[indices.mIndices[i]]);
            triangle.normals[i] = toGlm(source.mNormals[indices.mIndices[i]]);
            usable = usable && isFinite(triangle.corners[i]) && isFinite(triangle.normals[i]);
        }
        const glm::vec3* p = triangle.corners;
        if (usable && glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) > 0.0f)
            model.push_back(triangle);
    }
}

void standOnGround(Model& model, float height, float width)
{
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(-std::numeric_limits<float>::max());
    for (const ModelTriangle& triangle : model)
    {
        for (const glm::vec3& corner : triangle.corners)
        {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    }
    const glm::vec3 size = high - low;
    const float scale = std::min(height / std::max(size.y, 1e-6f), width / std::max({size.x, size.z, 1e-6f}));
    const glm::vec3 foot{0.5f * (low.x + high.x), low.y, 0.5f * (low.z + high.z)};
    for (ModelTriangle& triangle : model)
    {
        for (glm::vec3& corner : triangle.corners)
            corner = (corner - foot) * scale;
    }
}

} // namespace

Result<Model> loadModel(const std::string& path, float height, float width)
{
    const auto failure = [&](const std::string& reason)
    {
        return Failure{"cannot read the model '" + path + "': " + reason};
    };
    if (!std::filesystem::is_regular_file(path))
        return failure("there is no such file");

    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = nullptr;
    {
        const MemoryLimit limit;
        scene = importer.ReadFile(path, aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                                            aiProcess_PreTransformVertices | aiProcess_SortByPType |
                                            aiProcess_JoinIdenticalVertices);
    }
    const std::string problem = importer.GetErrorString();
    if (scene == nullptr)
        return failure(problem == "std::bad_alloc" ? "it needs more memory than it may have" : problem);

    Model model;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
    {
        if (scene->mMeshes[i]->HasNormals())
            addMesh(model, *scene->mMeshes[i]);
    }
    if (model.empty())
        return failure("it holds no triangles");
    standOnGround(model, height, width);
    return model;
}

} // namespace lvsm::support
