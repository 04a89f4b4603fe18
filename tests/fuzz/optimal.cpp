// optimalSplits and optimalSplitsHistogram: valid splits with no layer too short, or the reason why not.
#include <lvsm/optimal.hpp>

#include "bytes.hpp"

#include <algorithm>

namespace
{

using namespace lvsm;
using namespace lvsm::fuzz;

template <typename T>
void check(const OptimalResult<T>& result, const OptimalOptions<T>& options, int bins, const std::vector<T>& before,
           const std::vector<T>& splits)
{
    const int layers = static_cast<int>(splits.size()) - 1;
    LVSM_CLAIM(std::strlen(describe(result.status)) > 10);
    if (result.status != OptimalStatus::Optimal)
    {
        LVSM_CLAIM(areAlike(before, splits));
        return;
    }
    LVSM_CLAIM(areSplits(splits));
    LVSM_CLAIM(result.distortion >= T(0) && result.distortion <= T(0.25));
    // Half of the least cell, in whole bins, but for the rounding of two splits.
    const int cells = std::min(layers, bins);
    const double least = options.minLength > T(0) ? std::min(static_cast<double>(options.minLength), 1.0) : 0.0;
    const int leastBins = std::clamp(static_cast<int>(least * bins), 1, bins / cells);
    for (std::size_t i = 0; i < static_cast<std::size_t>(cells); ++i)
        LVSM_CLAIM(static_cast<double>(splits[i + 1] - splits[i]) >= 0.5 * leastBins / bins - 1.2e-7);
}

template <typename T>
void place(Bytes& bytes)
{
    const int layers = bytes.between(0, 18);
    OptimalOptions<T> options;
    options.uniformShare = bytes.number<T>();
    options.minLength = bytes.number<T>();
    options.leastGain = bytes.number<T>();
    options.maxSamples = bytes.between(-1, 300);
    const std::vector<T> before = bytes.numbers<T>(layers + 1);
    std::vector<T> splits = before;
    if (bytes.between(0, 1) == 0)
    {
        const int width = bytes.between(0, 130);
        const int height = bytes.between(0, 6);
        const std::vector<T> image = bytes.numbers<T>(width * height);
        const auto result = optimalSplits(image.data(), width, height, splits.data(), layers, options);
        check(result, options, kMaxOptimalBins, before, splits);
    }
    else
    {
        const int bins = bytes.between(0, 1030);
        const std::vector<T> weights = bytes.numbers<T>(bins);
        const auto result = optimalSplitsHistogram(weights.data(), bins, splits.data(), layers, options);
        check(result, options, bins, before, splits);
    }
}

} // namespace

LVSM_FUZZ(place)
