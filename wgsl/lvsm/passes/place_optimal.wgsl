// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place, passes/place_sums.
// The splits of least spread, for place.wgsl: the dynamic programme of optimal.hpp, each entry by trying all.

var<workgroup> lvsm_binWeights: array<f32, LVSM_PLACE_BINS>;
// Least cost of the cells so far over so many bins, for two rows in turn.
var<workgroup> lvsm_costs: array<f32, 2 * LVSM_PLACE_BINS>;
var<workgroup> lvsm_edges: array<i32, LVSM_MAX_LAYERS + 1>;

// A cell: weight, mean, and the mean square distance to it times the weight; sums of squares would cancel. x is the
// distance from the cell's end, in bins.
fn lvsm_withBin(cell: vec3f, bin: i32, end: i32) -> vec3f
{
    let weight = lvsm_binWeights[bin];
    let total = cell.x + weight;
    let offset = f32(end - bin) - 0.5 - cell.y;
    let share = select(0.0, weight / max(total, LVSM_TINY), weight > 0.0);
    return vec3f(total, cell.y + share * offset, cell.z + cell.x * share * offset * offset);
}

fn lvsm_cellOf(begin: i32, end: i32) -> vec3f
{
    var cell = vec3f(0.0);
    for (var bin = end - 1; bin >= begin; bin--)
    {
        cell = lvsm_withBin(cell, bin, end);
    }
    return cell;
}

// Where the last of row + 1 cells over so many bins begins, and what the cells cost.
fn lvsm_bestBegin(row: i32, end: i32) -> vec2f
{
    let previous = (row + 1) % 2 * LVSM_PLACE_BINS;
    let last = end - lvsm_place.leastBins;
    let first = row * lvsm_place.leastBins;
    var cell = vec3f(0.0);
    var best = vec2f(f32(last), LVSM_HUGE);
    for (var begin = end - 1; begin >= first; begin--)
    {
        cell = lvsm_withBin(cell, begin, end);
        let allowed = begin <= last && (row > 0 || begin == 0);
        let cost = cell.z + select(0.0, lvsm_costs[previous + max(begin - 1, 0)], row > 0);
        if (allowed && cost <= best.y)
        {
            best = vec2f(f32(begin), cost);
        }
    }
    return best;
}

// The edges of the optimal cells. The beginnings are kept behind the histogram.
fn lvsm_findEdges(thread: i32, layers: i32)
{
    for (var row = 0; row < layers; row++)
    {
        for (var end = thread + 1; end <= LVSM_PLACE_BINS; end += 256)
        {
            if (end < (row + 1) * lvsm_place.leastBins || (row == layers - 1 && end < LVSM_PLACE_BINS))
            {
                continue;
            }
            let best = lvsm_bestBegin(row, end);
            lvsm_costs[row % 2 * LVSM_PLACE_BINS + end - 1] = best.y;
            lvsm_histogram[(4 + row) * LVSM_PLACE_BINS + end - 1] = u32(best.x);
        }
        storageBarrier();
        workgroupBarrier();
    }
    if (thread == 0)
    {
        var end = LVSM_PLACE_BINS;
        for (var row = layers - 1; row >= 0; row--)
        {
            lvsm_edges[row + 1] = end;
            end = i32(lvsm_histogram[(4 + row) * LVSM_PLACE_BINS + end - 1]);
        }
        lvsm_edges[0] = 0;
    }
    workgroupBarrier();
}

// Cost of the layer in front of a split, the splits rounded to edges of bins.
fn lvsm_layerCost(begin: f32, end: f32) -> f32
{
    let first = clamp(i32(begin * f32(LVSM_PLACE_BINS) + 0.5), 0, LVSM_PLACE_BINS);
    let last = clamp(i32(end * f32(LVSM_PLACE_BINS) + 0.5), 0, LVSM_PLACE_BINS);
    return lvsm_cellOf(first, last).z;
}

// A cell's mean, as a depth.
fn lvsm_cellMean(begin: i32, end: i32) -> f32
{
    let cell = lvsm_cellOf(begin, end);
    let back = select(0.5 * f32(end - begin), cell.y, cell.x > 0.0);
    return (f32(end) - back) / f32(LVSM_PLACE_BINS);
}

// Hysteresis: whether the previous splits stay, since the new ones, which are lvsm_clusters, do not cost enough less.
fn lvsm_previousStay(layers: i32) -> bool
{
    var before = 0.0;
    var after = 0.0;
    var rising = lvsm_place.leastGain > 0.0 && lvsm_splits[0] == 0.0 && lvsm_splits[layers] == 1.0;
    for (var i = 0; i < layers; i++)
    {
        rising = rising && lvsm_splits[i] < lvsm_splits[i + 1];
        before += lvsm_layerCost(lvsm_splits[i], lvsm_splits[i + 1]);
        after += lvsm_layerCost(lvsm_clusters[i], lvsm_clusters[i + 1]);
    }
    return rising && after >= (1.0 - lvsm_place.leastGain) * before;
}

fn lvsm_placeOptimally(thread: i32, layers: i32)
{
    let total = lvsm_sumsAsFloats(lvsm_sumsUpTo(LVSM_PLACE_BINS - 1)).x;
    let share = select(1.0, clamp(lvsm_place.uniformShare, 0.0, 1.0), total > 0.0);
    for (var bin = thread; bin < LVSM_PLACE_BINS; bin += 256)
    {
        let weight = lvsm_sumsAsFloats(lvsm_subtractSums(lvsm_sumsUpTo(bin), lvsm_sumsUpTo(bin - 1))).x;
        let counted = select(0.0, weight * (1.0 - share) / max(total, LVSM_TINY), total > 0.0);
        lvsm_binWeights[bin] = counted + share / f32(LVSM_PLACE_BINS);
    }
    workgroupBarrier();
    lvsm_findEdges(thread, layers);

    // A cell's mean under the number of its layer, then the splits between the means.
    if (thread < layers)
    {
        lvsm_clusters[thread] = lvsm_cellMean(lvsm_edges[thread], lvsm_edges[thread + 1]);
    }
    workgroupBarrier();
    var placed = f32(clamp(thread, 0, 1));
    if (thread > 0 && thread < layers)
    {
        placed = 0.5 * (lvsm_clusters[thread - 1] + lvsm_clusters[thread]);
    }
    workgroupBarrier();
    if (thread <= LVSM_MAX_LAYERS)
    {
        lvsm_clusters[thread] = placed;
    }
    workgroupBarrier();

    if (thread == 0)
    {
        lvsm_quiet = select(0u, 1u, lvsm_previousStay(layers));
    }
    workgroupBarrier();
    if (thread <= LVSM_MAX_LAYERS && lvsm_quiet == 0u)
    {
        lvsm_splits[thread] = lvsm_clusters[thread];
    }
}
