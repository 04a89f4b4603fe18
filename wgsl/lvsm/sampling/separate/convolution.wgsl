// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, convolution, sampling/common, sampling/separate/maps.
// Convolution shadow maps, two slices to each four terms: their sines, then their cosines.

/// Visibility from a convolution shadow map.
/// map: of 4 components, as encodeFourier made them: slice 2 i has the fourierSines of the terms from 4 i + 1 on, slice
/// 2 i + 1 their fourierCosines. at: where, see mapPoint. depth: the receiver's, in [0,1]. order: number of terms, from
/// 2 to 256. offset: towards the light, see fourierOffset. strength: of fourierAttenuation. scale: of
/// fourierVisibility. Result in [0,1].
/// Source: CSM's reconstruction.
fn lvsm_sampleConvolution(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32, order: i32,
                          offset: f32, strength: f32, scale: f32) -> f32
{
    var sum = 0.0;
    for (var i = 0; i < (order + 3) / 4; i++)
    {
        let first = 4 * i + 1;
        let emptySines = lvsm_encodeFourier(lvsm_fourierSines(1.0, first, order));
        let emptyCosines = lvsm_encodeFourier(lvsm_fourierCosines(1.0, first, order));
        let sines = lvsm_decodeFourier(lvsm_sampleSlice(map, filtering, at, 2 * i, emptySines));
        let cosines = lvsm_decodeFourier(lvsm_sampleSlice(map, filtering, at, 2 * i + 1, emptyCosines));
        sum += lvsm_fourierSum(sines, cosines, depth, offset, first, order, strength);
    }
    return lvsm_fourierVisibility(sum, scale);
}
