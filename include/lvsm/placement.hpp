// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments.
// Placing the splits by Lloyd relaxation on second occluders, one step at a time.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, sections 4 and 5.
//
// Each frame: scheduledSplits chooses two splits. For every texel of the unwarped moments, a bilinear sample at
// neighbourhoodTexCoord (or neighbourhoodMoments of four loads) gives secondOccluder and occluderWeight; nearestSplit
// assigns it, and accumulateSplits writes what a mipmap chain or a reduction then averages. updateSplit moves the two
// splits, teleportSplits rescues one whose cluster is empty, monotoneSplits restores the order. lloyd.hpp runs all of
// it on the host.
#ifndef LVSM_PLACEMENT_HPP
#define LVSM_PLACEMENT_HPP

#include "moments.hpp"

#include <glm/vec4.hpp>

namespace lvsm
{

/// Texture coordinate at which one bilinear sample averages a texel and its neighbours in x, y and both.
/// texel: from 0 to size - 1, clamped to it. size: of the map in texels, each at least 1, less counts as 1.
/// Result in (0,1]: the far corner of the texel. With an address mode that clamps, the last row and column average
/// themselves.
/// Source: LVSM section 5.
template <typename T = float, glm::qualifier Q>
glm::vec<2, T> neighbourhoodTexCoord(const glm::vec<2, int, Q>& texel, const glm::vec<2, int, Q>& size)
{
    const int width = detail::maximum(size.x, 1);
    const int height = detail::maximum(size.y, 1);
    const T x = static_cast<T>(detail::clamp(texel.x, 0, width - 1));
    const T y = static_cast<T>(detail::clamp(texel.y, 0, height - 1));
    return {detail::clamp((x + T(1)) / static_cast<T>(width), T(0), T(1)),
            detail::clamp((y + T(1)) / static_cast<T>(height), T(0), T(1))};
}

/// Moments of a 2x2 neighbourhood from four loads: what one bilinear sample between the texels gives.
/// m00, m10, m01, m11: (M1, M2) of the four texels. Result: their average, any number.
/// Source: LVSM section 5.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> neighbourhoodMoments(const glm::vec<2, T, Q>& m00, const glm::vec<2, T, Q>& m10,
                                       const glm::vec<2, T, Q>& m01, const glm::vec<2, T, Q>& m11)
{
    const auto average = [](T a, T b, T c, T d) {
        const T quarter = T(0.25);
        const T two = detail::rounded(detail::rounded(quarter * a) + detail::rounded(quarter * b));
        return detail::rounded(two + detail::rounded(quarter * c)) + detail::rounded(quarter * d);
    };
    return {average(m00.x, m10.x, m01.x, m11.x), average(m00.y, m10.y, m01.y, m11.y)};
}

/// Depth of the second occluder of a neighbourhood: the mean plus the standard deviation.
/// moments: (M1, M2) of the neighbourhood. Result in [0,1].
/// Of two depths a and b that cover alpha and 1 - alpha it is max(a, b) at alpha = 1/2, and elsewhere
/// alpha a + (1 - alpha) b + sqrt(alpha (1 - alpha)) |a - b|.
/// Source: LVSM section 4.1.
template <typename T, glm::qualifier Q>
T secondOccluder(const glm::vec<2, T, Q>& moments)
{
    using glm::sqrt;
    return detail::clamp(moments.x + sqrt(variance(moments, T(0))), T(0), T(1));
}

/// Weight of a neighbourhood in the relaxation: its variance, clamped.
/// moments: (M1, M2) of the neighbourhood. minVariance: less variance than this weighs nothing. maxVariance: the most
/// that counts, >= 0. Both in depth squared. Result in [0, maxVariance].
/// Degenerate: maxVariance below 0 gives 0.
/// Source: LVSM section 4.1.
template <typename T, glm::qualifier Q>
T occluderWeight(const glm::vec<2, T, Q>& moments, T minVariance, T maxVariance)
{
    const T v = variance(moments, T(0));
    return v < minVariance ? T(0) : detail::minimum(v, detail::maximum(T(0), maxVariance));
}

/// Inner split nearest to a value: the cluster that the value belongs to.
/// value: in [0,1]. splits: layerCount + 1 values, not decreasing, from 0 to 1. layerCount: in shaders at most
/// LVSM_MAX_LAYERS.
/// Result from 1 to layerCount - 1, the lower one of two at the same distance; 0 where there is no inner split.
/// Source: LVSM section 5.
template <typename T>
int nearestSplit(T value, const T* splits, int layerCount)
{
    using glm::abs;
    LVSM_ASSERT(splits != nullptr);
    if (layerCount < 2)
        return 0;
    int nearest = 1;
    T least = abs(value - splits[1]);
    for (int i = 2; i < layerCount; ++i)
    {
        const T gap = abs(value - splits[i]);
        if (gap < least)
        {
            nearest = i;
            least = gap;
        }
    }
    return nearest;
}

