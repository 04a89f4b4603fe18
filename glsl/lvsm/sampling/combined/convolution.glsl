// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, convolution, sampling/highp, sampling/common, sampling/combined/maps.
// Convolution shadow maps, two slices to each four terms: their sines, then their cosines.
#ifndef LVSM_SAMPLING_COMBINED_CONVOLUTION_GLSL
#define LVSM_SAMPLING_COMBINED_CONVOLUTION_GLSL

#include "../../convolution.glsl"
#include "maps.glsl"

/// Visibility from a convolution shadow map.
/// map: of 4 components, as encodeFourier made them: slice 2 i has the fourierSines of the terms from 4 i + 1 on, slice
/// 2 i + 1 their fourierCosines. at: where, see mapPoint. depth: the receiver's, in [0,1]. order: number of terms, from
/// 2 to 256. offset: towards the light, see fourierOffset. strength: of fourierAttenuation. scale: of
/// fourierVisibility. Result in [0,1].
/// Source: CSM's reconstruction.
float lvsm_sampleConvolution(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, float depth, int order, float offset,
                             float strength, float scale)
{
    float sum = 0.0;
    for (int i = 0; i < (order + 3) / 4; ++i)
    {
        int first = 4 * i + 1;
        vec4 emptySines = lvsm_encodeFourier(lvsm_fourierSines(1.0, first, order));
        vec4 emptyCosines = lvsm_encodeFourier(lvsm_fourierCosines(1.0, first, order));
        vec4 sines = lvsm_decodeFourier(lvsm_sampleSlice(map, at, 2 * i, emptySines));
        vec4 cosines = lvsm_decodeFourier(lvsm_sampleSlice(map, at, 2 * i + 1, emptyCosines));
        sum += lvsm_fourierSum(sines, cosines, depth, offset, first, order, strength);
    }
    return lvsm_fourierVisibility(sum, scale);
}

#endif
