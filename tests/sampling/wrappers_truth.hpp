// What every sampling wrapper has to answer, by its definition and the library's C++ functions on the same texels.
#ifndef LVSM_SAMPLING_WRAPPERS_TRUTH_HPP
#define LVSM_SAMPLING_WRAPPERS_TRUTH_HPP

#include "checks.hpp"

#include <lvsm/lvsm.hpp>

namespace sampling
{

constexpr int kSize = 8;
// Of one receiver, in the order of kernels/wrappers.glsl.
constexpr int kResults = 51;
constexpr int kInputs = 4;
constexpr int kLayers = 4;
constexpr double kExponent = 20.0;
constexpr float kSplits[] = {0.0f, 0.25f, 0.5f, 0.75f, 1.0f};

// Where the maps begin in the array, as kernels/wrappers.glsl has it.
enum Slice
{
    kDepths = 0,
    kOverlapping = 1,
    kTerms = 3,
    kVariance = 4,
    kExponential = 5,
    kMoments4 = 6,
    kEncoded4 = 7,
    kLayered4 = 8,
    kTrigonometric = 12,
    kContiguous = 13,
    kCompact = 15,
    kQuantised = 17,
    kPacked = 19,
    kTwoLayers = 20,
    kFourier = 21,
    kSliceCount = 25
};

constexpr int kFourierOrder = 6;
constexpr double kMomentBias = 0.001;

// exponent, threshold, offset: of ESM. direction, tangent: of a cube's face.
struct Receiver
{
    glm::dvec2 uv;
    double depth;
    int level = 0;
    double exponent = kExponent;
    double threshold = 0.02;
    double offset = 0.05;
    glm::vec3 direction = {1, 0, 0};
    float tangent = 1;
};

// A rectangle of each slice that has the map: all of it, or what Atlas says.
struct Place
{
    int x = 0;
    int y = 0;
    int width = kSize;
    int height = kSize;

    glm::vec4 rectangle() const;
};

constexpr Place kAlone{};
constexpr Place kInAtlas{8, 4, 4 * kSize, 2 * kSize};

// What a kernel reads for a receiver: kInputs vectors.
std::vector<glm::vec4> inputsOf(const Receiver& receiver, const Place& place);

struct Maps
{
    Pixels map{kSize, kSize, 1, 2};
    // kTerms is blurred by a box of 3 x 3 in the first, and as stored in the second.
    Pixels slices{kSize, kSize, kSliceCount, 2};
    Pixels unfiltered{kSize, kSize, kSliceCount, 2};
    // Depths in kTerms. Level 1 is none of the greatest of level 0, so that both count.
    Pixels greatest{kSize, kSize, kSliceCount, 2};
};

Maps makeMaps();

// The slices as a rectangle of larger ones, with what no wrapper may read around it.
Pixels placed(const Pixels& slices, const Place& place);

// All over the map and around it.
std::vector<Receiver> makeReceivers();

// From three texels inside the map to three outside, in 16ths of a texel: over each edge, and over two corners.
std::vector<Receiver> makeWalk();

// A cube map at slice 5, of two slices a face, whose texels hold a smooth function of their direction and reach three
// texels beyond the face; and the same function at a receiver's direction.
Pixels makeCube();
float tangentOfCube();
bool compareCube(const std::vector<Receiver>& receivers, const std::vector<float>& results);

// components: how many the maps have, see kernels/wrappers.hlsl; what needs more is not compared.
bool compareWrappers(const Maps& maps, const std::vector<Receiver>& receivers, const std::vector<float>& results,
                     int components = 4);

// For the two halves of compareWrappers: a texel, or border off the map; filtered among four; four first components.
glm::dvec4 texelOrBorder(const Pixels& map, int x, int y, int slice, int level, glm::dvec4 border);
glm::dvec4 filteredTexel(const Pixels& map, const Receiver& receiver, int slice, glm::dvec4 border);
glm::dvec4 gatheredTexels(const Pixels& map, glm::dvec2 uv, int slice, double border);
glm::dvec2 cornerOf(glm::dvec2 uv);
bool compareTechniques(const Maps& maps, const std::vector<Receiver>& receivers, const std::vector<float>& results,
                       int components);

} // namespace sampling

#endif
