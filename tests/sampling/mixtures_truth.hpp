// What the mixture passes have to make, from their definition: by the library's C++ functions in double precision, round
// by round over a whole map, and by brute force from the weights of a window.
#ifndef LVSM_SAMPLING_MIXTURES_TRUTH_HPP
#define LVSM_SAMPLING_MIXTURES_TRUTH_HPP

#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <array>
#include <functional>

namespace sampling
{

using Packed = std::array<std::uint32_t, 4>;

// What a map is made of, and how.
struct MixtureCase
{
    std::string name;
    int count;
    int width;
    bool half;
    Shape depths{29, 23};
    lvsm::Rectangle map{0, 0, 29, 23};
    lvsm::Rectangle region{0, 0, 29, 23};
    int slice = 0;
    // Of the window, in place of the width.
    float deviation = 0;

    Shape coded() const;
    lvsm::MixtureWindow window() const;
};

using DepthOf = std::function<float(int, int)>;

// A field of a packed component, and how many of its levels are between two.
struct PackedField
{
    const char* name;
    int word;
    int begin;
    int bits;
};
extern const std::array<PackedField, 10> kPackedFields;
std::uint32_t fieldOf(const Packed& packed, const PackedField& field);
lvsm::MixtureComponent<double> unpacked(const Packed& packed);

// A texel of a map of mixtures.
struct TrueMixture
{
    std::array<Packed, 4> packed{};
    // A decision on the way to it was so close that rounding may decide otherwise.
    bool isTied = false;
};

// Over a rectangle of the codes, which may reach off the map.
struct Mixtures
{
    lvsm::Rectangle area;
    std::vector<TrueMixture> texels;

    explicit Mixtures(const lvsm::Rectangle& area);
    TrueMixture& at(int x, int y);
};

// What the depths begin with.
Mixtures depthMixtures(const MixtureCase& test, const lvsm::Rectangle& area, const DepthOf& depth);
// One direction of a round, over what is left of their area.
Mixtures mixed(const MixtureCase& test, Mixtures& from, int stepX, int stepY, double share);
// What a dispatch makes of them, over what is left of their area.
Mixtures mixedTwice(const MixtureCase& test, const Mixtures& from, const lvsm::MixingBlock& block);
glm::uvec4 trueCode(const MixtureCase& test, const TrueMixture& mixture);

// Depths that decide: any, all far from equal; and slanted ground under bars of two heights.
float noiseDepth(int x, int y);
float barDepth(int x, int y);

// All texels without a near tie, component by component: how many, and how many of them are the same to the bit.
std::pair<std::size_t, std::size_t> compareComponents(Comparison& comparison, const Mixtures& made,
                                                      const Mixtures& expected, int count);
// Each field within so many levels. Result: whether all bits are the same.
bool compareCode(Comparison& comparison, int count, const Packed& made, const glm::uvec4& expected, double tolerance,
                 const std::string& where);

// Weights of a window along an axis, from the first texel of the depths that it reaches to the last.
std::vector<double> windowWeights(const lvsm::MixtureWindow& window);

// Maps of codes, and who asks them.
struct MixtureMaps
{
    Shape shape{8, 12, 2};
    std::vector<glm::uvec2> two;
    std::vector<glm::uvec4> four;
};

struct MixtureReceiver
{
    glm::dvec2 uv;
    double depth;
    double texels;
    glm::dvec2 gradient;
    double deviation;
    int slice;

    // What a kernel reads for it: two vectors.
    glm::vec4 place() const { return {uv, depth, texels}; }
    glm::vec4 plane() const { return {gradient, deviation, slice}; }
};

// Any bits, of which some no encoder writes.
MixtureMaps randomCodes();
std::vector<MixtureReceiver> mixtureReceivers();
// results: of two and four planes, from the whole map and from the middle half of it.
bool compareMixtureWrappers(const MixtureMaps& maps, const std::vector<MixtureReceiver>& receivers,
                            const std::vector<glm::vec4>& results);

} // namespace sampling

#endif
