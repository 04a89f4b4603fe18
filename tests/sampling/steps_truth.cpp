#include "steps_truth.hpp"

#include <algorithm>
#include <cmath>

namespace sampling
{
namespace
{

constexpr double kTolerance = 1.0 / 4096;
// What the device may take for the very middle between two splits, either of which can have it then.
constexpr double kTie = 1e-6;
constexpr int kMostFrames = 200;
// Less than this a frame is at rest, here and on the host.
constexpr float kStill = 1e-5f;

struct Occluder
{
    double value;
    double weight;
};

std::vector<Occluder> occludersOf(const Depths& image, const lvsm::RelaxOptions<double>& options)
{
    std::vector<Occluder> occluders;
    for (int y = 0; y + 1 < kMap.height; ++y)
    {
        for (int x = 0; x + 1 < kMap.width; ++x)
        {
            const auto moments = [&](int dx, int dy)
            {
                const int index = (y + dy) * kMap.width + x + dx;
                return lvsm::depthMoments(static_cast<double>(image.values[static_cast<std::size_t>(index)]));
            };
            const auto mean = lvsm::neighbourhoodMoments(moments(0, 0), moments(1, 0), moments(0, 1), moments(1, 1));
            const double weight = lvsm::occluderWeight(mean, options.minVariance, options.maxVariance);
            if (weight > 0)
                occluders.push_back({lvsm::secondOccluder(mean), weight});
        }
    }
    return occluders;
}

struct Sums
{
    double weight = 0;
    double weighted = 0;
};

// Of a split's cluster, with or without what lies on the very middle towards the split before and the one behind.
Sums clusterOf(const std::vector<Occluder>& occluders, const State& splits, int layerCount, int split, bool withLower,
               bool withUpper)
{
    const auto at = [&](int i)
    {
        return static_cast<double>(splits[static_cast<std::size_t>(i)]);
    };
    const double lower = split == 1 ? -1 : 0.5 * (at(split - 1) + at(split)) + (withLower ? -kTie : kTie);
    const double upper = split == layerCount - 1 ? 2 : 0.5 * (at(split) + at(split + 1)) + (withUpper ? kTie : -kTie);
    Sums sums;
    for (const Occluder& occluder : occluders)
    {
        const bool inside = occluder.value > lower && occluder.value <= upper;
        sums.weight += inside ? occluder.weight : 0;
        sums.weighted += inside ? occluder.weight * occluder.value : 0;
    }
    return sums;
}

struct Range
{
    double lo = 2;
    double hi = -1;
};

// Where a split may be after a move.
Range movedSplit(const std::vector<Occluder>& occluders, const State& splits, int layerCount, int split)
{
    Range range;
    for (int i = 0; i < 4; ++i)
    {
        const Sums sums = clusterOf(occluders, splits, layerCount, split, i % 2 == 1, i / 2 == 1);
        const double moved =
            lvsm::updateSplit(static_cast<double>(splits[static_cast<std::size_t>(split)]), sums.weighted, sums.weight);
        range = {std::min(range.lo, moved), std::max(range.hi, moved)};
    }
    return range;
}

// The weights of all clusters as a step has them: of the splits that it moves from their sums' mean, of others from the
// state.
std::vector<float> weightsOf(const std::vector<Occluder>& occluders, const State& state, int layerCount,
                             const lvsm::StepBlock& block)
{
    const auto pair = lvsm::scheduledSplits(block.frame, layerCount);
    std::vector<float> weights(state.begin() + 4 * kStateWidth, state.end());
    for (int i = 1; i < layerCount; ++i)
    {
        const double sum = clusterOf(occluders, state, layerCount, i, false, true).weight;
        if (block.frame < 0 || i == pair.x || i == pair.y)
            weights[static_cast<std::size_t>(i)] = static_cast<float>(sum / (kMap.width * kMap.height));
    }
    return weights;
}

// Whether a step teleports and does not move: some cluster is empty and some is not, and a move has come since the last.
bool teleports(const std::vector<float>& weights, int layerCount)
{
    const auto first = weights.begin() + 1;
    const auto last = weights.begin() + layerCount;
    const auto isEmpty = [](float weight)
    {
        return weight == 0.0f;
    };
    return weights[0] > 1.5f && std::any_of(first, last, isEmpty) && !std::all_of(first, last, isEmpty);
}

// Where each split may be after a step.
std::vector<Range> afterStep(const std::vector<Occluder>& occluders, const State& state, int layerCount,
                             const lvsm::StepBlock& block)
{
    const std::vector<float> weights = weightsOf(occluders, state, layerCount, block);
    const bool jumps = teleports(weights, layerCount);
    float jumped[kMaxLayers + 1];
    std::copy_n(state.begin(), kMaxLayers + 1, jumped);
    lvsm::teleportSplits(jumped, weights.data(), layerCount);
    const auto pair = lvsm::scheduledSplits(block.frame, layerCount);
    std::vector<Range> ranges;
    for (int i = 0; i <= kMaxLayers; ++i)
    {
        const bool inner = i > 0 && i < layerCount;
        const bool moves = inner && !jumps && (block.frame < 0 || i == pair.x || i == pair.y);
        const auto still = static_cast<double>(jumps ? jumped[i] : state[static_cast<std::size_t>(i)]);
        ranges.push_back(moves ? movedSplit(occluders, state, layerCount, i) : Range{still, still});
    }
    // Moved by sums some frames old, they may be out of order.
    for (int i = 1; i < layerCount && !jumps; ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        ranges[k] = {std::max(ranges[k].lo, ranges[k - 1].lo), std::max(ranges[k].hi, ranges[k - 1].hi)};
    }
    return ranges;
}

} // namespace

State startState(int layerCount)
{
    State state(static_cast<std::size_t>(8 * kStateWidth));
    lvsm::startPlaceState(layerCount, kMaxLayers, state.data());
    return state;
}

void compareSteps(const Relaxed& relaxed, const DrawStep& draw, Comparison& steps, Comparison& ends)
{
    lvsm::RelaxOptions<float> options;
    options.splitsPerIteration = relaxed.inPairs ? 2 : 0;
    options.maxIterations = kMostFrames;
    options.tolerance = kStill;
    const int layers = relaxed.layerCount;
    const auto occluders = occludersOf(relaxed.image, {});
    State state = startState(layers);
    int quiet = 0;
    for (int frame = 0; frame < kMostFrames && quiet <= layers; ++frame)
    {
        const lvsm::PlaceStep step = lvsm::placeStep(layers, kMaxLayers, kMap, frame, options);
        const State next = draw(step, relaxed.image);
        const std::vector<Range> ranges = afterStep(occluders, state, layers, step.block);
        float movement = 0;
        for (std::size_t i = 0; i <= kMaxLayers; ++i)
        {
            const double middle = 0.5 * (ranges[i].lo + ranges[i].hi);
            // A tenth of what the whole may differ by: over a quarter of the map the sums round by as much.
            steps.expect(static_cast<double>(next[i]), middle, 0.5 * (ranges[i].hi - ranges[i].lo) + 0.1 * kTolerance,
                         relaxed.name + " frame " + std::to_string(frame) + " split " + std::to_string(i));
            movement = std::max(movement, std::abs(next[i] - state[i]));
        }
        quiet = movement <= kStill ? quiet + 1 : 0;
        state = next;
    }
    if (relaxed.inPairs || relaxed.isNoise)
        return;
    float splits[kMaxLayers + 1];
    lvsm::lloydRelax(relaxed.image.values.data(), kMap.width, kMap.height, splits, layers, options);
    for (int i = 1; i < layers; ++i)
        ends.expect(static_cast<double>(state[static_cast<std::size_t>(i)]), static_cast<double>(splits[i]), kTolerance,
                    relaxed.name + " split " + std::to_string(i));
}

} // namespace sampling
