#ifndef LVSM_EXAMPLES_PLACE_LAYERS_PLOT_HPP
#define LVSM_EXAMPLES_PLACE_LAYERS_PLOT_HPP

#include <string>

#include "report.hpp"

namespace lvsm::place_layers
{

/// The histogram of depths, the chosen splits through it, and below those of each method, as a PNG file's bytes.
std::string plot(const Report& report);

} // namespace lvsm::place_layers

#endif
