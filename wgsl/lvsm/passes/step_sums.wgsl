// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, placement, passes/step, passes/depths.
// What each 2x2 neighbourhood of one texture of depths, linear ones or a depth buffer (see depths.wgsl), adds to the sums
// of two splits: see step.wgsl. The sums begin at the map's first texel.

// The settings, to change here: where the resources are.
@group(0) @binding(0) var lvsm_depths: lvsm_DepthTexture;
@group(0) @binding(1) var lvsm_target: texture_storage_2d_array<rgba32float, write>;
@group(0) @binding(2) var<uniform> lvsm_step: lvsm_Step;
@group(0) @binding(3) var lvsm_state: texture_2d<f32>;

fn lvsm_stepDepth(texel: vec2i) -> f32
{
    return clamp(lvsm_depthAt(lvsm_depths, min(texel, lvsm_step.map.zw - 1), 0), 0.0, 1.0);
}

fn lvsm_stepSums(texel: vec2i, slice: i32) -> vec4f
{
    let d00 = lvsm_stepDepth(texel);
    let d10 = lvsm_stepDepth(texel + vec2i(1, 0));
    let d01 = lvsm_stepDepth(texel + vec2i(0, 1));
    let d11 = lvsm_stepDepth(texel + vec2i(1, 1));
    // Of four numbers the variance comes from their differences, which do not cancel.
    let left = d00 - d01;
    let right = d10 - d11;
    let across = (d00 - d10) + (d01 - d11);
    let variance = 0.0625 * ((left + right) * (left + right) + across * across + (left - right) * (left - right));
    let whole = all(texel + 1 < max(lvsm_step.map.zw, lvsm_step.map.xy + 2));
    let weight = select(0.0, min(variance, max(lvsm_step.maxVariance, 0.0)), whole && variance >= lvsm_step.minVariance);
    let value = clamp(0.25 * ((d00 + d10) + (d01 + d11)) + sqrt(variance), 0.0, 1.0);

    var splits: array<f32, LVSM_MAX_LAYERS + 1>;
    for (var i = 0; i <= LVSM_MAX_LAYERS; i++)
    {
        splits[i] = textureLoad(lvsm_state, vec2i(i / 4, 0), 0)[i % 4];
    }
    let own = lvsm_splitsOfSlice(lvsm_step, slice);
    return lvsm_accumulateSplits(value, weight, lvsm_nearestSplit(value, splits, lvsm_step.layerCount), own.x, own.y);
}

@compute @workgroup_size(8, 8)
fn lvsm_stepSumsCompute(@builtin(global_invocation_id) id: vec3u)
{
    let texel = vec2i(id.xy);
    let slice = i32(id.z) + lvsm_step.slice;
    if (all(texel < lvsm_step.map.zw - lvsm_step.map.xy))
    {
        textureStore(lvsm_target, texel, slice, lvsm_stepSums(texel + lvsm_step.map.xy, slice));
    }
}
