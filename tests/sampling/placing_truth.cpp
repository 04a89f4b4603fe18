#include "placing_truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sampling
{
namespace
{

constexpr double kTolerance = 1.0 / 4096;
constexpr int kMovingLayers = 4;
constexpr int kFrames = 16;

// The splits begin where the shaders have them.
static_assert(offsetof(lvsm::StoreBlock, splits) == 8 * sizeof(float));

lvsm::RelaxOptions<float> relaxOptions(bool isMoving)
{
    lvsm::RelaxOptions<float> options;
    options.keepSplits = isMoving;
    return options;
}

lvsm::OptimalOptions<float> optimalOptions(bool isMoving)
{
    lvsm::OptimalOptions<float> options;
    if (isMoving)
    {
        options.leastGain = 0.02f;
        options.minLength = 0.22f;
    }
    return options;
}

Placing moving(bool isOptimal)
{
    Placing placing{
        isOptimal ? "optimal, moving, with hysteresis" : "relaxed, moving", kMovingLayers, isOptimal, false, true, {}};
    for (int frame = 0; frame < kFrames; ++frame)
    {
        const float time = static_cast<float>(frame) / kFrames;
        placing.images.emplace_back([=](int x, int y) { return tree(x, y, time); });
    }
    return placing;
}

Placing still(bool isOptimal, int layerCount, std::vector<Depths> images)
{
    const std::string kind = isOptimal ? "optimal, still, " : "relaxed, still, ";
    return {kind + std::to_string(layerCount) + " layers", layerCount, isOptimal, false, false, std::move(images)};
}

Placing projected()
{
    return {"relaxed, from a depth buffer", kMovingLayers, false, true, false, {projectedTree()}};
}

bool areNear(const std::vector<float>& placed, const float* expected, int layerCount)
{
    for (int i = 0; i <= layerCount; ++i)
    {
        if (!(std::abs(placed[static_cast<std::size_t>(i)] - expected[i]) <= static_cast<float>(kTolerance)))
            return false;
    }
    return true;
}

void expectSplits(Comparison& comparison, const std::vector<float>& placed, const float* expected, int layerCount,
                  const std::string& where)
{
    for (int i = 0; i <= kPlacedLayers; ++i)
    {
        const double wanted = i <= layerCount ? static_cast<double>(expected[i]) : 1.0;
        const bool end = i == 0 || i >= layerCount;
        comparison.expect(static_cast<double>(placed[static_cast<std::size_t>(i)]), wanted, end ? 0 : kTolerance,
                          where + " split " + std::to_string(i));
    }
}

// Whether the host finds splits no better than these but for the rounding of a sum of 16 floats: optimal ones may tie.
bool isAsGood(const Depths& image, std::vector<float> splits, int layerCount)
{
    lvsm::OptimalOptions<float> options;
    options.leastGain = 1.0f / (1 << 20);
    const auto result =
        lvsm::optimalSplits(image.values.data(), kMap.width, kMap.height, splits.data(), layerCount, options);
    return result.status == lvsm::OptimalStatus::Kept;
}

// The host's splits, which while a light moves hold those of the frame before. Result: whether they stay.
bool placeOnHost(const Placing& placing, const Depths& image, float* splits)
{
    const float* depths = image.values.data();
    if (placing.isOptimal)
        return lvsm::optimalSplits(depths, kMap.width, kMap.height, splits, placing.layerCount,
                                   optimalOptions(placing.isMoving))
                   .status == lvsm::OptimalStatus::Kept;
    lvsm::lloydRelax(depths, kMap.width, kMap.height, splits, placing.layerCount, relaxOptions(placing.isMoving));
    return false;
}

} // namespace

lvsm::PlacePass Placing::pass() const
{
    return isOptimal ? lvsm::optimalPass(layerCount, kMap, optimalOptions(isMoving))
                     : lvsm::relaxPass(layerCount, kMap, relaxOptions(isMoving));
}

std::vector<Placing> placings()
{
    std::vector<Placing> all{projected()};
    for (const bool isOptimal : {false, true})
    {
        for (const int layerCount : {1, 2, 3, 4, kPlacedLayers})
            all.push_back(still(isOptimal, layerCount, stillImages()));
        all.push_back(moving(isOptimal));
    }
    return all;
}

std::vector<Placing> fewPlacings()
{
    std::vector<Placing> few{projected()};
    const std::vector<Depths> images = stillImages();
    for (const bool isOptimal : {false, true})
    {
        few.push_back(still(isOptimal, kPlacedLayers, {images.begin(), images.begin() + 3}));
        few.push_back(moving(isOptimal));
    }
    return few;
}

lvsm::StoreBlock placedBlock(int layerCount)
{
    float splits[kPlacedLayers + 1];
    for (int i = 0; i <= layerCount; ++i)
        splits[i] = static_cast<float>(i) / static_cast<float>(layerCount);
    return lvsm::storePass(splits, layerCount, 0.01f, kMap).block;
}

lvsm::DepthBlock placedDepths()
{
    return lvsm::perspectiveDepths(1, kFar, true, 1, kFar);
}

bool comparePlacing(const Placing& placing, const std::vector<std::vector<float>>& splits,
                    const std::vector<std::uint32_t>& histogram)
{
    Comparison comparison(placing.name);
    const int layers = placing.layerCount;
    float expected[kPlacedLayers + 1];
    const lvsm::StoreBlock first = placedBlock(layers);
    std::copy(first.splits, first.splits + layers + 1, expected);
    int kept = 0;
    int ties = 0;
    for (std::size_t i = 0; i < placing.images.size(); ++i)
    {
        const Depths& image = placing.images[i];
        kept += placeOnHost(placing, image, expected) ? 1 : 0;
        const bool isTied = placing.isOptimal && !placing.isMoving && !areNear(splits[i], expected, layers) &&
                            isAsGood(image, splits[i], layers);
        ties += isTied ? 1 : 0;
        if (!isTied)
            expectSplits(comparison, splits[i], expected, layers, "image " + std::to_string(i));
    }
    if (ties > 0)
        std::printf("     %d ties\n", ties);
    // Some frames keep and some do not, or hysteresis is not tested.
    if (placing.isOptimal && placing.isMoving)
        comparison.expect(kept > 0 && kept < kFrames ? 1 : 0, 1, 0, std::to_string(kept) + " frames kept");
    const bool isEmpty = std::all_of(histogram.begin(), histogram.begin() + 4 * kPlacedBins,
                                     [](std::uint32_t word) { return word == 0; });
    comparison.expect(isEmpty ? 1 : 0, 1, 0, "histogram left empty");
    return comparison.passed();
}

} // namespace sampling
