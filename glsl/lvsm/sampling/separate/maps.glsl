// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/highp, sampling/common.
// Texels of maps with the border around them: all that the other wrappers read goes through here.
#ifndef LVSM_SAMPLING_SEPARATE_MAPS_GLSL
#define LVSM_SAMPLING_SEPARATE_MAPS_GLSL

#include "../common.glsl"

// Size of a map in texels.
// map: of 1 component or more.
vec2 lvsm_mapSize(texture2D map, sampler filtering)
{
    return vec2(textureSize(sampler2D(map, filtering), 0));
}

// Size of each slice of an array of maps in texels.
// map: of 1 component or more.
vec2 lvsm_mapArraySize(texture2DArray map, sampler filtering)
{
    return vec2(textureSize(sampler2DArray(map, filtering), 0).xy);
}

/// Filtered texel of a map.
/// map: of 1 component or more. uv: texture coordinates. dx, dy: their change to the next pixel in x and in y.
/// border: what an empty texel holds. Result: the sample, blended with border at the edge, and border off the map.
vec4 lvsm_sampleMap(texture2D map, sampler filtering, vec2 uv, vec2 dx, vec2 dy, vec4 border)
{
    float coverage = lvsm_levelCoverage(uv, dx, dy, lvsm_mapSize(map, filtering));
    return lvsm_withBorder(textureGrad(sampler2D(map, filtering), uv, dx, dy), border, coverage);
}

/// Filtered texel of a slice of a map.
/// map: of 1 component or more. at: where, see mapPoint. index: of the slice among the map's. border: what an empty
/// texel holds. Result: the sample, blended with border at the edge, and border off the map.
vec4 lvsm_sampleSlice(texture2DArray map, sampler filtering, lvsm_MapPoint at, int index, vec4 border)
{
    vec2 size = lvsm_pointSize(at, lvsm_mapArraySize(map, filtering));
    float coverage = lvsm_levelCoverage(at.uv, at.dx, at.dy, size);
    vec3 place = vec3(lvsm_pointInTexture(at, size), float(at.slice + index));
    return lvsm_withBorder(textureGrad(sampler2DArray(map, filtering), place, at.dx * at.rectangle.zw,
                                       at.dy * at.rectangle.zw), border, coverage);
}

// First components of four texels of level 0, clamped to the edge. corner: the texel (0,0) of them. A gather where the
// four meet is where rounding the coordinates cannot choose others.
vec4 lvsm_fourTexels(texture2D map, sampler filtering, vec2 corner, vec2 size)
{
    return textureGather(sampler2D(map, filtering), (corner + 1.0) / size).wzxy;
}

vec4 lvsm_fourTexelsArray(texture2DArray map, sampler filtering, vec2 corner, vec2 size, int slice)
{
    return textureGather(sampler2DArray(map, filtering), vec3((corner + 1.0) / size, float(slice))).wzxy;
}

/// First components of the four texels around a position, unfiltered, of level 0.
/// map: of 1 component or more. uv: texture coordinates. border: what an empty texel holds.
/// Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
vec4 lvsm_gatherMap(texture2D map, sampler filtering, vec2 uv, float border)
{
    vec2 size = lvsm_mapSize(map, filtering);
    vec2 corner = lvsm_firstCorner(uv, size);
    return lvsm_maskCorners(lvsm_fourTexels(map, filtering, corner, size), corner, size, border);
}

/// First components of the four texels around a point of a map, unfiltered, of level 0.
/// map: of 1 component or more. at: where, see mapPoint. index: of the slice among the map's. border: what an empty
/// texel holds. Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
vec4 lvsm_gatherSlice(texture2DArray map, sampler filtering, lvsm_MapPoint at, int index, float border)
{
    vec2 whole = lvsm_mapArraySize(map, filtering);
    vec2 size = lvsm_pointSize(at, whole);
    vec2 corner = lvsm_firstCorner(at.uv, size);
    vec4 texels = lvsm_fourTexelsArray(map, filtering, corner + lvsm_pointOrigin(at, whole), whole, at.slice + index);
    return lvsm_maskCorners(texels, corner, size, border);
}

/// One texel of a slice of a map, unfiltered, of level 0.
/// map: of 1 component or more. at: where, see mapPoint; its coordinates count nothing here. index: of the slice among
/// the map's. texel: counted from the map's corner; off the map the nearest one on it is read.
vec4 lvsm_fetchSlice(texture2DArray map, sampler filtering, lvsm_MapPoint at, int index, vec2 texel)
{
    vec2 whole = lvsm_mapArraySize(map, filtering);
    vec2 place = lvsm_pointOrigin(at, whole) + clamp(texel, vec2(0.0, 0.0), lvsm_pointSize(at, whole) - 1.0);
    return texelFetch(sampler2DArray(map, filtering), ivec3(ivec2(place), at.slice + index), 0);
}

// Size of each slice of a map of codes in texels, and one of its texels.
vec2 lvsm_mapCodesSize(utexture2DArray map, sampler filtering)
{
    return vec2(textureSize(usampler2DArray(map, filtering), 0).xy);
}

uvec4 lvsm_codeAt(utexture2DArray map, sampler filtering, ivec3 texel)
{
    return texelFetch(usampler2DArray(map, filtering), texel, 0);
}

#endif
