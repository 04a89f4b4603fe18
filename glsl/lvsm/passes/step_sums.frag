#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, placement, passes/step, sampling/highp, passes/depths.
#extension GL_GOOGLE_include_directive : require
// What each 2x2 neighbourhood of one texture of depths, linear ones or a depth buffer (see depths.glsl), adds to the sums
// of two splits: see step.glsl. Draw it over the whole target, which begins at the map's first texel.
// GLSL 3.30, ES 3.00 and WebGL2: put their #version in the first line's place, and in ES `precision highp float;` and
// `precision highp int;` after it.
#include "step.glsl"
#include "depths.glsl"

#ifndef LVSM_STEP_STATE
#error define all of LVSM_STEP_SOURCE, LVSM_STEP_STATE and LVSM_STEP_BLOCK, or none
#endif

LVSM_STEP_SOURCE uniform LVSM_DEPTH_TEXTURE lvsm_depths;
LVSM_STEP_STATE uniform LVSM_HIGHP sampler2D lvsm_state;
layout(location = 0) out vec4 lvsm_result;

float lvsm_stepDepth(ivec2 texel)
{
    return clamp(lvsm_depthAt(lvsm_depths, min(texel, lvsm_map.zw - 1), 0), 0.0, 1.0);
}

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy) + lvsm_map.xy;
    float d00 = lvsm_stepDepth(texel);
    float d10 = lvsm_stepDepth(texel + ivec2(1, 0));
    float d01 = lvsm_stepDepth(texel + ivec2(0, 1));
    float d11 = lvsm_stepDepth(texel + ivec2(1, 1));
    // Of four numbers the variance comes from their differences, which do not cancel.
    float left = d00 - d01;
    float right = d10 - d11;
    float across = (d00 - d10) + (d01 - d11);
    float variance = 0.0625 * ((left + right) * (left + right) + across * across + (left - right) * (left - right));
    bool whole = all(lessThan(texel + 1, max(lvsm_map.zw, lvsm_map.xy + 2)));
    float weight = whole && variance >= lvsm_minVariance ? min(variance, max(lvsm_maxVariance, 0.0)) : 0.0;
    float value = clamp(0.25 * ((d00 + d10) + (d01 + d11)) + sqrt(variance), 0.0, 1.0);

    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = texelFetch(lvsm_state, ivec2(i / 4, 0), 0)[i % 4];
    ivec2 own = lvsm_splitsOfSlice(lvsm_slice);
    lvsm_result = lvsm_accumulateSplits(value, weight, lvsm_nearestSplit(value, splits, lvsm_layerCount), own.x, own.y);
}
