#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/highp, passes/blur.
#extension GL_GOOGLE_include_directive : require
// One direction of a separable blur of a map, or of one slice of an array of maps, of 1 to 4 components.
//
// Draw it twice, from the map to a second one and back, with what blurPasses of include/lvsm/passes.hpp gives: the
// block, and the rectangle of the target to draw over.
// GLSL 3.30, ES 3.00 and WebGL2: put their #version in the first line's place, and in ES `precision highp float;` and
// `precision highp int;` after it.
#include "blur.glsl"

LVSM_BLUR_SOURCE uniform LVSM_HIGHP sampler2DArray lvsm_source;
layout(location = 0) out vec4 lvsm_result;

void main()
{
    lvsm_result = LVSM_BLUR_TEXEL(lvsm_source, ivec3(ivec2(gl_FragCoord.xy), lvsm_slice));
}
