// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments, placement, runs, lloyd, filter, passes, passes_mip.
// What the host gives passes/step, which relaxes the splits by fragment passes alone, a step a frame.
// On the host alone: no shader has it.
#ifndef LVSM_PASSES_STEP_HPP
#define LVSM_PASSES_STEP_HPP

#include "lloyd.hpp"
#include "passes_mip.hpp"

namespace lvsm
{

/// The block lvsm_Step.
struct StepBlock
{
    std::int32_t map[4];
    std::int32_t layerCount;
    std::int32_t frame;
    std::int32_t slice;
    std::int32_t level;
    float minVariance;
    float maxVariance;
    std::int32_t unused[2];
};

/// One step of a relaxation, in the order in which to draw it: for each of the slices, step_sums over sums, with
/// block.slice set to its number; mipPass for each level of sums from 1 on; step_move over stateWidth x 2 texels.
struct PlaceStep
{
    StepBlock block;
    Rectangle sums;
    int slices;
    int stateWidth;
};

/// How many texels wide the state is that step_move draws.
/// maxLayers: LVSM_MAX_LAYERS of the shader, from 1 to 64, clamped to it. Result: four splits to a texel.
inline int placeStateWidth(int maxLayers)
{
    return (detail::clamp(maxLayers, 1, kMaxStoredLayers) + 4) / 4;
}

/// The state before the first step: uniform splits, whose clusters count as not empty until they are known.
/// layerCount: from 1 to maxLayers. maxLayers: LVSM_MAX_LAYERS of the shader, from 1 to 64, clamped to it.
/// state: 8 placeStateWidth(maxLayers) floats, written: two rows of texels of four.
inline void startPlaceState(int layerCount, int maxLayers, float* state)
{
    const int most = detail::clamp(maxLayers, 1, kMaxStoredLayers);
    const int layers = detail::clamp(layerCount, 1, most);
    const int row = 4 * placeStateWidth(most);
    for (int i = 0; i < row; ++i)
    {
        state[i] = i < layers ? static_cast<float>(i) / static_cast<float>(layers) : 1.0f;
        state[row + i] = 1.0f;
    }
    // Two teleports for each inner split, and one; negative until a move has come first.
    state[row] = -static_cast<float>(2 * (layers - 1) + 1);
}

/// One step of the relaxation of the splits by fragment passes, as lloydRelax does it: every step moves splits, or
/// teleports one where the move before has left a cluster empty.
/// layerCount: from 1 to maxLayers. maxLayers: LVSM_MAX_LAYERS of the shader, from 1 to 64, clamped to it. map: where the
/// depths are in their texture. frame: counted from 0; two splits move in each as scheduledSplits says where
/// options.splitsPerIteration is 2, all in every one otherwise. options: as lloydRelax takes them, of which the device
/// reads the variances. level: the last of the sums, as the shader's source has it, 0 where that is a view of it alone.
/// Result: what to draw. The sums have levelCount levels of their rectangle. The splits come to rest within 1/4096 of
/// lloydRelax's, but for depths spread over all bins of its histogram, such as noise, within 1/200.
inline PlaceStep placeStep(int layerCount, int maxLayers, const Rectangle& map, int frame,
                           const RelaxOptions<float>& options = {}, int level = 0)
{
    const bool inPairs = options.splitsPerIteration == 2;
    PlaceStep step{};
    detail::storeEnds(step.block.map, map);
    step.block.layerCount = detail::clamp(layerCount, 1, detail::clamp(maxLayers, 1, kMaxStoredLayers));
    step.block.frame = inPairs ? detail::maximum(frame, 0) : -1;
    step.block.level = level;
    step.block.minVariance = options.minVariance;
    step.block.maxVariance = options.maxVariance;
    step.sums = {0, 0, map.width, map.height};
    step.slices = inPairs ? 1 : detail::maximum(step.block.layerCount / 2, 1);
    step.stateWidth = placeStateWidth(maxLayers);
    return step;
}

} // namespace lvsm

#endif
