// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments.
// Layered variance shadow maps: the depth range cut into layers, each with its own linear warp.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, sections 3.2 to 3.4 and 5.
#ifndef LVSM_LAYERS_HLSLI
#define LVSM_LAYERS_HLSLI

#include "moments.hlsli"

/// The warp that resolves one receiver perfectly: everything in front of the split is one occluder.
/// depth, split: in [0,1]. Result in [0,1]: 0 below the split, 1 from the split on.
/// Source: LVSM equation 5.
float lvsm_stepWarp(float depth, float split)
{
    return depth >= split ? 1.0 : 0.0;
}

/// Depth warped to a layer: 0 in front of it, 1 behind it, linear inside.
/// depth: in [0,1]. interval: begin and end of the layer, begin < end. Result in [0,1].
/// Degenerate: an empty or inverted interval is stepWarp at its end.
/// Source: LVSM equation 6.
float lvsm_layerWarp(float depth, float2 interval)
{
    return lvsm_linstep(depth, interval.x, interval.y);
}

/// Interval that a layer covers: its two splits, moved outwards by the overlap.
/// begin, end: the splits in front of and behind the layer. overlap: in depth, >= 0, less counts as 0.
/// Result: (begin, end) in [0,1]; the outer ends of the first and last layer stay at 0 and 1.
/// Source: LVSM section 3.4.
float2 lvsm_layerInterval(float begin, float end, float overlap)
{
    float widening = max(overlap, 0.0);
    return clamp(float2(begin - widening, end + widening), 0.0, 1.0);
}

/// Variance floor in a layer's warped depth that equals a global floor in depth.
/// minVariance: the global floor in depth squared, >= 0, less counts as 0. interval: begin and end of the layer.
/// Result in [0, 1/4]: 1/4 is the largest variance that depths in [0,1] can have (Popoviciu's inequality).
/// Degenerate: for a vanishing layer 1/4, or 0 where minVariance is 0.
/// Source: LVSM equation 7.
float lvsm_layerMinVariance(float minVariance, float2 interval)
{
    float extent = clamp(interval.y - interval.x, 0.0, 1.0);
    float squared = extent * extent;
    if (minVariance < LVSM_TINY)
        return 0.0;
    return 0.25 * squared <= minVariance ? 0.25 : min(minVariance / squared, 0.25);
}

/// Split number index of layers of equal length.
/// index: from 0 to layerCount, clamped to it. layerCount: from 1 to 65536, clamped to it.
/// Result in [0,1]: index / layerCount, exactly 0 for the first and 1 for the last.
/// Source: LVSM section 4.
float lvsm_uniformSplit(int index, int layerCount)
{
    int count = clamp(layerCount, 1, LVSM_MAX_UNIFORM_LAYERS);
    return index >= count ? 1.0 : float(max(index, 0)) / float(count);
}

/// Layer that holds a depth, for layers of equal length.
/// depth: in [0,1]; depths outside go to the end layers. layerCount: from 1 to 65536, clamped to it.
/// Result from 0 to layerCount - 1, the same as layerIndex gives for the splits of uniformSplit.
/// Source: LVSM section 5.
int lvsm_uniformLayerIndex(float depth, int layerCount)
{
    int count = clamp(layerCount, 1, LVSM_MAX_UNIFORM_LAYERS);
    int index = min(int(clamp(depth, 0.0, 1.0) * float(count)), count - 1);
    if (index > 0 && depth < lvsm_uniformSplit(index, count))
        return index - 1;
    if (index + 1 < count && depth >= lvsm_uniformSplit(index + 1, count))
        return index + 1;
    return index;
}

