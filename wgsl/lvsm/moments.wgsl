// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth.
// Variance shadow maps: two moments of depth and the one-tailed Chebyshev bound.
// Donnelly & Lauritzen, Variance Shadow Maps, I3D 2006; Lauritzen & McCool, Layered Variance Shadow Maps,
// Graphics Interface 2008, section 3; Lauritzen, Summed-Area Variance Shadow Maps, GPU Gems 3 (2007), chapter 8.

// Largest rounding error of a depth in [0,1] stored in a format: half a step of 2^b - 1 equal ones for unorm,
// half a unit in the last place below 1 for floating point. For recommendedMinVariance.
const LVSM_DEPTH_ERROR_UNORM8: f32 = 0.00196078431372549;
const LVSM_DEPTH_ERROR_UNORM16: f32 = 7.629510948348211e-6;
const LVSM_DEPTH_ERROR_FP16: f32 = 0.000244140625;
const LVSM_DEPTH_ERROR_FP32: f32 = 2.98023224e-8;

/// Moments to store for one depth: the depth and its square.
/// depth: in [0,1], clamped to it. Result: (M1, M2), each in [0,1]. A texel without any surface stores depth 1: (1, 1).
/// Source: LVSM equation 1.
fn lvsm_depthMoments(depth: f32) -> vec2f
{
    let m1 = clamp(depth, 0.0, 1.0);
    return vec2f(m1, m1 * m1);
}

/// Moments to store for a texel that a slanted surface fills: the second carries the variance inside the texel.
/// depth: in [0,1], clamped to it. dx, dy: change of depth from one texel to the next (screen derivatives).
/// Result: (M1, M2), each in [0,1]; M2 is at most M1, which no distribution of depths in [0,1] exceeds.
/// Source: GPU Gems 3, section 8.4.2: M2 + (dx^2 + dy^2) / 4.
fn lvsm_depthMomentsSloped(depth: f32, dx: f32, dy: f32) -> vec2f
{
    let m1 = clamp(depth, 0.0, 1.0);
    return vec2f(m1, min(m1 * m1 + 0.25 * (dx * dx + dy * dy), m1));
}

/// Mean depth of filtered moments.
/// moments: (M1, M2). Result: M1, unchanged.
/// Source: LVSM equation 2.
fn lvsm_mean(moments: vec2f) -> f32
{
    return moments.x;
}

/// Variance of filtered moments, with a floor.
/// moments: (M1, M2). minVariance: the floor, in depth squared of the moments' space, >= 0 (less counts as 0).
/// Result: at least minVariance, never negative. Rounding can make M2 - M1^2 negative: the floor takes its place.
/// Source: LVSM equation 2 and the clamp that follows equation 3.
fn lvsm_variance(moments: vec2f, minVariance: f32) -> f32
{
    let difference = moments.y - moments.x * moments.x;
    return max(difference, max(minVariance, 0.0));
}

/// Upper bound on the share of the filter window that is at depth t or farther: the visibility of a receiver at t.
/// moments: (M1, M2) filtered. t: the receiver's depth in the moments' space. minVariance: floor of the variance, >= 0.
/// Result in [0,1]: 1 for t <= M1. Exact for one planar occluder over one planar receiver at t.
/// Degenerate: zero variance is a step, 1 up to M1 and 0 beyond. Up to 2^-63 beyond counts as M1 itself: what float
/// cannot resolve does not darken.
/// Source: LVSM equation 3 (one-tailed Chebyshev inequality, also called Cantelli's).
fn lvsm_chebyshevUpperBound(moments: vec2f, t: f32, minVariance: f32) -> f32
{
    let v = lvsm_variance(moments, minVariance);
    let d = t - moments.x;
    let tail = clamp(v / max(v + d * d, LVSM_TINY), 0.0, 1.0);
    return select(1.0, tail, d > LVSM_ROOT_TINY);
}

