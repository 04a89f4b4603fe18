#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, passes/store.
#extension GL_GOOGLE_include_directive : require
// Makes one slice of a map, the one that the uniform lvsm_slice names, from one texture of unwarped depths, in [0,1]
// and 1 where there is no surface.
//
// Draw it over a whole target of the texture's size, then blur. LVSM_STORE says what a slice holds, see store.glsl.
#include "store.glsl"

layout(binding = 0) uniform sampler2D lvsm_depths;
layout(location = 0) out vec4 lvsm_result;

void main()
{
    lvsm_result = LVSM_STORE(texelFetch(lvsm_depths, ivec2(gl_FragCoord.xy), 0).x, lvsm_slice);
}
