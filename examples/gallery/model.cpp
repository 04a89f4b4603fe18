#include "model.hpp"

#include "model_file.hpp"

namespace lvsm::gallery
{

support::Result<Mesh> loadModel(const std::string& path, float height, float width)
{
    constexpr glm::vec3 kColour{0.72f, 0.68f, 0.62f};
    const auto model = support::loadModel(path, height, width);
    if (!model)
        return support::Failure{model.error()};
    Mesh mesh;
    for (const support::ModelTriangle& triangle : *model)
        addTriangle(mesh, triangle.corners, triangle.normals, kColour);
    return mesh;
}

} // namespace lvsm::gallery
