// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, exponential, sampling/highp, sampling/common, sampling/separate/maps.
// Variance shadow maps, plain and of exponential warps.
#ifndef LVSM_SAMPLING_SEPARATE_VARIANCE_GLSL
#define LVSM_SAMPLING_SEPARATE_VARIANCE_GLSL

#include "../../exponential.glsl"
#include "maps.glsl"

/// Visibility from a variance shadow map; reduceLightBleeding may follow.
/// map: of 2 components or more, as depthMoments made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// minVariance: the floor in depth squared, >= 0, such as LVSM_MIN_VARIANCE_FP16.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: LVSM section 3.
float lvsm_sampleVariance(texture2DArray map, sampler filtering, lvsm_MapPoint at, float depth, float minVariance)
{
    vec4 texel = lvsm_sampleSlice(map, filtering, at, 0, vec4(1.0, 1.0, 1.0, 1.0));
    return lvsm_chebyshevUpperBound(texel.xy, depth, minVariance);
}

/// Visibility from an exponential variance shadow map of the positive warp alone (EVSM2).
/// map: of 2 components or more, the first two of exponentialMoments. at: where, see mapPoint. depth: the receiver's, in
/// [0,1]. exponent: as when stored. minVariance: the global floor in depth squared, >= 0, such as LVSM_MIN_VARIANCE.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: LVSM section 7.
float lvsm_sampleExponential2(texture2DArray map, sampler filtering, lvsm_MapPoint at, float depth, float exponent,
                              float minVariance)
{
    vec4 texel = lvsm_sampleSlice(map, filtering, at, 0, lvsm_exponentialMoments(1.0, vec2(exponent, 0.0)));
    return lvsm_exponentialVisibility2(texel.xy, depth, exponent, minVariance);
}

/// Visibility from an exponential variance shadow map of both warps (EVSM4).
/// map: of 4 components, as exponentialMoments made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// exponents: of the two warps, as when stored. minVariance: the global floor in depth squared, >= 0, such as
/// LVSM_MIN_VARIANCE. Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: LVSM section 7.
float lvsm_sampleExponential4(texture2DArray map, sampler filtering, lvsm_MapPoint at, float depth, vec2 exponents,
                              float minVariance)
{
    vec4 texel = lvsm_sampleSlice(map, filtering, at, 0, lvsm_exponentialMoments(1.0, exponents));
    return lvsm_exponentialVisibility4(texel, depth, exponents, minVariance);
}

#endif
