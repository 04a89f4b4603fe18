// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, runs.
// Placing the splits by dynamic programming, on the host: the best splits for bracketed layers, with no iterations.
//
// A bracketed layer is as exact as the depths inside it are alike. So the splits minimise the weighted mean square
// distance of depths to the mean of their layer (the Lloyd-Max quantiser). In one dimension that has one global
// optimum, which dynamic programming finds: nothing to start from, nothing to get stuck in.
// Wang & Song, Ckmeans.1d.dp: Optimal k-means Clustering in One Dimension by Dynamic Programming, The R Journal 3(2),
// 2011; the rows' optima rise with the bin, which divide and conquer uses: O(layers * bins * log bins).
// On the host alone: no shader has it.
#ifndef LVSM_OPTIMAL_HPP
#define LVSM_OPTIMAL_HPP

#include "runs.hpp"

namespace lvsm
{

// Most layers and histogram bins that optimalSplits takes. All its storage is on the stack, about 120 KiB.
constexpr int kMaxOptimalLayers = 16;
constexpr int kMaxOptimalBins = 1024;

/// What became of the splits. Optimal and Kept are success, the others are errors that leave the splits unchanged.
enum class OptimalStatus
{
    Optimal,
    Kept,
    NoImage,
    NoHistogram,
    LayerCountOutOfRange,
    DepthNotFinite,
    WeightNotFinite
};

/// Text for a person, without a full stop.
inline const char* describe(OptimalStatus status)
{
    switch (status)
    {
    case OptimalStatus::Optimal:
        return "placed the splits at the optimum";
    case OptimalStatus::Kept:
        return "kept the previous splits, which are nearly as good as the optimum";
    case OptimalStatus::NoImage:
        return "no image: a null pointer, or a width or height below 1";
    case OptimalStatus::NoHistogram:
        return "no histogram: a null pointer, or a number of bins that is not from 1 to 1024";
    case OptimalStatus::LayerCountOutOfRange:
        return "no splits, or a number of layers that is not from 1 to 16";
    case OptimalStatus::DepthNotFinite:
        return "a depth is infinite or not a number";
    case OptimalStatus::WeightNotFinite:
        return "a weight is negative, infinite or not a number";
    }
    return "unknown status";
}

/// How to place the splits. uniformShare: of a uniform histogram that is mixed in, in [0,1], so that depths without
/// weight count a little. minLength: least length of a cell in depth, at most 1 / layerCount; a layer, whose splits lie
/// between the means of cells, is at least half as long.
/// leastGain: hysteresis for moving scenes, in [0,1). With more than 0 the given splits are the previous ones, and they
/// are kept unless the new ones lower the mean square distance by more than this share of it; splits that are no
/// placement (not from 0 to 1 or not rising) are replaced.
/// maxSamples: of an image, about so many texels are sampled, spread evenly; 0 or less takes all.
template <typename T>
struct OptimalOptions
{
    T uniformShare = T(0.3);
    T minLength = T(1) / T(64);
    T leastGain = T(0);
    int maxSamples = 131072;
};

/// What a placement did. distortion: weighted mean square distance of depths to the mean of their layer, for the
/// resulting splits, in depth squared. Converts to false where the input made no sense.
template <typename T>
struct OptimalResult
{
    OptimalStatus status = OptimalStatus::NoImage;
    T distortion = T(0);

