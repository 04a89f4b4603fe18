// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, passes/depths, moments, placement, passes/place_sums, passes/place_relax, passes/place_optimal.
// The splits placed on the device, in two dispatches and without a read-back: entry points lvsm_histogramCompute, which
// counts what one depth texture holds (see depths.wgsl), over the groups that placePass of include/lvsm/passes.hpp gives,
// and lvsm_placeCompute, one group that places the splits and empties the histogram for the next frame.
// Lauritzen & McCool, Layered Variance Shadow Maps, sections 4 and 5; lloyd.hpp and optimal.hpp do the same on the host.
//
// placePass fills the block and says how many bytes the histogram takes. The splits are written where storePass has them,
// in the buffer that the store pass and the lighting read as lvsm_Store: bind it here as a storage buffer. Layers beyond
// layerCount are empty. A map without any depth discontinuity leaves the splits where they start.

// The settings, to change here: where the resources are. The histogram has four words a bin: the sum of weights, low and
// high, and of weights times values, in units of 2^-30; then scratch of lvsm_placeCompute. Fixed point adds up to the same
// whatever the order, and exactly. All 0 before the first frame; lvsm_placeCompute leaves it so. It is one buffer under two
// names, since WGSL adds atomically to nothing else than atomics.
@group(0) @binding(0) var lvsm_depths: lvsm_DepthTexture;
@group(0) @binding(1) var<storage, read_write> lvsm_counted: array<atomic<u32>>;
@group(0) @binding(1) var<storage, read_write> lvsm_histogram: array<u32>;
@group(0) @binding(2) var<uniform> lvsm_place: lvsm_Place;
@group(0) @binding(3) var<storage, read_write> lvsm_placed: array<f32>;

const LVSM_PLACE_BINS: i32 = 1024;
// The buffer of StoreBlock, as floats: the splits begin here.
const LVSM_PLACED_FIRST: i32 = 8;

// PlaceBlock of include/lvsm/passes_place.hpp.
struct lvsm_Place
{
    // First texel and end of the map.
    map: vec4i,
    layerCount: i32,
    // 1 finds the optimal splits, 0 relaxes them.
    optimal: i32,
    // 1 relaxes from the splits that the buffer holds, 0 from uniform ones.
    keepSplits: i32,
    maxIterations: i32,
    tolerance: f32,
    minVariance: f32,
    maxVariance: f32,
    uniformShare: f32,
    leastGain: f32,
    // Least length of a cell of optimal splits, in bins.
    leastBins: i32,
}

// Low words of the group's own sums: what they carry goes to the buffer at once.
var<workgroup> lvsm_weights: array<atomic<u32>, LVSM_PLACE_BINS>;
var<workgroup> lvsm_weighted: array<atomic<u32>, LVSM_PLACE_BINS>;

var<workgroup> lvsm_splits: array<f32, LVSM_MAX_LAYERS + 1>;
var<workgroup> lvsm_clusters: array<f32, LVSM_MAX_LAYERS + 1>;
var<workgroup> lvsm_quiet: u32;
var<workgroup> lvsm_teleports: i32;

fn lvsm_placedDepth(texel: vec2i) -> f32
{
    return clamp(lvsm_depthAt(lvsm_depths, min(texel, lvsm_place.map.zw - 1), 0), 0.0, 1.0);
}

// How much a neighbourhood weighs and under which value. Of four numbers the variance comes from their differences,
// which do not cancel.
fn lvsm_placedSample(texel: vec2i) -> vec2f
{
    let d00 = lvsm_placedDepth(texel);
    let d10 = lvsm_placedDepth(texel + vec2i(1, 0));
    let d01 = lvsm_placedDepth(texel + vec2i(0, 1));
    let d11 = lvsm_placedDepth(texel + vec2i(1, 1));
    let left = d00 - d01;
    let right = d10 - d11;
    let across = (d00 - d10) + (d01 - d11);
    let squares = (left + right) * (left + right) + across * across + (left - right) * (left - right);
    if (lvsm_place.optimal != 0)
    {
        return vec2f(sqrt(squares), d00);
    }
    let whole = all(texel + 1 < max(lvsm_place.map.zw, lvsm_place.map.xy + 2));
    let variance = 0.0625 * squares;
    let counts = whole && variance >= lvsm_place.minVariance;
    let weight = select(0.0, min(variance, max(lvsm_place.maxVariance, 0.0)), counts);
    return vec2f(weight, clamp(0.25 * ((d00 + d10) + (d01 + d11)) + sqrt(variance), 0.0, 1.0));
}

