// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place, depth, passes/depths, moments, placement, passes/place_sums, passes/place_relax, passes/place_optimal.
// The splits placed on the device, in two dispatches and without a read-back: entry points lvsm_histogramCompute, which
// counts what one depth texture holds, over the groups that placePass of include/lvsm/passes.hpp gives, and
// lvsm_placeCompute, one group that places the splits and empties the histogram for the next frame.
// Lauritzen & McCool, Layered Variance Shadow Maps, sections 4 and 5; lloyd.hpp and optimal.hpp do the same on the host.
//
// placePass fills the constant buffer and says how many bytes the histogram takes. The splits are written where
// storePass has them, in the buffer that the store pass and the lighting read as lvsm_Store: bind it here for writing.
// Layers beyond layerCount are empty. A map without any depth discontinuity leaves the splits where they start.
#include "place.hlsli"
#include "depths.hlsli"
#include "../placement.hlsli"

LVSM_DEPTH_TEXTURE lvsm_depths : register(LVSM_PLACE_DEPTHS);
#ifdef LVSM_PLACE_WEIGHTS
Texture2D<uint> lvsm_seen : register(LVSM_PLACE_WEIGHTS);
#endif
// The buffer of StoreBlock, as floats: the splits begin at LVSM_PLACED_FIRST.
RWStructuredBuffer<float> lvsm_placed : register(LVSM_PLACE_SPLITS);
static const int LVSM_PLACED_FIRST = 8;

// Low words of the group's own sums: what they carry goes to the buffer at once.
groupshared uint lvsm_weights[LVSM_PLACE_BINS];
groupshared uint lvsm_weighted[LVSM_PLACE_BINS];

groupshared float lvsm_splits[LVSM_MAX_LAYERS + 1];
groupshared float lvsm_clusters[LVSM_MAX_LAYERS + 1];
groupshared int lvsm_quiet;
groupshared int lvsm_teleports;

#include "place_relax.hlsli"
#include "place_optimal.hlsli"

float lvsm_placedDepth(int2 texel)
{
    return clamp(lvsm_depthAt(lvsm_depths, min(texel, lvsm_map.zw - 1), 0), 0.0, 1.0);
}

// What a texel's neighbourhood counts for, from 0 to 1.
float lvsm_placedShare(int2 texel)
{
#ifdef LVSM_PLACE_WEIGHTS
    return float(min(lvsm_seen.Load(int3(texel, 0)), 256u)) / 256.0;
#else
    return 1.0;
#endif
}

// How much a neighbourhood weighs and under which value. Of four numbers the variance comes from their differences,
// which do not cancel.
float2 lvsm_placedSample(int2 texel)
{
    float d00 = lvsm_placedDepth(texel);
    float d10 = lvsm_placedDepth(texel + int2(1, 0));
    float d01 = lvsm_placedDepth(texel + int2(0, 1));
    float d11 = lvsm_placedDepth(texel + int2(1, 1));
    float left = d00 - d01;
    float right = d10 - d11;
    float across = (d00 - d10) + (d01 - d11);
    float squares = (left + right) * (left + right) + across * across + (left - right) * (left - right);
    if (lvsm_optimal != 0)
        return float2(sqrt(squares) * lvsm_placedShare(texel), d00);
    bool whole = all(texel + 1 < max(lvsm_map.zw, lvsm_map.xy + 2));
    float variance = 0.0625 * squares;
    float weight = whole && variance >= lvsm_minVariance ? min(variance, max(lvsm_maxVariance, 0.0)) : 0.0;
    return float2(weight * lvsm_placedShare(texel), clamp(0.25 * ((d00 + d10) + (d01 + d11)) + sqrt(variance), 0.0, 1.0));
}

uint lvsm_fixed(float value)
{
    return uint(clamp(value, 0.0, 2.0) * 1073741824.0);
}

void lvsm_addWord(int word, uint amount)
{
    uint before;
    InterlockedAdd(lvsm_histogram[word], amount, before);
    if (before + amount < before)
        InterlockedAdd(lvsm_histogram[word + 1], 1u);
}

[numthreads(16, 16, 1)]
void lvsm_histogramCompute(uint3 group : SV_GroupID, uint3 id : SV_GroupThreadID, uint index : SV_GroupIndex)
{
    int bin;
    for (bin = int(index); bin < LVSM_PLACE_BINS; bin += 256)
    {
        lvsm_weights[bin] = 0u;
        lvsm_weighted[bin] = 0u;
    }
    GroupMemoryBarrierWithGroupSync();
    for (int i = 0; i < 4; ++i)
    {
        int2 texel = lvsm_map.xy + int2(group.xy) * 32 + int2(id.xy) + 16 * int2(i & 1, i >> 1);
        float2 found = all(texel < lvsm_map.zw) ? lvsm_placedSample(texel) : float2(0.0, 0.0);
        uint weight = lvsm_fixed(found.x);
        uint weighted = lvsm_fixed(found.x * found.y);
        if (weight == 0u)
            continue;
        bin = min(int(found.y * float(LVSM_PLACE_BINS)), LVSM_PLACE_BINS - 1);
        uint before;
        InterlockedAdd(lvsm_weights[bin], weight, before);
        if (before + weight < before)
            InterlockedAdd(lvsm_histogram[4 * bin + 1], 1u);
        InterlockedAdd(lvsm_weighted[bin], weighted, before);
        if (before + weighted < before)
            InterlockedAdd(lvsm_histogram[4 * bin + 3], 1u);
    }
    GroupMemoryBarrierWithGroupSync();
    for (bin = int(index); bin < LVSM_PLACE_BINS; bin += 256)
    {
        if (lvsm_weights[bin] != 0u)
            lvsm_addWord(4 * bin, lvsm_weights[bin]);
        if (lvsm_weighted[bin] != 0u)
            lvsm_addWord(4 * bin + 2, lvsm_weighted[bin]);
    }
}

[numthreads(256, 1, 1)]
void lvsm_placeCompute(uint3 id : SV_GroupThreadID)
{
    int thread = int(id.x);
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
    AllMemoryBarrierWithGroupSync();
    if (thread <= LVSM_MAX_LAYERS)
    {
        bool inner = thread > 0 && thread < layers;
        lvsm_placed[LVSM_PLACED_FIRST + thread] = inner ? lvsm_splits[thread] : float(min(thread, 1));
    }
    for (int word = thread; word < 4 * LVSM_PLACE_BINS; word += 256)
        lvsm_histogram[word] = 0u;
}
