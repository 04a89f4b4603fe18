// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments.
// Exponential variance shadow maps: moments of a positive and a negative exponential warp.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, section 7.

// Largest finite value of a storage format, for maxExponent.
const LVSM_LARGEST_FP16: f32 = 65504.0;
const LVSM_LARGEST_FP32: f32 = 3.4028234e38;

// Largest exponent in fp32. The second moments would be finite up to ln(FLT_MAX) / 2 = 44.36, but the bound divides by
// up to 2 e^(2c), and Vulkan promises nothing for divisors over 2^126. So c is 125 ln 2 / 2 = 43.32170, less 1.1e-5 for
// the error of exp, 3 + 2 |x| units in the last place. The smallest square, e^(-2c), is then a normal float too.
const LVSM_MAX_EXPONENT: f32 = 43.3216;

/// The two exponential warps of a depth: e^(cx) and -e^(-cx), for x the depth remapped to [-1,1].
/// depth: in [0,1], clamped to it. exponents: c of the positive and of the negative warp, each clamped to [0, 43.3216].
/// Result: (positive, negative); the positive in (0, 6.6e18], the negative in [-6.6e18, 0); both rise with depth.
/// Source: LVSM section 7.
fn lvsm_exponentialWarp(depth: f32, exponents: vec2f) -> vec2f
{
    let x = lvsm_signedDepth(depth);
    let c = clamp(exponents, vec2f(0.0), vec2f(LVSM_MAX_EXPONENT));
    return vec2f(exp(c.x * x), -exp(-c.y * x));
}

/// Moments to store for one depth: each warp and its square.
/// depth: in [0,1], clamped to it. exponents: of the two warps, each clamped to [0, 43.3216].
/// Result: (positive, positive^2, negative, negative^2), in [-6.6e18, 4.3e37]; fp16 holds it up to exponents of 5.545.
/// A texel without any surface stores depth 1; the clear colour is this function's result for it.
/// Source: LVSM section 7.
fn lvsm_exponentialMoments(depth: f32, exponents: vec2f) -> vec4f
{
    let warped = lvsm_exponentialWarp(depth, exponents);
    return vec4f(warped.x, warped.x * warped.x, warped.y, warped.y * warped.y);
}

/// Variance floors in the two warped spaces that equal a global floor in depth: carried through each warp's slope.
/// minVariance: the global floor in depth squared, >= 0, less counts as 0. depth: the receiver's, in [0,1].
/// exponents: of the two warps, each clamped to [0, 43.3216].
/// Result: (positive, negative), each in [0, 4.3e37]: (2 c w)^2 minVariance for a warp w, at most w^2.
/// Source: first-order propagation through the slope of each warp of LVSM section 7, d/dx e^(c (2x - 1)) = 2 c w.
fn lvsm_exponentialMinVariance(minVariance: f32, depth: f32, exponents: vec2f) -> vec2f
{
    let warped = lvsm_exponentialWarp(depth, exponents);
    let c = clamp(exponents, vec2f(0.0), vec2f(LVSM_MAX_EXPONENT));
    let scale = min(4.0 * c * c * max(minVariance, 0.0), vec2f(1.0));
    return scale * (warped * warped);
}

/// Visibility of a receiver from the moments of the positive warp alone (EVSM2).
/// moments: of the positive warp, filtered. depth: the receiver's, in [0,1]. exponent: of the warp, as when stored.
/// minVariance: the global floor in depth squared, >= 0.
/// Result in [0,1], an upper bound on the lit share of the window.
/// Source: LVSM section 7 and equation 3.
fn lvsm_exponentialVisibility2(moments: vec2f, depth: f32, exponent: f32, minVariance: f32) -> f32
{
    let exponents = vec2f(exponent, 0.0);
    let warped = lvsm_exponentialWarp(depth, exponents).x;
    return lvsm_chebyshevUpperBound(moments, warped, lvsm_exponentialMinVariance(minVariance, depth, exponents).x);
}

/// Visibility of a receiver from the moments of both warps (EVSM4): the lesser of their two upper bounds.
/// moments: as exponentialMoments made them, filtered. depth: the receiver's, in [0,1].
/// exponents: of the two warps, as when stored. minVariance: the global floor in depth squared, >= 0.
/// Result in [0,1], an upper bound on the lit share of the window.
/// Source: LVSM section 7 and equation 3.
fn lvsm_exponentialVisibility4(moments: vec4f, depth: f32, exponents: vec2f, minVariance: f32) -> f32
{
    let warped = lvsm_exponentialWarp(depth, exponents);
    let floors = lvsm_exponentialMinVariance(minVariance, depth, exponents);
    return min(lvsm_chebyshevUpperBound(moments.xy, warped.x, floors.x),
               lvsm_chebyshevUpperBound(moments.zw, warped.y, floors.y));
}

/// Largest exponent whose moments a storage format can hold and a filter can sum.
/// largest: the format's largest finite value, see the LVSM_LARGEST constants; less than 1 counts as 1.
/// headRoom: how often an unnormalised filter sum holds its largest sample, >= 1 (1 for weights that sum to 1). Each
/// rounding to fp16 on the way needs 1/2048 more of it.
/// Result in [0, 43.3216]: 5.545 for fp16 and 43.3216 for fp32 without head room.
/// Source: headRoom e^(2c) <= largest, solved for c; in fp32 the divisor of the bound sets the limit.
fn lvsm_maxExponent(largest: f32, headRoom: f32) -> f32
{
    let ratio = max(largest, 1.0) / clamp(headRoom, 1.0, LVSM_HUGE);
    return clamp(0.5 * log(max(ratio, 1.0)), 0.0, LVSM_MAX_EXPONENT);
}
