// The host functions for WebAssembly: what lvsm.mjs.in calls. It keeps the memory: images lie where it put them.
#include <lvsm/lloyd.hpp>
#include <lvsm/optimal.hpp>

#define LVSM_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace
{

// The options of the next call, in the order of the struct's members; afterwards its figures.
double values[8];
const char* message = "";

} // namespace

LVSM_EXPORT(values) double* exportedValues()
{
    return values;
}

LVSM_EXPORT(message) const char* exportedMessage()
{
    return message;
}

LVSM_EXPORT(version) int version()
{
    return LVSM_VERSION;
}

LVSM_EXPORT(lloydDefaults) void lloydDefaults()
{
    const lvsm::RelaxOptions<float> options;
    values[0] = options.maxIterations;
    values[1] = static_cast<double>(options.tolerance);
    values[2] = static_cast<double>(options.minVariance);
    values[3] = static_cast<double>(options.maxVariance);
    values[4] = options.splitsPerIteration;
    values[5] = options.keepSplits ? 1.0 : 0.0;
    values[6] = options.maxSamples;
}

LVSM_EXPORT(lloydRelax) bool lloydRelax(const float* depths, int width, int height, float* splits, int layerCount)
{
    lvsm::RelaxOptions<float> options;
    options.maxIterations = static_cast<int>(values[0]);
    options.tolerance = static_cast<float>(values[1]);
    options.minVariance = static_cast<float>(values[2]);
    options.maxVariance = static_cast<float>(values[3]);
    options.splitsPerIteration = static_cast<int>(values[4]);
    options.keepSplits = values[5] != 0.0;
    options.maxSamples = static_cast<int>(values[6]);
    const auto result = lvsm::lloydRelax(depths, width, height, splits, layerCount, options);
    values[0] = result.iterations;
    values[1] = static_cast<double>(result.movement);
    message = lvsm::describe(result.status);
    return static_cast<bool>(result);
}

LVSM_EXPORT(optimalDefaults) void optimalDefaults()
{
    const lvsm::OptimalOptions<float> options;
    values[0] = static_cast<double>(options.uniformShare);
    values[1] = static_cast<double>(options.minLength);
    values[2] = static_cast<double>(options.leastGain);
    values[3] = options.maxSamples;
}

LVSM_EXPORT(optimalSplits) bool optimalSplits(const float* depths, int width, int height, float* splits, int layerCount)
{
    lvsm::OptimalOptions<float> options;
    options.uniformShare = static_cast<float>(values[0]);
    options.minLength = static_cast<float>(values[1]);
    options.leastGain = static_cast<float>(values[2]);
    options.maxSamples = static_cast<int>(values[3]);
    const auto result = lvsm::optimalSplits(depths, width, height, splits, layerCount, options);
    values[0] = static_cast<double>(result.distortion);
    message = lvsm::describe(result.status);
    return static_cast<bool>(result);
}
