#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/highp, passes/blur.
#extension GL_GOOGLE_include_directive : require
// One direction of a separable blur of a map, or of all slices of an array of maps, of 1 to 4 components.
//
// Run it twice, from the map to a second one and back, with what blurPasses of include/lvsm/passes.hpp gives: the
// block, and how many groups of 8 x 8 texels and one slice. LVSM_BLUR_FORMAT is the target's format.
// GLSL ES 3.10: put `#version 310 es` in the first line's place, `precision highp float;` and `precision highp int;`
// after it.
#include "blur.glsl"

#ifndef LVSM_BLUR_FORMAT
#define LVSM_BLUR_FORMAT rgba16f
#endif
#ifndef LVSM_BLUR_TARGET
#error define all of LVSM_BLUR_SOURCE, LVSM_BLUR_TARGET and LVSM_BLUR_BLOCK, or none
#endif

layout(local_size_x = 8, local_size_y = 8) in;
LVSM_BLUR_SOURCE uniform LVSM_HIGHP sampler2DArray lvsm_source;
LVSM_BLUR_TARGET layout(LVSM_BLUR_FORMAT) uniform writeonly LVSM_HIGHP image2DArray lvsm_target;

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(lvsm_region.xy, lvsm_slice);
    if (texel.x < lvsm_region.z && texel.y < lvsm_region.w)
        imageStore(lvsm_target, texel, LVSM_BLUR_TEXEL(lvsm_source, texel));
}
