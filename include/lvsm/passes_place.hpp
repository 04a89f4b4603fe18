// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments, placement, runs, lloyd, optimal, filter, passes.
// What the host gives passes/place, which places the splits on the device: two dispatches, one that counts what a depth
// texture holds and one group that relaxes the splits or finds the optimal ones, as lloydRelax and optimalSplits do.
// On the host alone: no shader has it.
#ifndef LVSM_PASSES_PLACE_HPP
#define LVSM_PASSES_PLACE_HPP

#include "lloyd.hpp"
#include "optimal.hpp"
#include "passes.hpp"

#include <cstddef>

namespace lvsm
{

// Texels that a group counts, in x and in y.
constexpr int kPlaceGroupTexels = 32;

/// The block lvsm_Place.
struct PlaceBlock
{
    std::int32_t map[4];
    std::int32_t layerCount;
    std::int32_t optimal;
    std::int32_t keepSplits;
    std::int32_t maxIterations;
    float tolerance;
    float minVariance;
    float maxVariance;
    float uniformShare;
    float leastGain;
    std::int32_t leastBins;
    std::int32_t unused[2];
};

/// Both dispatches of a placement: the first over groups, the second over one group, with the same block.
/// histogramBytes: of the buffer that they share, to be filled with 0 once.
struct PlacePass
{
    PlaceBlock block;
    GroupCount groups;
    std::size_t histogramBytes;
};

namespace detail
{

inline PlacePass placePass(int layerCount, const Rectangle& map)
{
    PlacePass pass{};
    storeEnds(pass.block.map, map);
    pass.block.layerCount = clamp(layerCount, 1, kMaxStoredLayers);
    pass.groups = {(map.width + kPlaceGroupTexels - 1) / kPlaceGroupTexels,
                   (map.height + kPlaceGroupTexels - 1) / kPlaceGroupTexels, 1};
    // Four words a bin for the sums, and one for where each layer begins.
    const int words = OccluderHistogram::kBins * (4 + pass.block.layerCount);
    pass.histogramBytes = static_cast<std::size_t>(words) * sizeof(std::uint32_t);
    return pass;
}

} // namespace detail

/// Splits by Lloyd relaxation on the device, run to its end.
/// layerCount: from 1 to LVSM_MAX_LAYERS of the shader. map: where the depths are in their texture.
/// options: as lloydRelax takes them, of which the device reads all neighbourhoods and always moves all splits.
/// keepSplits starts from what the buffer holds; it has to hold a placement then, such as storePass gives.
/// Result: what to run; the splits are within 1/4096 of lloydRelax's, unless depths lie on the very middle between two
/// splits, as evenly spaced ones may: either can take those.
inline PlacePass relaxPass(int layerCount, const Rectangle& map, const RelaxOptions<float>& options = {})
{
    PlacePass pass = detail::placePass(layerCount, map);
    pass.block.keepSplits = options.keepSplits ? 1 : 0;
    pass.block.maxIterations = options.maxIterations;
    pass.block.tolerance = options.tolerance;
    pass.block.minVariance = options.minVariance;
    pass.block.maxVariance = options.maxVariance;
    return pass;
}

/// Splits of least spread, found on the device.
/// layerCount: from 1 to LVSM_MAX_LAYERS of the shader. map: where the depths are in their texture.
/// options: as optimalSplits takes them, of which the device reads all texels; leastGain keeps what the buffer holds.
/// Result: what to run; the splits are within 1/4096 of optimalSplits', or as good where the optimum is not the only
/// one to the precision of float, 2^-20 of it.
inline PlacePass optimalPass(int layerCount, const Rectangle& map, const OptimalOptions<float>& options = {})
{
    PlacePass pass = detail::placePass(layerCount, map);
    const float length = detail::clamp(options.minLength, 0.0f, 1.0f);
    pass.block.optimal = 1;
    pass.block.uniformShare = options.uniformShare;
    pass.block.leastGain = options.leastGain;
    pass.block.leastBins =
        detail::clamp(static_cast<int>(length * static_cast<float>(kMaxOptimalBins)), 1,
                      kMaxOptimalBins / pass.block.layerCount);
    return pass;
}

} // namespace lvsm

#endif
