// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments, placement, runs.
// Placing the splits of a whole image on the host: the relaxation of placement.hpp, run to its end.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, sections 4 and 5.
//
// The neighbourhoods are sorted into a histogram of second occluders once, so that an iteration does not depend on the
// image's size. Nothing is allocated: the splits live in the caller's array, for any number of layers.
// On the host alone: no shader has it.
#ifndef LVSM_LLOYD_HPP
#define LVSM_LLOYD_HPP

#include "placement.hpp"
#include "runs.hpp"

#include <cstddef>

namespace lvsm
{

/// Why a relaxation stopped, or why it could not start.
enum class RelaxStatus
{
    Converged,
    IterationLimit,
    NoDiscontinuity,
    NoImage,
    NoLayers,
    DepthNotFinite,
    SplitsNotIncreasing
};

/// A status in words.
inline const char* describe(RelaxStatus status)
{
    switch (status)
    {
    case RelaxStatus::Converged:
        return "converged: no split moved further than the tolerance";
    case RelaxStatus::IterationLimit:
        return "stopped at the iteration limit";
    case RelaxStatus::NoDiscontinuity:
        return "the image has no depth discontinuity: the splits are the starting ones";
    case RelaxStatus::NoImage:
        return "no image: the pointer is null, or the width or height is less than 1";
    case RelaxStatus::NoLayers:
        return "no layers: the array of splits is null, or the number of layers is less than 1";
    case RelaxStatus::DepthNotFinite:
        return "the image holds a depth or moment that is NaN or infinite";
    case RelaxStatus::SplitsNotIncreasing:
        return "the starting splits do not rise from 0 to 1";
    }
    return "unknown status";
}

/// How to relax. maxIterations: at most so many, less than 0 counts as 0. tolerance: converged when no split moves
/// further, in depth. minVariance, maxVariance: as occluderWeight takes them, in depth squared; a minVariance such as
/// 0.01 keeps the many small steps inside foliage from holding splits that large steps need.
/// splitsPerIteration: 2 moves them in turn as scheduledSplits says, anything else moves all.
/// keepSplits: start from the given splits, such as those of the last frame, not from uniform ones.
/// maxSamples: of an image, about so many neighbourhoods are read, spread evenly; 0 or less takes all.
template <typename T>
struct RelaxOptions
{
    int maxIterations = 64;
    T tolerance = T(1.0e-4);
    T minVariance = T(1.0e-6);
    T maxVariance = T(0.25);
    int splitsPerIteration = 0;
    bool keepSplits = false;
    int maxSamples = 0;
};

/// What a relaxation did. movement: the largest of the last round of iterations, in depth.
/// Converts to false where the input made no sense; the splits are then unchanged.
template <typename T>
struct RelaxResult
{
    RelaxStatus status = RelaxStatus::NoImage;
    int iterations = 0;
    T movement = T(0);

    explicit operator bool() const
    {
        return status == RelaxStatus::Converged || status == RelaxStatus::IterationLimit ||
               status == RelaxStatus::NoDiscontinuity;
    }
};

namespace detail
{

// Weights of second occluders over depth. A bin keeps the sum of its values too, so that means are not rounded to bins.
struct OccluderHistogram
{
    static constexpr int kBins = 1024;
    double weight[kBins] = {};
    double weighted[kBins] = {};

