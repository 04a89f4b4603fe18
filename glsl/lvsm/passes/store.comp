#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, sampling/highp, config, depth, passes/depths, passes/store.
#extension GL_GOOGLE_include_directive : require
// Makes every slice of a map from one texture of depths, linear ones or a depth buffer (see depths.glsl).
//
// Run it with what storePass of include/lvsm/passes.hpp gives, the block and how many groups of 8 x 8 texels and one
// slice, then blur. LVSM_STORE says what a slice holds, see store.glsl; LVSM_STORE_FORMAT is the target's format. Of
// the block, only the default LVSM_STORE reads splits, layerCount and overlap.
// GLSL ES 3.10: put `#version 310 es` in the first line's place, `precision highp float;` and `precision highp int;`
// after it.
#include "store.glsl"

#ifndef LVSM_STORE_FORMAT
#define LVSM_STORE_FORMAT rgba16f
#endif
#ifndef LVSM_STORE_TARGET
#error define all of LVSM_STORE_DEPTHS, LVSM_STORE_TARGET and LVSM_STORE_BLOCK, or none
#endif

layout(local_size_x = 8, local_size_y = 8) in;
LVSM_STORE_DEPTHS uniform LVSM_DEPTH_TEXTURE lvsm_depths;
LVSM_STORE_TARGET layout(LVSM_STORE_FORMAT) uniform writeonly LVSM_HIGHP image2DArray lvsm_target;

void main()
{
    int slice = int(gl_GlobalInvocationID.z);
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + lvsm_region.xy;
    if (texel.x < lvsm_region.z && texel.y < lvsm_region.w)
        imageStore(lvsm_target, ivec3(texel, lvsm_firstSlice + slice),
                   lvsm_storedFrom(lvsm_depths, texel, slice));
}
