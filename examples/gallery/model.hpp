#ifndef LVSM_GALLERY_MODEL_HPP
#define LVSM_GALLERY_MODEL_HPP

#include <string>

#include "mesh.hpp"
#include "result.hpp"

namespace lvsm::gallery
{

/// Reads a model with Assimp and stands it on the ground at the origin, within the given height and width.
support::Result<Mesh> loadModel(const std::string& path, float height, float width);

} // namespace lvsm::gallery

#endif
