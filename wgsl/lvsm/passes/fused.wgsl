// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, config, depth, passes/depths, passes/store.
// The store pass and the first direction of the blur in one: every depth is read once for all slices, and the unblurred
// map is never written. Then run the second direction of the blur.
//
// Run it with what fusedPasses of include/lvsm/passes_fused.hpp gives, the two blocks and how many groups of 64 x 4 texels.
// Settings are those of store.wgsl, target and bindings too. A group keeps linear depths, so that multisampled textures
// and slopes need store and blur.

// Another setting: where its own block is.
@group(0) @binding(3) var<uniform> lvsm_fused: lvsm_Fused;

// FusedBlock of include/lvsm/passes_fused.hpp.
struct lvsm_Fused
{
    // What an empty texel holds.
    border: vec4f,
    // First texel and end of the map.
    map: vec4i,
    // Of the map: two layers each, or one.
    sliceCount: i32,
    // Texels to each side that the filter reads, at most 32.
    reach: i32,
    // Weights from the middle outwards, four to a vector.
    weights: array<vec4f, 9>,
}

const LVSM_FUSED_ROW: i32 = 64 + 2 * 32;
var<workgroup> lvsm_rows: array<f32, 4 * LVSM_FUSED_ROW>;

fn lvsm_fusedTexel(x: i32, first: i32, slice: i32) -> vec4f
{
    var sum = vec4f(0.0);
    for (var tap = -lvsm_fused.reach; tap <= lvsm_fused.reach; tap++)
    {
        let inside = x + tap >= lvsm_fused.map.x && x + tap < lvsm_fused.map.z;
        let weight = lvsm_fused.weights[abs(tap) >> 2][abs(tap) & 3];
        let stored = lvsm_stored(lvsm_rows[first + tap + lvsm_fused.reach], vec2f(0.0), slice);
        let kept = clamp(stored, vec4f(-LVSM_STORE_LARGEST), vec4f(LVSM_STORE_LARGEST));
        sum += weight * select(lvsm_fused.border, kept, inside);
    }
    return sum;
}

@compute @workgroup_size(64, 4)
fn lvsm_fusedCompute(@builtin(global_invocation_id) id: vec3u, @builtin(local_invocation_id) local: vec3u)
{
    let row = LVSM_FUSED_ROW * i32(local.y);
    let thread = i32(local.x);
    let texel = vec2i(id.xy) + lvsm_store.region.xy;
    // A texel of the group and its halo, counted from the halo's beginning. Off the map no depth is read.
    for (var i = thread; i < 64 + 2 * lvsm_fused.reach; i += 64)
    {
        let read = vec2i(texel.x - thread + i - lvsm_fused.reach, texel.y);
        var depth = 1.0;
        if (read.x >= lvsm_fused.map.x && read.x < lvsm_fused.map.z && read.y < lvsm_fused.map.w)
        {
            depth = lvsm_depthAt(lvsm_depths, read, 0);
        }
        lvsm_rows[row + i] = depth;
    }
    workgroupBarrier();
    if (texel.x >= lvsm_store.region.z || texel.y >= lvsm_store.region.w)
    {
        return;
    }
    for (var slice = 0; slice < lvsm_fused.sliceCount; slice++)
    {
        textureStore(lvsm_target, texel, lvsm_store.firstSlice + slice, lvsm_fusedTexel(texel.x, row + thread, slice));
    }
}