    void add(double value, double amount)
    {
        const int bin = minimum(static_cast<int>(value * kBins), kBins - 1);
        weight[bin] += amount;
        weighted[bin] += amount * value;
    }
};

struct ClusterSums
{
    double weight = 0.0;
    double weighted = 0.0;
};

// The bins whose mean is nearest to a split: past the middle to the split before, up to the middle to the one behind.
template <typename T>
ClusterSums clusterOf(const OccluderHistogram& histogram, T before, T split, T behind, bool isFirst, bool isLast)
{
    const double lower = isFirst ? -1.0 : 0.5 * (static_cast<double>(before) + static_cast<double>(split));
    const double upper = isLast ? 2.0 : 0.5 * (static_cast<double>(split) + static_cast<double>(behind));
    ClusterSums sums;
    const int first = clamp(static_cast<int>(lower * OccluderHistogram::kBins), 0, OccluderHistogram::kBins - 1);
    const int last = clamp(static_cast<int>(upper * OccluderHistogram::kBins), 0, OccluderHistogram::kBins - 1);
    for (int bin = first; bin <= last; ++bin)
    {
        const double weight = histogram.weight[bin];
        if (weight > 0.0 && histogram.weighted[bin] > lower * weight && histogram.weighted[bin] <= upper * weight)
        {
            sums.weight += weight;
            sums.weighted += histogram.weighted[bin];
        }
    }
    return sums;
}

template <typename T, glm::qualifier Q>
bool isFinite(const glm::vec<2, T, Q>& moments)
{
    return isFinite(moments.x) && isFinite(moments.y);
}

// Fills the histogram from the 2x2 neighbourhoods of an image; momentsOf(texel) gives a texel's moments.
// False where a texel that is read is not finite.
template <typename Texel, typename MomentsOf>
bool gatherOccluders(OccluderHistogram& histogram, const Texel* texels, int width, int height, int maxSamples,
                     double minVariance, double maxVariance, const MomentsOf& momentsOf)
{
    const int columns = maximum(width - 1, 1);
    const int rows = maximum(height - 1, 1);
    const int right = width > 1 ? 1 : 0;
    const std::ptrdiff_t below = height > 1 ? width : 0;
    bool areFinite = true;
    forEachRun(columns, rows, maxSamples, [&](int begin, int y, int count) {
        const Texel* const row = texels + static_cast<std::ptrdiff_t>(y) * width + begin;
        for (int x = 0; x < count + right; ++x)
            areFinite &= isFinite(row[x]) && isFinite(row[x + below]);
        for (int x = 0; x < count; ++x)
        {
            const glm::vec<2, double> moments =
                neighbourhoodMoments(momentsOf(row[x]), momentsOf(row[x + right]), momentsOf(row[x + below]),
                                     momentsOf(row[x + below + right]));
            const double weight = occluderWeight(moments, minVariance, maxVariance);
            if (weight > 0.0)
                histogram.add(secondOccluder(moments), weight);
        }
    });
    return areFinite;
}

template <typename T>
bool areIncreasing(const T* splits, int layerCount)
{
    bool increasing = splits[0] == T(0) && splits[layerCount] == T(1);
    for (int i = 0; i < layerCount; ++i)
        increasing = increasing && isFinite(splits[i]) && splits[i] <= splits[i + 1];
    return increasing;
}

template <typename T>
class Relaxation
{
public:
    Relaxation(const OccluderHistogram& histogram, T* splits, int layerCount)
        : m_histogram(histogram), m_splits(splits), m_layerCount(layerCount)
    {
    }

    // Moves the splits from first to last to the means of their clusters, all judged before any moves.
    // Returns the largest movement.
    T moveSplits(int first, int last)
    {
        T largest = T(0);
        T before = m_splits[first - 1];
        for (int i = first; i <= last; ++i)
        {
            const T split = m_splits[i];
            const ClusterSums sums =
                clusterOf(m_histogram, before, split, m_splits[i + 1], i == 1, i == m_layerCount - 1);
            const T mean = updateSplit(split, static_cast<T>(sums.weighted), static_cast<T>(sums.weight));
            // It lies between the neighbours but for rounding.
            m_splits[i] = clamp(mean, m_splits[i - 1], m_splits[i + 1]);
            largest = maximum(largest, m_splits[i] > split ? m_splits[i] - split : split - m_splits[i]);
            before = split;
        }
        return largest;
    }

