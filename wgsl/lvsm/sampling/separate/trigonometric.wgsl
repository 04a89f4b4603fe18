// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, trigonometric, sampling/common, sampling/separate/maps.
// Shadow maps of trigonometric moments.

/// Visibility from a map of trigonometric moments.
/// map: of 4 components, as trigonometricMoments made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// bias: of trigonometricVisibility; recommendedTrigonometricBias of three roundings to unorm16 is 1.2e-4.
/// Result in [0,1]; 1 half a texel off the map and beyond, but for the bias.
fn lvsm_sampleTrigonometric(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32,
                            bias: f32) -> f32
{
    return lvsm_trigonometricVisibility(lvsm_sampleSlice(map, filtering, at, 0, lvsm_trigonometricMoments(1.0)), depth,
                                        bias);
}
