// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, exponential, sampling/common, sampling/separate/maps.
// Variance shadow maps, plain and of exponential warps.

/// Visibility from a variance shadow map; reduceLightBleeding may follow.
/// map: of 2 components or more, as depthMoments made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// minVariance: the floor in depth squared, >= 0, such as LVSM_MIN_VARIANCE_FP16.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: LVSM section 3.
fn lvsm_sampleVariance(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32,
                       minVariance: f32) -> f32
{
    let texel = lvsm_sampleSlice(map, filtering, at, 0, vec4f(1.0, 1.0, 1.0, 1.0));
    return lvsm_chebyshevUpperBound(texel.xy, depth, minVariance);
}

/// Visibility from an exponential variance shadow map of the positive warp alone (EVSM2).
/// map: of 2 components or more, the first two of exponentialMoments. at: where, see mapPoint. depth: the receiver's, in
/// [0,1]. exponent: as when stored. minVariance: the global floor in depth squared, >= 0, such as LVSM_MIN_VARIANCE.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: LVSM section 7.
fn lvsm_sampleExponential2(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32, exponent: f32,
                           minVariance: f32) -> f32
{
    let texel = lvsm_sampleSlice(map, filtering, at, 0, lvsm_exponentialMoments(1.0, vec2f(exponent, 0.0)));
    return lvsm_exponentialVisibility2(texel.xy, depth, exponent, minVariance);
}

/// Visibility from an exponential variance shadow map of both warps (EVSM4).
/// map: of 4 components, as exponentialMoments made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// exponents: of the two warps, as when stored. minVariance: the global floor in depth squared, >= 0, such as
/// LVSM_MIN_VARIANCE. Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: LVSM section 7.
fn lvsm_sampleExponential4(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32,
                           exponents: vec2f, minVariance: f32) -> f32
{
    let texel = lvsm_sampleSlice(map, filtering, at, 0, lvsm_exponentialMoments(1.0, exponents));
    return lvsm_exponentialVisibility4(texel, depth, exponents, minVariance);
}
