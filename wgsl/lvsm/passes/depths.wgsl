// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth.
// Depths as the first pass reads them: linear ones, in [0,1] and 1 where there is no surface, unless a setting below says
// otherwise. Passes that store filter what they store over the samples; passes that place read the first sample.

// The settings, to change here. A depth buffer binds as texture_2d<f32> too; multisampled it is a
// texture_multisampled_2d<f32> of 4 samples.
alias lvsm_DepthTexture = texture_2d<f32>;
const LVSM_DEPTH_SAMPLES: i32 = 1;

// Another setting: linear depth of what the texture holds for a texel. For a depth buffer, with lvsm_Depths bound:
//   return lvsm_convertedDepth(value, texel);
fn lvsm_depthOf(value: f32, texel: vec2i) -> f32
{
    return value;
}

@group(0) @binding(4) var<uniform> lvsm_depthBlock: lvsm_Depths;

// DepthBlock of include/lvsm/passes_depth.hpp.
struct lvsm_Depths
{
    // Tangents across the light's view at a texel's centre: the centre times xy plus zw. All 0 for distances to a plane.
    tangents: vec4f,
    // What the projected depths 0 and 1 are: distances along the view, or 1 over them in perspective.
    distances: vec2f,
    // Distances of the depths 0 and 1.
    range: vec2f,
    isPerspective: i32,
}

fn lvsm_convertedDepth(value: f32, texel: vec2i) -> f32
{
    let z = clamp(value, 0.0, 1.0);
    let between = (1.0 - z) * lvsm_depthBlock.distances.x + z * lvsm_depthBlock.distances.y;
    let along = select(between, 1.0 / max(between, LVSM_ROOT_TINY), lvsm_depthBlock.isPerspective != 0);
    let across = (vec2f(texel) + 0.5) * lvsm_depthBlock.tangents.xy + lvsm_depthBlock.tangents.zw;
    return lvsm_linstep(along * sqrt(1.0 + dot(across, across)), lvsm_depthBlock.range.x, lvsm_depthBlock.range.y);
}

// index: of the sample, for a multisampled texture. In others it has to be 0.
fn lvsm_depthAt(depths: lvsm_DepthTexture, texel: vec2i, index: i32) -> f32
{
    return lvsm_depthOf(textureLoad(depths, texel, index).x, texel);
}

// Change of depth to the next texel, of a texel between two neighbours: the lesser of the two, which the same surface
// has more likely. firstTexel, lastTexel: whether there is no neighbour on that side.
fn lvsm_lesserChange(before: f32, depth: f32, behind: f32, firstTexel: bool, lastTexel: bool) -> f32
{
    let backward = depth - before;
    let forward = behind - depth;
    if (firstTexel || lastTexel)
    {
        return select(backward, forward, firstTexel);
    }
    return select(forward, backward, abs(backward) < abs(forward));
}

// Change of depth to the next texel in x and in y, from the four neighbours within a region (first texel and end).
fn lvsm_slopeAt(depths: lvsm_DepthTexture, texel: vec2i, index: i32, region: vec4i) -> vec2f
{
    let first = max(texel - 1, region.xy);
    let last = min(texel + 1, region.zw - 1);
    let depth = lvsm_depthAt(depths, texel, index);
    return vec2f(lvsm_lesserChange(lvsm_depthAt(depths, vec2i(first.x, texel.y), index), depth,
                                   lvsm_depthAt(depths, vec2i(last.x, texel.y), index), first.x == texel.x,
                                   last.x == texel.x),
                 lvsm_lesserChange(lvsm_depthAt(depths, vec2i(texel.x, first.y), index), depth,
                                   lvsm_depthAt(depths, vec2i(texel.x, last.y), index), first.y == texel.y,
                                   last.y == texel.y));
}
