// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// One direction of a separable blur of a map, or of all slices of an array of maps.
//
// Run it twice, from the map to a second one and back, with what blurPasses of include/lvsm/passes.hpp gives: the block,
// and how many groups of 8 x 8 texels and one slice. What is off the map is empty, as sampling/common.wgsl has it. The
// sampler filters linearly and clamps to the edge; 32-bit formats are filtered where the device has float32-filterable,
// and a kernel that is not paired does without: see lvsm_blurFetch.

// The settings, to change here: the target, and where the resources are.
alias lvsm_BlurTarget = texture_storage_2d_array<rgba16float, write>;
@group(0) @binding(0) var lvsm_source: texture_2d_array<f32>;
@group(0) @binding(1) var lvsm_target: lvsm_BlurTarget;
@group(0) @binding(2) var<uniform> lvsm_blur: lvsm_Blur;
@group(0) @binding(3) var lvsm_filtering: sampler;

// Another setting: true finds the largest of the texels under the kernel, each component for itself, as the Z-Max test of
// ESM needs. The kernel is not paired then, such as boxKernel(5, false), and its weights are not read.
const LVSM_BLUR_MAXIMUM: bool = false;

// BlurBlock of include/lvsm/passes.hpp.
struct lvsm_Blur
{
    // What an empty texel holds.
    border: vec4f,
    // First texel and end of the map: a whole texture, or its rectangle of an atlas.
    map: vec4i,
    // First texel and end of what is written.
    region: vec4i,
    // (1, 0) or (0, 1).
    direction: vec2f,
    // The first slice that is blurred.
    slice: i32,
    fetchCount: i32,
    // Offset in texels and weight of two fetches each.
    taps: array<vec4f, 33>,
}

fn lvsm_blurTap(fetch: i32) -> vec2f
{
    let two = lvsm_blur.taps[fetch >> 1];
    return select(two.zw, two.xy, (fetch & 1) == 0);
}

// A texel between two along the blur. Without a filter, for a kernel that is not paired:
//   return textureLoad(lvsm_source, vec2i(position), slice, 0);
fn lvsm_blurFetch(position: vec2f, slice: i32) -> vec4f
{
    return textureSampleLevel(lvsm_source, lvsm_filtering, position / vec2f(textureDimensions(lvsm_source).xy), slice, 0.0);
}

fn lvsm_blurredTexel(texel: vec2i, slice: i32) -> vec4f
{
    // Along the direction of the blur; across it the texel's own centre.
    let centre = vec2f(texel) + 0.5;
    let at = dot(centre, lvsm_blur.direction);
    let first = dot(vec2f(lvsm_blur.map.xy), lvsm_blur.direction) + 0.5;
    let last = dot(vec2f(lvsm_blur.map.zw), lvsm_blur.direction) - 0.5;
    let origin = centre - at * lvsm_blur.direction;
    var sum = vec4f(0.0);
    // At the edge, border takes what weight of a fetch is off the map.
    var empty = 0.0;
    for (var fetch = 0; fetch < lvsm_blur.fetchCount; fetch++)
    {
        let tap = lvsm_blurTap(fetch);
        let inside = clamp(at + tap.x, first, last);
        let off = tap.y * min(abs(at + tap.x - inside), 1.0);
        sum += (tap.y - off) * lvsm_blurFetch(origin + inside * lvsm_blur.direction, slice);
        empty += off;
    }
    return sum + empty * lvsm_blur.border;
}

fn lvsm_largestTexel(texel: vec2i, slice: i32) -> vec4f
{
    var largest = lvsm_blur.border;
    for (var fetch = 0; fetch < lvsm_blur.fetchCount; fetch++)
    {
        let place = texel + vec2i(lvsm_blurTap(fetch).x * lvsm_blur.direction);
        var found = lvsm_blur.border;
        if (all(place >= lvsm_blur.map.xy) && all(place < lvsm_blur.map.zw))
        {
            found = textureLoad(lvsm_source, place, slice, 0);
        }
        largest = select(max(largest, found), found, fetch == 0);
    }
    return largest;
}

@compute @workgroup_size(8, 8)
fn lvsm_blurCompute(@builtin(global_invocation_id) id: vec3u)
{
    let texel = vec2i(id.xy) + lvsm_blur.region.xy;
    let slice = i32(id.z) + lvsm_blur.slice;
    if (any(texel >= lvsm_blur.region.zw))
    {
        return;
    }
    if (LVSM_BLUR_MAXIMUM)
    {
        textureStore(lvsm_target, texel, slice, lvsm_largestTexel(texel, slice));
    }
    else
    {
        textureStore(lvsm_target, texel, slice, lvsm_blurredTexel(texel, slice));
    }
}