    bool teleportOne()
    {
        return teleport(m_splits, m_layerCount, [this](int i) {
            return static_cast<T>(clusterOf(m_histogram, m_splits[i - 1], m_splits[i], m_splits[i + 1], i == 1,
                                            i == m_layerCount - 1)
                                      .weight);
        });
    }

private:
    const OccluderHistogram& m_histogram;
    T* m_splits;
    int m_layerCount;
};

// A cluster can stay empty for good where the image has fewer peaks than there are splits. So teleportation has a
// budget, two for each inner split, after which only the relaxation goes on.
template <typename T>
RelaxResult<T> relax(const OccluderHistogram& histogram, T* splits, int layerCount, const RelaxOptions<T>& options)
{
    RelaxResult<T> result;
    const int inner = layerCount - 1;
    const bool inPairs = options.splitsPerIteration == 2;
    const int round = inPairs ? (inner + 1) / 2 : 1;
    int teleports = 2 * inner;
    int quietIterations = 0;
    Relaxation<T> relaxation(histogram, splits, layerCount);

    result.status = RelaxStatus::IterationLimit;
    while (result.iterations < options.maxIterations)
    {
        T movement;
        if (inPairs)
        {
            const glm::vec<2, int> pair = scheduledSplits(result.iterations, layerCount);
            movement = relaxation.moveSplits(pair.x, pair.x); // before the other: arguments have no order
            movement = maximum(movement, relaxation.moveSplits(pair.y, pair.y));
        }
        else
            movement = relaxation.moveSplits(1, inner);
        ++result.iterations;

        if (teleports > 0 && relaxation.teleportOne())
        {
            --teleports;
            movement = T(1);
        }
        const bool isQuiet = movement <= options.tolerance;
        result.movement = quietIterations > 0 && isQuiet ? maximum(result.movement, movement) : movement;
        quietIterations = isQuiet ? quietIterations + 1 : 0;
        if (quietIterations >= round)
        {
            result.status = RelaxStatus::Converged;
            break;
        }
    }
    return result;
}

template <typename Texel, typename T, typename MomentsOf>
RelaxResult<T> relaxImage(const Texel* texels, int width, int height, T* splits, int layerCount,
                          const RelaxOptions<T>& options, const MomentsOf& momentsOf)
{
    RelaxResult<T> result;
    const auto stop = [&result](RelaxStatus status) {
        result.status = status;
        return result;
    };
    if (texels == nullptr || width < 1 || height < 1)
        return stop(RelaxStatus::NoImage);
    if (splits == nullptr || layerCount < 1)
        return stop(RelaxStatus::NoLayers);
    if (options.keepSplits && !areIncreasing(splits, layerCount))
        return stop(RelaxStatus::SplitsNotIncreasing);

    OccluderHistogram histogram;
    if (!gatherOccluders(histogram, texels, width, height, options.maxSamples, static_cast<double>(options.minVariance),
                         static_cast<double>(options.maxVariance), momentsOf))
        return stop(RelaxStatus::DepthNotFinite);

    for (int i = 0; !options.keepSplits && i <= layerCount; ++i)
        splits[i] = static_cast<T>(i) / static_cast<T>(layerCount);
    if (layerCount == 1)
        return stop(RelaxStatus::Converged);
    if (!(clusterOf(histogram, T(0), T(0), T(0), true, true).weight > 0.0))
        return stop(RelaxStatus::NoDiscontinuity);
    return relax(histogram, splits, layerCount, options);
}

} // namespace detail

/// Splits for an image of depths, by Lloyd relaxation.
/// A local optimum: teleportation can put a split back where its cluster is empty, and two peaks share another then.
/// depths: width x height of them, row by row, in [0,1], clamped to it. splits: layerCount + 1 values, written from 0
/// to 1 and not decreasing; the start where options say so. layerCount: at least 1.
/// Result: why it stopped, the iterations and the last movement, or the reason why the input makes no sense.
/// Source: LVSM sections 4 and 5.
template <typename T>
RelaxResult<T> lloydRelax(const T* depths, int width, int height, T* splits, int layerCount,
                          const RelaxOptions<T>& options = {})
{
    return detail::relaxImage(depths, width, height, splits, layerCount, options,
                              [](T depth) { return depthMoments(static_cast<double>(depth)); });
}

/// Splits for an image of moments, such as a variance shadow map, by Lloyd relaxation.
/// moments: width x height pairs (M1, M2), unwarped, row by row. The rest as for lloydRelax.
/// Source: LVSM sections 4 and 5.
template <typename T, glm::qualifier Q>
RelaxResult<T> lloydRelaxMoments(const glm::vec<2, T, Q>* moments, int width, int height, T* splits, int layerCount,
                                 const RelaxOptions<T>& options = {})
{
    return detail::relaxImage(moments, width, height, splits, layerCount, options,
                              [](const glm::vec<2, T, Q>& texel) {
                                  return glm::vec<2, double>(static_cast<double>(texel.x),
                                                             static_cast<double>(texel.y));
                              });
}

} // namespace lvsm

#endif
