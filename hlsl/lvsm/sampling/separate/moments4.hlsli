// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, moments4, sampling/common, sampling/separate/maps.
// Moment shadow maps, plain and in layers. Their moments lie in 32-bit floats as they are, or in unorm16 as
// encodeMoments4 makes them, which the parameter encoded says.
#ifndef LVSM_SAMPLING_SEPARATE_MOMENTS4_HLSLI
#define LVSM_SAMPLING_SEPARATE_MOMENTS4_HLSLI

#include "../../moments4.hlsli"
#include "maps.hlsli"

// Four moments of a slice.
// map: of 4 components.
float4 lvsm_sampleFourMoments(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, int index,
                              bool encoded)
{
    float4 empty = float4(1.0, 1.0, 1.0, 1.0);
    if (!encoded)
        return lvsm_sampleSlice(map, filtering, at, index, empty);
    return lvsm_decodeMoments4(lvsm_sampleSlice(map, filtering, at, index, lvsm_encodeMoments4(empty)));
}

/// Visibility from a moment shadow map (MSM4).
/// map: of 4 components, as depthMoments4 made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// encoded: whether encodeMoments4 followed. bias: of hamburgerUpperBound, LVSM_MOMENT4_BIAS_UNORM16 for an encoded map
/// and LVSM_MOMENT4_BIAS_FP32 for others. Result in [0,1]; 1 half a texel off the map and beyond, but for the bias.
/// Source: JCGT section 2.
float lvsm_sampleMoments4(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, float depth,
                          bool encoded, float bias)
{
    return lvsm_momentVisibility4(lvsm_sampleFourMoments(map, filtering, at, 0, encoded), depth, bias);
}

/// Visibility from a layered moment shadow map, a layer to a slice, each with its two neighbours.
/// map: of 4 components, as layerMoments4 made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// splits: layerCount + 1 values, not decreasing, from 0 to 1, of layers without overlap. layerCount: from 1 to
/// LVSM_MAX_LAYERS. encoded, bias: as for sampleMoments4.
/// Result in [0,1]; 1 half a texel off the map and beyond, but for the bias.
/// Source: bracketedVisibility4.
float lvsm_sampleLayeredMoments4(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, float depth,
                                 float splits[LVSM_MAX_LAYERS + 1], int layerCount, bool encoded, float bias)
{
    int last = clamp(layerCount, 1, LVSM_MAX_LAYERS) - 1;
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    float4 front = float4(1.0, 1.0, 1.0, 1.0);
    float4 behind = float4(-1.0, 1.0, -1.0, 1.0);
    if (layer > 0)
        front = lvsm_sampleFourMoments(map, filtering, at, layer - 1, encoded);
    if (layer < last)
        behind = lvsm_sampleFourMoments(map, filtering, at, layer + 1, encoded);
    return lvsm_bracketedVisibility4(front, lvsm_sampleFourMoments(map, filtering, at, layer, encoded), behind, depth,
                                     float2(splits[layer], splits[layer + 1]), bias);
}

#endif
