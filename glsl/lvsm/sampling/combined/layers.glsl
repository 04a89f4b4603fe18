// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, sampling/highp, sampling/common, sampling/combined/maps.
// Layered variance shadow maps, two layers to a slice of an array texture.
#ifndef LVSM_SAMPLING_COMBINED_LAYERS_GLSL
#define LVSM_SAMPLING_COMBINED_LAYERS_GLSL

#include "../../layers.glsl"
#include "maps.glsl"

// Visibility from the layer that the receiver is judged by.
// map: of 4 components.
float lvsm_visibilityInLayer(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, float depth, vec2 interval, int layer,
                             float minVariance)
{
    vec4 texel = lvsm_sampleSlice(map, at, layer / 2, vec4(1.0, 1.0, 1.0, 1.0));
    return lvsm_layeredVisibility(lvsm_unpackLayer(texel, layer), depth, interval, minVariance);
}

/// Visibility from a layered variance shadow map: two layers to a slice, as packLayers lays them out.
/// map: of 4 components. at: where, see mapPoint. depth: the receiver's, in [0,1]. splits: layerCount + 1 values, not
/// decreasing, from 0 to 1. layerCount: from 1 to LVSM_MAX_LAYERS. overlap: of the layers, as when stored. width: of
/// the transition, at most the overlap; only there is a second sample taken. minVariance: the global floor in depth
/// squared, >= 0, such as LVSM_MIN_VARIANCE_FP16 times the squared length of a layer.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: LVSM section 5.
float lvsm_sampleLayers(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, float depth,
                        float splits[LVSM_MAX_LAYERS + 1], int layerCount, float overlap, float width,
                        float minVariance)
{
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    vec2 interval = lvsm_layerInterval(splits[layer], splits[layer + 1], overlap);
    float visibility = lvsm_visibilityInLayer(map, at, depth, interval, layer, minVariance);
    float weight = lvsm_transitionWeight(depth, splits[layer], splits[layer + 1], width);
    if (weight == 0.0)
        return visibility;
    int other = clamp(weight < 0.0 ? layer - 1 : layer + 1, 0, min(layerCount, LVSM_MAX_LAYERS) - 1);
    vec2 otherInterval = lvsm_layerInterval(splits[other], splits[other + 1], overlap);
    float neighbour = lvsm_visibilityInLayer(map, at, depth, otherInterval, other, minVariance);
    return lvsm_blendTransition(visibility, neighbour, weight);
}

#endif
