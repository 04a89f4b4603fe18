#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, sampling/highp, config, depth, passes/depths, passes/store.
#extension GL_GOOGLE_include_directive : require
// The store pass and the first direction of the blur in one: every depth is read once for all slices, and the unblurred
// map is never written. Then run the second direction of the blur.
//
// Run it with what fusedPass of include/lvsm/passes_fused.hpp gives, the two blocks and how many groups of 64 x 4 texels.
// Settings are those of store.glsl. A group keeps linear depths, so that a multisampled texture needs store and blur.
// GLSL ES 3.10: put `#version 310 es` in the first line's place, `precision highp float;` and `precision highp int;`
// after it.
#include "store.glsl"

#if LVSM_DEPTH_SAMPLES > 1 || defined(LVSM_STORE_SLOPED)
#error samples and slopes of depths need the passes store and blur
#endif
#ifndef LVSM_STORE_FORMAT
#define LVSM_STORE_FORMAT rgba16f
#endif
#ifndef LVSM_STORE_TARGET
#error define all of LVSM_STORE_DEPTHS, LVSM_STORE_TARGET and LVSM_STORE_BLOCK, or none
#endif
#ifndef LVSM_FUSED_BLOCK
#define LVSM_FUSED_BLOCK layout(binding = 3, std140)
#endif

layout(local_size_x = 64, local_size_y = 4) in;
LVSM_STORE_DEPTHS uniform LVSM_DEPTH_TEXTURE lvsm_depths;
LVSM_STORE_TARGET layout(LVSM_STORE_FORMAT) uniform writeonly LVSM_HIGHP image2DArray lvsm_target;

// FusedBlock of include/lvsm/passes_fused.hpp.
LVSM_FUSED_BLOCK uniform lvsm_Fused
{
    // What an empty texel holds.
    vec4 lvsm_border;
    // First texel and end of the map.
    ivec4 lvsm_map;
    // Of the map: two layers each, or one.
    int lvsm_sliceCount;
    // Texels to each side that the filter reads, at most 32.
    int lvsm_reach;
    // Weights from the middle outwards, four to a vector.
    vec4 lvsm_weights[9];
};

const int LVSM_FUSED_ROW = 64 + 2 * 32;
shared float lvsm_rows[4 * LVSM_FUSED_ROW];

void main()
{
    int row = LVSM_FUSED_ROW * int(gl_LocalInvocationID.y);
    int thread = int(gl_LocalInvocationID.x);
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + lvsm_region.xy;
    // A texel of the group and its halo, counted from the halo's beginning. Off the map no depth is read.
    for (int i = thread; i < 64 + 2 * lvsm_reach; i += 64)
    {
        ivec2 read = ivec2(texel.x - thread + i - lvsm_reach, texel.y);
        bool inside = read.x >= lvsm_map.x && read.x < lvsm_map.z && read.y < lvsm_map.w;
        lvsm_rows[row + i] = inside ? lvsm_depthAt(lvsm_depths, read, 0) : 1.0;
    }
    barrier();
    if (texel.x >= lvsm_region.z || texel.y >= lvsm_region.w)
        return;
    for (int slice = 0; slice < lvsm_sliceCount; ++slice)
    {
        vec4 sum = vec4(0.0);
        for (int tap = -lvsm_reach; tap <= lvsm_reach; ++tap)
        {
            int x = texel.x + tap;
            bool inside = x >= lvsm_map.x && x < lvsm_map.z;
            float weight = lvsm_weights[abs(tap) >> 2][abs(tap) & 3];
            vec4 stored = lvsm_storedTexel(lvsm_rows[row + thread + tap + lvsm_reach], slice);
            sum += weight * (inside ? stored : lvsm_border);
        }
        imageStore(lvsm_target, ivec3(texel, lvsm_firstSlice + slice), sum);
    }
}
