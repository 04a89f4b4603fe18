// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, config, depth, passes/depths, passes/store.
// The store pass and the first direction of the blur in one: every depth is read once for all slices, and the unblurred
// map is never written. Then run the second direction of the blur.
//
// Entry point: lvsm_fusedCompute, with what fusedPass of include/lvsm/passes_fused.hpp gives, the two blocks and how
// many groups of 64 x 4 texels. Settings are those of store.hlsl. A group keeps linear depths, so that a multisampled
// texture needs store and blur.
#include "store.hlsl"

#if LVSM_DEPTH_SAMPLES > 1 || defined(LVSM_STORE_SLOPED)
#error samples and slopes of depths need the passes store and blur
#endif
#ifndef LVSM_FUSED_BLOCK
#define LVSM_FUSED_BLOCK b3
#endif

// FusedBlock of include/lvsm/passes_fused.hpp.
cbuffer lvsm_Fused : register(LVSM_FUSED_BLOCK)
{
    // What an empty texel holds.
    float4 lvsm_border;
    // First texel and end of the map.
    int4 lvsm_map;
    // Of the map: two layers each, or one.
    int lvsm_sliceCount;
    // Texels to each side that the filter reads, at most 32.
    int lvsm_reach;
    // Weights from the middle outwards, four to a vector.
    float4 lvsm_weights[9];
};

static const int LVSM_FUSED_ROW = 64 + 2 * 32;
groupshared float lvsm_rows[4 * LVSM_FUSED_ROW];

[numthreads(64, 4, 1)]
void lvsm_fusedCompute(uint3 id : SV_DispatchThreadID, uint3 local : SV_GroupThreadID)
{
    int row = LVSM_FUSED_ROW * int(local.y);
    int thread = int(local.x);
    int2 texel = int2(id.xy) + lvsm_region.xy;
    // A texel of the group and its halo, counted from the halo's beginning. Off the map no depth is read.
    for (int i = thread; i < 64 + 2 * lvsm_reach; i += 64)
    {
        int2 place = int2(texel.x - thread + i - lvsm_reach, texel.y);
        bool onMap = place.x >= lvsm_map.x && place.x < lvsm_map.z && place.y < lvsm_map.w;
        lvsm_rows[row + i] = 1.0;
        if (onMap)
            lvsm_rows[row + i] = lvsm_depthAt(lvsm_depths, place, 0);
    }
    GroupMemoryBarrierWithGroupSync();
    if (texel.x >= lvsm_region.z || texel.y >= lvsm_region.w)
        return;
    for (int slice = 0; slice < lvsm_sliceCount; ++slice)
    {
        float4 sum = float4(0.0, 0.0, 0.0, 0.0);
        for (int tap = -lvsm_reach; tap <= lvsm_reach; ++tap)
        {
            int x = texel.x + tap;
            bool inside = x >= lvsm_map.x && x < lvsm_map.z;
            float weight = lvsm_weights[abs(tap) >> 2][abs(tap) & 3];
            float4 stored = lvsm_storedTexel(lvsm_rows[row + thread + tap + lvsm_reach], slice);
            sum += weight * (inside ? stored : lvsm_border);
        }
        lvsm_target[uint3(texel, lvsm_firstSlice + slice)] = sum;
    }
}
