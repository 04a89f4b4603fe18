// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, placement.
// A step of the relaxation by fragment passes alone, as the paper has it, where there are no compute shaders: the sums of
// every texel for two splits, their mean by the mip pass, and one pass that moves the splits or teleports one.
// Lauritzen & McCool, Layered Variance Shadow Maps, sections 4 and 5; lloydRelax of lloyd.hpp does the same on the host.
//
// placeStep of include/lvsm/passes_step.hpp fills the block and says what to draw. All splits take one slice of sums for
// each two; two a frame take one slice, and every frame another two. Sums are 32-bit floats, and so is the state: four
// splits to a texel in its first row, and the weights of their clusters in its second.
//
// The splits need not leave the device: copy the first row of the state into the buffer of StoreBlock, at the splits,
// which store and lighting read as their uniform block; in OpenGL ES by glReadPixels into it as a pixel buffer.
#ifndef LVSM_PASSES_STEP_GLSL
#define LVSM_PASSES_STEP_GLSL

#include "../placement.glsl"

// Where the resources are: define all of these or none, in front of this file.
#if defined(LVSM_STEP_SOURCE) != defined(LVSM_STEP_BLOCK)
#error define all of LVSM_STEP_SOURCE, LVSM_STEP_BLOCK and, for step_move.frag, LVSM_STEP_STATE, or none
#elif !defined(LVSM_STEP_SOURCE) && (__VERSION__ < 310 || !defined(GL_ES) && __VERSION__ < 420)
#define LVSM_STEP_SOURCE
#define LVSM_STEP_STATE
#define LVSM_STEP_BLOCK layout(std140)
#elif !defined(LVSM_STEP_SOURCE)
#define LVSM_STEP_SOURCE layout(binding = 0)
#define LVSM_STEP_STATE layout(binding = 1)
#define LVSM_STEP_BLOCK layout(binding = 2, std140)
#endif

// StepBlock of include/lvsm/passes_step.hpp.
LVSM_STEP_BLOCK uniform lvsm_Step
{
    // First texel and end of the map of depths.
    ivec4 lvsm_map;
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
ivec2 lvsm_splitsOfSlice(int slice)
{
    if (lvsm_frame < 0)
        return ivec2(2 * slice + 1, 2 * slice + 2);
    return lvsm_scheduledSplits(lvsm_frame, lvsm_layerCount);
}

#endif
