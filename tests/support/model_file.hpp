#ifndef LVSM_TESTS_SUPPORT_MODEL_FILE_HPP
#define LVSM_TESTS_SUPPORT_MODEL_FILE_HPP

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "result.hpp"

namespace lvsm::support
{

struct ModelTriangle
{
    glm::vec3 corners[3];
    glm::vec3 normals[3];
};

/// Reads any file that Assimp reads and stands the model on the ground at the origin, as large as fits a height and a
/// width; y is up. Triangles that are not finite or
/// have no area are left out.
Result<std::vector<ModelTriangle>> loadModel(const std::string& path, float height, float width);

} // namespace lvsm::support

#endif
