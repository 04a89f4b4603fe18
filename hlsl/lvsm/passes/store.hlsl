// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, config, depth, passes/depths.
// Makes a map from one texture of depths, linear ones or a depth buffer (see depths.hlsli): all layers of any technique.
// Lauritzen & McCool, Layered Variance Shadow Maps, section 5, the second way to make the layers.
//
// Entry points: lvsm_storeCompute makes every slice, over groups of 8 x 8 texels and one slice each; lvsm_storePixel
// makes one slice, lvsm_slice. storePass of include/lvsm/passes.hpp fills the constant buffer, and says how many groups
// to run and which rectangle to draw. Then blur. LVSM_STORE says what a slice holds; only its default reads splits,
// layerCount and overlap. In Vulkan, LVSM_STORE_FORMAT may name the target's format, such as "rgba16f".
#include "../lvsm.hlsli"
#include "depths.hlsli"

// Where the resources are: define all of these or none, in front of this file. The numbers differ, so that they serve as
// Vulkan's bindings too; a space goes in here as well:
//   #define LVSM_STORE_DEPTHS t4, space1
#if defined(LVSM_STORE_DEPTHS) && defined(LVSM_STORE_TARGET) && defined(LVSM_STORE_BLOCK)
#elif defined(LVSM_STORE_DEPTHS) || defined(LVSM_STORE_TARGET) || defined(LVSM_STORE_BLOCK)
#error define all of LVSM_STORE_DEPTHS, LVSM_STORE_TARGET and LVSM_STORE_BLOCK, or none
#else
#define LVSM_STORE_DEPTHS t0
#define LVSM_STORE_TARGET u1
#define LVSM_STORE_BLOCK b2
#endif

LVSM_DEPTH_TEXTURE lvsm_depths : register(LVSM_STORE_DEPTHS);
#ifdef LVSM_STORE_FORMAT
[[vk::image_format(LVSM_STORE_FORMAT)]]
#endif
RWTexture2DArray<float4> lvsm_target : register(LVSM_STORE_TARGET);
// StoreBlock of include/lvsm/passes.hpp.
cbuffer lvsm_Store : register(LVSM_STORE_BLOCK)
{
    // First texel and end of what the compute shader writes.
    int4 lvsm_region;
    int lvsm_layerCount;
    float lvsm_overlap;
    // The slice of the target where the compute shader begins to write the map.
    int lvsm_firstSlice;
    // The slice of the map that the pixel shader makes.
    int lvsm_slice;
    // The splits 0 to LVSM_MAX_LAYERS, four to a vector.
    float4 lvsm_splits[(LVSM_MAX_LAYERS + 4) / 4];
};

// Moments of one layer; a layer beyond the last is empty.
float2 lvsm_storedLayer(float depth, int layer)
{
    if (layer >= min(lvsm_layerCount, LVSM_MAX_LAYERS))
        return float2(1.0, 1.0);
    float begin = lvsm_splits[layer / 4][layer % 4];
    float end = lvsm_splits[(layer + 1) / 4][(layer + 1) % 4];
    return lvsm_layerMoments(depth, lvsm_layerInterval(begin, end, lvsm_overlap));
}

float4 lvsm_storedLayers(float depth, int slice)
{
    return lvsm_packLayers(lvsm_storedLayer(depth, 2 * slice), lvsm_storedLayer(depth, 2 * slice + 1));
}

// What slice number slice of the map holds for a depth: two layers, in [0,1], which every format bears. Define it for
// another technique, together with the largest value that the target's format bears: all is clamped to it, so that no
// texel is infinite. In 16-bit floats, exponents end at 5.545:
//   #define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, float2(5.54, 5.54))
//   #define LVSM_STORE_LARGEST LVSM_LARGEST_FP16
// and in 32 bits at 43.32:
//   #define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, float2(42.0, 10.0))
//   #define LVSM_STORE_LARGEST LVSM_LARGEST_FP32
#ifndef LVSM_STORE
#define LVSM_STORE(depth, slice) lvsm_storedLayers(depth, slice)
#define LVSM_STORE_LARGEST 1.0
#elif !defined(LVSM_STORE_LARGEST)
#error define LVSM_STORE_LARGEST together with LVSM_STORE: the largest value that the format of the target bears
#endif

float4 lvsm_storedTexel(float depth, int slice)
{
    return clamp(LVSM_STORE(depth, slice), -LVSM_STORE_LARGEST, LVSM_STORE_LARGEST);
}

// The texel of a map: what is stored, filtered over the samples of a multisampled texture. Where LVSM_STORE_SLOPED is
// defined, it is stored instead, with the change of depth to the next texel that the four neighbours show:
//   #define LVSM_STORE_SLOPED(depth, slope, slice) float4(lvsm_depthMomentsSloped(depth, slope.x, slope.y), 0.0, 0.0)
float4 lvsm_storedFrom(LVSM_DEPTH_TEXTURE depths, int2 texel, int slice)
{
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < LVSM_DEPTH_SAMPLES; ++i)
    {
        float depth = lvsm_depthAt(depths, texel, i);
#ifdef LVSM_STORE_SLOPED
        float4 stored = LVSM_STORE_SLOPED(depth, lvsm_slopeAt(depths, texel, i, lvsm_region), slice);
        stored = clamp(stored, -LVSM_STORE_LARGEST, LVSM_STORE_LARGEST);
#else
        float4 stored = lvsm_storedTexel(depth, slice);
#endif
        sum += stored / float(LVSM_DEPTH_SAMPLES);
    }
    return sum;
}

[numthreads(8, 8, 1)]
void lvsm_storeCompute(uint3 id : SV_DispatchThreadID)
{
    int2 texel = int2(id.xy) + lvsm_region.xy;
    if (texel.x < lvsm_region.z && texel.y < lvsm_region.w)
        lvsm_target[uint3(texel, lvsm_firstSlice + int(id.z))] =
            lvsm_storedFrom(lvsm_depths, texel, int(id.z));
}

float4 lvsm_storePixel(float4 position : SV_Position) : SV_Target
{
    return lvsm_storedFrom(lvsm_depths, int2(position.xy), lvsm_slice);
}
