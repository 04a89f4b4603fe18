// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, esm, depth, moments, layers, pcf, receiver.
// Reading shadow maps from textures that carry their sampler: OpenGL's way, and one of Vulkan's two.
//
// A map is filtered linearly, wraps by clamping to its edge, and its texture coordinates go from 0 to 1. What lies off
// the map is lit: there a sample is what an empty texel holds, border, such as depthMoments(1).
//
// A branch on the receiver's layer or position breaks the derivatives that a texture's level comes from. So the
// gradients of the coordinates are parameters: take them with dFdx and dFdy before any branch.
//
// Needs GLSL 4.00 or ES 3.10, which have textureGather.
#ifndef LVSM_SAMPLING_COMBINED_GLSL
#define LVSM_SAMPLING_COMBINED_GLSL

#include "../esm.glsl"
#include "../layers.glsl"
#include "../pcf.glsl"
#include "../receiver.glsl"

// Whether coordinates are on the map.
bool lvsm_isOnMap(vec2 uv)
{
    return uv.x >= 0.0 && uv.x <= 1.0 && uv.y >= 0.0 && uv.y <= 1.0;
}

// The texel (0,0) of the four that surround a position, counted from the map's corner.
vec2 lvsm_firstCorner(vec2 uv, vec2 size)
{
    return floor(clamp(uv, -1.0, 2.0) * size - 0.5);
}

// Four texels around a position with those off the map replaced.
vec4 lvsm_maskCorners(vec4 texels, vec2 corner, vec2 size, float border)
{
    bool left = corner.x >= 0.0 && corner.x < size.x;
    bool right = corner.x >= -1.0 && corner.x < size.x - 1.0;
    bool top = corner.y >= 0.0 && corner.y < size.y;
    bool bottom = corner.y >= -1.0 && corner.y < size.y - 1.0;
    return vec4(left && top ? texels.x : border, right && top ? texels.y : border,
                left && bottom ? texels.z : border, right && bottom ? texels.w : border);
}

/// Filtered texel of a map.
/// uv: texture coordinates. dx, dy: their change to the next pixel in x and in y. border: what an empty texel holds.
/// Result: the sample, or border off the map.
vec4 lvsm_sampleMap(sampler2D map, vec2 uv, vec2 dx, vec2 dy, vec4 border)
{
    vec4 texel = textureGrad(map, uv, dx, dy);
    return lvsm_isOnMap(uv) ? texel : border;
}

/// Filtered texel of one slice of an array of maps.
/// uv: texture coordinates. slice: of the array. dx, dy: change of uv to the next pixel in x and in y.
/// border: what an empty texel holds. Result: the sample, or border off the map.
vec4 lvsm_sampleMapArray(sampler2DArray map, vec2 uv, int slice, vec2 dx, vec2 dy, vec4 border)
{
    vec4 texel = textureGrad(map, vec3(uv, float(slice)), dx, dy);
    return lvsm_isOnMap(uv) ? texel : border;
}

/// First components of the four texels around a position, unfiltered, of level 0.
/// uv: texture coordinates. border: what an empty texel holds.
/// Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
vec4 lvsm_gatherMap(sampler2D map, vec2 uv, float border)
{
    vec2 size = vec2(textureSize(map, 0));
    vec2 corner = lvsm_firstCorner(uv, size);
    // The point where the four meet is where rounding the coordinates cannot choose others.
    return lvsm_maskCorners(textureGather(map, (corner + 1.0) / size).wzxy, corner, size, border);
}

/// First components of the four texels around a position in one slice of an array, unfiltered, of level 0.
/// uv: texture coordinates. slice: of the array. border: what an empty texel holds.
/// Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
vec4 lvsm_gatherMapArray(sampler2DArray map, vec2 uv, int slice, float border)
{
    vec2 size = vec2(textureSize(map, 0).xy);
    vec2 corner = lvsm_firstCorner(uv, size);
    vec4 texels = textureGather(map, vec3((corner + 1.0) / size, float(slice))).wzxy;
    return lvsm_maskCorners(texels, corner, size, border);
}

/// Position between the four texels that gatherMap reads, as bilinearVisibility takes it.
/// uv: texture coordinates. size: of the map in texels. Result: each component in [0,1].
vec2 lvsm_mapFraction(vec2 uv, vec2 size)
{
    return clamp(clamp(uv, -1.0, 2.0) * size - 0.5 - lvsm_firstCorner(uv, size), 0.0, 1.0);
}

// Visibility from the layer that the receiver is judged by.
float lvsm_visibilityInLayer(sampler2DArray map, vec2 uv, vec2 dx, vec2 dy, float depth, vec2 interval, int layer,
                             float minVariance)
{
    vec4 texel = lvsm_sampleMapArray(map, uv, layer / 2, dx, dy, vec4(1.0, 1.0, 1.0, 1.0));
    return lvsm_layeredVisibility(lvsm_unpackLayer(texel, layer), depth, interval, minVariance);
}

