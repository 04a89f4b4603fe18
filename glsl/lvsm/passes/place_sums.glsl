// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place.
// The histogram as sums over all bins up to one, in 64 bits, for place.comp.
#ifndef LVSM_PASSES_PLACE_SUMS_GLSL
#define LVSM_PASSES_PLACE_SUMS_GLSL

#include "place.glsl"

// Weights in xy and weights times values in zw, low and high words.
uvec4 lvsm_addSums(uvec4 a, uvec4 b)
{
    uvec4 sum = a + b;
    sum.y += sum.x < a.x ? 1u : 0u;
    sum.w += sum.z < a.z ? 1u : 0u;
    return sum;
}

uvec4 lvsm_subtractSums(uvec4 a, uvec4 b)
{
    uvec4 difference = a - b;
    difference.y -= a.x < b.x ? 1u : 0u;
    difference.w -= a.z < b.z ? 1u : 0u;
    return difference;
}

vec2 lvsm_sumsAsFloats(uvec4 sums)
{
    return 4.0 * vec2(sums.yw) + vec2(sums.xz) / 1073741824.0;
}

uvec4 lvsm_sumsUpTo(int bin)
{
    return bin < 0 ? uvec4(0u)
                   : uvec4(lvsm_histogram[4 * bin], lvsm_histogram[4 * bin + 1], lvsm_histogram[4 * bin + 2],
                           lvsm_histogram[4 * bin + 3]);
}

const int LVSM_PLACE_RUN = 8;
shared uvec4 lvsm_runs[LVSM_PLACE_BINS / LVSM_PLACE_RUN];

// Turns the bins into the sums up to each: in runs of eight, then over the runs.
void lvsm_sumBins(int thread)
{
    const int runs = LVSM_PLACE_BINS / LVSM_PLACE_RUN;
    uvec4 sum = uvec4(0u);
    for (int i = 0; i < LVSM_PLACE_RUN && thread < runs; ++i)
        sum = lvsm_addSums(sum, lvsm_sumsUpTo(LVSM_PLACE_RUN * thread + i));
    if (thread < runs)
        lvsm_runs[thread] = sum;
    barrier();
    for (int reach = 1; reach < runs; reach *= 2)
    {
        uvec4 before = thread >= reach && thread < runs ? lvsm_runs[thread - reach] : uvec4(0u);
        barrier();
        if (thread < runs)
            lvsm_runs[thread] = lvsm_addSums(lvsm_runs[thread], before);
        barrier();
    }
    sum = thread > 0 && thread < runs ? lvsm_runs[thread - 1] : uvec4(0u);
    for (int j = 0; j < LVSM_PLACE_RUN && thread < runs; ++j)
    {
        int bin = LVSM_PLACE_RUN * thread + j;
        sum = lvsm_addSums(sum, lvsm_sumsUpTo(bin));
        for (int c = 0; c < 4; ++c)
            lvsm_histogram[4 * bin + c] = sum[c];
    }
    memoryBarrierBuffer();
    barrier();
}

#endif
