// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place.
// The histogram as sums over all bins up to one, in 64 bits, for place.wgsl.

// Weights in xy and weights times values in zw, low and high words.
fn lvsm_addSums(a: vec4u, b: vec4u) -> vec4u
{
    var sum = a + b;
    sum.y += select(0u, 1u, sum.x < a.x);
    sum.w += select(0u, 1u, sum.z < a.z);
    return sum;
}

fn lvsm_subtractSums(a: vec4u, b: vec4u) -> vec4u
{
    var difference = a - b;
    difference.y -= select(0u, 1u, a.x < b.x);
    difference.w -= select(0u, 1u, a.z < b.z);
    return difference;
}

fn lvsm_sumsAsFloats(sums: vec4u) -> vec2f
{
    return 4.0 * vec2f(sums.yw) + vec2f(sums.xz) / 1073741824.0;
}

fn lvsm_sumsUpTo(bin: i32) -> vec4u
{
    if (bin < 0)
    {
        return vec4u(0u);
    }
    return vec4u(lvsm_histogram[4 * bin], lvsm_histogram[4 * bin + 1], lvsm_histogram[4 * bin + 2],
                 lvsm_histogram[4 * bin + 3]);
}

const LVSM_PLACE_RUN: i32 = 8;
const LVSM_PLACE_RUNS: i32 = LVSM_PLACE_BINS / LVSM_PLACE_RUN;
var<workgroup> lvsm_runs: array<vec4u, LVSM_PLACE_RUNS>;

// Turns the bins into the sums up to each: in runs of eight, then over the runs.
fn lvsm_sumBins(thread: i32)
{
    var sum = vec4u(0u);
    for (var i = 0; i < LVSM_PLACE_RUN && thread < LVSM_PLACE_RUNS; i++)
    {
        sum = lvsm_addSums(sum, lvsm_sumsUpTo(LVSM_PLACE_RUN * thread + i));
    }
    if (thread < LVSM_PLACE_RUNS)
    {
        lvsm_runs[thread] = sum;
    }
    workgroupBarrier();
    for (var reach = 1; reach < LVSM_PLACE_RUNS; reach *= 2)
    {
        var before = vec4u(0u);
        if (thread >= reach && thread < LVSM_PLACE_RUNS)
        {
            before = lvsm_runs[thread - reach];
        }
        workgroupBarrier();
        if (thread < LVSM_PLACE_RUNS)
        {
            lvsm_runs[thread] = lvsm_addSums(lvsm_runs[thread], before);
        }
        workgroupBarrier();
    }
    sum = vec4u(0u);
    if (thread > 0 && thread < LVSM_PLACE_RUNS)
    {
        sum = lvsm_runs[thread - 1];
    }
    for (var j = 0; j < LVSM_PLACE_RUN && thread < LVSM_PLACE_RUNS; j++)
    {
        let bin = LVSM_PLACE_RUN * thread + j;
        sum = lvsm_addSums(sum, lvsm_sumsUpTo(bin));
        for (var c = 0; c < 4; c++)
        {
            lvsm_histogram[4 * bin + c] = sum[c];
        }
    }
    storageBarrier();
    workgroupBarrier();
}
