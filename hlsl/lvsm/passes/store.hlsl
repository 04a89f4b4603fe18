// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm.
// Makes a map from one texture of unwarped depths, in [0,1] and 1 where there is no surface: all layers of any
// technique.
// Lauritzen & McCool, Layered Variance Shadow Maps, section 5, the second way to make the layers.
//
// Entry points: lvsm_storeCompute makes every slice, over groups of 8 x 8 texels and one slice each; lvsm_storePixel
// makes one slice, lvsm_slice, over a whole target of the texture's size. Then blur. LVSM_STORE says what a slice
// holds; only its default reads splits, layerCount and overlap. The registers' numbers differ, so that they serve as Vulkan's
// bindings too; there LVSM_STORE_FORMAT may name the target's format, such as "rgba16f".
#include "../lvsm.hlsli"

Texture2D<float4> lvsm_depths : register(t0);
#ifdef LVSM_STORE_FORMAT
[[vk::image_format(LVSM_STORE_FORMAT)]]
#endif
RWTexture2DArray<float4> lvsm_target : register(u1);
cbuffer lvsm_Store : register(b2)
{
    // The splits 0 to LVSM_MAX_LAYERS, four to a vector.
    float4 lvsm_splits[(LVSM_MAX_LAYERS + 4) / 4];
    int lvsm_layerCount;
    float lvsm_overlap;
    int lvsm_slice;
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

// What slice number slice of the array holds for a depth: two layers. Define it for another technique, such as
//   #define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, float2(42.0, 10.0))
#ifndef LVSM_STORE
#define LVSM_STORE(depth, slice) \
    lvsm_packLayers(lvsm_storedLayer(depth, 2 * (slice)), lvsm_storedLayer(depth, 2 * (slice) + 1))
#endif

[numthreads(8, 8, 1)]
void lvsm_storeCompute(uint3 id : SV_DispatchThreadID)
{
    uint width;
    uint height;
    uint slices;
    lvsm_target.GetDimensions(width, height, slices);
    if (id.x < width && id.y < height && id.z < slices)
        lvsm_target[id] = LVSM_STORE(lvsm_depths.Load(int3(int2(id.xy), 0)).x, int(id.z));
}

float4 lvsm_storePixel(float4 position : SV_Position) : SV_Target
{
    return LVSM_STORE(lvsm_depths.Load(int3(int2(position.xy), 0)).x, lvsm_slice);
}
