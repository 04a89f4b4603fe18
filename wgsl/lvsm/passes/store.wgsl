// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, config, depth, passes/depths.
// Makes every slice of a map from one texture of depths, linear ones or a depth buffer (see depths.wgsl): all layers of
// any technique.
// Lauritzen & McCool, Layered Variance Shadow Maps, section 5, the second way to make the layers.
//
// Run it with what storePass of include/lvsm/passes.hpp gives, the block and how many groups of 8 x 8 texels and one
// slice, then blur.

// The settings, to change here: the target, and where the resources are.
alias lvsm_StoreTarget = texture_storage_2d_array<rgba16float, write>;
@group(0) @binding(0) var lvsm_depths: lvsm_DepthTexture;
@group(0) @binding(1) var lvsm_target: lvsm_StoreTarget;
@group(0) @binding(2) var<uniform> lvsm_store: lvsm_Store;

// More settings: what slice number slice of the map holds for a depth, and the largest value that the target's format
// bears, to which all is clamped, so that no texel is infinite. Two layers, in [0,1], which every format bears; of the
// block, they alone read splits, layerCount and overlap. In rgba16float, exponents end at 5.545:
//   return lvsm_exponentialMoments(depth, vec2f(5.54, 5.54));
//   const LVSM_STORE_LARGEST: f32 = LVSM_LARGEST_FP16;
// and in rgba32float at 43.32, with LVSM_LARGEST_FP32. The slope is the change of depth to the next texel that the four
// neighbours show, where LVSM_STORE_SLOPED asks for it:
//   return vec4f(lvsm_depthMomentsSloped(depth, slope.x, slope.y), 0.0, 0.0);
const LVSM_STORE_SLOPED: bool = false;
const LVSM_STORE_LARGEST: f32 = 1.0;
fn lvsm_stored(depth: f32, slope: vec2f, slice: i32) -> vec4f
{
    return lvsm_storedLayers(depth, slice);
}

// StoreBlock of include/lvsm/passes.hpp.
struct lvsm_Store
{
    // First texel and end of what is written.
    region: vec4i,
    layerCount: i32,
    overlap: f32,
    // The slice of the target where the map begins.
    firstSlice: i32,
    // Of the fragment shaders that the other languages have.
    slice: i32,
    // The splits 0 to LVSM_MAX_LAYERS, four to a vector.
    splits: array<vec4f, (LVSM_MAX_LAYERS + 4) / 4>,
}

// Moments of one layer; a layer beyond the last is empty.
fn lvsm_storedLayer(depth: f32, layer: i32) -> vec2f
{
    if (layer >= min(lvsm_store.layerCount, LVSM_MAX_LAYERS))
    {
        return vec2f(1.0, 1.0);
    }
    let begin = lvsm_store.splits[layer / 4][layer % 4];
    let end = lvsm_store.splits[(layer + 1) / 4][(layer + 1) % 4];
    return lvsm_layerMoments(depth, lvsm_layerInterval(begin, end, lvsm_store.overlap));
}

fn lvsm_storedLayers(depth: f32, slice: i32) -> vec4f
{
    return lvsm_packLayers(lvsm_storedLayer(depth, 2 * slice), lvsm_storedLayer(depth, 2 * slice + 1));
}

// The texel of a map: what is stored, filtered over the samples of a multisampled texture.
fn lvsm_storedTexel(texel: vec2i, slice: i32) -> vec4f
{
    var sum = vec4f(0.0);
    for (var i = 0; i < LVSM_DEPTH_SAMPLES; i++)
    {
        var slope = vec2f(0.0);
        if (LVSM_STORE_SLOPED)
        {
            slope = lvsm_slopeAt(lvsm_depths, texel, i, lvsm_store.region);
        }
        let stored = lvsm_stored(lvsm_depthAt(lvsm_depths, texel, i), slope, slice);
        sum += clamp(stored, vec4f(-LVSM_STORE_LARGEST), vec4f(LVSM_STORE_LARGEST)) / f32(LVSM_DEPTH_SAMPLES);
    }
    return sum;
}

@compute @workgroup_size(8, 8)
fn lvsm_storeCompute(@builtin(global_invocation_id) id: vec3u)
{
    let slice = i32(id.z);
    let texel = vec2i(id.xy) + lvsm_store.region.xy;
    if (all(texel < lvsm_store.region.zw))
    {
        textureStore(lvsm_target, texel, lvsm_store.firstSlice + slice, lvsm_storedTexel(texel, slice));
    }
}
