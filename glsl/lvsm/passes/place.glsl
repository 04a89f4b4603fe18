// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config.
// The splits placed on the device, in two dispatches and without a read-back: place_histogram.comp counts what one depth
// texture holds, place.comp is one group that places the splits. This file is what both share.
// Lauritzen & McCool, Layered Variance Shadow Maps, sections 4 and 5; lloyd.hpp and optimal.hpp do the same on the host.
//
// placePass of include/lvsm/passes.hpp fills the block, says how many groups count, and how many bytes the histogram
// takes. The splits are written where storePass has them, in the buffer that the store pass and the lighting read as
// their uniform block lvsm_Store: bind it here as a storage buffer.
//
// Where splits are to follow what is on the screen, define in front of the pass
//   #define LVSM_PLACE_WEIGHTS layout(binding = 5)   where a texture of whole numbers is, one for each texel of the depths:
// how many of the screen's pixels read it, which the lighting can count by atomics. From 256 on they count as 256; a
// texel with 0 has no say. It is what the paper gives to future work: the relaxation in view space.
#ifndef LVSM_PASSES_PLACE_GLSL
#define LVSM_PASSES_PLACE_GLSL

#include "../config.glsl"

// Where the resources are: define all of these or none, in front of this file.
#ifndef LVSM_PLACE_BLOCK
#define LVSM_PLACE_DEPTHS layout(binding = 0)
#define LVSM_PLACE_HISTOGRAM layout(binding = 1, std430)
#define LVSM_PLACE_BLOCK layout(binding = 2, std140)
#define LVSM_PLACE_SPLITS layout(binding = 3, std430)
#elif !defined(LVSM_PLACE_DEPTHS) || !defined(LVSM_PLACE_HISTOGRAM) || !defined(LVSM_PLACE_SPLITS)
#error define all of LVSM_PLACE_DEPTHS, LVSM_PLACE_HISTOGRAM, LVSM_PLACE_BLOCK and LVSM_PLACE_SPLITS, or none
#endif

const int LVSM_PLACE_BINS = 1024;

// PlaceBlock of include/lvsm/passes.hpp.
LVSM_PLACE_BLOCK uniform lvsm_Place
{
    // First texel and end of the map.
    ivec4 lvsm_map;
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
// place.comp. Fixed point adds up to the same whatever the order, and exactly. All 0 before the first histogram;
// place.comp leaves it so.
LVSM_PLACE_HISTOGRAM coherent buffer lvsm_Histogram { uint lvsm_histogram[]; };

#endif