/// Lower bound on the share of the filter window that is at depth t or farther: the mirror of chebyshevUpperBound.
/// moments: (M1, M2) filtered. t: the receiver's depth in the moments' space. minVariance: floor of the variance, >= 0.
/// Result in [0,1]: 0 for t >= M1, where the inequality says nothing.
/// Degenerate: zero variance is a step, 1 below M1 and 0 from M1 on. Up to 2^-63 below counts as M1 itself.
/// Source: LVSM equation 3 applied to -x: P(x >= t) >= 1 - v / (v + d^2).
fn lvsm_chebyshevLowerBound(moments: vec2f, t: f32, minVariance: f32) -> f32
{
    let v = lvsm_variance(moments, minVariance);
    let d = moments.x - t;
    let tail = clamp(v / max(v + d * d, LVSM_TINY), 0.0, 1.0);
    return select(0.0, 1.0 - tail, d > LVSM_ROOT_TINY);
}

/// Upper bound on the share of the filter window that is at depth t or farther, for depths known to lie in [0,1].
/// moments: (M1, M2) filtered, of a depth in [0,1]. t: the receiver's depth in the moments' space.
/// minVariance: floor of the variance, >= 0. Result in [0,1]: 1 for t <= 0, never above chebyshevUpperBound.
/// Exact for samples at 0 and 1 alone; without a floor no bound from two moments is less anywhere.
/// Degenerate: zero variance is a step, 1 up to M1 and 0 beyond.
/// Source: the least mean of three parabolas that are nowhere less than the step at t: Cantelli's; x / t (Markov's);
/// x (1 + t - x) / t. Together they are the bound of Markov and Krein for the support [0,1]. The floor adds
/// 9/4 minVariance / t^2 to the last two, which makes up for the same depth error as it does in Cantelli's.
fn lvsm_boundedUpperBound(moments: vec2f, t: f32, minVariance: f32) -> f32
{
    let tail = lvsm_chebyshevUpperBound(moments, t, minVariance);
    let valid = clamp(moments, vec2f(0.0), vec2f(1.0));
    let at = clamp(t, 0.0, 1.0);
    let inverse = 1.0 / max(at, LVSM_TINY);
    let room = 2.25 * clamp(minVariance, 0.0, 1.0) * inverse;
    let parabolas = (min(valid.x, valid.x * at + (valid.x - valid.y)) + room) * inverse;
    return select(1.0, clamp(min(tail, parabolas), 0.0, 1.0), t > 0.0);
}

/// Visibility with its low end cut off and the rest stretched back to [0,1]: less bleeding, darker penumbrae.
/// visibility: in [0,1]. amount: what counts as no light, in [0,1), less counts as 0.
/// Result in [0,1]: 0 up to amount, 1 at 1; rises with visibility and falls with amount.
/// Degenerate: amount >= 1 leaves only full visibility lit.
/// Source: GPU Gems 3, section 8.4.3.
fn lvsm_reduceLightBleeding(visibility: f32, amount: f32) -> f32
{
    return lvsm_linstep(visibility, max(amount, 0.0), 1.0);
}

/// Least variance floor with which rounding alone never darkens a flat lit receiver by more than a stated amount.
/// depthError: largest error of the stored depth, in [0,1], see the LVSM_DEPTH_ERROR constants; add those of all passes.
/// worstDarkening: accepted loss of visibility, in (0,1), clamped to [2^-24, 1].
/// Result in the square of the stored depth's unit, in [0, 2^24]. A layer stores its warped depth: the global floor
/// that layeredVisibility takes is the result times the square of the layer's length.
/// Source: solves v / (v + depthError^2) = 1 - worstDarkening, LVSM equation 3, for v.
fn lvsm_recommendedMinVariance(depthError: f32, worstDarkening: f32) -> f32
{
    let e = clamp(depthError, 0.0, 1.0);
    let darkening = clamp(worstDarkening, 5.96046448e-8, 1.0);
    return e * e * ((1.0 - darkening) / darkening);
}
