// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, trigonometric, sampling/common, sampling/separate/maps.
// Shadow maps of trigonometric moments.
#ifndef LVSM_SAMPLING_SEPARATE_TRIGONOMETRIC_HLSLI
#define LVSM_SAMPLING_SEPARATE_TRIGONOMETRIC_HLSLI

#include "../../trigonometric.hlsli"
#include "maps.hlsli"

/// Visibility from a map of trigonometric moments.
/// map: of 4 components, as trigonometricMoments made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// bias: of trigonometricVisibility; recommendedTrigonometricBias of three roundings to unorm16 is 1.2e-4.
/// Result in [0,1]; 1 half a texel off the map and beyond, but for the bias.
float lvsm_sampleTrigonometric(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, float depth,
                               float bias)
{
    return lvsm_trigonometricVisibility(lvsm_sampleSlice(map, filtering, at, 0, lvsm_trigonometricMoments(1.0)), depth,
                                        bias);
}

#endif
