#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, sampling/highp, passes/store.
#extension GL_GOOGLE_include_directive : require
// Makes one slice of a map, the one that the block's lvsm_slice names, from one texture of unwarped depths, in [0,1]
// and 1 where there is no surface.
//
// Draw it with what storePass of include/lvsm/passes.hpp gives, the block and the rectangle of the target to draw over,
// then blur. LVSM_STORE says what a slice holds, see store.glsl.
// GLSL 3.30, ES 3.00 and WebGL2: put their #version in the first line's place, and in ES `precision highp float;` and
// `precision highp int;` after it.
#include "store.glsl"

LVSM_STORE_DEPTHS uniform LVSM_HIGHP sampler2D lvsm_depths;
layout(location = 0) out vec4 lvsm_result;

void main()
{
    lvsm_result = lvsm_storedTexel(texelFetch(lvsm_depths, ivec2(gl_FragCoord.xy), 0).x, lvsm_slice);
}
