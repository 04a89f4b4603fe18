// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// One direction of a separable blur of maps of 1 to 4 components: entry points lvsm_blurCompute and lvsm_blurPixel.
//
// Run it twice, from the map to a second one and back, with what blurPasses of include/lvsm/passes.hpp gives: the
// constant buffer, and either how many groups of 8 x 8 texels and one slice of the array lvsm_blurCompute runs over, or
// the rectangle of the target over which to draw lvsm_blurPixel, for one slice. What is off the map is empty, as
// sampling/common.hlsli has it. The map's sampler filters linearly, which 16-bit formats allow everywhere; a kernel that
// is not paired does without. In Vulkan, LVSM_BLUR_FORMAT may name the target's format, such as "rgba16f".

// Where the resources are: define all of these or none, in front of this file. The numbers differ, so that they serve as
// Vulkan's bindings too; a space goes in here as well:
//   #define LVSM_BLUR_SOURCE t4, space1
#if defined(LVSM_BLUR_SOURCE) && defined(LVSM_BLUR_TARGET) && defined(LVSM_BLUR_BLOCK) && defined(LVSM_BLUR_SAMPLER)
#elif defined(LVSM_BLUR_SOURCE) || defined(LVSM_BLUR_TARGET) || defined(LVSM_BLUR_BLOCK) || defined(LVSM_BLUR_SAMPLER)
#error define all of LVSM_BLUR_SOURCE, LVSM_BLUR_TARGET, LVSM_BLUR_BLOCK and LVSM_BLUR_SAMPLER, or none
#else
#define LVSM_BLUR_SOURCE t0
#define LVSM_BLUR_TARGET u1
#define LVSM_BLUR_BLOCK b2
#define LVSM_BLUR_SAMPLER s3
#endif

// How many fetches a texel takes; a constant, which has to be that of the kernel, lets the compiler unroll them:
//   #define LVSM_BLUR_FETCHES 5
#ifndef LVSM_BLUR_FETCHES
#define LVSM_BLUR_FETCHES lvsm_fetchCount
#endif

Texture2DArray<float4> lvsm_source : register(LVSM_BLUR_SOURCE);
#ifdef LVSM_BLUR_FORMAT
[[vk::image_format(LVSM_BLUR_FORMAT)]]
#endif
RWTexture2DArray<float4> lvsm_target : register(LVSM_BLUR_TARGET);
// BlurBlock of include/lvsm/passes.hpp.
cbuffer lvsm_Blur : register(LVSM_BLUR_BLOCK)
{
    // What an empty texel holds.
    float4 lvsm_border;
    // First texel and end of the map: a whole texture, or its rectangle of an atlas.
    int4 lvsm_map;
    // First texel and end of what the compute shader writes.
    int4 lvsm_region;
    // (1, 0) or (0, 1).
    float2 lvsm_direction;
    // The slice that is blurred; for the compute shader the first one.
    int lvsm_slice;
    int lvsm_fetchCount;
    // Offset in texels and weight of two fetches each.
    float4 lvsm_taps[33];
};
SamplerState lvsm_filtering : register(LVSM_BLUR_SAMPLER);

float2 lvsm_blurTap(int fetch)
{
    float4 two = lvsm_taps[fetch >> 1];
    return (fetch & 1) == 0 ? two.xy : two.zw;
}

float4 lvsm_blurredTexel(int3 texel)
{
    uint width;
    uint height;
    uint slices;
    lvsm_source.GetDimensions(width, height, slices);
    float2 texelSize = 1.0 / float2(float(width), float(height));
    // Along the direction of the blur; across it the texel's own centre.
    float2 centre = float2(texel.xy) + 0.5;
    float at = dot(centre, lvsm_direction);
    float first = dot(float2(lvsm_map.xy), lvsm_direction) + 0.5;
    float last = dot(float2(lvsm_map.zw), lvsm_direction) - 0.5;
    float2 origin = (centre - at * lvsm_direction) * texelSize;
    float2 along = lvsm_direction * texelSize;
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    // No tap reaches farther than there are fetches.
    float reach = float(LVSM_BLUR_FETCHES);
    if (at - reach > first && at + reach < last)
    {
        for (int fetch = 0; fetch < LVSM_BLUR_FETCHES; ++fetch)
        {
            float2 tap = lvsm_blurTap(fetch);
            float3 position = float3(origin + (at + tap.x) * along, float(texel.z));
            sum += tap.y * lvsm_source.SampleLevel(lvsm_filtering, position, 0.0);
        }
        return sum;
    }
    // At the edge, border takes what weight of a fetch is off the map.
    float empty = 0.0;
    for (int edgeFetch = 0; edgeFetch < lvsm_fetchCount; ++edgeFetch)
    {
        float2 tap = lvsm_blurTap(edgeFetch);
        float inside = clamp(at + tap.x, first, last);
        float off = tap.y * min(abs(at + tap.x - inside), 1.0);
        float3 position = float3(origin + inside * along, float(texel.z));
        sum += (tap.y - off) * lvsm_source.SampleLevel(lvsm_filtering, position, 0.0);
        empty += off;
    }
    return sum + empty * lvsm_border;
}

// Where LVSM_BLUR_MAXIMUM is defined, the passes find the largest of the texels under the kernel, each component for
// itself, as the Z-Max test of ESM needs. The kernel is not paired, such as boxKernel(5, false), and its weights are not
// read.
float4 lvsm_largestTexel(int3 texel)
{
    float4 largest = lvsm_border;
    for (int fetch = 0; fetch < LVSM_BLUR_FETCHES; ++fetch)
    {
        int2 place = texel.xy + int2(lvsm_blurTap(fetch).x * lvsm_direction);
        bool isOn = all(place >= lvsm_map.xy) && all(place < lvsm_map.zw);
        float4 found = isOn ? lvsm_source.Load(int4(place, texel.z, 0)) : lvsm_border;
        largest = fetch == 0 ? found : max(largest, found);
    }
    return largest;
}

#ifdef LVSM_BLUR_MAXIMUM
#define LVSM_BLUR_TEXEL lvsm_largestTexel
#else
#define LVSM_BLUR_TEXEL lvsm_blurredTexel
#endif

[numthreads(8, 8, 1)]
void lvsm_blurCompute(uint3 id : SV_DispatchThreadID)
{
    int3 texel = int3(id) + int3(lvsm_region.xy, lvsm_slice);
    if (texel.x < lvsm_region.z && texel.y < lvsm_region.w)
        lvsm_target[uint3(texel)] = LVSM_BLUR_TEXEL(texel);
}

float4 lvsm_blurPixel(float4 position : SV_Position) : SV_Target
{
    return LVSM_BLUR_TEXEL(int3(int2(position.xy), lvsm_slice));
}
