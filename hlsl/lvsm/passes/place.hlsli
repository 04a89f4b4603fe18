// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config.
// What the two dispatches of place.hlsl share.
//
// Where splits are to follow what is on the screen, define in front of the pass
//   #define LVSM_PLACE_WEIGHTS t5   where a texture of whole numbers is, one for each texel of the depths:
// how many of the screen's pixels read it, which the lighting can count by atomics. From 256 on they count as 256; a
// texel with 0 has no say. It is what the paper gives to future work: the relaxation in view space.
#ifndef LVSM_PASSES_PLACE_HLSLI
#define LVSM_PASSES_PLACE_HLSLI

#include "../config.hlsli"

// Where the resources are: define all of these or none, in front of this file. The numbers differ, so that they serve as
// Vulkan's bindings too.
#ifndef LVSM_PLACE_BLOCK
#define LVSM_PLACE_DEPTHS t0
#define LVSM_PLACE_HISTOGRAM u1
#define LVSM_PLACE_BLOCK b2
#define LVSM_PLACE_SPLITS u3
#elif !defined(LVSM_PLACE_DEPTHS) || !defined(LVSM_PLACE_HISTOGRAM) || !defined(LVSM_PLACE_SPLITS)
#error define all of LVSM_PLACE_DEPTHS, LVSM_PLACE_HISTOGRAM, LVSM_PLACE_BLOCK and LVSM_PLACE_SPLITS, or none
#endif

static const int LVSM_PLACE_BINS = 1024;

// PlaceBlock of include/lvsm/passes.hpp.
cbuffer lvsm_Place : register(LVSM_PLACE_BLOCK)
{
    // First texel and end of the map.
    int4 lvsm_map;
    int lvsm_layerCount;
    // 1 finds the optimal splits, 0 relaxes them.
    int lvsm_optimal;
    // 1 relaxes from the splits that the buffer holds, 0 from uniform ones.
    int lvsm_keepSplits;
    int lvsm_maxIterations;
    float lvsm_tolerance;
    float lvsm_minVariance;
    float lvsm_maxVariance;
    float lvsm_uniformShare;
    float lvsm_leastGain;
    // Least length of a cell of optimal splits, in bins.
    int lvsm_leastBins;
};

// Four words a bin: the sum of weights, low and high, and of weights times values, in units of 2^-30. Then scratch of
// lvsm_placeCompute. Fixed point adds up to the same whatever the order, and exactly. All 0 before the first histogram;
// lvsm_placeCompute leaves it so.
RWStructuredBuffer<uint> lvsm_histogram : register(LVSM_PLACE_HISTOGRAM);

#endif
