// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket, sampling/common, sampling/separate/maps.
// Bracketed layers: two in the one texel of a slice, or two to each slice of many. They do not overlap.

/// Visibility from two layers in one texel, each judged with the other.
/// map: of 4 components, as packLayers made them. at: where, see mapPoint. depth: the receiver's, in [0,1]. split:
/// between the layers, in [0,1]. minVariance: the global floor in depth squared, >= 0, for layers of half the depth a
/// quarter of LVSM_MIN_VARIANCE_FP16. Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: bracketedVisibility2.
fn lvsm_sampleBracketed2(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32, split: f32,
                         minVariance: f32) -> f32
{
    let texel = lvsm_sampleSlice(map, filtering, at, 0, vec4f(1.0, 1.0, 1.0, 1.0));
    return lvsm_bracketedVisibility2(texel, depth, split, minVariance);
}

// Moments of the two layers of a slice.
// map: of 4 components.
fn lvsm_sampleLayerPair(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, index: i32,
                        compact: bool) -> vec4f
{
    let second = select(1.0, 0.0, compact);
    let texel = lvsm_sampleSlice(map, filtering, at, index, vec4f(1.0, second, 1.0, second));
    return select(texel, vec4f(lvsm_expandMoments(texel.xy), lvsm_expandMoments(texel.zw)), compact);
}

/// Visibility from the layer that holds the receiver and its two neighbours, two layers to a slice: two samples.
/// map: of 4 components, as packLayers made them. at: where, see mapPoint. depth: the receiver's, in [0,1]. splits:
/// layerCount + 1 values, not decreasing, from 0 to 1. layerCount: from 1 to LVSM_MAX_LAYERS. compact: whether the
/// layers are in the basis of compactMoments. minVariance: the global floor in depth squared, >= 0, such as
/// LVSM_MIN_VARIANCE_FP16 times the squared length of a layer. Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: bracketedBoundedVisibility.
fn lvsm_sampleBracketed(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32,
                        splits: array<f32, LVSM_MAX_LAYERS + 1>, layerCount: i32, compact: bool,
                        minVariance: f32) -> f32
{
    let last = clamp(layerCount, 1, LVSM_MAX_LAYERS) - 1;
    let layer = lvsm_layerIndex(depth, splits, layerCount);
    let isEven = (layer & 1) == 0;
    let own = lvsm_sampleLayerPair(map, filtering, at, layer / 2, compact);
    let other = lvsm_sampleLayerPair(map, filtering, at,
                                     clamp(select(layer / 2 + 1, layer / 2 - 1, isEven), 0, last / 2), compact);
    var front = select(own.xy, other.zw, isEven);
    var behind = select(other.xy, own.zw, isEven);
    if (layer == 0)
    {
        front = vec2f(1.0, 1.0);
    }
    if (layer >= last)
    {
        behind = vec2f(0.0, 0.0);
    }
    return lvsm_bracketedBoundedVisibility(front, lvsm_unpackLayer(own, layer), behind, depth,
                                           vec2f(splits[layer], splits[layer + 1]), minVariance);
}