fn lvsm_fixed(value: f32) -> u32
{
    return u32(clamp(value, 0.0, 2.0) * 1073741824.0);
}

fn lvsm_addWord(word: i32, amount: u32)
{
    let before = atomicAdd(&lvsm_counted[word], amount);
    if (before + amount < before)
    {
        atomicAdd(&lvsm_counted[word + 1], 1u);
    }
}

@compute @workgroup_size(16, 16)
fn lvsm_histogramCompute(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_id) id: vec3u,
                         @builtin(local_invocation_index) index: u32)
{
    // WGSL promises zeros, but Mesa 22.3's software device lets threads begin before all are written.
    for (var bin = i32(index); bin < LVSM_PLACE_BINS; bin += 256)
    {
        atomicStore(&lvsm_weights[bin], 0u);
        atomicStore(&lvsm_weighted[bin], 0u);
    }
    workgroupBarrier();
    for (var i = 0; i < 4; i++)
    {
        let texel = lvsm_place.map.xy + vec2i(group.xy) * 32 + vec2i(id.xy) + 16 * vec2i(i & 1, i >> 1);
        var found = vec2f(0.0);
        if (all(texel < lvsm_place.map.zw))
        {
            found = lvsm_placedSample(texel);
        }
        let weight = lvsm_fixed(found.x);
        let weighted = lvsm_fixed(found.x * found.y);
        if (weight == 0u)
        {
            continue;
        }
        let bin = min(i32(found.y * f32(LVSM_PLACE_BINS)), LVSM_PLACE_BINS - 1);
        var before = atomicAdd(&lvsm_weights[bin], weight);
        if (before + weight < before)
        {
            atomicAdd(&lvsm_counted[4 * bin + 1], 1u);
        }
        before = atomicAdd(&lvsm_weighted[bin], weighted);
        if (before + weighted < before)
        {
            atomicAdd(&lvsm_counted[4 * bin + 3], 1u);
        }
    }
    workgroupBarrier();
    for (var bin = i32(index); bin < LVSM_PLACE_BINS; bin += 256)
    {
        let weight = atomicLoad(&lvsm_weights[bin]);
        let weighted = atomicLoad(&lvsm_weighted[bin]);
        if (weight != 0u)
        {
            lvsm_addWord(4 * bin, weight);
        }
        if (weighted != 0u)
        {
            lvsm_addWord(4 * bin + 2, weighted);
        }
    }
}

@compute @workgroup_size(256)
fn lvsm_placeCompute(@builtin(local_invocation_index) index: u32)
{
    let thread = i32(index);
    let layers = clamp(lvsm_place.layerCount, 1, LVSM_MAX_LAYERS);
    if (thread <= LVSM_MAX_LAYERS)
    {
        let kept = lvsm_place.keepSplits != 0 || lvsm_place.optimal != 0;
        let uniformSplit = min(f32(thread) / f32(layers), 1.0);
        lvsm_splits[thread] = select(uniformSplit, lvsm_placed[LVSM_PLACED_FIRST + thread], kept);
    }
    lvsm_sumBins(thread);
    if (lvsm_place.optimal != 0)
    {
        lvsm_placeOptimally(thread, layers);
    }
    else
    {
        lvsm_relax(thread, layers);
    }
    storageBarrier();
    workgroupBarrier();
    if (thread <= LVSM_MAX_LAYERS)
    {
        let inner = thread > 0 && thread < layers;
        lvsm_placed[LVSM_PLACED_FIRST + thread] = select(f32(min(thread, 1)), lvsm_splits[thread], inner);
    }
    for (var word = thread; word < 4 * LVSM_PLACE_BINS; word += 256)
    {
        lvsm_histogram[word] = 0u;
    }
}
