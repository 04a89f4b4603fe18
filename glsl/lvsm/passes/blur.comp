#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, passes/blur.
#extension GL_GOOGLE_include_directive : require
// One direction of a separable blur of a map, or of all slices of an array of maps, of 1 to 4 components.
//
// Run it twice, with direction (1, 0) from the map to a second one and with (0, 1) back, over groups of 8 x 8 texels
// and one slice each. The map's sampler filters linearly and clamps to the edge; its format must allow that, which
// 16-bit formats do everywhere. LVSM_BLUR_SIZE is the number of taps (9); LVSM_BLUR_SIGMA, where defined, makes the
// binomial filter a Gaussian; LVSM_BLUR_FORMAT is the target's format.
#include "blur.glsl"

#ifndef LVSM_BLUR_FORMAT
#define LVSM_BLUR_FORMAT rgba16f
#endif

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray lvsm_source;
layout(binding = 1, LVSM_BLUR_FORMAT) uniform writeonly image2DArray lvsm_target;
layout(binding = 2, std140) uniform lvsm_Blur
{
    vec2 lvsm_direction;
};

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (all(lessThan(texel, imageSize(lvsm_target))))
        imageStore(lvsm_target, texel, lvsm_blurredTexel(lvsm_source, texel, lvsm_direction));
}
