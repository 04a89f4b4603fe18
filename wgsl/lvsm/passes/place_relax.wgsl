// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place, passes/place_sums, depth, moments, placement.
// Lloyd relaxation of the splits to convergence, for place.wgsl: lloydRelax of lloyd.hpp.

// Sums of the bins whose mean is at most a value: of the value's own bin all or nothing.
fn lvsm_sumsBelow(value: f32) -> vec4u
{
    let bin = clamp(i32(value * f32(LVSM_PLACE_BINS)), 0, LVSM_PLACE_BINS - 1);
    let before = lvsm_sumsUpTo(bin - 1);
    let upTo = lvsm_sumsUpTo(bin);
    let own = lvsm_sumsAsFloats(lvsm_subtractSums(upTo, before));
    return select(before, upTo, own.y <= value * own.x);
}

// Weight of an inner split's cluster, and the same times its values.
fn lvsm_clusterSums(split: i32, inner: i32) -> vec2f
{
    let lower = 0.5 * (lvsm_splits[max(split - 1, 0)] + lvsm_splits[split]);
    let upper = 0.5 * (lvsm_splits[split] + lvsm_splits[min(split + 1, LVSM_MAX_LAYERS)]);
    var first = vec4u(0u);
    var last = lvsm_sumsUpTo(LVSM_PLACE_BINS - 1);
    if (split != 1)
    {
        first = lvsm_sumsBelow(lower);
    }
    if (split != inner)
    {
        last = lvsm_sumsBelow(upper);
    }
    return lvsm_sumsAsFloats(lvsm_subtractSums(last, first));
}

// True where it moved a split whose cluster is empty.
fn lvsm_teleportOne(layers: i32) -> bool
{
    var splits: array<f32, LVSM_MAX_LAYERS + 1>;
    var weights: array<f32, LVSM_MAX_LAYERS + 1>;
    var isEmpty = false;
    for (var i = 0; i <= LVSM_MAX_LAYERS; i++)
    {
        splits[i] = lvsm_splits[i];
        weights[i] = lvsm_clusters[i];
        isEmpty = isEmpty || (i > 0 && i < layers && weights[i] < LVSM_TINY);
    }
    if (!isEmpty || layers < 3 || lvsm_teleports <= 0)
    {
        return false;
    }
    lvsm_teleports--;
    lvsm_teleportSplits(&splits, weights, layers);
    for (var j = 0; j <= LVSM_MAX_LAYERS; j++)
    {
        lvsm_splits[j] = splits[j];
    }
    return true;
}

fn lvsm_relax(thread: i32, layers: i32)
{
    let inner = layers - 1;
    let moves = thread >= 1 && thread <= inner;
    let isAny = lvsm_sumsAsFloats(lvsm_sumsUpTo(LVSM_PLACE_BINS - 1)).x > 0.0;
    if (thread == 0)
    {
        lvsm_teleports = 2 * inner;
        lvsm_quiet = select(1u, 0u, isAny && inner > 0);
    }
    for (var iteration = 0; iteration < lvsm_place.maxIterations; iteration++)
    {
        // All threads leave together, or the barriers would not be met by all.
        if (workgroupUniformLoad(&lvsm_quiet) != 0u)
        {
            break;
        }
        var moved = 0.0;
        if (moves)
        {
            let sums = lvsm_clusterSums(thread, inner);
            moved = lvsm_updateSplit(lvsm_splits[thread], sums.y, sums.x);
        }
        workgroupBarrier();
        if (moves)
        {
            lvsm_clusters[thread] = abs(moved - lvsm_splits[thread]);
            lvsm_splits[thread] = moved;
        }
        workgroupBarrier();
        var largest = 0.0;
        for (var i = 1; i <= inner; i++)
        {
            largest = max(largest, lvsm_clusters[i]);
        }
        workgroupBarrier();
        if (moves)
        {
            lvsm_clusters[thread] = lvsm_clusterSums(thread, inner).x;
        }
        workgroupBarrier();
        if (thread == 0)
        {
            lvsm_quiet = select(0u, 1u, !lvsm_teleportOne(layers) && largest <= lvsm_place.tolerance);
        }
    }
}
