// What the ready passes have to make, by its definition and the library's C++ functions.
#ifndef LVSM_SAMPLING_PASSES_TRUTH_HPP
#define LVSM_SAMPLING_PASSES_TRUTH_HPP

#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <functional>

namespace sampling
{

constexpr int kWidth = 29;
constexpr int kHeight = 23;
constexpr int kSlices = 2;

const lvsm::Rectangle kWhole{0, 0, kWidth, kHeight};
const glm::vec4 kBorder(1, 2, 3, 4);

Pixels randomPixels(int slices);

struct Blur
{
    lvsm::BlurKernel kernel;
    // Of each tap.
    std::function<double(int)> weight;
    lvsm::Rectangle map = kWhole;
    lvsm::Rectangle region = kWhole;
    // The largest of the taps in place of their weighted sum.
    bool maximum = false;

    lvsm::BlurPasses passes() const { return lvsm::blurPasses(kernel, map, region, kBorder, 0, kSlices); }
};

Blur binomialBlur();
Blur gaussianBlur();
// A box of fractional width, whose fetches are not paired.
Blur boxBlur();
// The largest of 5 x 5 texels, in a rectangle of an atlas.
Blur largestOfPart();
// A rectangle of an atlas, and of that a part which has changed.
Blur blurOfPart();

// bits: of the sampler's position between texels. The target was 0 before.
bool compareBlur(const std::string& what, const Blur& blur, const Pixels& source, const Pixels& target, int bits);

// Lit ground, slanted by slope a texel, over the whole map and beyond: what an exponential and a layered map hold.
enum class Ground
{
    Exponential,
    Layered
};
Pixels groundMap(Ground ground, double slope);
glm::vec4 groundBorder(Ground ground);

// blurred: groundMap. Walks over both edges in 16ths of a texel: nowhere is the ground darker than in the middle.
bool compareGround(const std::string& what, Ground ground, double slope, const Pixels& blurred);

// A technique as the store pass is told of it, with the exact result for a depth and a slice.
struct Store
{
    std::string macros;
    std::function<glm::dvec4(double, int)> texel;
};

Store layersStore();
Store exponentialStore(bool hlsl);

lvsm::Pass<lvsm::StoreBlock> storePassOfTest();
Pixels storeDepths();
bool compareStore(const std::string& what, const Store& store, const Pixels& depths, const Pixels& target);

} // namespace sampling

#endif
