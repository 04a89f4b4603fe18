// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, filter, passes.
// What the host gives passes/mip, which makes the levels of a map, each from the one before.
// On the host alone: no shader has it.
#ifndef LVSM_PASSES_MIP_HPP
#define LVSM_PASSES_MIP_HPP

#include "passes.hpp"

namespace lvsm
{

/// The block lvsm_Mip.
struct MipBlock
{
    std::int32_t before[4];
    std::int32_t region[4];
    std::int32_t slice;
    std::int32_t level;
    std::int32_t unused[2];
};

/// Where a map is in a level of its texture.
/// map: where it is in level 0; a rectangle of an atlas has its corner at a multiple of 2^level, or it moves.
/// level: from 0 to 30, clamped to it. Result: half the size for each level, rounded down, and at least 1.
inline Rectangle levelRectangle(const Rectangle& map, int level)
{
    const int halvings = detail::clamp(level, 0, 30);
    return {map.x >> halvings, map.y >> halvings, detail::maximum(map.width >> halvings, 1),
            detail::maximum(map.height >> halvings, 1)};
}

/// How many levels a map has, with the first one and the last, of one texel.
inline int levelCount(const Rectangle& map)
{
    int count = 1;
    while (count < 31 && ((detail::maximum(map.width, map.height) >> count) > 0))
        ++count;
    return count;
}

/// The pass that makes a level of a map from the level before.
/// map: where it is in level 0, see levelRectangle. level: to be made, at least 1; run the pass for each in turn.
/// firstSlice, slices: of the array of textures. For a fragment shader, draw once a slice and set block.slice to it.
/// sourceLevel: the level before as the shader's source has it, 0 where that is a view of it alone.
inline Pass<MipBlock> mipPass(const Rectangle& map, int level, int firstSlice = 0, int slices = 1, int sourceLevel = 0)
{
    const Rectangle region = levelRectangle(map, level);
    Pass<MipBlock> pass{{}, detail::groupsOver(region, slices), region};
    detail::storeEnds(pass.block.before, levelRectangle(map, level - 1));
    detail::storeEnds(pass.block.region, region);
    pass.block.slice = firstSlice;
    pass.block.level = sourceLevel;
    return pass;
}

} // namespace lvsm

#endif
