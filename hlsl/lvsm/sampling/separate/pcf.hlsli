// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, pcf, receiver, sampling/common, sampling/separate/maps.
// Percentage-closer filtering of a map of depths.
#ifndef LVSM_SAMPLING_SEPARATE_PCF_HLSLI
#define LVSM_SAMPLING_SEPARATE_PCF_HLSLI

#include "../../pcf.hlsli"
#include "../../receiver.hlsli"
#include "maps.hlsli"

/// Visibility by percentage-closer filtering with a box of any width, or a Gaussian in one, over a map of depths.
/// map: of 1 component or more. at: where, see mapPoint. depth: the receiver's, in [0,1]. gradient: of the receiver's
/// depth per texel, see receiverGradient; (0, 0) takes one depth for all texels. width: of the box in texels, from 1 to
/// 65, clamped to it. deviation: of the Gaussian in texels, at least 1/64; 0 or less takes the box alone. bias: what the
/// receiver is moved towards the light, in [0,1]. Result in [0,1]; 1 where the box is off the map.
/// Source: Reeves et al. 1987.
float lvsm_samplePcf(Texture2DArray<float> map, SamplerState filtering, lvsm_MapPoint at, float depth, float2 gradient,
                     float width, float deviation, float bias)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float extent = clamp(width, 1.0, float(LVSM_MAX_FILTER_SIZE));
    float2 position = clamp(at.uv, -65536.0, 65536.0) * size - 0.5;
    float2 beyond = lvsm_texelsBeyond(position + 0.5, size);
    if (max(beyond.x, beyond.y) >= 0.5 * extent + 0.5)
        return 1.0;
    float2 first = floor(position - 0.5 * extent + 0.5);
    int quads = int(0.5 * ceil(extent)) + 1;
    float inverse = 1.0 / max(deviation, 0.015625);
    float falloff = deviation > 0.0 ? -0.5 * inverse * inverse : 0.0;
    lvsm_MapPoint quad = at;
    float2 sum = float2(0.0, 0.0);
    for (int y = 0; y < quads; ++y)
    {
        for (int x = 0; x < quads; ++x)
        {
            float2 texel = first + 2.0 * float2(float(x), float(y));
            float2 offset = texel - position;
            quad.uv = (texel + 1.0) / size;
            float4 depths = lvsm_gatherSlice(map, filtering, quad, 0, 1.0);
            float2 across = float2(lvsm_boxWeight(offset.x, extent), lvsm_boxWeight(offset.x + 1.0, extent));
            float2 down = float2(lvsm_boxWeight(offset.y, extent), lvsm_boxWeight(offset.y + 1.0, extent));
            across *= exp(falloff * (offset.x + float2(0.0, 1.0)) * (offset.x + float2(0.0, 1.0)));
            down *= exp(falloff * (offset.y + float2(0.0, 1.0)) * (offset.y + float2(0.0, 1.0)));
            float4 receivers = float4(lvsm_planeDepth(depth, gradient, offset),
                                      lvsm_planeDepth(depth, gradient, offset + float2(1.0, 0.0)),
                                      lvsm_planeDepth(depth, gradient, offset + float2(0.0, 1.0)),
                                      lvsm_planeDepth(depth, gradient, offset + float2(1.0, 1.0)));
            sum = lvsm_pcfAdd(sum, depths, across.xyxy * down.xxyy, receivers, bias);
        }
    }
    return lvsm_pcfVisibility(sum);
}

