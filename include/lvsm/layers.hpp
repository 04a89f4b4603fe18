// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments.
// Layered variance shadow maps: the depth range cut into layers, each with its own linear warp.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, sections 3.2 to 3.4 and 5.
#ifndef LVSM_LAYERS_HPP
#define LVSM_LAYERS_HPP

#include "moments.hpp"

#include <glm/vec4.hpp>

namespace lvsm
{

/// The warp that resolves one receiver perfectly: everything in front of the split is one occluder.
/// depth, split: in [0,1]. Result in [0,1]: 0 below the split, 1 from the split on.
/// Source: LVSM equation 5.
template <typename T>
T stepWarp(T depth, T split)
{
    return depth >= split ? T(1) : T(0);
}

/// Depth warped to a layer: 0 in front of it, 1 behind it, linear inside.
/// depth: in [0,1]. interval: begin and end of the layer, begin < end. Result in [0,1].
/// Degenerate: an empty or inverted interval is stepWarp at its end.
/// Source: LVSM equation 6.
template <typename T, glm::qualifier Q>
T layerWarp(T depth, const glm::vec<2, T, Q>& interval)
{
    return linstep(depth, interval.x, interval.y);
}

/// Interval that a layer covers: its two splits, moved outwards by the overlap.
/// begin, end: the splits in front of and behind the layer. overlap: in depth, >= 0, less counts as 0.
/// Result: (begin, end) in [0,1]; the outer ends of the first and last layer stay at 0 and 1.
/// Source: LVSM section 3.4.
template <typename T>
glm::vec<2, T> layerInterval(T begin, T end, T overlap)
{
    const T widening = detail::maximum(T(0), overlap);
    return {detail::clamp(begin - widening, T(0), T(1)), detail::clamp(end + widening, T(0), T(1))};
}

/// Variance floor in a layer's warped depth that equals a global floor in depth.
/// minVariance: the global floor in depth squared, >= 0, less counts as 0. interval: begin and end of the layer.
/// Result in [0, 1/4]: 1/4 is the largest variance that depths in [0,1] can have (Popoviciu's inequality).
/// Degenerate: for a vanishing layer 1/4, or 0 where minVariance is 0.
/// Source: LVSM equation 7.
template <typename T, glm::qualifier Q>
T layerMinVariance(T minVariance, const glm::vec<2, T, Q>& interval)
{
    const T extent = detail::clamp(interval.y - interval.x, T(0), T(1));
    const T squared = extent * extent;
    if (!(minVariance >= kTiny<T>))
        return T(0);
    return T(0.25) * squared <= minVariance ? T(0.25) : detail::minimum(T(0.25), minVariance / squared);
}

/// Split number index of layers of equal length.
/// index: from 0 to layerCount, clamped to it. layerCount: from 1 to 65536, clamped to it.
/// Result in [0,1]: index / layerCount, exactly 0 for the first and 1 for the last.
/// Source: LVSM section 4.
template <typename T = float>
T uniformSplit(int index, int layerCount)
{
    const int count = detail::clamp(layerCount, 1, kMaxUniformLayers);
    // Rounded, so that it is the same number wherever it is worked out.
    const T length = detail::rounded(static_cast<T>(count));
    return index >= count ? T(1) : detail::rounded(static_cast<T>(detail::maximum(index, 0)) / length);
}

/// Layer that holds a depth, for layers of equal length.
/// depth: in [0,1]; depths outside go to the end layers. layerCount: from 1 to 65536, clamped to it.
/// Result from 0 to layerCount - 1, the same as layerIndex gives for the splits of uniformSplit.
/// Source: LVSM section 5.
template <typename T>
int uniformLayerIndex(T depth, int layerCount)
{
    const int count = detail::clamp(layerCount, 1, kMaxUniformLayers);
    const T scaled = detail::clamp(depth, T(0), T(1)) * static_cast<T>(count);
    const int index = detail::minimum(static_cast<int>(scaled), count - 1);
    if (index > 0 && depth < uniformSplit<T>(index, count))
        return index - 1;
    if (index + 1 < count && depth >= uniformSplit<T>(index + 1, count))
        return index + 1;
    return index;
}

/// Layer that holds a depth, by search of the splits.
/// depth: in [0,1]; depths outside go to the end layers, and a depth on a split to the layer behind it.
/// splits: layerCount + 1 values, not decreasing, from 0 to 1. layerCount: at least 1, in shaders at most
/// LVSM_MAX_LAYERS. Result from 0 to layerCount - 1.
/// Source: LVSM section 5.
template <typename T>
int layerIndex(T depth, const T* splits, int layerCount)
{
    LVSM_ASSERT(splits != nullptr);
    int index = 0;
    for (int i = 1; i < layerCount; ++i)
        index += depth >= splits[i] ? 1 : 0;
    return index;
}

/// Moments to store in a layer for one depth: the warped depth and its square.
/// depth: in [0,1]. interval: begin and end of the layer. Result: (M1, M2), each in [0,1].
/// A texel without any surface stores depth 1: (1, 1) in every layer.
/// Source: LVSM equations 1 and 6.
template <typename T, glm::qualifier Q>
glm::vec<2, T> layerMoments(T depth, const glm::vec<2, T, Q>& interval)
{
    const T warped = layerWarp(depth, interval);
    return {warped, warped * warped};
}

/// Two layers in one texel of four components.
/// even, odd: moments of the layer of even index and of the next. Result: even in xy, odd in zw, unchanged.
/// Source: LVSM section 5.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> packLayers(const glm::vec<2, T, Q>& even, const glm::vec<2, T, Q>& odd)
{
    return {even.x, even.y, odd.x, odd.y};
}

/// One layer out of a texel that holds two.
/// texel: as packLayers made it. index: of the layer; its texel is number index / 2.
/// Result: the moments in xy where index is even, in zw where it is odd, unchanged.
/// Source: LVSM section 5.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> unpackLayer(const glm::vec<4, T, Q>& texel, int index)
{
    return (index & 1) == 0 ? glm::vec<2, T, Q>(texel.x, texel.y) : glm::vec<2, T, Q>(texel.z, texel.w);
}

/// Visibility of a receiver from the moments of one layer: an upper bound on the lit share of the filter window.
/// moments: of the layer, filtered. depth: the receiver's, in [0,1]. interval: begin and end of the layer.
/// minVariance: the global floor in depth squared, >= 0. Result in [0,1].
/// Exact where all occluders lie at or in front of the layer's begin and the receiver inside it. The layer that holds
/// the receiver is not always the least bound: where the window holds deeper surfaces, a layer in front can be less.
/// Source: LVSM section 3.3, equations 3, 6 and 7.
template <typename T, glm::qualifier Q, glm::qualifier QI>
T layeredVisibility(const glm::vec<2, T, Q>& moments, T depth, const glm::vec<2, T, QI>& interval, T minVariance)
{
    const T t = layerWarp(depth, interval);
    return chebyshevUpperBound(moments, t, layerMinVariance(minVariance, interval));
}

/// Weight of the neighbour layer near a split, which makes visibility continuous in depth across it.
/// depth: the receiver's, in [begin, end]. begin, end: splits of the layer that holds it.
/// width: of the transition on each side of a split, in depth, at most half the layer's length; 0 gives none.
/// Result in [-1/2, 1/2]: 0 where the layer's own sample suffices, negative towards the neighbour in front,
/// positive towards the one behind. The outer ends, at 0 and 1, have no neighbour.
/// Source: LVSM section 5, the transition region.
template <typename T>
T transitionWeight(T depth, T begin, T end, T width)
{
    const T reach = detail::minimum(width, T(0.5) * (end - begin));
    if (!(reach >= kTiny<T>))
        return T(0);
    const T fromBegin = begin > T(0) ? linstep(depth, begin, begin + reach) : T(1);
    const T toEnd = end < T(1) ? linstep(depth, end - reach, end) : T(0);
    return T(0.5) * (fromBegin + toEnd - T(1));
}

/// Visibility blended across a split.
/// visibility: of the layer that holds the receiver. neighbour: of the layer that the sign of weight names. Both are
/// clamped to [0,1]. weight: as transitionWeight gives it, its size clamped to [0,1].
/// Result in [0,1]: visibility at weight 0, neighbour at a size of 1, linear between.
/// Source: LVSM section 5, the transition region.
template <typename T>
T blendTransition(T visibility, T neighbour, T weight)
{
    using glm::abs;
    const T share = detail::minimum(T(1), abs(weight));
    const T rest = detail::rounded(T(1) - share);
    return detail::clamp(visibility, T(0), T(1)) * rest + detail::clamp(neighbour, T(0), T(1)) * share;
}

} // namespace lvsm

#endif
