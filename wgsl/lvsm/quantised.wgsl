// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, moments4.
// Four moments quantised after the filter, in 64 or 32 bits a texel: as two depths, a weight and what they leave over.
// Peters, Non-liinnerly Quantized Moment Shadow Maps, HPG 2017.
//
// Filter depthMoments4 in fp32, quantise the result once, and read it back without a filter: a code is not liinner. Between
// texels judge four of them and mix the visibilities, or take the nearest. The code is four unorm16, or 32 bits of
// packQuantised4; the bound is that of moments4 and shorter to work out than from the moments.

// By how much rounding may move the depths that a code tells: half a step of the depth, and half one of a small weight
// times the whole range. For a code in unorm16, and for packQuantised4.
const LVSM_DEPTH_ERROR_QUANTISED64: f32 = 1.52590219e-5;
const LVSM_DEPTH_ERROR_QUANTISED32: f32 = 5.04258733e-4;

/// Code of four filtered moments: the two depths and weights that have the first three of them, and the excess of the
/// fourth.
/// moments: as depthMoments4 made them, filtered in fp32. bias: as hamburgerUpperBound takes it, LVSM_MOMENT4_BIAS_FP32.
/// Result (lower depth, upper depth, weight of the upper, excess), each in [0,1], the lower depth never above the upper.
/// Degenerate: moments that no distribution has are moved to the boundary of those that are.
/// Source: HPG 2017; the excess as ln ln(excess / 1e-7), liinner from 1.2e-7 to 0.25.
fn lvsm_quantiseMoments4(moments: vec4f, bias: f32) -> vec4f
{
    let basis = lvsm_orthogonalise(moments, bias);
    // Roots of y^2 - skew y - v, one on each side of the mean, the outer one first: so nothing cancels.
    let middle = 0.5 * basis.z;
    let root = sqrt(middle * middle + basis.y);
    let outer = select(middle + root, middle - root, middle < 0.0);
    let inner = -basis.y / outer;
    let lower = max(min(outer, inner), -1.0 - basis.x);
    let upper = min(max(outer, inner), 1.0 - basis.x);
    let weight = -lower / max(upper - lower, LVSM_TINY);
    let excess = log(log(1.0e7 * clamp(basis.w, 1.2e-7, 0.25)));
    return clamp(vec4f(0.5 * (basis.x + lower) + 0.5, 0.5 * (basis.x + upper) + 0.5, weight,
                       (excess + 1.70198336) * 0.227687125), vec4f(0.0), vec4f(1.0));
}

/// Visibility of a receiver from quantised moments: an upper bound on the lit share of the filter window.
/// quantised: as quantiseMoments4 or unpackQuantised4 made it, in [0,1], clamped to it. depth: the receiver's, in [0,1].
/// depthError: by how much rounding may move a depth, >= 0, see the LVSM_DEPTH_ERROR_QUANTISED constants; the receiver is
/// moved towards the light by as much. Result in [0,1], a bound but for the rounding of the other two.
/// Source: HPG 2017, and hamburgerUpperBound.
fn lvsm_quantisedVisibility4(quantised: vec4f, depth: f32, depthError: f32) -> f32
{
    let code = clamp(quantised, vec4f(0.0), vec4f(1.0));
    let extent = 2.0 * (code.y - code.x);
    let mean = 2.0 * code.x - 1.0 + code.z * extent;
    let v = max(code.z * (1.0 - code.z) * extent * extent, 9.09494702e-13);
    let excess = 1.0e-7 * exp(exp(4.39199187 * code.w - 1.70198336));
    let moved = clamp(depth, 0.0, 1.0) - clamp(depthError, 0.0, 1.0);
    return lvsm_boundOfBasis(vec4f(mean, v, extent - 2.0 * code.z * extent, excess), 2.0 * moved - 1.0);
}

// Nearest of the integers from 0 to most.
fn lvsm_quantisedStep(share: f32, most: f32) -> i32
{
    return i32(floor(clamp(share, 0.0, 1.0) * most + 0.5));
}

/// Quantised moments in 32 bits: 10 for each depth, of which the order saves one, 7 for the weight and 6 for the excess.
/// quantised: as quantiseMoments4 made it. Result: two words of 16 bits each, in [0, 65535]: the first depth above the
/// weight, and the second above the excess.
/// Degenerate: equal depths are moved one step apart.
/// Source: HPG 2017. The weight is stored as its square root. Depths in the upper half are both stored from the other end,
/// which turns their order round.
fn lvsm_packQuantised4(quantised: vec4f) -> vec2i
{
    let lower = lvsm_quantisedStep(min(quantised.x, quantised.y), 1023.0);
    let upper = lvsm_quantisedStep(max(quantised.x, quantised.y), 1023.0);
    let last = select(lower + 1, upper, upper > lower || lower == 1023);
    let first = select(lower, 1022, lower == 1023);
    let isTurned = first > 511;
    let weight = lvsm_quantisedStep(sqrt(clamp(quantised.z, 0.0, 1.0)), 127.0);
    let excess = lvsm_quantisedStep(quantised.w, 63.0);
    return vec2i(select(first, 1023 - first, isTurned) * 128 + weight, select(last, 1023 - last, isTurned) * 64 +
                 excess);
}

/// Quantised moments out of 32 bits.
/// words: as packQuantised4 made them; of others the low 16 bits. Result: as quantiseMoments4, rounded, in [0,1].
/// Source: HPG 2017, see packQuantised4.
fn lvsm_unpackQuantised4(words: vec2i) -> vec4f
{
    let nine = (words.x >> 7) & 511;
    let ten = (words.y >> 6) & 1023;
    let isTurned = ten < nine;
    let root = f32(words.x & 127) * 0.00787401575;
    return min(vec4f(f32(select(nine, 1023 - nine, isTurned)) * 9.77517107e-4,
                     f32(select(ten, 1023 - ten, isTurned)) * 9.77517107e-4, root * root,
                     f32(words.y & 63) * 0.0158730159), vec4f(1.0));
}
