// lloydRelax and lloydRelaxMoments: valid splits, or the reason why not and the splits as they were.
#include <lvsm/lloyd.hpp>

#include "bytes.hpp"

#include <algorithm>

namespace
{

using namespace lvsm;
using namespace lvsm::fuzz;

template <typename T>
RelaxOptions<T> options(Bytes& bytes)
{
    RelaxOptions<T> options;
    options.maxIterations = bytes.between(-1, 100);
    options.tolerance = bytes.number<T>();
    options.minVariance = bytes.number<T>();
    options.maxVariance = bytes.number<T>();
    options.splitsPerIteration = bytes.between(0, 2);
    options.keepSplits = bytes.between(0, 1) == 1;
    options.maxSamples = bytes.between(-1, 300);
    return options;
}

template <typename T>
void check(const RelaxResult<T>& result, const RelaxOptions<T>& options, const std::vector<T>& before,
           const std::vector<T>& splits)
{
    LVSM_CLAIM(result ? areSplits(splits) : areAlike(before, splits));
    LVSM_CLAIM(result.iterations >= 0 && result.iterations <= std::max(options.maxIterations, 0));
    LVSM_CLAIM(result.movement >= T(0) && result.movement <= T(1));
    LVSM_CLAIM(std::strlen(describe(result.status)) > 10);
}

template <typename T>
void relax(Bytes& bytes)
{
    const int width = bytes.between(0, 130);
    const int height = bytes.between(0, 6);
    const int layers = bytes.between(0, 20);
    const RelaxOptions<T> chosen = options<T>(bytes);
    const std::vector<T> before = bytes.numbers<T>(layers + 1);
    const std::vector<T> image = bytes.numbers<T>(2 * width * height);
    std::vector<T> splits = before;
    check(lloydRelax(image.data(), width, height, splits.data(), layers, chosen), chosen, before, splits);

    std::vector<glm::vec<2, T>> moments;
    for (std::size_t i = 0; i + 1 < image.size(); i += 2)
        moments.emplace_back(image[i], image[i + 1]);
    splits = before;
    check(lloydRelaxMoments(moments.data(), width, height, splits.data(), layers, chosen), chosen, before, splits);
}

} // namespace

LVSM_FUZZ(relax)