    explicit operator bool() const
    {
        return status == OptimalStatus::Optimal || status == OptimalStatus::Kept;
    }
};

namespace detail
{

// Sums of weight, weight x and weight x^2 of the bins up to an index, and what a cell of bins costs by them.
// x is the centre of a bin.
class CellCosts
{
public:
    CellCosts(const double (&weights)[kMaxOptimalBins], int binCount, double uniformShare) : m_binCount(binCount)
    {
        // Relative to the largest, neither the sum nor its inverse overflows.
        double largest = 0.0;
        for (int i = 0; i < binCount; ++i)
            largest = maximum(largest, weights[i]);
        const double unit = largest > 0.0 ? largest : 1.0;
        double total = 0.0;
        for (int i = 0; i < binCount; ++i)
            total += weights[i] / unit;
        const double scale = total > 0.0 ? (1.0 - uniformShare) / total : 0.0;
        const double uniform = (total > 0.0 ? uniformShare : 1.0) / binCount;
        for (int i = 0; i < binCount; ++i)
        {
            // Measured from the middle of the range, which halves the digits that the squares cancel.
            const double x = (i + 0.5) / binCount - 0.5;
            const double weight = weights[i] / unit * scale + uniform;
            m_sums[i + 1] = {m_sums[i].weight + weight, m_sums[i].first + weight * x,
                             m_sums[i].second + weight * x * x};
        }
    }

    // Mean square distance of the bins from first to last - 1 to their mean, times their weight.
    double cost(int first, int last) const
    {
        const Sums sums = between(first, last);
        return sums.weight > 0.0 ? maximum(0.0, sums.second - sums.first * sums.first / sums.weight) : 0.0;
    }

    // Between the centres of the first and the last bin, also where rounding is all of the weight: so means rise.
    double mean(int first, int last) const
    {
        const Sums sums = between(first, last);
        const double low = (first + 0.5) / m_binCount;
        const double high = (last - 0.5) / m_binCount;
        return sums.weight > 0.0 ? clamp(0.5 + sums.first / sums.weight, low, high) : 0.5 * (low + high);
    }

    // The cost of layers with the given splits, each rounded to a bin's edge.
    template <typename T>
    double costOf(const T* splits, int layerCount) const
    {
        double total = 0.0;
        int first = 0;
        for (int i = 1; i <= layerCount; ++i)
        {
            const int last = i == layerCount ? m_binCount : edge(static_cast<double>(splits[i]));
            total += cost(first, last);
            first = last;
        }
        return total;
    }

private:
    struct Sums
    {
        double weight = 0.0;
        double first = 0.0;
        double second = 0.0;
    };

    Sums between(int first, int last) const
    {
        return {m_sums[last].weight - m_sums[first].weight, m_sums[last].first - m_sums[first].first,
                m_sums[last].second - m_sums[first].second};
    }

    int edge(double split) const
    {
        return clamp(static_cast<int>(split * m_binCount + 0.5), 0, m_binCount);
    }

    int m_binCount;
    Sums m_sums[kMaxOptimalBins + 1];
};

// Row k of the programme holds, for each number of bins, the least cost of k + 1 cells over those bins, and where the
// last of the cells begins.
class SplitProgramme
{
public:
    SplitProgramme(const CellCosts& costs, int binCount, int layerCount, int leastBins)
        : m_costs(costs), m_binCount(binCount), m_layerCount(layerCount), m_leastBins(leastBins)
    {
        for (int last = leastBins; last <= binCount; ++last)
            m_current[last] = costs.cost(0, last);
        for (m_row = 1; m_row < layerCount; ++m_row)
        {
            for (int last = m_row * leastBins; last <= binCount; ++last)
                m_previous[last] = m_current[last];
            fill((m_row + 1) * leastBins, binCount, m_row * leastBins, binCount - leastBins);
        }
    }

    // Edges of the optimal cells, layerCount + 1 of them, in bins.
    void edges(int* out) const
    {
        out[m_layerCount] = m_binCount;
        for (int i = m_layerCount - 1; i > 0; --i)
            out[i] = m_begin[i][out[i + 1]];
        out[0] = 0;
    }

private:
    // Entries from low to high of the row, whose last cells begin from lowBegin to highBegin: the middle one by trying
    // all, the halves within the bounds that it sets.
    void fill(int low, int high, int lowBegin, int highBegin)
    {
        if (low > high)
            return;
        const int middle = low + (high - low) / 2;
        const int end = minimum(highBegin, middle - m_leastBins);
        int best = lowBegin;
        double least = m_previous[lowBegin] + m_costs.cost(lowBegin, middle);
        for (int begin = lowBegin + 1; begin <= end; ++begin)
        {
            const double cost = m_previous[begin] + m_costs.cost(begin, middle);
            if (cost < least)
            {
                least = cost;
                best = begin;
            }
        }
        m_current[middle] = least;
        m_begin[m_row][middle] = static_cast<short>(best);
        fill(low, middle - 1, lowBegin, best);
        fill(middle + 1, high, best, highBegin);
    }