float lvsm_samplePcf(Texture2DArray<float2> map, SamplerState filtering, lvsm_MapPoint at, float depth,
                     float2 gradient, float width, float deviation, float bias)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float extent = clamp(width, 1.0, float(LVSM_MAX_FILTER_SIZE));
    float2 position = clamp(at.uv, -65536.0, 65536.0) * size - 0.5;
    float2 beyond = lvsm_texelsBeyond(position + 0.5, size);
    if (max(beyond.x, beyond.y) >= 0.5 * extent + 0.5)
        return 1.0;
    float2 first = floor(position - 0.5 * extent + 0.5);
    int quads = int(0.5 * ceil(extent)) + 1;
    float inverse = 1.0 / max(deviation, 0.015625);
    float falloff = deviation > 0.0 ? -0.5 * inverse * inverse : 0.0;
    lvsm_MapPoint quad = at;
    float2 sum = float2(0.0, 0.0);
    for (int y = 0; y < quads; ++y)
    {
        for (int x = 0; x < quads; ++x)
        {
            float2 texel = first + 2.0 * float2(float(x), float(y));
            float2 offset = texel - position;
            quad.uv = (texel + 1.0) / size;
            float4 depths = lvsm_gatherSlice(map, filtering, quad, 0, 1.0);
            float2 across = float2(lvsm_boxWeight(offset.x, extent), lvsm_boxWeight(offset.x + 1.0, extent));
            float2 down = float2(lvsm_boxWeight(offset.y, extent), lvsm_boxWeight(offset.y + 1.0, extent));
            across *= exp(falloff * (offset.x + float2(0.0, 1.0)) * (offset.x + float2(0.0, 1.0)));
            down *= exp(falloff * (offset.y + float2(0.0, 1.0)) * (offset.y + float2(0.0, 1.0)));
            float4 receivers = float4(lvsm_planeDepth(depth, gradient, offset),
                                      lvsm_planeDepth(depth, gradient, offset + float2(1.0, 0.0)),
                                      lvsm_planeDepth(depth, gradient, offset + float2(0.0, 1.0)),
                                      lvsm_planeDepth(depth, gradient, offset + float2(1.0, 1.0)));
            sum = lvsm_pcfAdd(sum, depths, across.xyxy * down.xxyy, receivers, bias);
        }
    }
    return lvsm_pcfVisibility(sum);
}

float lvsm_samplePcf(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, float depth,
                     float2 gradient, float width, float deviation, float bias)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float extent = clamp(width, 1.0, float(LVSM_MAX_FILTER_SIZE));
    float2 position = clamp(at.uv, -65536.0, 65536.0) * size - 0.5;
    float2 beyond = lvsm_texelsBeyond(position + 0.5, size);
    if (max(beyond.x, beyond.y) >= 0.5 * extent + 0.5)
        return 1.0;
    float2 first = floor(position - 0.5 * extent + 0.5);
    int quads = int(0.5 * ceil(extent)) + 1;
    float inverse = 1.0 / max(deviation, 0.015625);
    float falloff = deviation > 0.0 ? -0.5 * inverse * inverse : 0.0;
    lvsm_MapPoint quad = at;
    float2 sum = float2(0.0, 0.0);
    for (int y = 0; y < quads; ++y)
    {
        for (int x = 0; x < quads; ++x)
        {
            float2 texel = first + 2.0 * float2(float(x), float(y));
            float2 offset = texel - position;
            quad.uv = (texel + 1.0) / size;
            float4 depths = lvsm_gatherSlice(map, filtering, quad, 0, 1.0);
            float2 across = float2(lvsm_boxWeight(offset.x, extent), lvsm_boxWeight(offset.x + 1.0, extent));
            float2 down = float2(lvsm_boxWeight(offset.y, extent), lvsm_boxWeight(offset.y + 1.0, extent));
            across *= exp(falloff * (offset.x + float2(0.0, 1.0)) * (offset.x + float2(0.0, 1.0)));
            down *= exp(falloff * (offset.y + float2(0.0, 1.0)) * (offset.y + float2(0.0, 1.0)));
            float4 receivers = float4(lvsm_planeDepth(depth, gradient, offset),
                                      lvsm_planeDepth(depth, gradient, offset + float2(1.0, 0.0)),
                                      lvsm_planeDepth(depth, gradient, offset + float2(0.0, 1.0)),
                                      lvsm_planeDepth(depth, gradient, offset + float2(1.0, 1.0)));
            sum = lvsm_pcfAdd(sum, depths, across.xyxy * down.xxyy, receivers, bias);
        }
    }
    return lvsm_pcfVisibility(sum);
}

#endif