/// Layer that holds a depth, by search of the splits.
/// depth: in [0,1]; depths outside go to the end layers, and a depth on a split to the layer behind it.
/// splits: layerCount + 1 values, not decreasing, from 0 to 1. layerCount: at least 1, in shaders at most
/// LVSM_MAX_LAYERS. Result from 0 to layerCount - 1.
/// Source: LVSM section 5.
int lvsm_layerIndex(float depth, float splits[LVSM_MAX_LAYERS + 1], int layerCount)
{
    int index = 0;
    for (int i = 1; i < LVSM_MAX_LAYERS; ++i)
        index += i < layerCount && depth >= splits[i] ? 1 : 0;
    return index;
}

/// Moments to store in a layer for one depth: the warped depth and its square.
/// depth: in [0,1]. interval: begin and end of the layer. Result: (M1, M2), each in [0,1].
/// A texel without any surface stores depth 1: (1, 1) in every layer.
/// Source: LVSM equations 1 and 6.
float2 lvsm_layerMoments(float depth, float2 interval)
{
    float warped = lvsm_layerWarp(depth, interval);
    return float2(warped, warped * warped);
}

/// Two layers in one texel of four components.
/// even, odd: moments of the layer of even index and of the next. Result: even in xy, odd in zw, unchanged.
/// Source: LVSM section 5.
float4 lvsm_packLayers(float2 even, float2 odd)
{
    return float4(even, odd);
}

/// One layer out of a texel that holds two.
/// texel: as packLayers made it. index: of the layer; its texel is number index / 2.
/// Result: the moments in xy where index is even, in zw where it is odd, unchanged.
/// Source: LVSM section 5.
float2 lvsm_unpackLayer(float4 texel, int index)
{
    return (index & 1) == 0 ? texel.xy : texel.zw;
}

/// Visibility of a receiver from the moments of one layer: an upper bound on the lit share of the filter window.
/// moments: of the layer, filtered. depth: the receiver's, in [0,1]. interval: begin and end of the layer.
/// minVariance: the global floor in depth squared, >= 0. Result in [0,1].
/// Exact where all occluders lie at or in front of the layer's begin and the receiver inside it. The layer that holds
/// the receiver is not always the least bound: where the window holds deeper surfaces, a layer in front can be less.
/// Source: LVSM section 3.3, equations 3, 6 and 7.
float lvsm_layeredVisibility(float2 moments, float depth, float2 interval, float minVariance)
{
    float t = lvsm_layerWarp(depth, interval);
    return lvsm_chebyshevUpperBound(moments, t, lvsm_layerMinVariance(minVariance, interval));
}

/// Weight of the neighbour layer near a split, which makes visibility continuous in depth across it.
/// depth: the receiver's, in [begin, end]. begin, end: splits of the layer that holds it.
/// width: of the transition on each side of a split, in depth, at most half the layer's length; 0 gives none.
/// Result in [-1/2, 1/2]: 0 where the layer's own sample suffices, negative towards the neighbour in front,
/// positive towards the one behind. The outer ends, at 0 and 1, have no neighbour.
/// Source: LVSM section 5, the transition region.
float lvsm_transitionWeight(float depth, float begin, float end, float width)
{
    float reach = min(width, 0.5 * (end - begin));
    if (reach < LVSM_TINY)
        return 0.0;
    float fromBegin = begin > 0.0 ? lvsm_linstep(depth, begin, begin + reach) : 1.0;
    float toEnd = end < 1.0 ? lvsm_linstep(depth, end - reach, end) : 0.0;
    return 0.5 * (fromBegin + toEnd - 1.0);
}

/// Visibility blended across a split.
/// visibility: of the layer that holds the receiver. neighbour: of the layer that the sign of weight names. Both are
/// clamped to [0,1]. weight: as transitionWeight gives it, its size clamped to [0,1].
/// Result in [0,1]: visibility at weight 0, neighbour at a size of 1, linear between.
/// Source: LVSM section 5, the transition region.
float lvsm_blendTransition(float visibility, float neighbour, float weight)
{
    float share = min(abs(weight), 1.0);
    return clamp(visibility, 0.0, 1.0) * (1.0 - share) + clamp(neighbour, 0.0, 1.0) * share;
}

#endif
