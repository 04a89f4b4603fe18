// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, moments4, sampling/common, sampling/separate/maps.
// Moment shadow maps, plain and in layers. Their moments lie in 32-bit floats as they are, or in unorm16 as
// encodeMoments4 makes them, which the parameter encoded says.

// Four moments of a slice.
// map: of 4 components.
fn lvsm_sampleFourMoments(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, index: i32,
                          encoded: bool) -> vec4f
{
    let empty = vec4f(1.0, 1.0, 1.0, 1.0);
    if (!encoded)
    {
        return lvsm_sampleSlice(map, filtering, at, index, empty);
    }
    return lvsm_decodeMoments4(lvsm_sampleSlice(map, filtering, at, index, lvsm_encodeMoments4(empty)));
}

/// Visibility from a moment shadow map (MSM4).
/// map: of 4 components, as depthMoments4 made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// encoded: whether encodeMoments4 followed. bias: of hamburgerUpperBound, LVSM_MOMENT4_BIAS_UNORM16 for an encoded map
/// and LVSM_MOMENT4_BIAS_FP32 for others. Result in [0,1]; 1 half a texel off the map and beyond, but for the bias.
/// Source: JCGT section 2.
fn lvsm_sampleMoments4(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32, encoded: bool,
                       bias: f32) -> f32
{
    return lvsm_momentVisibility4(lvsm_sampleFourMoments(map, filtering, at, 0, encoded), depth, bias);
}

/// Visibility from a layered moment shadow map, a layer to a slice, each with its two neighbours.
/// map: of 4 components, as layerMoments4 made them. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// splits: layerCount + 1 values, not decreasing, from 0 to 1, of layers without overlap. layerCount: from 1 to
/// LVSM_MAX_LAYERS. encoded, bias: as for sampleMoments4.
/// Result in [0,1]; 1 half a texel off the map and beyond, but for the bias.
/// Source: bracketedVisibility4.
fn lvsm_sampleLayeredMoments4(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32,
                              splits: array<f32, LVSM_MAX_LAYERS + 1>, layerCount: i32, encoded: bool, bias: f32) -> f32
{
    let last = clamp(layerCount, 1, LVSM_MAX_LAYERS) - 1;
    let layer = lvsm_layerIndex(depth, splits, layerCount);
    var front = vec4f(1.0, 1.0, 1.0, 1.0);
    var behind = vec4f(-1.0, 1.0, -1.0, 1.0);
    if (layer > 0)
    {
        front = lvsm_sampleFourMoments(map, filtering, at, layer - 1, encoded);
    }
    if (layer < last)
    {
        behind = lvsm_sampleFourMoments(map, filtering, at, layer + 1, encoded);
    }
    return lvsm_bracketedVisibility4(front, lvsm_sampleFourMoments(map, filtering, at, layer, encoded), behind, depth,
                                     vec2f(splits[layer], splits[layer + 1]), bias);
}
