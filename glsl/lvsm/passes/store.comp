#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, passes/store.
#extension GL_GOOGLE_include_directive : require
// Makes every slice of a map from one texture of unwarped depths, in [0,1] and 1 where there is no surface.
//
// Run it over groups of 8 x 8 texels and one slice each, then blur. LVSM_STORE says what a slice holds, see store.glsl;
// LVSM_STORE_FORMAT is the target's format. Of the uniforms, only the default LVSM_STORE reads splits, layerCount and
// overlap.
#include "store.glsl"

#ifndef LVSM_STORE_FORMAT
#define LVSM_STORE_FORMAT rgba16f
#endif

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D lvsm_depths;
layout(binding = 1, LVSM_STORE_FORMAT) uniform writeonly image2DArray lvsm_target;

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (all(lessThan(texel, imageSize(lvsm_target))))
        imageStore(lvsm_target, texel, LVSM_STORE(texelFetch(lvsm_depths, texel.xy, 0).x, texel.z));
}
