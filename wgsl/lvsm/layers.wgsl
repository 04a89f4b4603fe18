// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments.
// Layered variance shadow maps: the depth range cut into layers, each with its own linear warp.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, sections 3.2 to 3.4 and 5.

/// The warp that resolves one receiver perfectly: everything in front of the split is one occluder.
/// depth, split: in [0,1]. Result in [0,1]: 0 below the split, 1 from the split on.
/// Source: LVSM equation 5.
fn lvsm_stepWarp(depth: f32, split: f32) -> f32
{
    return select(0.0, 1.0, depth >= split);
}

/// Depth warped to a layer: 0 in front of it, 1 behind it, linear inside.
/// depth: in [0,1]. interval: begin and end of the layer, begin < end. Result in [0,1].
/// Degenerate: an empty or inverted interval is stepWarp at its end.
/// Source: LVSM equation 6.
fn lvsm_layerWarp(depth: f32, interval: vec2f) -> f32
{
    return lvsm_linstep(depth, interval.x, interval.y);
}

/// Interval that a layer covers: its two splits, moved outwards by the overlap.
/// begin, end: the splits in front of and behind the layer. overlap: in depth, >= 0, less counts as 0.
/// Result: (begin, end) in [0,1]; the outer ends of the first and last layer stay at 0 and 1.
/// Source: LVSM section 3.4.
fn lvsm_layerInterval(begin: f32, end: f32, overlap: f32) -> vec2f
{
    let widening = max(overlap, 0.0);
    return clamp(vec2f(begin - widening, end + widening), vec2f(0.0), vec2f(1.0));
}

/// Variance floor in a layer's warped depth that equals a global floor in depth.
/// minVariance: the global floor in depth squared, >= 0, less counts as 0. interval: begin and end of the layer.
/// Result in [0, 1/4]: 1/4 is the largest variance that depths in [0,1] can have (Popoviciu's inequality).
/// Degenerate: for a vanishing layer 1/4, or 0 where minVariance is 0.
/// Source: LVSM equation 7.
fn lvsm_layerMinVariance(minVariance: f32, interval: vec2f) -> f32
{
    let extent = clamp(interval.y - interval.x, 0.0, 1.0);
    let squared = extent * extent;
    if (minVariance < LVSM_TINY)
    {
        return 0.0;
    }
    return select(min(minVariance / squared, 0.25), 0.25, 0.25 * squared <= minVariance);
}

/// Split number index of layers of equal length.
/// index: from 0 to layerCount, clamped to it. layerCount: from 1 to 65536, clamped to it.
/// Result in [0,1]: index / layerCount, exactly 0 for the first and 1 for the last.
/// Source: LVSM section 4.
fn lvsm_uniformSplit(index: i32, layerCount: i32) -> f32
{
    let count = clamp(layerCount, 1, LVSM_MAX_UNIFORM_LAYERS);
    return select(f32(max(index, 0)) / f32(count), 1.0, index >= count);
}

/// Layer that holds a depth, for layers of equal length.
/// depth: in [0,1]; depths outside go to the end layers. layerCount: from 1 to 65536, clamped to it.
/// Result from 0 to layerCount - 1, the same as layerIndex gives for the splits of uniformSplit.
/// Source: LVSM section 5.
fn lvsm_uniformLayerIndex(depth: f32, layerCount: i32) -> i32
{
    let count = clamp(layerCount, 1, LVSM_MAX_UNIFORM_LAYERS);
    let index = min(i32(clamp(depth, 0.0, 1.0) * f32(count)), count - 1);
    if (index > 0 && depth < lvsm_uniformSplit(index, count))
    {
        return index - 1;
    }
    if (index + 1 < count && depth >= lvsm_uniformSplit(index + 1, count))
    {
        return index + 1;
    }
    return index;
}

