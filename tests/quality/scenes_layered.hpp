// Worlds of flat layers, which stress light bleeding and nothing else.
#ifndef LVSM_TESTS_QUALITY_SCENES_LAYERED_HPP
#define LVSM_TESTS_QUALITY_SCENES_LAYERED_HPP

#include <vector>

#include "peel.hpp"

namespace lvsm::quality
{

/// Names of the layered scenes.
const std::vector<std::string>& layeredSceneNames();

/// One of them. The draws are those of std::mt19937 with libstdc++'s uniform_real_distribution<float>.
Scene layeredScene(const std::string& name, int size, unsigned seed);

} // namespace lvsm::quality

#endif
