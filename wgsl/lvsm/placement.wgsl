// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments.
// Placing the splits by Lloyd relaxation on second occluders, one step at a time.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, sections 4 and 5.
//
// Each frame: scheduledSplits chooses two splits. For every texel of the unwarped moments, a bilinear sample at
// neighbourhoodTexCoord (or neighbourhoodMoments of four loads) gives secondOccluder and occluderWeight; nearestSplit
// assigns it, and accumulateSplits writes what a mipmap chain or a reduction then averages. updateSplit moves the two
// splits, teleportSplits rescues one whose cluster is empty, monotoneSplits restores the order.

/// Texture coordinate at which one bilinear sample averages a texel and its neighbours in x, y and both.
/// texel: from 0 to size - 1, clamped to it. size: of the map in texels, each at least 1, less counts as 1.
/// Result in (0,1]: the far corner of the texel. With an address mode that clamps, the last row and column average
/// themselves.
/// Source: LVSM section 5.
fn lvsm_neighbourhoodTexCoord(texel: vec2i, size: vec2i) -> vec2f
{
    let extent = max(size, vec2i(1));
    let inside = clamp(texel, vec2i(0), extent - 1);
    return clamp((vec2f(inside) + 1.0) / vec2f(extent), vec2f(0.0), vec2f(1.0));
}

/// Moments of a 2x2 neighbourhood from four loads: what one bilinear sample between the texels gives.
/// m00, m10, m01, m11: (M1, M2) of the four texels. Result: their average, any number.
/// Source: LVSM section 5.
fn lvsm_neighbourhoodMoments(m00: vec2f, m10: vec2f, m01: vec2f, m11: vec2f) -> vec2f
{
    let average = 0.25 * m00 + 0.25 * m10 + 0.25 * m01 + 0.25 * m11;
    return average;
}

/// Depth of the second occluder of a neighbourhood: the mean plus the standard deviation.
/// moments: (M1, M2) of the neighbourhood. Result in [0,1].
/// Of two depths a and b that cover alpha and 1 - alpha it is max(a, b) at alpha = 1/2, and elsewhere
/// alpha a + (1 - alpha) b + sqrt(alpha (1 - alpha)) |a - b|.
/// Source: LVSM section 4.1.
fn lvsm_secondOccluder(moments: vec2f) -> f32
{
    return clamp(moments.x + sqrt(lvsm_variance(moments, 0.0)), 0.0, 1.0);
}

/// Weight of a neighbourhood in the relaxation: its variance, clamped.
/// moments: (M1, M2) of the neighbourhood. minVariance: less variance than this weighs nothing. maxVariance: the most
/// that counts, >= 0. Both in depth squared. Result in [0, maxVariance].
/// Degenerate: maxVariance below 0 gives 0.
/// Source: LVSM section 4.1.
fn lvsm_occluderWeight(moments: vec2f, minVariance: f32, maxVariance: f32) -> f32
{
    let v = lvsm_variance(moments, 0.0);
    return select(min(v, max(maxVariance, 0.0)), 0.0, v < minVariance);
}

