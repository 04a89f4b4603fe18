#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, placement, passes/step, sampling/highp.
#extension GL_GOOGLE_include_directive : require
// Moves the splits by the mean of their sums, or teleports one whose cluster is empty: see step.glsl. Draw it over the
// whole of another state, which takes the first one's place.
// GLSL 3.30, ES 3.00 and WebGL2: put their #version in the first line's place, and in ES `precision highp float;` and
// `precision highp int;` after it.
#include "step.glsl"
#include "../sampling/highp.glsl"

#ifndef LVSM_STEP_STATE
#error define all of LVSM_STEP_SOURCE, LVSM_STEP_STATE and LVSM_STEP_BLOCK, or none
#endif

LVSM_STEP_SOURCE uniform LVSM_HIGHP sampler2DArray lvsm_sums;
LVSM_STEP_STATE uniform LVSM_HIGHP sampler2D lvsm_state;
layout(location = 0) out vec4 lvsm_result;

void main()
{
    int layers = clamp(lvsm_layerCount, 1, LVSM_MAX_LAYERS);
    float splits[LVSM_MAX_LAYERS + 1];
    float weights[LVSM_MAX_LAYERS + 1];
    float moved[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
    {
        splits[i] = texelFetch(lvsm_state, ivec2(i / 4, 0), 0)[i % 4];
        weights[i] = texelFetch(lvsm_state, ivec2(i / 4, 1), 0)[i % 4];
        moved[i] = splits[i];
    }
    // Teleports that are left, and one more, as weights[0]; negative until a move has followed the last teleport.
    float left = weights[0];
    for (int slice = 0; slice < (lvsm_frame < 0 ? layers / 2 : 1); ++slice)
    {
        vec4 sums = texelFetch(lvsm_sums, ivec3(0, 0, slice), lvsm_level);
        ivec2 own = lvsm_splitsOfSlice(slice);
        for (int j = 1; j < LVSM_MAX_LAYERS; ++j)
        {
            if (j >= layers || (j != own.x && j != own.y))
                continue;
            vec2 share = j == own.x ? sums.xy : sums.zw;
            weights[j] = share.y;
            moved[j] = lvsm_updateSplit(splits[j], share.x, share.y);
        }
    }
    bool isEmpty = false;
    bool isAll = true;
    for (int k = 1; k < LVSM_MAX_LAYERS; ++k)
    {
        isEmpty = isEmpty || (k < layers && weights[k] < LVSM_TINY);
        isAll = isAll && (k >= layers || weights[k] < LVSM_TINY);
    }
    if (isEmpty && !isAll && left > 1.5)
    {
        lvsm_teleportSplits(splits, weights, layers);
        left = 1.0 - left;
    }
    else
    {
        for (int m = 1; m < LVSM_MAX_LAYERS; ++m)
            splits[m] = moved[m];
        lvsm_monotoneSplits(splits, layers);
        left = abs(left);
    }
    weights[0] = left;
    vec4 result = vec4(0.0);
    for (int c = 0; c < 4; ++c)
    {
        int index = min(4 * int(gl_FragCoord.x) + c, LVSM_MAX_LAYERS);
        result[c] = gl_FragCoord.y < 1.0 ? splits[index] : weights[index];
    }
    lvsm_result = result;
}