/// Visibility from a layered variance shadow map: two layers to a slice, as packLayers lays them out.
/// uv: texture coordinates. dx, dy: their change to the next pixel. depth: the receiver's, in [0,1].
/// splits: layerCount + 1 values, not decreasing, from 0 to 1. layerCount: from 1 to LVSM_MAX_LAYERS.
/// overlap: of the layers, as when stored. width: of the transition, at most the overlap; only there is a second sample
/// taken. minVariance: the global floor in depth squared, >= 0. Result in [0,1]; 1 off the map.
/// Source: LVSM section 5.
float lvsm_sampleLayers(sampler2DArray map, vec2 uv, vec2 dx, vec2 dy, float depth, float splits[LVSM_MAX_LAYERS + 1],
                        int layerCount, float overlap, float width, float minVariance)
{
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    vec2 interval = lvsm_layerInterval(splits[layer], splits[layer + 1], overlap);
    float visibility = lvsm_visibilityInLayer(map, uv, dx, dy, depth, interval, layer, minVariance);
    float weight = lvsm_transitionWeight(depth, splits[layer], splits[layer + 1], width);
    if (weight == 0.0)
        return visibility;
    int other = clamp(weight < 0.0 ? layer - 1 : layer + 1, 0, min(layerCount, LVSM_MAX_LAYERS) - 1);
    vec2 otherInterval = lvsm_layerInterval(splits[other], splits[other + 1], overlap);
    float neighbour = lvsm_visibilityInLayer(map, uv, dx, dy, depth, otherInterval, other, minVariance);
    return lvsm_blendTransition(visibility, neighbour, weight);
}

/// Visibility by percentage-closer filtering with a box of any width, over a map of depths.
/// uv: texture coordinates. width: of the box in texels, from 1 to 65, clamped to it. depth: the receiver's, in [0,1].
/// gradient: of the receiver's depth per texel, see receiverGradient; (0, 0) takes one depth for all texels.
/// bias: what the receiver is moved towards the light, in [0,1]. Result in [0,1]; 1 off the map.
/// Source: Reeves et al. 1987.
float lvsm_samplePcf(sampler2D map, vec2 uv, float width, float depth, vec2 gradient, float bias)
{
    if (!lvsm_isOnMap(uv))
        return 1.0;
    vec2 size = vec2(textureSize(map, 0));
    float extent = clamp(width, 1.0, float(LVSM_MAX_FILTER_SIZE));
    vec2 position = uv * size - 0.5;
    vec2 first = floor(position - 0.5 * extent + 0.5);
    int quads = int(0.5 * ceil(extent)) + 1;
    vec2 sum = vec2(0.0, 0.0);
    for (int y = 0; y < quads; ++y)
    {
        for (int x = 0; x < quads; ++x)
        {
            vec2 texel = first + 2.0 * vec2(float(x), float(y));
            vec2 offset = texel - position;
            vec4 depths = lvsm_gatherMap(map, (texel + 1.0) / size, 1.0);
            vec2 across = vec2(lvsm_boxWeight(offset.x, extent), lvsm_boxWeight(offset.x + 1.0, extent));
            vec2 down = vec2(lvsm_boxWeight(offset.y, extent), lvsm_boxWeight(offset.y + 1.0, extent));
            vec4 receivers = vec4(lvsm_planeDepth(depth, gradient, offset),
                                  lvsm_planeDepth(depth, gradient, offset + vec2(1.0, 0.0)),
                                  lvsm_planeDepth(depth, gradient, offset + vec2(0.0, 1.0)),
                                  lvsm_planeDepth(depth, gradient, offset + vec2(1.0, 1.0)));
            sum = lvsm_pcfAdd(sum, depths, across.xyxy * down.xxyy, receivers, bias);
        }
    }
    return lvsm_pcfVisibility(sum);
}

/// Visibility from an exponential shadow map, with the 2x2 filter where the threshold test finds the map at fault.
/// uv: texture coordinates. dx, dy: their change to the next pixel. depth: the receiver's, in [0,1].
/// exponent: c as when stored. threshold: of violatesThreshold. Result in [0,1]; 1 off the map.
/// Source: ESM section 3.3.
float lvsm_sampleEsm(sampler2D map, vec2 uv, vec2 dx, vec2 dy, float depth, float exponent, float threshold)
{
    float empty = lvsm_occluderTerm(1.0, exponent);
    float occluder = lvsm_sampleMap(map, uv, dx, dy, vec4(empty, empty, empty, empty)).x;
    if (!lvsm_violatesThreshold(occluder, depth, exponent, threshold))
        return lvsm_exponentialShadow(occluder, depth, exponent);
    vec2 fraction = lvsm_mapFraction(uv, vec2(textureSize(map, 0)));
    return lvsm_exponentialShadow2x2(lvsm_gatherMap(map, uv, empty), fraction, depth, exponent);
}

#endif
