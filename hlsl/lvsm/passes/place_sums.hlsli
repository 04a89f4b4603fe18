// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place.
// The histogram as sums over all bins up to one, in 64 bits, for place.hlsl.
#ifndef LVSM_PASSES_PLACE_SUMS_HLSLI
#define LVSM_PASSES_PLACE_SUMS_HLSLI

#include "place.hlsli"

// Weights in xy and weights times values in zw, low and high words.
uint4 lvsm_addSums(uint4 a, uint4 b)
{
    uint4 sum = a + b;
    sum.y += sum.x < a.x ? 1u : 0u;
    sum.w += sum.z < a.z ? 1u : 0u;
    return sum;
}

uint4 lvsm_subtractSums(uint4 a, uint4 b)
{
    uint4 difference = a - b;
    difference.y -= a.x < b.x ? 1u : 0u;
    difference.w -= a.z < b.z ? 1u : 0u;
    return difference;
}

float2 lvsm_sumsAsFloats(uint4 sums)
{
    return 4.0 * float2(sums.yw) + float2(sums.xz) / 1073741824.0;
}

uint4 lvsm_sumsUpTo(int bin)
{
    return bin < 0 ? uint4(0u, 0u, 0u, 0u)
                   : uint4(lvsm_histogram[4 * bin], lvsm_histogram[4 * bin + 1], lvsm_histogram[4 * bin + 2],
                           lvsm_histogram[4 * bin + 3]);
}

static const int LVSM_PLACE_RUN = 8;
groupshared uint4 lvsm_runs[LVSM_PLACE_BINS / LVSM_PLACE_RUN];

// Turns the bins into the sums up to each: in runs of eight, then over the runs.
void lvsm_sumBins(int thread)
{
    const int runs = LVSM_PLACE_BINS / LVSM_PLACE_RUN;
    uint4 sum = uint4(0u, 0u, 0u, 0u);
    for (int i = 0; i < LVSM_PLACE_RUN && thread < runs; ++i)
        sum = lvsm_addSums(sum, lvsm_sumsUpTo(LVSM_PLACE_RUN * thread + i));
    if (thread < runs)
        lvsm_runs[thread] = sum;
    AllMemoryBarrierWithGroupSync();
    for (int reach = 1; reach < runs; reach *= 2)
    {
        uint4 before = thread >= reach && thread < runs ? lvsm_runs[thread - reach] : uint4(0u, 0u, 0u, 0u);
        AllMemoryBarrierWithGroupSync();
        if (thread < runs)
            lvsm_runs[thread] = lvsm_addSums(lvsm_runs[thread], before);
        AllMemoryBarrierWithGroupSync();
    }
    sum = thread > 0 && thread < runs ? lvsm_runs[thread - 1] : uint4(0u, 0u, 0u, 0u);
    for (int j = 0; j < LVSM_PLACE_RUN && thread < runs; ++j)
    {
        int bin = LVSM_PLACE_RUN * thread + j;
        sum = lvsm_addSums(sum, lvsm_sumsUpTo(bin));
        for (int c = 0; c < 4; ++c)
            lvsm_histogram[4 * bin + c] = sum[c];
    }
    AllMemoryBarrierWithGroupSync();
}

#endif
