// What every sampling wrapper has to answer, by its definition and the library's C++ functions on the same texels.
#ifndef LVSM_SAMPLING_WRAPPERS_TRUTH_HPP
#define LVSM_SAMPLING_WRAPPERS_TRUTH_HPP

#include "checks.hpp"

#include <lvsm/lvsm.hpp>

namespace sampling
{

constexpr int kSize = 8;
// Of one receiver, in the order of kernels/wrappers.glsl.
constexpr int kResults = 21;
constexpr int kLayers = 4;
constexpr double kExponent = 20.0;

// exponent, threshold: of ESM.
struct Receiver
{
    glm::dvec2 uv;
    double depth;
    int level = 0;
    double exponent = kExponent;
    double threshold = 0.02;

    // What a kernel reads for it: two vectors.
    glm::vec4 place() const { return {uv, depth, std::ldexp(1.0, level) / kSize}; }
    glm::vec4 settings() const { return {exponent, threshold, 0, 0}; }
};

struct Maps
{
    Pixels depths{kSize, kSize, 1, 2};
    Pixels layers{kSize, kSize, kLayers / 2, 2};
    Pixels terms{kSize, kSize, 1, 2};
    // The terms under a box of 3 x 3.
    Pixels blurred{kSize, kSize, 1, 2};
};

Maps makeMaps();

// All over the map and around it.
std::vector<Receiver> makeReceivers();

// From three texels inside the map to three outside, in 16ths of a texel: over each edge, and over two corners.
std::vector<Receiver> makeWalk();

bool compareWrappers(const Maps& maps, const std::vector<Receiver>& receivers, const std::vector<float>& results);

} // namespace sampling

#endif
