#ifndef LVSM_EXAMPLES_PLACE_LAYERS_PLACEMENT_HPP
#define LVSM_EXAMPLES_PLACE_LAYERS_PLACEMENT_HPP

#include <optional>
#include <string>
#include <vector>

#include "depth_image.hpp"

namespace lvsm::place_layers
{

/// Side of the windows that errors are predicted for, in pixels.
constexpr int kWindow = 5;

/// Root mean square errors of visibility: of layeredVisibility, and of bracketedVisibility, which layers with an overlap
/// do not have.
struct Errors
{
    double layered = 0;
    std::optional<double> bracketed;
};

/// One way to place layers. splits: one more than layers, from 0 to 1; empty where the method has no room for so many.
struct Placement
{
    std::string method;
    std::vector<float> splits;
    Errors errors;
};

/// What is to be placed. weights: how much each pixel counts, or no values: all alike.
struct Task
{
    Image depths;
    Image weights;
    int layerCount = 0;
    float overlap = 0;

    double weightAt(int x, int y) const { return weights.values.empty() ? 1.0 : static_cast<double>(weights.at(x, y)); }
};

/// By all three methods: uniform, Lloyd's relaxation, and the splits of least spread.
std::vector<Placement> placeLayers(const Task& task);

} // namespace lvsm::place_layers

#endif
