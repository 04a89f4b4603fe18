// The techniques whose times are measured, in terms of the library's passes and wrappers.
#include "frame.hpp"

namespace lvsm::papers
{
namespace
{

std::string storing(const std::string& texel, const std::string& largest)
{
    return "#define LVSM_STORE(depth, slice) " + texel + "\n#define LVSM_STORE_LARGEST " + largest + "\n";
}

} // namespace

Way vsm()
{
    return {vk::Format::eR32G32Sfloat,
            "rg32f",
            1,
            0,
            storing("vec4(lvsm_depthMoments(depth), 0.0, 0.0)", "1.0"),
            "lvsm_sampleVariance(map, at, depth, LVSM_MIN_VARIANCE)"};
}

Way vsmNineSamples()
{
    Way way = vsm();
    way.visibility = "nineSamples(at, depth)";
    return way;
}

Way lvsm(int layers, bool transitions)
{
    const std::string n = std::to_string(layers);
    return {vk::Format::eR16G16B16A16Unorm,
            "rgba16",
            (layers + 1) / 2,
            layers,
            "#define LVSM_MAX_LAYERS " + n + "\n",
            transitions ? "lvsm_sampleLayers(map, at, depth, splits, " + n + ", 0.01, 0.01, 1e-5)"
                        : "oneLayer(at, depth, " + n + ")"};
}

Way evsm4()
{
    return {vk::Format::eR32G32B32A32Sfloat,
            "rgba32f",
            1,
            0,
            storing("lvsm_exponentialMoments(depth, vec2(42.0, 42.0))", "LVSM_LARGEST_FP32"),
            "lvsm_sampleExponential4(map, at, depth, vec2(42.0, 42.0), LVSM_MIN_VARIANCE)"};
}

Way csm(int terms)
{
    const std::string m = std::to_string(terms);
    return {vk::Format::eR8G8B8A8Unorm,
            "rgba8",
            terms / 2,
            0,
            storing("(slice % 2 == 0 ? lvsm_encodeFourier(lvsm_fourierSines(depth, 2 * slice + 1, " + m +
                        ")) : lvsm_encodeFourier(lvsm_fourierCosines(depth, 2 * slice - 1, " + m + ")))",
                    "1.0"),
            "lvsm_sampleConvolution(map, at, depth, " + m + ", lvsm_fourierOffset(" + m + "), 1.0, 1.0)"};
}

Way esm(bool byZMax)
{
    Way way{vk::Format::eR32Sfloat,
            "r32f",
            1,
            0,
            storing("vec4(lvsm_occluderTerm(depth, 80.0))", "LVSM_LARGEST_FP32"),
            byZMax ? "esmByZMax(at, depth)" : "lvsm_sampleEsm(map, unfiltered, at, depth, 80.0, 0.02)"};
    way.keepsUnfiltered = true;
    way.keepsGreatest = byZMax;
    return way;
}

Way ofDepths(const std::string& visibility)
{
    return {vk::Format::eR32Sfloat, "r32f", 1, 0, "-", visibility};
}

} // namespace lvsm::papers
