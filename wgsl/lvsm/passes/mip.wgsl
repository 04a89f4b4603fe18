// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// One level of a map, or of all slices of an array of maps, from the level before.
//
// Each texel is the mean of its share of the level before: of two texels in each direction, and where that level has an
// odd size of three, the outer ones in part. So every level has the map's mean, the last row is not left out, and
// nothing off the map is read, such as its neighbour in an atlas; what is off the map is empty for whoever samples the
// level, see sampling/common.wgsl.
//
// Run it for each level from 1 on with what mipPass of include/lvsm/passes_mip.hpp gives: the block, and how many groups
// of 8 x 8 texels and one slice. Source and target are views of one level each.

// The settings, to change here: the target, and where the resources are.
alias lvsm_MipTarget = texture_storage_2d_array<rgba16float, write>;
@group(0) @binding(0) var lvsm_source: texture_2d_array<f32>;
@group(0) @binding(1) var lvsm_target: lvsm_MipTarget;
@group(0) @binding(2) var<uniform> lvsm_mip: lvsm_Mip;

// Another setting: true takes the largest of a texel's share, each component for itself, as the Z-Max test of ESM needs.
const LVSM_MIP_MAXIMUM: bool = false;

// MipBlock of include/lvsm/passes_mip.hpp.
struct lvsm_Mip
{
    // First texel and end of the map in the level before.
    before: vec4i,
    // The same in the level that is made.
    region: vec4i,
    // The first slice that is made.
    slice: i32,
    // The level before, as the source has it: 0, since it is a view of that level alone.
    level: i32,
}

// First texel and end of what a texel is the mean of, in units that whole numbers hold: m to a texel of the n before.
fn lvsm_mipCell(texel: i32, n: i32) -> vec2i
{
    return vec2i(texel, texel + 1) * n;
}

// How much of a texel of the level before lies in a cell, in those units.
fn lvsm_mipShare(texel: i32, cell: vec2i, m: i32) -> i32
{
    return min((texel + 1) * m, cell.y) - max(texel * m, cell.x);
}

fn lvsm_mipTexel(texel: vec2i, slice: i32) -> vec4f
{
    let n = lvsm_mip.before.zw - lvsm_mip.before.xy;
    let m = max(lvsm_mip.region.zw - lvsm_mip.region.xy, vec2i(1));
    let own = texel - lvsm_mip.region.xy;
    let across = lvsm_mipCell(own.x, n.x);
    let down = lvsm_mipCell(own.y, n.y);
    let first = vec2i(across.x, down.x) / m;
    let last = (vec2i(across.y, down.y) - 1) / m;
    var sum = vec4f(0.0);
    for (var y = first.y; y <= last.y; y++)
    {
        for (var x = first.x; x <= last.x; x++)
        {
            let found = textureLoad(lvsm_source, lvsm_mip.before.xy + vec2i(x, y), slice, lvsm_mip.level);
            if (LVSM_MIP_MAXIMUM)
            {
                sum = select(max(sum, found), found, x == first.x && y == first.y);
            }
            else
            {
                let share = vec2f(vec2i(lvsm_mipShare(x, across, m.x), lvsm_mipShare(y, down, m.y))) / vec2f(n);
                sum += share.x * share.y * found;
            }
        }
    }
    return sum;
}

@compute @workgroup_size(8, 8)
fn lvsm_mipCompute(@builtin(global_invocation_id) id: vec3u)
{
    let texel = vec2i(id.xy) + lvsm_mip.region.xy;
    let slice = i32(id.z) + lvsm_mip.slice;
    if (all(texel < lvsm_mip.region.zw))
    {
        textureStore(lvsm_target, texel, slice, lvsm_mipTexel(texel, slice));
    }
}
