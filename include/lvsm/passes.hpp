// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, filter.
// What the host gives the ready passes in glsl/lvsm/passes and hlsl/lvsm/passes: their uniform blocks, how many groups a
// compute shader runs over, and the rectangle that a fragment shader is drawn over.
//
// A block has the layout of std140 and of an HLSL constant buffer: copy it into a uniform buffer as it is. A map may be
// a rectangle of an atlas or a part of an array of textures; where only some of it has changed, a region of it is
// enough.
// On the host alone: no shader has it.
#ifndef LVSM_PASSES_HPP
#define LVSM_PASSES_HPP

#include "filter.hpp"

#include <glm/vec4.hpp>

#include <cstdint>

namespace lvsm
{

// Threads of a group, in x and in y; in z it has one.
constexpr int kPassGroupSize = 8;

// Most fetches of one direction of a blur, as its block has room for them.
constexpr int kMaxBlurFetches = 66;

// Most layers that the block of the store pass has room for: LVSM_MAX_LAYERS may be set up to it.
constexpr int kMaxStoredLayers = 64;

/// Texels of a texture, from the corner (x, y) on.
struct Rectangle
{
    int x;
    int y;
    int width;
    int height;
};

/// How many groups to dispatch.
struct GroupCount
{
    int x;
    int y;
    int z;
};

/// One direction of a separable filter: fetches at offsets from a texel's centre, in texels, and their weights.
struct BlurKernel
{
    // Number of taps; those of the outermost reach (size - 1) / 2 texels.
    int size;
    int fetchCount;
    float taps[kMaxBlurFetches][2];
};

/// The block lvsm_Blur.
struct BlurBlock
{
    float border[4];
    std::int32_t map[4];
    std::int32_t region[4];
    float direction[2];
    std::int32_t slice;
    std::int32_t fetchCount;
    float taps[kMaxBlurFetches][2];
};

/// The block lvsm_Store.
struct StoreBlock
{
    std::int32_t region[4];
    std::int32_t layerCount;
    float overlap;
    std::int32_t firstSlice;
    std::int32_t slice;
    float splits[kMaxStoredLayers + 4];
};

/// One run of a pass: as a compute shader over groups, or as a fragment shader over the region.
template <typename Block>
struct Pass
{
    Block block;
    GroupCount groups;
    Rectangle region;
};

/// The two directions of a blur, in the order in which to run them.
struct BlurPasses
{
    Pass<BlurBlock> across;
    Pass<BlurBlock> down;
};

namespace detail
{

inline Rectangle intersection(const Rectangle& a, const Rectangle& b)
{
    const int x = maximum(a.x, b.x);
    const int y = maximum(a.y, b.y);
    const int right = minimum(a.x + a.width, b.x + b.width);
    const int bottom = minimum(a.y + a.height, b.y + b.height);
    return {x, y, maximum(right - x, 0), maximum(bottom - y, 0)};
}

inline void storeEnds(std::int32_t (&ends)[4], const Rectangle& rectangle)
{
    ends[0] = rectangle.x;
    ends[1] = rectangle.y;
    ends[2] = rectangle.x + rectangle.width;
    ends[3] = rectangle.y + rectangle.height;
}

inline void storeBorder(float (&to)[4], const glm::vec4& border)
{
    for (glm::vec4::length_type c = 0; c < 4; ++c)
        to[c] = border[c];
}

inline GroupCount groupsOver(const Rectangle& region, int slices)
{
    return {(region.width + kPassGroupSize - 1) / kPassGroupSize, (region.height + kPassGroupSize - 1) / kPassGroupSize,
            slices};
}

template <typename Weight>
BlurKernel kernelOf(int size, bool paired, const Weight& weight)
{
    BlurKernel kernel{size, 0, {}};
    const float middle = 0.5f * static_cast<float>(size - 1);
    for (int i = 0; i < size; i += paired ? 2 : 1)
    {
        const glm::dvec2 pair = linearPair(weight(i), paired ? weight(i + 1) : 0.0);
        kernel.taps[kernel.fetchCount][0] = static_cast<float>(i) - middle + static_cast<float>(pair.x);
        kernel.taps[kernel.fetchCount++][1] = static_cast<float>(pair.y);
    }
    return kernel;
}

inline Pass<BlurBlock> blurPass(const BlurKernel& kernel, const Rectangle& map, const Rectangle& region, bool down,
                                const glm::vec4& border, int firstSlice, int slices)
{
    Pass<BlurBlock> pass{{}, groupsOver(region, slices), region};
    storeBorder(pass.block.border, border);
    storeEnds(pass.block.map, map);
    storeEnds(pass.block.region, region);
    pass.block.direction[down ? 1 : 0] = 1.0f;
    pass.block.slice = firstSlice;
    pass.block.fetchCount = kernel.fetchCount;
    for (int i = 0; i < kernel.fetchCount; ++i)
    {
        pass.block.taps[i][0] = kernel.taps[i][0];
        pass.block.taps[i][1] = kernel.taps[i][1];
    }
    return pass;
}

} // namespace detail

/// Binomial filter, one direction of it.
/// size: number of taps, from 1 to 65, clamped to it. paired: two taps a fetch, which needs a map that the sampler
/// filters linearly; without, every fetch is at a texel's centre.
/// Source: binomialWeight, linearPair.
inline BlurKernel binomialKernel(int size, bool paired = true)
{
    const int count = detail::clamp(size, 1, kMaxFilterSize);
    return detail::kernelOf(count, paired, [count](int i) { return binomialWeight<double>(i, count); });
}

/// Gaussian filter, one direction of it.
/// size: number of taps, from 1 to 65, clamped to it. sigma: standard deviation in texels, from 1/64 to 2^20, clamped to
/// it. paired: two taps a fetch, which needs a map that the sampler filters linearly.
/// Source: gaussianWeight, linearPair.
inline BlurKernel gaussianKernel(int size, float sigma, bool paired = true)
{
    const int count = detail::clamp(size, 1, kMaxFilterSize);
    return detail::kernelOf(count, paired,
                            [count, sigma](int i) { return gaussianWeight(i, count, static_cast<double>(sigma)); });
}

/// Box filter of any width, one direction of it.
/// width: in texels, from 1 to 65, clamped to it. paired: two taps a fetch, which needs a map that the sampler filters
/// linearly. Result: the least odd number of taps that covers the width.
/// Source: boxWeight, linearPair.
inline BlurKernel boxKernel(float width, bool paired = true)
{
    const double extent = detail::clamp(static_cast<double>(width), 1.0, static_cast<double>(kMaxFilterSize));
    int reach = 0;
    while (2 * reach + 1 < extent)
        ++reach;
    return detail::kernelOf(2 * reach + 1, paired, [=](int i) { return boxWeight<double>(i - reach, extent); });
}

/// Both directions of a separable blur: the first from the map to a second one, the other back.
/// kernel: of both directions. map: where the map is in its texture. region: what of it is to be blurred; what is off
/// the map is left out. A change of the unblurred map by a rectangle changes that of the blurred one by
/// (kernel.size - 1) / 2 texels more on every side. border: what an empty texel holds, such as depthMoments(1).
/// firstSlice, slices: of the array of textures. For a fragment shader, draw once a slice and set block.slice to it.
/// Result: the first direction's region is as much higher than the second's as that reads.
inline BlurPasses blurPasses(const BlurKernel& kernel, const Rectangle& map, const Rectangle& region,
                             const glm::vec4& border, int firstSlice = 0, int slices = 1)
{
    const Rectangle inside = detail::intersection(map, region);
    const int reach = kernel.size / 2;
    const Rectangle grown{inside.x, inside.y - reach, inside.width, inside.height + 2 * reach};
    return {detail::blurPass(kernel, map, detail::intersection(map, grown), false, border, firstSlice, slices),
            detail::blurPass(kernel, map, inside, true, border, firstSlice, slices)};
}

/// The pass that makes a map from depths.
/// splits: layerCount + 1 values, not decreasing, from 0 to 1. layerCount: from 1 to LVSM_MAX_LAYERS of the shader.
/// overlap: of the layers. region: of the depths, and of the map likewise. firstSlice: of the array, where the map
/// begins. A technique without layers has layerCount 0 and takes one slice; set groups.z where it takes more.
/// Result: over all slices. For a fragment shader, draw once a slice and set block.slice to its number in the map.
inline Pass<StoreBlock> storePass(const float* splits, int layerCount, float overlap, const Rectangle& region,
                                  int firstSlice = 0)
{
    const int layers = detail::clamp(layerCount, 0, kMaxStoredLayers);
    const int slices = detail::maximum((layers + 1) / 2, 1);
    Pass<StoreBlock> pass{{}, detail::groupsOver(region, slices), region};
    detail::storeEnds(pass.block.region, region);
    pass.block.layerCount = layers;
    pass.block.overlap = overlap;
    pass.block.firstSlice = firstSlice;
    for (int i = 0; i < kMaxStoredLayers + 4; ++i)
        pass.block.splits[i] = layers > 0 && i <= layers ? splits[i] : 1.0f;
    return pass;
}

} // namespace lvsm

#endif