/// What one neighbourhood adds to the sums of the two splits that are being moved.
/// value: second occluder, in [0,1]. weight: of the neighbourhood, >= 0. nearest: the split it belongs to.
/// first, second: the two splits being moved.
/// Result: (weight value, weight) for first in xy and for second in zw, any number; 0 where it belongs to neither.
/// Source: LVSM section 5.
template <typename T>
glm::vec<4, T> accumulateSplits(T value, T weight, int nearest, int first, int second)
{
    const T weighted = weight * detail::clamp(value, T(0), T(1));
    return {nearest == first ? weighted : T(0), nearest == first ? weight : T(0),
            nearest == second ? weighted : T(0), nearest == second ? weight : T(0)};
}

/// Split moved to the weighted mean of its cluster.
/// split: where it is, in [0,1]. weightedValue, weight: sums or averages of what accumulateSplits gave.
/// Result in [0,1]: weightedValue / weight, or split where the cluster is empty (weight under 2^-126).
/// Source: LVSM section 5.
template <typename T>
T updateSplit(T split, T weightedValue, T weight)
{
    const T total = detail::minimum(kHuge<T>, weight);
    return detail::clamp(total < kTiny<T> ? split : weightedValue / total, T(0), T(1));
}

/// The two inner splits to move in a frame, so that all have their turn.
/// frame: number of the frame, >= 0, less counts as 0. layerCount: up to 65536.
/// Result: each from 1 to layerCount - 1, both 1 for two layers, both 0 where there is no inner split.
/// Source: LVSM section 5.
inline glm::vec<2, int> scheduledSplits(int frame, int layerCount)
{
    const int inner = detail::clamp(layerCount, 1, kMaxUniformLayers) - 1;
    if (inner < 1)
        return {0, 0};
    const int turn = 2 * (detail::maximum(frame, 0) % inner);
    return {1 + turn % inner, 1 + (turn + 1) % inner};
}

/// Splits made valid: the ends at 0 and 1, everything in [0,1], not decreasing.
/// splits: layerCount + 1 values, changed in place. layerCount: at least 1, less counts as 1; in shaders
/// at most LVSM_MAX_LAYERS, more counts as that.
/// Source: LVSM section 5 needs a monotone sequence; splits moved by data some frames old may not be one.
template <typename T>
void monotoneSplits(T* splits, int layerCount)
{
    LVSM_ASSERT(splits != nullptr);
    const int count = detail::maximum(layerCount, 1);
    splits[0] = T(0);
    for (int i = 1; i < count; ++i)
        splits[i] = detail::clamp(splits[i], splits[i - 1], T(1));
    splits[count] = T(1);
}

namespace detail
{

template <typename T, typename WeightOf>
bool teleport(T* splits, int layerCount, const WeightOf& weightOf)
{
    if (layerCount < 3)
        return false;
    int empty = 0;
    for (int i = layerCount - 1; i > 0; --i)
        empty = weightOf(i) < kTiny<T> ? i : empty;
    if (empty == 0)
        return false;

    T heaviest = T(0);
    int behind = 0;
    T before = T(0);
    for (int j = 1; j <= layerCount; ++j)
    {
        if (j == empty)
            continue;
        const T after = j < layerCount ? T(0.5) * maximum(T(0), weightOf(j)) : T(0);
        if (before + after > heaviest)
        {
            heaviest = before + after;
            behind = j;
        }
        before = after;
    }
    if (behind == 0)
        return false;

    const int inFront = behind - 1 == empty ? behind - 2 : behind - 1;
    const T middle =
        T(0.5) * (clamp(splits[inFront], T(0), T(1)) + clamp(splits[behind], T(0), T(1)));
    for (int k = empty; k < inFront; ++k)
        splits[k] = splits[k + 1];
    for (int m = empty; m > behind; --m)
        splits[m] = splits[m - 1];
    splits[behind > empty ? maximum(inFront, empty) : behind] = middle;
    return true;
}

} // namespace detail

/// A split whose cluster is empty, moved to where it is of use: its two layers merge and the heaviest layer is halved.
/// splits: layerCount + 1 values, not decreasing, changed in place. weights: of the cluster of each inner split, under
/// the split's index; the first and last are not read. layerCount: in shaders at most LVSM_MAX_LAYERS, more counts as
/// that.
/// The first empty one of several moves. A layer weighs as much as the clusters at its two ends together, and the
/// first of several heaviest is halved. Nothing changes where no cluster is empty or all are.
/// Source: LVSM section 5, teleportation.
template <typename T>
void teleportSplits(T* splits, const T* weights, int layerCount)
{
    LVSM_ASSERT(splits != nullptr && weights != nullptr);
    detail::teleport(splits, layerCount, [weights](int index) { return weights[index]; });
}

} // namespace lvsm

#endif
