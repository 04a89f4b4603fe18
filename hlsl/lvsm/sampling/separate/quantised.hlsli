// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, depth, moments, layers, moments4, quantised, sampling/common, sampling/separate/maps.
// Quantised moments: a code that no hardware filters, so that four texels are judged and their visibilities mixed.
#ifndef LVSM_SAMPLING_SEPARATE_QUANTISED_HLSLI
#define LVSM_SAMPLING_SEPARATE_QUANTISED_HLSLI

#include "../../filter.hlsli"
#include "../../quantised.hlsli"
#include "maps.hlsli"

/// Visibility from a map of quantised moments in four unorm16.
/// map: of 4 components, as quantiseMoments4 made them; its own filter is not asked. at: where, see mapPoint. depth: the
/// receiver's, in [0,1]. Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: HPG 2017.
float lvsm_sampleQuantised4(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, float depth)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float2 corner = lvsm_firstCorner(at.uv, size);
    float4 lit = float4(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; ++i)
    {
        float4 code = lvsm_fetchSlice(map, filtering, at, 0, corner + float2(float(i & 1), float(i >> 1)));
        lit[i] = lvsm_quantisedVisibility4(code, depth, LVSM_DEPTH_ERROR_QUANTISED64);
    }
    return lvsm_bilinearVisibility(lvsm_maskCorners(lit, corner, size, 1.0), lvsm_mapFraction(at.uv, size));
}

/// Visibility from a map of quantised moments in 32 bits.
/// map: of 2 components or more, the words of packQuantised4 over 65535, as two unorm16 hold them; its own filter is not
/// asked. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: HPG 2017.
float lvsm_samplePackedQuantised4(Texture2DArray<float2> map, SamplerState filtering, lvsm_MapPoint at, float depth)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float2 corner = lvsm_firstCorner(at.uv, size);
    float4 lit = float4(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; ++i)
    {
        float2 texel = lvsm_fetchSlice(map, filtering, at, 0, corner + float2(float(i & 1), float(i >> 1))).xy;
        float4 code = lvsm_unpackQuantised4(int2(65535.0 * texel + 0.5));
        lit[i] = lvsm_quantisedVisibility4(code, depth, LVSM_DEPTH_ERROR_QUANTISED32);
    }
    return lvsm_bilinearVisibility(lvsm_maskCorners(lit, corner, size, 1.0), lvsm_mapFraction(at.uv, size));
}

float lvsm_samplePackedQuantised4(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, float depth)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float2 corner = lvsm_firstCorner(at.uv, size);
    float4 lit = float4(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; ++i)
    {
        float2 texel = lvsm_fetchSlice(map, filtering, at, 0, corner + float2(float(i & 1), float(i >> 1))).xy;
        float4 code = lvsm_unpackQuantised4(int2(65535.0 * texel + 0.5));
        lit[i] = lvsm_quantisedVisibility4(code, depth, LVSM_DEPTH_ERROR_QUANTISED32);
    }
    return lvsm_bilinearVisibility(lvsm_maskCorners(lit, corner, size, 1.0), lvsm_mapFraction(at.uv, size));
}

#endif