    const CellCosts& m_costs;
    int m_binCount;
    int m_layerCount;
    int m_leastBins;
    int m_row = 0;
    double m_previous[kMaxOptimalBins + 1];
    double m_current[kMaxOptimalBins + 1];
    short m_begin[kMaxOptimalLayers][kMaxOptimalBins + 1];
};

// Adds up the weights of an image's depths, in runs of texels of a row: four times the standard deviation of each
// texel's 2x2 neighbourhood. False where a depth is not finite.
template <typename T>
bool weighDepths(const T* depths, int width, int height, int maxSamples, double* weights)
{
    using glm::sqrt;
    // Neighbours mostly share a bin: sums of their own do not wait for each other.
    constexpr int kLanes = 4;
    double lanes[kLanes][kMaxOptimalBins] = {};
    T variances[kRun];
    int bins[kRun];
    T above[kRun + 1];
    T below[kRun + 1];
    bool areFinite = true;
    forEachRun(width, height, maxSamples, [&](int begin, int y, int count) {
        const T* row = depths + static_cast<std::ptrdiff_t>(y) * width + begin;
        const T* next = y + 1 < height ? row + width : row;
        for (int i = 0; i < count; ++i)
        {
            areFinite &= isFinite(row[i]);
            above[i] = clamp(row[i], T(0), T(1));
            below[i] = clamp(next[i], T(0), T(1));
        }
        const int last = begin + count < width ? count : count - 1;
        above[count] = clamp(row[last], T(0), T(1));
        below[count] = clamp(next[last], T(0), T(1));
        for (int i = 0; i < count; ++i)
        {
            // Of four numbers from their differences, which do not cancel.
            const T left = above[i] - below[i];
            const T right = above[i + 1] - below[i + 1];
            const T across = (above[i] - above[i + 1]) + (below[i] - below[i + 1]);
            const T vertical = left + right;
            const T diagonal = left - right;
            variances[i] = vertical * vertical + across * across + diagonal * diagonal;
            bins[i] = minimum(static_cast<int>(above[i] * T(kMaxOptimalBins)), kMaxOptimalBins - 1);
        }
        for (int i = 0; i < count; ++i)
            lanes[i % kLanes][bins[i]] += static_cast<double>(sqrt(variances[i]));
    });
    for (const auto& lane : lanes)
        for (int bin = 0; bin < kMaxOptimalBins; ++bin)
            weights[bin] += lane[bin];
    return areFinite;
}

template <typename T>
bool isPlacement(const T* splits, int layerCount)
{
    bool rising = splits[0] == T(0) && splits[layerCount] == T(1);
    for (int i = 0; i < layerCount; ++i)
        rising = rising && isFinite(splits[i]) && splits[i] < splits[i + 1];
    return rising;
}

template <typename T>
OptimalResult<T> placeOptimally(const double (&weights)[kMaxOptimalBins], int binCount, T* splits, int layerCount,
                                const OptimalOptions<T>& options)
{
    const CellCosts costs(weights, binCount, clamp(static_cast<double>(options.uniformShare), 0.0, 1.0));
    const int cells = minimum(layerCount, binCount);
    const double leastLength = clamp(static_cast<double>(options.minLength), 0.0, 1.0);
    const int leastBins = clamp(static_cast<int>(leastLength * binCount), 1, binCount / cells);

    int edges[kMaxOptimalLayers + 1];
    SplitProgramme(costs, binCount, cells, leastBins).edges(edges);
    T placed[kMaxOptimalLayers + 1];
    placed[0] = T(0);
    for (int i = 1; i < cells; ++i)
        placed[i] = static_cast<T>(
            0.5 * (costs.mean(edges[i - 1], edges[i]) + costs.mean(edges[i], edges[i + 1])));
    for (int i = cells; i <= layerCount; ++i)
        placed[i] = T(1);

    OptimalResult<T> result;
    const double distortion = costs.costOf(placed, layerCount);
    if (options.leastGain > T(0) && isPlacement(splits, layerCount))
    {
        const double previous = costs.costOf(splits, layerCount);
        if (distortion >= (1.0 - static_cast<double>(options.leastGain)) * previous)
        {
            result.status = OptimalStatus::Kept;
            result.distortion = static_cast<T>(previous);
            return result;
        }
    }
    for (int i = 0; i <= layerCount; ++i)
        splits[i] = placed[i];
    result.status = OptimalStatus::Optimal;
    result.distortion = static_cast<T>(distortion);
    return result;
}

} // namespace detail

/// Splits for a histogram of depths: the global optimum.
/// weights: one for each of binCount equal bins over [0,1], finite and >= 0; all 0 counts as uniform.
/// binCount: from 1 to 1024. splits: layerCount + 1 values, written from 0 to 1 and not decreasing; the previous ones
/// where options give a leastGain. layerCount: from 1 to 16; layers beyond the number of bins are empty.
/// Result: whether new splits were placed and their distortion, or the reason why the input makes no sense.
template <typename T>
OptimalResult<T> optimalSplitsHistogram(const T* weights, int binCount, T* splits, int layerCount,
                                        const OptimalOptions<T>& options = {})
{
    OptimalResult<T> result;
    const auto stop = [&result](OptimalStatus status) {
        result.status = status;
        return result;
    };
    if (weights == nullptr || binCount < 1 || binCount > kMaxOptimalBins)
        return stop(OptimalStatus::NoHistogram);
    if (splits == nullptr || layerCount < 1 || layerCount > kMaxOptimalLayers)
        return stop(OptimalStatus::LayerCountOutOfRange);
    double copies[kMaxOptimalBins];
    for (int i = 0; i < binCount; ++i)
    {
        copies[i] = static_cast<double>(weights[i]);
        if (!detail::isFinite(weights[i]) || copies[i] < 0.0)
            return stop(OptimalStatus::WeightNotFinite);
    }
    return detail::placeOptimally(copies, binCount, splits, layerCount, options);
}

/// Splits for an image of depths: the global optimum for a histogram of 1024 bins, in which a depth weighs as much as
/// its 2x2 neighbourhood deviates, because only where depths differ is there anything to bound.
/// depths: width x height of them, row by row, in [0,1], clamped to it. splits, layerCount, options: as for
/// optimalSplitsHistogram. Of an image with more than options.maxSamples texels only so many are read. An image without
/// any edge gives the splits of a uniform histogram.
/// Result: whether new splits were placed and their distortion, or the reason why the input makes no sense.
template <typename T>
OptimalResult<T> optimalSplits(const T* depths, int width, int height, T* splits, int layerCount,
                               const OptimalOptions<T>& options = {})
{
    OptimalResult<T> result;
    const auto stop = [&result](OptimalStatus status) {
        result.status = status;
        return result;
    };
    if (depths == nullptr || width < 1 || height < 1)
        return stop(OptimalStatus::NoImage);
    if (splits == nullptr || layerCount < 1 || layerCount > kMaxOptimalLayers)
        return stop(OptimalStatus::LayerCountOutOfRange);

    double weights[kMaxOptimalBins] = {};
    if (!detail::weighDepths(depths, width, height, options.maxSamples, weights))
        return stop(OptimalStatus::DepthNotFinite);
    return detail::placeOptimally(weights, kMaxOptimalBins, splits, layerCount, options);
}

} // namespace lvsm

#endif
