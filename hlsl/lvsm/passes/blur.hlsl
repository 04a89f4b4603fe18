// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter.
// One direction of a separable blur of maps of 1 to 4 components: entry points lvsm_blurCompute and lvsm_blurPixel.
//
// Run it twice, with direction (1, 0) from the map to a second one and with (0, 1) back: lvsm_blurCompute over groups
// of 8 x 8 texels and one slice of the array each, or lvsm_blurPixel over a whole target of the map's size, for one
// slice, lvsm_slice.
// The map's sampler filters linearly and clamps to the edge; its format must allow that, which 16-bit formats do
// everywhere. LVSM_BLUR_SIZE is the number of taps (9); LVSM_BLUR_SIGMA, where defined, makes the binomial filter a
// Gaussian. The registers' numbers differ, so that they serve as Vulkan's bindings too; there LVSM_BLUR_FORMAT may name
// the target's format, such as "rgba16f".
#include "../filter.hlsli"

// Number of taps, odd, up to 65; 9 taps cost 5 fetches.
#ifndef LVSM_BLUR_SIZE
#define LVSM_BLUR_SIZE 9
#endif

Texture2DArray<float4> lvsm_source : register(t0);
#ifdef LVSM_BLUR_FORMAT
[[vk::image_format(LVSM_BLUR_FORMAT)]]
#endif
RWTexture2DArray<float4> lvsm_target : register(u1);
cbuffer lvsm_Blur : register(b2)
{
    float2 lvsm_direction;
    int lvsm_slice;
};
SamplerState lvsm_filtering : register(s3);

// Offset from the texel's centre, in texels, and weight of a fetch: binomial, or Gaussian with LVSM_BLUR_SIGMA texels.
float2 lvsm_blurTap(int fetch)
{
#ifdef LVSM_BLUR_SIGMA
    return lvsm_gaussianTap(fetch, LVSM_BLUR_SIZE, LVSM_BLUR_SIGMA);
#else
    return lvsm_binomialTap(fetch, LVSM_BLUR_SIZE);
#endif
}

float4 lvsm_blurredTexel(int3 texel)
{
    uint width;
    uint height;
    uint slices;
    lvsm_source.GetDimensions(width, height, slices);
    float2 size = float2(float(width), float(height));
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    for (int fetch = 0; fetch <= (LVSM_BLUR_SIZE - 1) / 2; ++fetch)
    {
        float2 tap = lvsm_blurTap(fetch);
        float2 position = float2(texel.xy) + 0.5 + tap.x * lvsm_direction;
        sum += tap.y * lvsm_source.SampleLevel(lvsm_filtering, float3(position / size, float(texel.z)), 0.0);
    }
    return sum;
}

[numthreads(8, 8, 1)]
void lvsm_blurCompute(uint3 id : SV_DispatchThreadID)
{
    uint width;
    uint height;
    uint slices;
    lvsm_target.GetDimensions(width, height, slices);
    if (id.x < width && id.y < height && id.z < slices)
        lvsm_target[id] = lvsm_blurredTexel(int3(id));
}

float4 lvsm_blurPixel(float4 position : SV_Position) : SV_Target
{
    return lvsm_blurredTexel(int3(int2(position.xy), lvsm_slice));
}