/// Inner split nearest to a value: the cluster that the value belongs to.
/// value: in [0,1]. splits: layerCount + 1 values, not decreasing, from 0 to 1. layerCount: in shaders at most
/// LVSM_MAX_LAYERS.
/// Result from 1 to layerCount - 1, the lower one of two at the same distance; 0 where there is no inner split.
/// Source: LVSM section 5.
fn lvsm_nearestSplit(value: f32, splits: array<f32, LVSM_MAX_LAYERS + 1>, layerCount: i32) -> i32
{
    if (layerCount < 2)
    {
        return 0;
    }
    var nearest = 1;
    var least = abs(value - splits[1]);
    for (var i = 2; i < LVSM_MAX_LAYERS; i++)
    {
        let gap = abs(value - splits[i]);
        if (i < layerCount && gap < least)
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
fn lvsm_accumulateSplits(value: f32, weight: f32, nearest: i32, first: i32, second: i32) -> vec4f
{
    let share = vec2f(weight * clamp(value, 0.0, 1.0), weight);
    return vec4f(select(vec2f(0.0), share, nearest == first), select(vec2f(0.0), share, nearest == second));
}

/// Split moved to the weighted mean of its cluster.
/// split: where it is, in [0,1]. weightedValue, weight: sums or averages of what accumulateSplits gave.
/// Result in [0,1]: weightedValue / weight, or split where the cluster is empty (weight under 2^-126).
/// Source: LVSM section 5.
fn lvsm_updateSplit(split: f32, weightedValue: f32, weight: f32) -> f32
{
    let total = min(weight, LVSM_HUGE);
    return clamp(select(weightedValue / total, split, total < LVSM_TINY), 0.0, 1.0);
}

/// The two inner splits to move in a frame, so that all have their turn.
/// frame: number of the frame, >= 0, less counts as 0. layerCount: up to 65536.
/// Result: each from 1 to layerCount - 1, both 1 for two layers, both 0 where there is no inner split.
/// Source: LVSM section 5.
fn lvsm_scheduledSplits(frame: i32, layerCount: i32) -> vec2i
{
    let inner = clamp(layerCount, 1, LVSM_MAX_UNIFORM_LAYERS) - 1;
    if (inner < 1)
    {
        return vec2i(0);
    }
    let turn = 2 * (max(frame, 0) % inner);
    return vec2i(1 + turn % inner, 1 + (turn + 1) % inner);
}

/// Splits made valid: the ends at 0 and 1, everything in [0,1], not decreasing.
/// splits: layerCount + 1 values, changed in place. layerCount: at least 1, less counts as 1; in shaders
/// at most LVSM_MAX_LAYERS, more counts as that.
/// Source: LVSM section 5 needs a monotone sequence; splits moved by data some frames old may not be one.
fn lvsm_monotoneSplits(splits: ptr<function, array<f32, LVSM_MAX_LAYERS + 1>>, layerCount: i32)
{
    let count = clamp(layerCount, 1, LVSM_MAX_LAYERS);
    (*splits)[0] = 0.0;
    for (var i = 1; i < LVSM_MAX_LAYERS; i++)
    {
        if (i < count)
        {
            (*splits)[i] = clamp((*splits)[i], (*splits)[i - 1], 1.0);
        }
    }
    (*splits)[count] = 1.0;
}

/// A split whose cluster is empty, moved to where it is of use: its two layers merge and the heaviest layer is halved.
/// splits: layerCount + 1 values, not decreasing, changed in place. weights: of the cluster of each inner split, under
/// the split's index; the first and last are not read. layerCount: in shaders at most LVSM_MAX_LAYERS, more counts as
/// that.
/// The first empty one of several moves. A layer weighs as much as the clusters at its two ends together, and the
/// first of several heaviest is halved. Nothing changes where no cluster is empty or all are.
/// Source: LVSM section 5, teleportation.
fn lvsm_teleportSplits(splits: ptr<function, array<f32, LVSM_MAX_LAYERS + 1>>, weights: array<f32, LVSM_MAX_LAYERS + 1>,
                       layerCount: i32)
{
    let count = min(layerCount, LVSM_MAX_LAYERS);
    var empty = 0;
    for (var i = LVSM_MAX_LAYERS - 1; i > 0; i--)
    {
        empty = select(empty, i, i < count && weights[i] < LVSM_TINY);
    }
    if (empty == 0)
    {
        return;
    }

    var heaviest = 0.0;
    var behind = 0;
    var before = 0.0;
    for (var j = 1; j <= LVSM_MAX_LAYERS; j++)
    {
        if (j > count || j == empty)
        {
            continue;
        }
        let after = select(0.0, 0.5 * max(weights[j], 0.0), j < count);
        if (before + after > heaviest)
        {
            heaviest = before + after;
            behind = j;
        }
        before = after;
    }
    if (behind == 0)
    {
        return;
    }

    let inFront = select(behind - 1, behind - 2, behind - 1 == empty);
    let middle = 0.5 * (clamp((*splits)[inFront], 0.0, 1.0) + clamp((*splits)[behind], 0.0, 1.0));
    for (var k = 1; k < LVSM_MAX_LAYERS - 1; k++)
    {
        if (k >= empty && k < inFront)
        {
            (*splits)[k] = (*splits)[k + 1];
        }
    }
    for (var m = LVSM_MAX_LAYERS - 1; m > 1; m--)
    {
        if (m <= empty && m > behind)
        {
            (*splits)[m] = (*splits)[m - 1];
        }
    }
    (*splits)[select(behind, max(inFront, empty), behind > empty)] = middle;
}
