// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, placement, passes/depths.
// A step of the relaxation by fragment passes alone, as the paper has it, where there are no compute shaders: the sums of
// every texel for two splits, their mean by the mip pass, and one pass that moves the splits or teleports one.
// Lauritzen & McCool, Layered Variance Shadow Maps, sections 4 and 5; lloydRelax of lloyd.hpp does the same on the host.
//
// placeStep of include/lvsm/passes_step.hpp fills the block and says what to draw. All splits take one slice of sums for
// each two; two a frame take one slice, and every frame another two. Sums are 32-bit floats, and so is the state: four
// splits to a texel in its first row, and the weights of their clusters in its second.
//
// Entry points: lvsm_stepSumsPixel draws what each 2x2 neighbourhood of one texture of depths, linear ones or a depth
// buffer (see depths.hlsli), adds to the sums of two splits, over the whole target, which begins at the map's first
// texel; lvsm_stepMovePixel draws another state, which takes the first one's place.
//
// The splits need not leave the device: copy the first row of the state into the buffer of StoreBlock, at the splits,
// which store and lighting read as their uniform block.
#include "../placement.hlsli"
#include "depths.hlsli"

// Where the resources are: define all of these or none, in front of this file. The numbers differ, so that they serve as
// Vulkan's bindings too.
#if defined(LVSM_STEP_DEPTHS) && defined(LVSM_STEP_STATE) && defined(LVSM_STEP_BLOCK) && defined(LVSM_STEP_SUMS)
#elif defined(LVSM_STEP_DEPTHS) || defined(LVSM_STEP_STATE) || defined(LVSM_STEP_BLOCK) || defined(LVSM_STEP_SUMS)
#error define all of LVSM_STEP_DEPTHS, LVSM_STEP_STATE, LVSM_STEP_BLOCK and LVSM_STEP_SUMS, or none
#else
#define LVSM_STEP_DEPTHS t0
#define LVSM_STEP_STATE t1
#define LVSM_STEP_BLOCK b2
#define LVSM_STEP_SUMS t3
#endif

LVSM_DEPTH_TEXTURE lvsm_depths : register(LVSM_STEP_DEPTHS);
Texture2D<float4> lvsm_state : register(LVSM_STEP_STATE);
Texture2DArray<float4> lvsm_sums : register(LVSM_STEP_SUMS);
// StepBlock of include/lvsm/passes_step.hpp.
cbuffer lvsm_Step : register(LVSM_STEP_BLOCK)
{
    // First texel and end of the map of depths.
    int4 lvsm_map;
    int lvsm_layerCount;
    // Number of the frame where two splits move in each; less than 0 moves all.
    int lvsm_frame;
    // The slice of the sums that is drawn.
    int lvsm_slice;
    // The last level of the sums, as the source has it: 0 where the source is a view of that level alone.
    int lvsm_level;
    float lvsm_minVariance;
    float lvsm_maxVariance;
};

// The two splits whose sums a slice has; one that is not there has no texel nearest to it.
int2 lvsm_splitsOfSlice(int slice)
{
    if (lvsm_frame < 0)
        return int2(2 * slice + 1, 2 * slice + 2);
    return lvsm_scheduledSplits(lvsm_frame, lvsm_layerCount);
}

float lvsm_stepDepth(int2 texel)
{
    return clamp(lvsm_depthAt(lvsm_depths, min(texel, lvsm_map.zw - 1), 0), 0.0, 1.0);
}

float4 lvsm_stepSumsPixel(float4 position : SV_Position) : SV_Target
{
    int2 texel = int2(position.xy) + lvsm_map.xy;
    float d00 = lvsm_stepDepth(texel);
    float d10 = lvsm_stepDepth(texel + int2(1, 0));
    float d01 = lvsm_stepDepth(texel + int2(0, 1));
    float d11 = lvsm_stepDepth(texel + int2(1, 1));
    // Of four numbers the variance comes from their differences, which do not cancel.
    float left = d00 - d01;
    float right = d10 - d11;
    float across = (d00 - d10) + (d01 - d11);
    float variance = 0.0625 * ((left + right) * (left + right) + across * across + (left - right) * (left - right));
    bool whole = all(texel + 1 < max(lvsm_map.zw, lvsm_map.xy + 2));
    float weight = whole && variance >= lvsm_minVariance ? min(variance, max(lvsm_maxVariance, 0.0)) : 0.0;
    float value = clamp(0.25 * ((d00 + d10) + (d01 + d11)) + sqrt(variance), 0.0, 1.0);

    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = lvsm_state.Load(int3(i / 4, 0, 0))[i % 4];
    int2 own = lvsm_splitsOfSlice(lvsm_slice);
    return lvsm_accumulateSplits(value, weight, lvsm_nearestSplit(value, splits, lvsm_layerCount), own.x, own.y);
}

float4 lvsm_stepMovePixel(float4 position : SV_Position) : SV_Target
{
    int layers = clamp(lvsm_layerCount, 1, LVSM_MAX_LAYERS);
    float splits[LVSM_MAX_LAYERS + 1];
    float weights[LVSM_MAX_LAYERS + 1];
    float moved[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
    {
        splits[i] = lvsm_state.Load(int3(i / 4, 0, 0))[i % 4];
        weights[i] = lvsm_state.Load(int3(i / 4, 1, 0))[i % 4];
        moved[i] = splits[i];
    }
    // Teleports that are left, and one more, as weights[0]; negative until a move has followed the last teleport.
    float left = weights[0];
    for (int slice = 0; slice < (lvsm_frame < 0 ? layers / 2 : 1); ++slice)
    {
        float4 sums = lvsm_sums.Load(int4(0, 0, slice, lvsm_level));
        int2 own = lvsm_splitsOfSlice(slice);
        for (int j = 1; j < LVSM_MAX_LAYERS; ++j)
        {
            if (j >= layers || (j != own.x && j != own.y))
                continue;
            float2 share = j == own.x ? sums.xy : sums.zw;
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
    float4 result = float4(0.0, 0.0, 0.0, 0.0);
    for (int c = 0; c < 4; ++c)
    {
        int index = min(4 * int(position.x) + c, LVSM_MAX_LAYERS);
        result[c] = position.y < 1.0 ? splits[index] : weights[index];
    }
    return result;
}
