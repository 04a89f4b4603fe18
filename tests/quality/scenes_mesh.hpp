// Depth peels of real shapes, with slopes and contact: the scenes that count.
#ifndef LVSM_TESTS_QUALITY_SCENES_MESH_HPP
#define LVSM_TESTS_QUALITY_SCENES_MESH_HPP

#include <string>
#include <vector>

#include "models.hpp"
#include "peel.hpp"

namespace lvsm::quality
{

/// Names of the worlds: each is seen from every light of lightNames, as the scene WORLD-LIGHT.
const std::vector<std::string>& worldNames();
const std::vector<std::string>& lightNames();

/// A world made from Debian's models or on the spot; the reason, if a model cannot be read.
support::Result<Mesh> world(const std::string& name, unsigned seed);

/// The user's own model, beside a fence.
support::Result<Mesh> modelWorld(const std::string& path);

/// A light of lightNames on a mesh, turned by so many degrees around the vertical.
Light meshLight(const Mesh& mesh, const std::string& lightName, int size, float turned = 0.0f);

Scene meshScene(const std::string& worldName, const Mesh& mesh, const std::string& lightName, int size);

} // namespace lvsm::quality

#endif
