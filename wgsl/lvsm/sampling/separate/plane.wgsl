// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket, plane, sampling/common, sampling/separate/maps, sampling/separate/bracket.
// Bracketed layers judged relative to the receiver's plane.

// The two layers of a slice at a point, moved by some texels, see sampleLayerPair.
// map: of 4 components.
fn lvsm_sampleNeighbourPair(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, index: i32,
                            compact: bool, offset: vec2f) -> vec4f
{
    var moved = at;
    moved.uv += offset / lvsm_pointSize(at, lvsm_mapArraySize(map, filtering));
    return lvsm_sampleLayerPair(map, filtering, moved, index, compact);
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
fn lvsm_samplePlane(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32, gradient: vec2f,
                    splits: array<f32, LVSM_MAX_LAYERS + 1>, layerCount: i32, compact: bool, deviation: f32,
                    minVariance: f32, amount: f32) -> f32
{
    let count = clamp(layerCount, 1, LVSM_MAX_LAYERS);
    let variance = lvsm_planeVariance(gradient, deviation);
    let first = lvsm_layerIndex(depth - sqrt(variance), splits, layerCount);
    let last = lvsm_layerIndex(depth + sqrt(variance), splits, layerCount);
    let interval = vec2f(splits[first], splits[last + 1]);
    var front = vec2f(1.0, 1.0);
    var behind = vec2f(0.0, 0.0);
    var merged = vec2f(0.0, 0.0);
    var covariances = vec3f(0.0, 0.0, 0.0);
    var pair = vec4f(0.0, 0.0, 0.0, 0.0);
    var pairCovariances = vec2f(0.0, 0.0);
    for (var i = max(first - 1, 0); i <= min(last + 1, count - 1); i++)
    {
        if (i == max(first - 1, 0) || (i & 1) == 0)
        {
            pair = lvsm_sampleLayerPair(map, filtering, at, i / 2, compact);
            let right = lvsm_sampleNeighbourPair(map, filtering, at, i / 2, compact, vec2f(1.0, 0.0));
            let left = lvsm_sampleNeighbourPair(map, filtering, at, i / 2, compact, vec2f(-1.0, 0.0));
            let up = lvsm_sampleNeighbourPair(map, filtering, at, i / 2, compact, vec2f(0.0, 1.0));
            let down = lvsm_sampleNeighbourPair(map, filtering, at, i / 2, compact, vec2f(0.0, -1.0));
            pairCovariances = vec2f(lvsm_planeCovariance(vec4f(right.x, left.x, up.x, down.x), gradient, deviation),
                                    lvsm_planeCovariance(vec4f(right.z, left.z, up.z, down.z), gradient, deviation));
        }
        let moments = lvsm_unpackLayer(pair, i);
        let covariance = select(pairCovariances.y, pairCovariances.x, (i & 1) == 0);
        let extent = splits[i + 1] - splits[i];
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
