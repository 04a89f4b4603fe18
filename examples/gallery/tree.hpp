#ifndef LVSM_GALLERY_TREE_HPP
#define LVSM_GALLERY_TREE_HPP

#include "mesh.hpp"

namespace lvsm::gallery
{

/// A leafy tree with its trunk's foot at `foot`; a seed always grows the same one.
void addTree(Mesh& mesh, glm::vec3 foot, unsigned seed);

} // namespace lvsm::gallery

#endif
