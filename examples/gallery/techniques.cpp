// The table of techniques: how each is stored, how it is read, and with what settings.
#include "techniques.hpp"

#include <lvsm/lvsm.hpp>

namespace lvsm::gallery
{
namespace
{

using Format = vk::Format;

const Storage kR32f{Format::eR32Sfloat, "r32f", "one 32-bit float", 32, kDepthErrorFp32<float>, "LVSM_LARGEST_FP32"};
const Storage kRg32f{Format::eR32G32Sfloat, "rg32f", "two 32-bit floats", 64, kDepthErrorFp32<float>,
                     "LVSM_LARGEST_FP32"};
const Storage kRgba32f{Format::eR32G32B32A32Sfloat, "rgba32f",          "four 32-bit floats", 128,
                       kDepthErrorFp32<float>,      "LVSM_LARGEST_FP32"};
const Storage kRgba16f{Format::eR16G16B16A16Sfloat, "rgba16f",          "four 16-bit floats", 64,
                       kDepthErrorFp16<float>,      "LVSM_LARGEST_FP16"};
const Storage kRg16{Format::eR16G16Unorm, "rg16", "two 16-bit fixed point", 32, kDepthErrorUnorm16<float>, "1.0"};
const Storage kRgba16{Format::eR16G16B16A16Unorm, "rgba16", "four 16-bit fixed point", 64,
                      kDepthErrorUnorm16<float>,  "1.0"};
const Storage kRgba8{Format::eR8G8B8A8Unorm, "rgba8", "four 8-bit fixed point", 32, kDepthErrorUnorm8<float>, "1.0"};
const Storage kRg32ui{Format::eR32G32Uint, "rg32ui", "a code of 64 bits", 64, 0.0f, ""};
const Storage kRgba32ui{Format::eR32G32B32A32Uint, "rgba32ui", "a code of 128 bits", 128, 0.0f, ""};

constexpr float kGaussianDeviation = 1.4142136f; // that of the binomial blur of 9 taps
const Window kBlur{"blur", 4, 0, 0, {70.0f / 256, 56.0f / 256, 28.0f / 256, 8.0f / 256, 1.0f / 256}};
const Window kBilinear{"2x2", 1, 1, 0, {}};
const Window kBox3{"3x3", 2, 3, 0, {}};
const Window kGauss3{"3x3-gauss", 2, 3, 1, {}};
const Window kGauss9{"9x9-gauss", 5, 9, kGaussianDeviation, {}};
// The mixtures' tree of steps 1 and 2, which passes/mixture makes for 7 texels.
const Window kTree7{"tree", 3, 0, 0, {4.0f / 16, 3.0f / 16, 2.0f / 16, 1.0f / 16}};

constexpr int kTerms = 16;
const glm::vec2 kExponents{43.3f, 10.0f};
constexpr float kEsmExponent = 80.0f;

const char* const kDepth = "vec4(depth, 0.0, 0.0, 0.0)";
const char* const kMoments = "vec4(lvsm_depthMoments(depth), 0.0, 0.0)";
const char* const kWarped = "lvsm_exponentialMoments(depth, vec2(43.3, 10.0))";
const char* const kTerm = "vec4(lvsm_occluderTerm(depth, 80.0), 0.0, 0.0, 0.0)";
const char* const kFourier = "lvsm_encodeFourier((slice & 1) == 0 ? lvsm_fourierSines(depth, 2 * slice + 1, 16)"
                             " : lvsm_fourierCosines(depth, 2 * slice - 1, 16))";
const char* const kHamburger = "lvsm_encodeMoments4(lvsm_depthMoments4(depth))";
const char* const kHamburgers = "lvsm_encodeMoments4(lvsm_layerMoments4(depth, vec2(lvsm_splits[slice / 4][slice % 4],"
                                " lvsm_splits[(slice + 1) / 4][(slice + 1) % 4])))";
const char* const kCircle = "lvsm_trigonometricMoments(depth)";
const char* const kLayers = "";

const char* const kVariance = "lvsm_sampleVariance(map, at, depth, MIN_VARIANCE)";
const char* const kLayered = "lvsm_sampleLayers(map, at, depth, splits, lvsm_layerCount, lvsm_overlap, transition,"
                             " MIN_VARIANCE)";
const char* const kBracketed = "lvsm_sampleBracketed(map, at, depth, splits, lvsm_layerCount, false, MIN_VARIANCE)";
const char* const kPlane = "lvsm_samplePlane(map, at, depth, gradient, splits, lvsm_layerCount, false, 1.4142136,"
                           " MIN_VARIANCE, 0.15)";
// A lit plane's own depths, five texels away, are no failure.
const char* const kZMax = "lvsm_sampleEsmZMax(map, unfiltered, greatest, at, depth, 80.0,"
                          " 2.0 * bias + 5.0 * (abs(gradient.x) + abs(gradient.y)))";

const std::vector<glm::vec4> kOnes{glm::vec4(1.0f)};

// Depth 1 in each slice of a convolution map.
std::vector<glm::vec4> fourierBorder()
{
    std::vector<glm::vec4> border;
    for (int first = 1; first <= kTerms; first += 4)
    {
        border.push_back(encodeFourier(fourierSines(1.0f, first, kTerms)));
        border.push_back(encodeFourier(fourierCosines(1.0f, first, kTerms)));
    }
    return border;
}

std::vector<Technique> table()
{
    const Layers none;
    const auto relaxed = [](int count)
    {
        return Layers{count, Placing::Relaxed, 0.01f, 0.01f};
    };
    const auto placed = [](Placing placing)
    {
        return Layers{4, placing, 0.01f, 0.01f};
    };
    const auto apart = [](int count)
    {
        return Layers{count, Placing::Relaxed, 0.0f, 0.0f};
    };
    const std::vector<glm::vec4> warped{exponentialMoments(1.0f, kExponents)};
    const std::vector<glm::vec4> term{glm::vec4(occluderTerm(1.0f, kEsmExponent))};
    const std::vector<glm::vec4> hamburger{encodeMoments4(depthMoments4(1.0f))};
    const std::vector<glm::vec4> circle{trigonometricMoments(1.0f)};
    constexpr auto stored = Making::Stored;
    constexpr auto blurred = Making::Blurred;
    return {
        {"basic", "Shadow map", "One comparison with the nearest texel: hard and jagged edges.", &kR32f, 1, stored,
         kDepth, "lvsm_stepWarp(lvsm_fetchSlice(map, at, 0, floor(at.uv * size)).x, depth - 4.0 * bias)", &kBlur, kOnes,
         none, true},
        {"pcf2", "PCF 2 &times; 2", "The four nearest texels are compared, and the results are interpolated.", &kR32f,
         1, stored, kDepth, "lvsm_samplePcf(map, at, depth, gradient, 1.0, 0.0, 0.0)", &kBilinear, kOnes, none, false},
        {"pcf3", "PCF 3 &times; 3", "A box of three texels, each compared with the receiver's plane.", &kR32f, 1,
         stored, kDepth, "lvsm_samplePcf(map, at, depth, gradient, 3.0, 0.0, 0.0)", &kBox3, kOnes, none, false},
        {"pcf3-gauss", "PCF 3 &times; 3, Gaussian", "The same with the middle weighing more.", &kR32f, 1, stored,
         kDepth, "lvsm_samplePcf(map, at, depth, gradient, 3.0, 1.0, 0.0)", &kGauss3, kOnes, none, false},
        {"pcf9-gauss", "PCF 9 &times; 9, Gaussian", "As soft as the blurred maps, for a hundred comparisons a pixel.",
         &kR32f, 1, stored, kDepth, "lvsm_samplePcf(map, at, depth, gradient, 9.0, 1.4142136, 0.0)", &kGauss9, kOnes,
         none, true},
        {"vsm", "VSM", "Chebyshev's bound from two moments: soft, but too light where shadows overlap.", &kRg32f, 1,
         blurred, kMoments, kVariance, &kBlur, kOnes, none, true},
        {"vsm-reduced", "VSM, bleeding reduced",
         "What is darker than 0.3 is cut away, from bleeding and from soft edges.", &kRg32f, 1, blurred, kMoments,
         "lvsm_reduceLightBleeding(lvsm_sampleVariance(map, at, depth, MIN_VARIANCE), 0.3)", &kBlur, kOnes, none,
         false},
        {"lvsm2", "LVSM-2", "Two layers of two moments; a surface reads the layer that it lies in.", &kRgba16, 1,
         blurred, kLayers, kLayered, &kBlur, kOnes, relaxed(2), true},
        {"lvsm4-uniform", "LVSM-4, uniform", "Four layers of one length.", &kRgba16, 2, blurred, kLayers, kLayered,
         &kBlur, kOnes, placed(Placing::Uniform), false},
        {"lvsm4-manual", "LVSM-4, by hand", "Four layers, parted where a person would.", &kRgba16, 2, blurred, kLayers,
         kLayered, &kBlur, kOnes, placed(Placing::Manual), false},
        {"lvsm4", "LVSM-4", "Four layers in twice the storage; a surface still reads one, near a split two.", &kRgba16,
         2, blurred, kLayers, kLayered, &kBlur, kOnes, relaxed(4), true},
        {"lvsm4-view", "LVSM-4, placed in view", "Four layers where what is on the screen needs them.", &kRgba16, 2,
         blurred, kLayers, kLayered, &kBlur, kOnes, placed(Placing::InView), true},
        {"lvsm4-optimal", "LVSM-4, optimal", "Four layers of least spread.", &kRgba16, 2, blurred, kLayers, kLayered,
         &kBlur, kOnes, placed(Placing::Optimal), false},
        {"lvsm4-apart", "LVSM-4, no overlap", "Relaxed layers that end at their splits: seams may show there.",
         &kRgba16, 2, blurred, kLayers, kLayered, &kBlur, kOnes, apart(4), false},
        {"lvsm8", "LVSM-8", "Eight layers.", &kRgba16, 4, blurred, kLayers, kLayered, &kBlur, kOnes, relaxed(8), false},
        {"lvsm4-bracketed", "LVSM-4, bracketed", "A layer is judged with what its two neighbours know: two samples.",
         &kRgba16, 2, blurred, kLayers, kBracketed, &kBlur, kOnes, apart(4), true},
        {"lvsm4-plane", "LVSM-4, relative to the plane", "Bracketed layers, judged by the receiver's own plane.",
         &kRgba16, 2, blurred, kLayers, kPlane, &kBlur, kOnes, apart(4), true},
        {"evsm2", "EVSM2", "Chebyshev's bound of an exponential warp.", &kRg32f, 1, blurred, kWarped,
         "lvsm_sampleExponential2(map, at, depth, 43.3, MIN_VARIANCE)", &kBlur, warped, none, false},
        {"evsm4", "EVSM4", "The lesser of the bounds from a positive and a negative exponential warp.", &kRgba32f, 1,
         blurred, kWarped, "lvsm_sampleExponential4(map, at, depth, vec2(43.3, 10.0), MIN_VARIANCE)", &kBlur, warped,
         none, true},
        {"esm", "ESM", "One exponential term, and four comparisons where the result is seen to exceed 1.", &kR32f, 1,
         Making::BlurredBeside, kTerm, "lvsm_sampleEsm(map, unfiltered, at, depth, 80.0, 0.02)", &kBlur, term, none,
         true},
        {"esm-zmax", "ESM, Z-Max", "Four comparisons wherever a map of greatest depths has one beyond the receiver.",
         &kR32f, 1, Making::BlurredWithGreatest, kTerm, kZMax, &kBlur, term, none, false},
        {"csm", "CSM-16", "The step as a Fourier series of sixteen terms.", &kRgba8, 8, blurred, kFourier,
         "lvsm_sampleConvolution(map, at, depth, 16, lvsm_fourierOffset(16), 0.0, 1.0)", &kBlur, fourierBorder(), none,
         true},
        {"msm4", "MSM4", "Four moments and the sharpest bound that they allow.", &kRgba16, 1, blurred, kHamburger,
         "lvsm_sampleMoments4(map, at, depth, true, LVSM_MOMENT4_BIAS_UNORM16)", &kBlur, hamburger, none, true},
        {"msm4-layers", "MSM4 in four layers", "Four moments for each of four layers.", &kRgba16, 4, blurred,
         kHamburgers,
         "lvsm_sampleLayeredMoments4(map, at, depth, splits, lvsm_layerCount, true, LVSM_MOMENT4_BIAS_UNORM16)", &kBlur,
         hamburger, apart(4), false},
        {"trigonometric", "Trigonometric moments", "Two harmonics in place of four powers.", &kRgba16, 1, blurred,
         kCircle, "lvsm_sampleTrigonometric(map, at, depth, 1.2e-4)", &kBlur, circle, none, false},
        {"mixture2", "Mixture of two planes", "What lies under the filter as two planes: an estimate and no bound.",
         &kRg32ui, 1, Making::Mixed, "", "lvsm_sampleMixture2(map, at, depth, gradient, 1.0, 1.5811388)", &kTree7,
         kOnes, none, false},
        {"mixture4", "Mixture of four planes", "The same with four.", &kRgba32ui, 1, Making::Mixed, "",
         "lvsm_sampleMixture4(map, at, depth, gradient, 1.0, 1.5811388)", &kTree7, kOnes, none, true},
    };
}

std::vector<Technique> completed(std::vector<Technique> all)
{
    for (Technique& technique : all)
    {
        technique.layerCount = technique.layers.count;
        technique.bits = technique.slices * technique.texel->bits;
        technique.storage = technique.slices > 1 ? std::to_string(technique.slices) + " &times; " : "";
        technique.storage += technique.texel->words;
    }
    return all;
}

} // namespace

const Window& blurWindow()
{
    return kBlur;
}

const std::vector<Technique>& techniques()
{
    static const std::vector<Technique> all = completed(table());
    return all;
}

} // namespace lvsm::gallery