/// Layer that holds a depth, by search of the splits.
/// depth: in [0,1]; depths outside go to the end layers, and a depth on a split to the layer behind it.
/// splits: layerCount + 1 values, not decreasing, from 0 to 1. layerCount: at least 1, in shaders at most
/// LVSM_MAX_LAYERS. Result from 0 to layerCount - 1.
/// Source: LVSM section 5.
fn lvsm_layerIndex(depth: f32, splits: array<f32, LVSM_MAX_LAYERS + 1>, layerCount: i32) -> i32
{
    var index = 0;
    for (var i = 1; i < LVSM_MAX_LAYERS; i++)
    {
        index += select(0, 1, i < layerCount && depth >= splits[i]);
    }
    return index;
}

/// Moments to store in a layer for one depth: the warped depth and its square.
/// depth: in [0,1]. interval: begin and end of the layer. Result: (M1, M2), each in [0,1].
/// A texel without any surface stores depth 1: (1, 1) in every layer.
/// Source: LVSM equations 1 and 6.
fn lvsm_layerMoments(depth: f32, interval: vec2f) -> vec2f
{
    let warped = lvsm_layerWarp(depth, interval);
    return vec2f(warped, warped * warped);
}

/// Two layers in one texel of four components.
/// even, odd: moments of the layer of even index and of the next. Result: even in xy, odd in zw, unchanged.
/// Source: LVSM section 5.
fn lvsm_packLayers(even: vec2f, odd: vec2f) -> vec4f
{
    return vec4f(even, odd);
}

/// One layer out of a texel that holds two.
/// texel: as packLayers made it. index: of the layer; its texel is number index / 2.
/// Result: the moments in xy where index is even, in zw where it is odd, unchanged.
/// Source: LVSM section 5.
fn lvsm_unpackLayer(texel: vec4f, index: i32) -> vec2f
{
    return select(texel.zw, texel.xy, (index & 1) == 0);
}

/// Visibility of a receiver from the moments of one layer: an upper bound on the lit share of the filter window.
/// moments: of the layer, filtered. depth: the receiver's, in [0,1]. interval: begin and end of the layer.
/// minVariance: the global floor in depth squared, >= 0. Result in [0,1].
/// Exact where all occluders lie at or in front of the layer's begin and the receiver inside it. The layer that holds
/// the receiver is not always the least bound: where the window holds deeper surfaces, a layer in front can be less.
/// Source: LVSM section 3.3, equations 3, 6 and 7.
fn lvsm_layeredVisibility(moments: vec2f, depth: f32, interval: vec2f, minVariance: f32) -> f32
{
    let t = lvsm_layerWarp(depth, interval);
    return lvsm_chebyshevUpperBound(moments, t, lvsm_layerMinVariance(minVariance, interval));
}

/// Weight of the neighbour layer near a split, which makes visibility continuous in depth across it.
/// depth: the receiver's, in [begin, end]. begin, end: splits of the layer that holds it.
/// width: of the transition on each side of a split, in depth, at most half the layer's length; 0 gives none.
/// Result in [-1/2, 1/2]: 0 where the layer's own sample suffices, negative towards the neighbour in front,
/// positive towards the one behind. The outer ends, at 0 and 1, have no neighbour.
/// Source: LVSM section 5, the transition region.
fn lvsm_transitionWeight(depth: f32, begin: f32, end: f32, width: f32) -> f32
{
    let reach = min(width, 0.5 * (end - begin));
    if (reach < LVSM_TINY)
    {
        return 0.0;
    }
    let fromBegin = select(1.0, lvsm_linstep(depth, begin, begin + reach), begin > 0.0);
    let toEnd = select(0.0, lvsm_linstep(depth, end - reach, end), end < 1.0);
    return 0.5 * (fromBegin + toEnd - 1.0);
}

/// Visibility blended across a split.
/// visibility: of the layer that holds the receiver. neighbour: of the layer that the sign of weight names. Both are
/// clamped to [0,1]. weight: as transitionWeight gives it, its size clamped to [0,1].
/// Result in [0,1]: visibility at weight 0, neighbour at a size of 1, linear between.
/// Source: LVSM section 5, the transition region.
fn lvsm_blendTransition(visibility: f32, neighbour: f32, weight: f32) -> f32
{
    let share = min(abs(weight), 1.0);
    return clamp(visibility, 0.0, 1.0) * (1.0 - share) + clamp(neighbour, 0.0, 1.0) * share;
}
