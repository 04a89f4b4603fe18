// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place, passes/place_sums, depth, moments, placement.
// Lloyd relaxation of the splits to convergence, for place.hlsl: lloydRelax of lloyd.hpp.
#ifndef LVSM_PASSES_PLACE_RELAX_HLSLI
#define LVSM_PASSES_PLACE_RELAX_HLSLI

#include "place_sums.hlsli"
#include "../placement.hlsli"

// Sums of the bins whose mean is at most a value: of the value's own bin all or nothing.
uint4 lvsm_sumsBelow(float value)
{
    int bin = clamp(int(value * float(LVSM_PLACE_BINS)), 0, LVSM_PLACE_BINS - 1);
    uint4 before = lvsm_sumsUpTo(bin - 1);
    uint4 with = lvsm_sumsUpTo(bin);
    float2 own = lvsm_sumsAsFloats(lvsm_subtractSums(with, before));
    return own.y <= value * own.x ? with : before;
}

// Weight of an inner split's cluster, and the same times its values.
float2 lvsm_clusterSums(int split, int inner)
{
    float lower = 0.5 * (lvsm_splits[max(split - 1, 0)] + lvsm_splits[split]);
    float upper = 0.5 * (lvsm_splits[split] + lvsm_splits[min(split + 1, LVSM_MAX_LAYERS)]);
    uint4 first = split == 1 ? uint4(0u, 0u, 0u, 0u) : lvsm_sumsBelow(lower);
    uint4 last = split == inner ? lvsm_sumsUpTo(LVSM_PLACE_BINS - 1) : lvsm_sumsBelow(upper);
    return lvsm_sumsAsFloats(lvsm_subtractSums(last, first));
}

// True where it moved a split whose cluster is empty.
bool lvsm_teleportOne(int layers)
{
    float splits[LVSM_MAX_LAYERS + 1];
    float weights[LVSM_MAX_LAYERS + 1];
    bool empty = false;
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
    {
        splits[i] = lvsm_splits[i];
        weights[i] = lvsm_clusters[i];
        empty = empty || (i > 0 && i < layers && weights[i] < LVSM_TINY);
    }
    if (!empty || layers < 3 || lvsm_teleports <= 0)
        return false;
    --lvsm_teleports;
    lvsm_teleportSplits(splits, weights, layers);
    for (int j = 0; j <= LVSM_MAX_LAYERS; ++j)
        lvsm_splits[j] = splits[j];
    return true;
}

void lvsm_relax(int thread, int layers)
{
    int inner = layers - 1;
    bool moves = thread >= 1 && thread <= inner;
    bool any = lvsm_sumsAsFloats(lvsm_sumsUpTo(LVSM_PLACE_BINS - 1)).x > 0.0;
    if (thread == 0)
    {
        lvsm_teleports = 2 * inner;
        lvsm_quiet = any && inner > 0 ? 0 : 1;
    }
    AllMemoryBarrierWithGroupSync();
    for (int iteration = 0; iteration < lvsm_maxIterations && lvsm_quiet == 0; ++iteration)
    {
        float moved = 0.0;
        if (moves)
        {
            float2 sums = lvsm_clusterSums(thread, inner);
            moved = lvsm_updateSplit(lvsm_splits[thread], sums.y, sums.x);
        }
        AllMemoryBarrierWithGroupSync();
        if (moves)
        {
            lvsm_clusters[thread] = abs(moved - lvsm_splits[thread]);
            lvsm_splits[thread] = moved;
        }
        AllMemoryBarrierWithGroupSync();
        float largest = 0.0;
        for (int i = 1; i <= inner; ++i)
            largest = max(largest, lvsm_clusters[i]);
        AllMemoryBarrierWithGroupSync();
        if (moves)
            lvsm_clusters[thread] = lvsm_clusterSums(thread, inner).x;
        AllMemoryBarrierWithGroupSync();
        if (thread == 0)
            lvsm_quiet = !lvsm_teleportOne(layers) && largest <= lvsm_tolerance ? 1 : 0;
        AllMemoryBarrierWithGroupSync();
    }
}

#endif
