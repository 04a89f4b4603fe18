#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/highp, passes/mip.
#extension GL_GOOGLE_include_directive : require
// One level of a map, or of one slice of an array of maps, from the level before.
//
// Draw it for each level with what mipPass of include/lvsm/passes_mip.hpp gives: the block, and the rectangle of the
// level to draw over. WebGL2 draws to a level only while the texture's base and maximum level are the one before.
// GLSL 3.30, ES 3.00 and WebGL2: put their #version in the first line's place, and in ES `precision highp float;` and
// `precision highp int;` after it.
#include "mip.glsl"

LVSM_MIP_SOURCE uniform LVSM_HIGHP sampler2DArray lvsm_source;
layout(location = 0) out vec4 lvsm_result;

void main()
{
    lvsm_result = lvsm_mipTexel(lvsm_source, ivec3(ivec2(gl_FragCoord.xy), lvsm_slice));
}
