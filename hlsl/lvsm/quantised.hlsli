// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, moments4.
// Four moments quantised after the filter, in 64 or 32 bits a texel: as two depths, a weight and what they leave over.
// Peters, Non-liinnerly Quantized Moment Shadow Maps, HPG 2017.
//
// Filter depthMoments4 in fp32, quantise the result once, and read it back without a filter: a code is not liinner. Between
// texels judge four of them and mix the visibilities, or take the nearest. The code is four unorm16, or 32 bits of
// packQuantised4; the bound is that of moments4 and shorter to work out than from the moments.
#ifndef LVSM_QUANTISED_HLSLI
#define LVSM_QUANTISED_HLSLI

#include "moments4.hlsli"

// By how much rounding may move the depths that a code tells: half a step of the depth, and half one of a small weight
// times the whole range. For a code in unorm16, and for packQuantised4.
static const float LVSM_DEPTH_ERROR_QUANTISED64 = 1.52590219e-5;
static const float LVSM_DEPTH_ERROR_QUANTISED32 = 5.04258733e-4;

/// Code of four filtered moments: the two depths and weights that have the first three of them, and the excess of the
/// fourth.
/// moments: as depthMoments4 made them, filtered in fp32. bias: as hamburgerUpperBound takes it, LVSM_MOMENT4_BIAS_FP32.
/// Result (lower depth, upper depth, weight of the upper, excess), each in [0,1], the lower depth never above the upper.
/// Degenerate: moments that no distribution has are moved to the boundary of those that are.
/// Source: HPG 2017; the excess as ln ln(excess / 1e-7), liinner from 1.2e-7 to 0.25.
float4 lvsm_quantiseMoments4(float4 moments, float bias)
{
    float4 basis = lvsm_orthogonalise(moments, bias);
    // Roots of y^2 - skew y - v, one on each side of the mean, the outer one first: so nothing cancels.
    float middle = 0.5 * basis.z;
    float root = sqrt(middle * middle + basis.y);
    float outer = middle < 0.0 ? middle - root : middle + root;
    float inner = -basis.y / outer;
    float lower = max(min(outer, inner), -1.0 - basis.x);
    float upper = min(max(outer, inner), 1.0 - basis.x);
    float weight = -lower / max(upper - lower, LVSM_TINY);
    float excess = log(log(1.0e7 * clamp(basis.w, 1.2e-7, 0.25)));
    return clamp(float4(0.5 * (basis.x + lower) + 0.5, 0.5 * (basis.x + upper) + 0.5, weight,
                      (excess + 1.70198336) * 0.227687125), 0.0, 1.0);
}

/// Visibility of a receiver from quantised moments: an upper bound on the lit share of the filter window.
/// quantised: as quantiseMoments4 or unpackQuantised4 made it, in [0,1], clamped to it. depth: the receiver's, in [0,1].
/// depthError: by how much rounding may move a depth, >= 0, see the LVSM_DEPTH_ERROR_QUANTISED constants; the receiver is
/// moved towards the light by as much. Result in [0,1], a bound but for the rounding of the other two.
/// Source: HPG 2017, and hamburgerUpperBound.
float lvsm_quantisedVisibility4(float4 quantised, float depth, float depthError)
{
    float4 code = clamp(quantised, 0.0, 1.0);
    float extent = 2.0 * (code.y - code.x);
    float mean = 2.0 * code.x - 1.0 + code.z * extent;
    float v = max(code.z * (1.0 - code.z) * extent * extent, 9.09494702e-13);
    float excess = 1.0e-7 * exp(exp(4.39199187 * code.w - 1.70198336));
    float moved = clamp(depth, 0.0, 1.0) - clamp(depthError, 0.0, 1.0);
    return lvsm_boundOfBasis(float4(mean, v, extent - 2.0 * code.z * extent, excess), 2.0 * moved - 1.0);
}

// Nearest of the integers from 0 to most.
int lvsm_quantisedStep(float share, float most)
{
    return int(floor(clamp(share, 0.0, 1.0) * most + 0.5));
}

/// Quantised moments in 32 bits: 10 for each depth, of which the order saves one, 7 for the weight and 6 for the excess.
/// quantised: as quantiseMoments4 made it. Result: two words of 16 bits each, in [0, 65535]: the first depth above the
/// weight, and the second above the excess.
/// Degenerate: equal depths are moved one step apart.
/// Source: HPG 2017. The weight is stored as its square root. Depths in the upper half are both stored from the other end,
/// which turns their order round.
int2 lvsm_packQuantised4(float4 quantised)
{
    int lower = lvsm_quantisedStep(min(quantised.x, quantised.y), 1023.0);
    int upper = lvsm_quantisedStep(max(quantised.x, quantised.y), 1023.0);
    int last = upper > lower || lower == 1023 ? upper : lower + 1;
    int first = lower == 1023 ? 1022 : lower;
    bool isTurned = first > 511;
    int weight = lvsm_quantisedStep(sqrt(clamp(quantised.z, 0.0, 1.0)), 127.0);
    int excess = lvsm_quantisedStep(quantised.w, 63.0);
    return int2((isTurned ? 1023 - first : first) * 128 + weight, (isTurned ? 1023 - last : last) * 64 + excess);
}

/// Quantised moments out of 32 bits.
/// words: as packQuantised4 made them; of others the low 16 bits. Result: as quantiseMoments4, rounded, in [0,1].
/// Source: HPG 2017, see packQuantised4.
float4 lvsm_unpackQuantised4(int2 words)
{
    int nine = (words.x >> 7) & 511;
    int ten = (words.y >> 6) & 1023;
    bool isTurned = ten < nine;
    float root = float(words.x & 127) * 0.00787401575;
    return min(float4(float(isTurned ? 1023 - nine : nine) * 9.77517107e-4,
                    float(isTurned ? 1023 - ten : ten) * 9.77517107e-4, root * root,
                    float(words.y & 63) * 0.0158730159), 1.0);
}

#endif
