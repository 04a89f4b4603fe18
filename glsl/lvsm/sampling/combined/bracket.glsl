// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket, sampling/highp, sampling/common, sampling/combined/maps.
// Bracketed layers: two in the one texel of a slice, or two to each slice of many. They do not overlap.
#ifndef LVSM_SAMPLING_COMBINED_BRACKET_GLSL
#define LVSM_SAMPLING_COMBINED_BRACKET_GLSL

#include "../../bracket.glsl"
#include "maps.glsl"

/// Visibility from two layers in one texel, each judged with the other.
/// map: of 4 components, as packLayers made them. at: where, see mapPoint. depth: the receiver's, in [0,1]. split:
/// between the layers, in [0,1]. minVariance: the global floor in depth squared, >= 0, for layers of half the depth a
/// quarter of LVSM_MIN_VARIANCE_FP16. Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: bracketedVisibility2.
float lvsm_sampleBracketed2(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, float depth, float split,
                            float minVariance)
{
    vec4 texel = lvsm_sampleSlice(map, at, 0, vec4(1.0, 1.0, 1.0, 1.0));
    return lvsm_bracketedVisibility2(texel, depth, split, minVariance);
}

// Moments of the two layers of a slice.
// map: of 4 components.
vec4 lvsm_sampleLayerPair(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, int index, bool compact)
{
    float second = compact ? 0.0 : 1.0;
    vec4 texel = lvsm_sampleSlice(map, at, index, vec4(1.0, second, 1.0, second));
    return compact ? vec4(lvsm_expandMoments(texel.xy), lvsm_expandMoments(texel.zw)) : texel;
}

/// Visibility from the layer that holds the receiver and its two neighbours, two layers to a slice: two samples.
/// map: of 4 components, as packLayers made them. at: where, see mapPoint. depth: the receiver's, in [0,1]. splits:
/// layerCount + 1 values, not decreasing, from 0 to 1. layerCount: from 1 to LVSM_MAX_LAYERS. compact: whether the
/// layers are in the basis of compactMoments. minVariance: the global floor in depth squared, >= 0, such as
/// LVSM_MIN_VARIANCE_FP16 times the squared length of a layer. Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: bracketedBoundedVisibility.
float lvsm_sampleBracketed(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, float depth,
                           float splits[LVSM_MAX_LAYERS + 1], int layerCount, bool compact, float minVariance)
{
    int last = clamp(layerCount, 1, LVSM_MAX_LAYERS) - 1;
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    bool isEven = (layer & 1) == 0;
    vec4 own = lvsm_sampleLayerPair(map, at, layer / 2, compact);
    vec4 other = lvsm_sampleLayerPair(map, at, clamp(isEven ? layer / 2 - 1 : layer / 2 + 1, 0, last / 2), compact);
    vec2 front = isEven ? other.zw : own.xy;
    vec2 behind = isEven ? own.zw : other.xy;
    if (layer == 0)
        front = vec2(1.0, 1.0);
    if (layer >= last)
        behind = vec2(0.0, 0.0);
    return lvsm_bracketedBoundedVisibility(front, lvsm_unpackLayer(own, layer), behind, depth,
                                           vec2(splits[layer], splits[layer + 1]), minVariance);
}

#endif
