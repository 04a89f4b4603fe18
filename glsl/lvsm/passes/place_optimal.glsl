// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place, passes/place_sums.
// The splits of least spread, for place.comp: the dynamic programme of optimal.hpp, each entry by trying all.
#ifndef LVSM_PASSES_PLACE_OPTIMAL_GLSL
#define LVSM_PASSES_PLACE_OPTIMAL_GLSL

#include "place_sums.glsl"

shared float lvsm_binWeights[LVSM_PLACE_BINS];
// Least cost of the cells so far over so many bins, for two rows in turn.
shared float lvsm_costs[2 * LVSM_PLACE_BINS];
shared int lvsm_edges[LVSM_MAX_LAYERS + 1];

// A cell: weight, mean, and the mean square distance to it times the weight; sums of squares would cancel. x is the
// distance from the cell's end, in bins.
vec3 lvsm_withBin(vec3 cell, int bin, int end)
{
    float weight = lvsm_binWeights[bin];
    float total = cell.x + weight;
    float offset = float(end - bin) - 0.5 - cell.y;
    float share = weight > 0.0 ? weight / total : 0.0;
    return vec3(total, cell.y + share * offset, cell.z + cell.x * share * offset * offset);
}

vec3 lvsm_cellOf(int begin, int end)
{
    vec3 cell = vec3(0.0);
    for (int bin = end - 1; bin >= begin; --bin)
        cell = lvsm_withBin(cell, bin, end);
    return cell;
}

// Where the last of row + 1 cells over so many bins begins, and what the cells cost.
vec2 lvsm_bestBegin(int row, int end)
{
    int previous = (row + 1) % 2 * LVSM_PLACE_BINS;
    int last = end - lvsm_leastBins;
    int first = row * lvsm_leastBins;
    vec3 cell = vec3(0.0);
    vec2 best = vec2(float(last), LVSM_HUGE);
    for (int begin = end - 1; begin >= first; --begin)
    {
        cell = lvsm_withBin(cell, begin, end);
        bool allowed = begin <= last && (row > 0 || begin == 0);
        float cost = cell.z + (row > 0 ? lvsm_costs[previous + max(begin - 1, 0)] : 0.0);
        if (allowed && cost <= best.y)
            best = vec2(float(begin), cost);
    }
    return best;
}

// The edges of the optimal cells. The beginnings are kept behind the histogram.
void lvsm_findEdges(int thread, int layers)
{
    for (int row = 0; row < layers; ++row)
    {
        for (int end = thread + 1; end <= LVSM_PLACE_BINS; end += 256)
        {
            if (end < (row + 1) * lvsm_leastBins || (row == layers - 1 && end < LVSM_PLACE_BINS))
                continue;
            vec2 best = lvsm_bestBegin(row, end);
            lvsm_costs[row % 2 * LVSM_PLACE_BINS + end - 1] = best.y;
            lvsm_histogram[(4 + row) * LVSM_PLACE_BINS + end - 1] = uint(best.x);
        }
        memoryBarrierBuffer();
        barrier();
    }
    if (thread == 0)
    {
        int end = LVSM_PLACE_BINS;
        for (int row = layers - 1; row >= 0; --row)
        {
            lvsm_edges[row + 1] = end;
            end = int(lvsm_histogram[(4 + row) * LVSM_PLACE_BINS + end - 1]);
        }
        lvsm_edges[0] = 0;
    }
    barrier();
}

// Cost of the layer in front of a split, the splits rounded to edges of bins.
float lvsm_layerCost(float begin, float end)
{
    int first = clamp(int(begin * float(LVSM_PLACE_BINS) + 0.5), 0, LVSM_PLACE_BINS);
    int last = clamp(int(end * float(LVSM_PLACE_BINS) + 0.5), 0, LVSM_PLACE_BINS);
    return lvsm_cellOf(first, last).z;
}

void lvsm_placeOptimally(int thread, int layers)
{
    float total = lvsm_sumsAsFloats(lvsm_sumsUpTo(LVSM_PLACE_BINS - 1)).x;
    float share = total > 0.0 ? clamp(lvsm_uniformShare, 0.0, 1.0) : 1.0;
    for (int bin = thread; bin < LVSM_PLACE_BINS; bin += 256)
    {
        float weight = lvsm_sumsAsFloats(lvsm_subtractSums(lvsm_sumsUpTo(bin), lvsm_sumsUpTo(bin - 1))).x;
        lvsm_binWeights[bin] = (total > 0.0 ? weight * (1.0 - share) / total : 0.0) + share / float(LVSM_PLACE_BINS);
    }
    barrier();
    lvsm_findEdges(thread, layers);

    // A cell's mean under the number of its layer, then the splits between the means.
    if (thread < layers)
    {
        vec3 cell = lvsm_cellOf(lvsm_edges[thread], lvsm_edges[thread + 1]);
        float back = cell.x > 0.0 ? cell.y : 0.5 * float(lvsm_edges[thread + 1] - lvsm_edges[thread]);
        lvsm_clusters[thread] = (float(lvsm_edges[thread + 1]) - back) / float(LVSM_PLACE_BINS);
    }
    barrier();
    float placed = thread > 0 && thread < layers ? 0.5 * (lvsm_clusters[thread - 1] + lvsm_clusters[thread])
                                                 : (thread < 1 ? 0.0 : 1.0);
    barrier();
    if (thread <= LVSM_MAX_LAYERS)
        lvsm_clusters[thread] = placed;
    barrier();

    // Hysteresis: the previous splits stay unless the new ones cost enough less.
    if (thread == 0)
    {
        float before = 0.0;
        float after = 0.0;
        bool rising = lvsm_leastGain > 0.0 && lvsm_splits[0] == 0.0 && lvsm_splits[layers] == 1.0;
        for (int i = 0; i < layers; ++i)
        {
            rising = rising && lvsm_splits[i] < lvsm_splits[i + 1];
            before += lvsm_layerCost(lvsm_splits[i], lvsm_splits[i + 1]);
            after += lvsm_layerCost(lvsm_clusters[i], lvsm_clusters[i + 1]);
        }
        lvsm_quiet = rising && after >= (1.0 - lvsm_leastGain) * before ? 1 : 0;
    }
    barrier();
    if (thread <= LVSM_MAX_LAYERS && lvsm_quiet == 0)
        lvsm_splits[thread] = lvsm_clusters[thread];
}

#endif
