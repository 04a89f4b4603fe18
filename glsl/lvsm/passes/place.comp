#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place, depth, moments, placement, passes/place_sums, passes/place_relax, passes/place_optimal.
#extension GL_GOOGLE_include_directive : require
// Places the splits by the histogram of place_histogram.comp, as one group, and empties the histogram for the next
// frame. Layers beyond layerCount are empty. A map without any depth discontinuity leaves the splits where they start.
#include "place.glsl"
#include "../placement.glsl"

layout(local_size_x = 256) in;

// The buffer of StoreBlock, as floats: the splits begin at LVSM_PLACED_FIRST.
LVSM_PLACE_SPLITS buffer lvsm_Placed { float lvsm_placed[]; };
const int LVSM_PLACED_FIRST = 8;

shared float lvsm_splits[LVSM_MAX_LAYERS + 1];
shared float lvsm_clusters[LVSM_MAX_LAYERS + 1];
shared int lvsm_quiet;
shared int lvsm_teleports;

#include "place_relax.glsl"
#include "place_optimal.glsl"

void main()
{
    int thread = int(gl_LocalInvocationIndex);
    int layers = clamp(lvsm_layerCount, 1, LVSM_MAX_LAYERS);
    if (thread <= LVSM_MAX_LAYERS)
    {
        bool kept = lvsm_keepSplits != 0 || lvsm_optimal != 0;
        float uniformSplit = min(float(thread) / float(layers), 1.0);
        lvsm_splits[thread] = kept ? lvsm_placed[LVSM_PLACED_FIRST + thread] : uniformSplit;
    }
    lvsm_sumBins(thread);
    if (lvsm_optimal != 0)
        lvsm_placeOptimally(thread, layers);
    else
        lvsm_relax(thread, layers);
    barrier();
    if (thread <= LVSM_MAX_LAYERS)
    {
        bool inner = thread > 0 && thread < layers;
        lvsm_placed[LVSM_PLACED_FIRST + thread] = inner ? lvsm_splits[thread] : float(min(thread, 1));
    }
    for (int word = thread; word < 4 * LVSM_PLACE_BINS; word += 256)
        lvsm_histogram[word] = 0u;
}
