// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, placement.
// A step of the relaxation of the splits, as the paper has it: the sums of every texel for two splits, their mean by the
// mip pass, and one pass that moves the splits or teleports one.
// Lauritzen & McCool, Layered Variance Shadow Maps, sections 4 and 5; lloydRelax of lloyd.hpp does the same on the host.
//
// placeStep of include/lvsm/passes_step.hpp fills the block. step_sums runs over the sums in groups of 8 x 8 texels and
// one slice, mip for each level of them from 1 on, step_move in one group. Sums are rgba32float, and so is the state:
// four splits to a texel in its first row, and the weights of their clusters in its second.
//
// The splits need not leave the device: copyTextureToBuffer puts the first row of the state into the buffer of
// StoreBlock, 32 bytes from its beginning, which store and lighting read as their uniform block.

// StepBlock of include/lvsm/passes_step.hpp.
struct lvsm_Step
{
    // First texel and end of the map of depths.
    map: vec4i,
    layerCount: i32,
    // Number of the frame where two splits move in each; less than 0 moves all.
    frame: i32,
    // The first slice of the sums.
    slice: i32,
    // The last level of the sums, as the source has it: 0 where the source is a view of that level alone.
    level: i32,
    minVariance: f32,
    maxVariance: f32,
}

// The two splits whose sums a slice has; one that is not there has no texel nearest to it.
fn lvsm_splitsOfSlice(step: lvsm_Step, slice: i32) -> vec2i
{
    if (step.frame < 0)
    {
        return vec2i(2 * slice + 1, 2 * slice + 2);
    }
    return lvsm_scheduledSplits(step.frame, step.layerCount);
}
