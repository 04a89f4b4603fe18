// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, filter, passes.
// What the host gives passes/fused, which stores a map and blurs it across in one.
// On the host alone: no shader has it.
#ifndef LVSM_PASSES_FUSED_HPP
#define LVSM_PASSES_FUSED_HPP

#include "passes.hpp"

namespace lvsm
{

// Most texels to each side that the fused pass reads.
constexpr int kMaxFusedReach = 32;

// Threads of a group of the fused pass, in x and in y.
constexpr int kFusedGroupWidth = 64;
constexpr int kFusedGroupHeight = 4;

/// The block lvsm_Fused.
struct FusedBlock
{
    float border[4];
    std::int32_t map[4];
    std::int32_t sliceCount;
    std::int32_t reach;
    std::int32_t unused[2];
    float weights[kMaxFusedReach + 4];
};

/// A map stored and blurred in two passes: the fused one, with its two blocks, and the blur's second direction.
struct FusedPasses
{
    Pass<StoreBlock> store;
    FusedBlock fused;
    Pass<BlurBlock> down;
};

/// The passes that make a map from depths and blur it, without writing what is not blurred.
/// kernel: of both directions, of an odd number of taps, paired or not; the fused pass reads no texel between two.
/// splits, layerCount, overlap, firstSlice: as for storePass. map, region, border: as for blurPasses.
/// Result: what to run: the fused pass over store.groups from the depths, and down.
inline FusedPasses fusedPasses(const BlurKernel& kernel, const float* splits, int layerCount, float overlap,
                               const Rectangle& map, const Rectangle& region, const glm::vec4& border,
                               int firstSlice = 0)
{
    FusedPasses passes{};
    const int slices = detail::maximum((detail::clamp(layerCount, 0, kMaxStoredLayers) + 1) / 2, 1);
    const BlurPasses blur = blurPasses(kernel, map, region, border, firstSlice, slices);
    passes.down = blur.down;
    passes.store = storePass(splits, layerCount, overlap, blur.across.region, firstSlice);
    passes.store.groups = {(passes.store.region.width + kFusedGroupWidth - 1) / kFusedGroupWidth,
                           (passes.store.region.height + kFusedGroupHeight - 1) / kFusedGroupHeight, 1};
    detail::storeBorder(passes.fused.border, border);
    detail::storeEnds(passes.fused.map, map);
    passes.fused.sliceCount = slices;
    passes.fused.reach = detail::minimum(kernel.size / 2, kMaxFusedReach);
    for (int i = 0; i < kernel.fetchCount; ++i)
    {
        for (int tap = 0; tap <= passes.fused.reach; ++tap)
        {
            // A fetch between two texels counts for both.
            const float offset = kernel.taps[i][0] - static_cast<float>(tap);
            passes.fused.weights[tap] += kernel.taps[i][1] * detail::maximum(0.0f, 1.0f - (offset < 0 ? -offset : offset));
        }
    }
    return passes;
}

} // namespace lvsm

#endif
