// Images of depths whose splits are placed.
#ifndef LVSM_SAMPLING_PLACING_IMAGES_HPP
#define LVSM_SAMPLING_PLACING_IMAGES_HPP

#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <functional>

namespace sampling
{

// The map is a rectangle of its texture that no group fills.
constexpr int kTexture = 128;
const lvsm::Rectangle kMap{5, 9, 107, 83};
constexpr float kFar = 8;

// What lies in the map, row by row, and a texture with it, whose other texels no pass may read.
struct Depths
{
    std::vector<float> values;
    Pixels pixels{kTexture, kTexture};

    explicit Depths(const std::function<float(int, int)>& depth);
};

// Ground that slopes, boards over it, leaves far above both, all moved by a time.
float tree(int x, int y, float time);

// The same depths as a reversed depth buffer has them, but for its rounding.
Depths projectedTree();

// One of them is noise.
constexpr std::size_t kNoise = 3;
std::vector<Depths> stillImages();

} // namespace sampling

#endif
