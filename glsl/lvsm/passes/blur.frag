#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, passes/blur.
#extension GL_GOOGLE_include_directive : require
// One direction of a separable blur of a map, or of one slice of an array of maps, of 1 to 4 components.
//
// Draw it twice over a whole target of the map's size, with direction (1, 0) from the map to a second one and with
// (0, 1) back. The map's sampler filters linearly and clamps to the edge; its format must allow that, which 16-bit
// formats do everywhere. LVSM_BLUR_SIZE is the number of taps (9); LVSM_BLUR_SIGMA, where defined, makes the binomial
// filter a Gaussian.
#include "blur.glsl"

layout(binding = 0) uniform sampler2DArray lvsm_source;
layout(binding = 2, std140) uniform lvsm_Blur
{
    vec2 lvsm_direction;
    int lvsm_slice;
};
layout(location = 0) out vec4 lvsm_result;

void main()
{
    lvsm_result = lvsm_blurredTexel(lvsm_source, ivec3(ivec2(gl_FragCoord.xy), lvsm_slice), lvsm_direction);
}
