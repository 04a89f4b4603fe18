// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket, plane, sampling/highp, sampling/common, sampling/combined/maps, sampling/combined/bracket.
// Bracketed layers judged relative to the receiver's plane.
#ifndef LVSM_SAMPLING_COMBINED_PLANE_GLSL
#define LVSM_SAMPLING_COMBINED_PLANE_GLSL

#include "../../plane.glsl"
#include "bracket.glsl"

// The two layers of a slice at a point, moved by some texels, see sampleLayerPair.
// map: of 4 components.
vec4 lvsm_sampleNeighbourPair(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, int index, bool compact, vec2 offset)
{
    lvsm_MapPoint moved = at;
    moved.uv += offset / lvsm_pointSize(at, lvsm_mapArraySize(map));
    return lvsm_sampleLayerPair(map, moved, index, compact);
}

/// Visibility of a slanted receiver from all layers that its plane reaches and the two neighbours of these, relative to
/// the plane: five samples of each slice that has one of them, mostly two.
/// map: of 4 components, as packLayers made them, under a filter that is about Gaussian. at: where, see mapPoint. depth:
/// the receiver's, in [0,1]. gradient: of the depth per texel, see receiverGradient. splits: layerCount + 1 values, not
/// decreasing, from 0 to 1. layerCount: from 1 to LVSM_MAX_LAYERS. compact: whether the layers are in the basis of
/// compactMoments. deviation: standard deviation of the filter in texels, see receiverMinVariance. minVariance: the
/// global floor in depth squared, >= 0. amount: of planeBracketedVisibility; 0.15 suits meshes.
/// Result in [0,1]; 1 one and a half texels off the map and beyond.
/// Source: planeBracketedVisibility.
float lvsm_samplePlane(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, float depth, vec2 gradient,
                       float splits[LVSM_MAX_LAYERS + 1], int layerCount, bool compact, float deviation,
                       float minVariance, float amount)
{
    int count = clamp(layerCount, 1, LVSM_MAX_LAYERS);
    float variance = lvsm_planeVariance(gradient, deviation);
    int first = lvsm_layerIndex(depth - sqrt(variance), splits, layerCount);
    int last = lvsm_layerIndex(depth + sqrt(variance), splits, layerCount);
    vec2 interval = vec2(splits[first], splits[last + 1]);
    vec2 front = vec2(1.0, 1.0);
    vec2 behind = vec2(0.0, 0.0);
    vec2 merged = vec2(0.0, 0.0);
    vec3 covariances = vec3(0.0, 0.0, 0.0);
    vec4 pair = vec4(0.0, 0.0, 0.0, 0.0);
    vec2 pairCovariances = vec2(0.0, 0.0);
    for (int i = max(first - 1, 0); i <= min(last + 1, count - 1); ++i)
    {
        if (i == max(first - 1, 0) || (i & 1) == 0)
        {
            pair = lvsm_sampleLayerPair(map, at, i / 2, compact);
            vec4 right = lvsm_sampleNeighbourPair(map, at, i / 2, compact, vec2(1.0, 0.0));
            vec4 left = lvsm_sampleNeighbourPair(map, at, i / 2, compact, vec2(-1.0, 0.0));
            vec4 up = lvsm_sampleNeighbourPair(map, at, i / 2, compact, vec2(0.0, 1.0));
            vec4 down = lvsm_sampleNeighbourPair(map, at, i / 2, compact, vec2(0.0, -1.0));
            pairCovariances = vec2(
                lvsm_planeCovariance(vec4(right.x, left.x, up.x, down.x), gradient, deviation),
                lvsm_planeCovariance(vec4(right.z, left.z, up.z, down.z), gradient, deviation));
        }
        vec2 moments = lvsm_unpackLayer(pair, i);
        float covariance = (i & 1) == 0 ? pairCovariances.x : pairCovariances.y;
        float extent = splits[i + 1] - splits[i];
        if (i < first)
        {
            front = moments;
            covariances.x = covariance;
        }
        else if (i > last)
        {
            behind = moments;
            covariances.z = covariance;
        }
        else
        {
            merged = lvsm_mergeLayers(merged, moments, splits[i] - interval.x, extent);
            covariances.y += covariance * extent / max(interval.y - interval.x, 0.0009765625);
        }
    }
    return lvsm_planeBracketedVisibility(front, merged, behind, covariances, depth, interval, variance, minVariance,
                                         amount);
}

#endif
