#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/highp, passes/mip.
#extension GL_GOOGLE_include_directive : require
// One level of a map, or of all slices of an array of maps, from the level before.
//
// Run it for each level with what mipPass of include/lvsm/passes_mip.hpp gives: the block, and how many groups of 8 x 8
// texels and one slice. LVSM_MIP_FORMAT is the target's format.
// GLSL ES 3.10: put `#version 310 es` in the first line's place, `precision highp float;` and `precision highp int;`
// after it.
#include "mip.glsl"

#ifndef LVSM_MIP_FORMAT
#define LVSM_MIP_FORMAT rgba16f
#endif
#ifndef LVSM_MIP_TARGET
#error define all of LVSM_MIP_SOURCE, LVSM_MIP_TARGET and LVSM_MIP_BLOCK, or none
#endif

layout(local_size_x = 8, local_size_y = 8) in;
LVSM_MIP_SOURCE uniform LVSM_HIGHP sampler2DArray lvsm_source;
LVSM_MIP_TARGET layout(LVSM_MIP_FORMAT) uniform writeonly LVSM_HIGHP image2DArray lvsm_target;

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(lvsm_region.xy, lvsm_slice);
    if (texel.x < lvsm_region.z && texel.y < lvsm_region.w)
        imageStore(lvsm_target, texel, lvsm_mipTexel(lvsm_source, texel));
}
