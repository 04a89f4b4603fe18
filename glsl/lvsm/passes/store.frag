#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, sampling/highp, config, depth, passes/depths, passes/store.
#extension GL_GOOGLE_include_directive : require
// Makes one slice of a map, the one that the block's lvsm_slice names, from one texture of depths, linear
// ones or a depth buffer (see depths.glsl).
//
// Draw it with what storePass of include/lvsm/passes.hpp gives, the block and the rectangle of the target to draw over,
// then blur. LVSM_STORE says what a slice holds, see store.glsl.
// GLSL 3.30, ES 3.00 and WebGL2: put their #version in the first line's place, and in ES `precision highp float;` and
// `precision highp int;` after it.
#include "store.glsl"

LVSM_STORE_DEPTHS uniform LVSM_DEPTH_TEXTURE lvsm_depths;
layout(location = 0) out vec4 lvsm_result;

void main()
{
    lvsm_result = lvsm_storedFrom(lvsm_depths, ivec2(gl_FragCoord.xy), lvsm_slice);
}
