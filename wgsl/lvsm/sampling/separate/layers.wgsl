// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, sampling/common, sampling/separate/maps.
// Layered variance shadow maps, two layers to a slice of an array texture.

// Visibility from the layer that the receiver is judged by.
// map: of 4 components.
fn lvsm_visibilityInLayer(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32,
                          interval: vec2f, layer: i32, minVariance: f32) -> f32
{
    let texel = lvsm_sampleSlice(map, filtering, at, layer / 2, vec4f(1.0, 1.0, 1.0, 1.0));
    return lvsm_layeredVisibility(lvsm_unpackLayer(texel, layer), depth, interval, minVariance);
}

/// Visibility from a layered variance shadow map: two layers to a slice, as packLayers lays them out.
/// map: of 4 components. at: where, see mapPoint. depth: the receiver's, in [0,1]. splits: layerCount + 1 values, not
/// decreasing, from 0 to 1. layerCount: from 1 to LVSM_MAX_LAYERS. overlap: of the layers, as when stored. width: of
/// the transition, at most the overlap; only there is a second sample taken. minVariance: the global floor in depth
/// squared, >= 0, such as LVSM_MIN_VARIANCE_FP16 times the squared length of a layer.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: LVSM section 5.
fn lvsm_sampleLayers(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32, splits: array<f32,
                     LVSM_MAX_LAYERS + 1>, layerCount: i32, overlap: f32, width: f32, minVariance: f32) -> f32
{
    let layer = lvsm_layerIndex(depth, splits, layerCount);
    let interval = lvsm_layerInterval(splits[layer], splits[layer + 1], overlap);
    let visibility = lvsm_visibilityInLayer(map, filtering, at, depth, interval, layer, minVariance);
    let weight = lvsm_transitionWeight(depth, splits[layer], splits[layer + 1], width);
    if (weight == 0.0)
    {
        return visibility;
    }
    let other = clamp(select(layer + 1, layer - 1, weight < 0.0), 0, min(layerCount, LVSM_MAX_LAYERS) - 1);
    let otherInterval = lvsm_layerInterval(splits[other], splits[other + 1], overlap);
    let neighbour = lvsm_visibilityInLayer(map, filtering, at, depth, otherInterval, other, minVariance);
    return lvsm_blendTransition(visibility, neighbour, weight);
}
