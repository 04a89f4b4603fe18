// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/highp, sampling/common.
// Texels of maps with the border around them: all that the other wrappers read goes through here.
#ifndef LVSM_SAMPLING_COMBINED_MAPS_GLSL
#define LVSM_SAMPLING_COMBINED_MAPS_GLSL

#include "../common.glsl"

// Size of a map in texels.
// map: of 1 component or more.
vec2 lvsm_mapSize(LVSM_HIGHP sampler2D map)
{
    return vec2(textureSize(map, 0));
}

// Size of each slice of an array of maps in texels.
// map: of 1 component or more.
vec2 lvsm_mapArraySize(LVSM_HIGHP sampler2DArray map)
{
    return vec2(textureSize(map, 0).xy);
}

/// Filtered texel of a map.
/// map: of 1 component or more. uv: texture coordinates. dx, dy: their change to the next pixel in x and in y.
/// border: what an empty texel holds. Result: the sample, blended with border at the edge, and border off the map.
vec4 lvsm_sampleMap(LVSM_HIGHP sampler2D map, vec2 uv, vec2 dx, vec2 dy, vec4 border)
{
    float coverage = lvsm_levelCoverage(uv, dx, dy, lvsm_mapSize(map));
    return lvsm_withBorder(textureGrad(map, uv, dx, dy), border, coverage);
}

/// Filtered texel of a slice of a map.
/// map: of 1 component or more. at: where, see mapPoint. index: of the slice among the map's. border: what an empty
/// texel holds. Result: the sample, blended with border at the edge, and border off the map.
vec4 lvsm_sampleSlice(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, int index, vec4 border)
{
    vec2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float coverage = lvsm_levelCoverage(at.uv, at.dx, at.dy, size);
    vec3 place = vec3(lvsm_pointInTexture(at, size), float(at.slice + index));
    return lvsm_withBorder(textureGrad(map, place, at.dx * at.rectangle.zw, at.dy * at.rectangle.zw), border, coverage);
}

// First components of four texels of level 0, clamped to the edge. corner: the texel (0,0) of them. A gather where the
// four meet is where rounding the coordinates cannot choose others.
#if __VERSION__ >= 400 || defined(GL_ES) && __VERSION__ >= 310
vec4 lvsm_fourTexels(LVSM_HIGHP sampler2D map, vec2 corner, vec2 size)
{
    return textureGather(map, (corner + 1.0) / size).wzxy;
}

vec4 lvsm_fourTexelsArray(LVSM_HIGHP sampler2DArray map, vec2 corner, vec2 size, int slice)
{
    return textureGather(map, vec3((corner + 1.0) / size, float(slice))).wzxy;
}
#else
vec4 lvsm_fourTexels(LVSM_HIGHP sampler2D map, vec2 corner, vec2 size)
{
    ivec2 last = ivec2(size) - 1;
    ivec2 first = clamp(ivec2(corner), ivec2(0, 0), last);
    ivec2 next = clamp(ivec2(corner) + 1, ivec2(0, 0), last);
    return vec4(texelFetch(map, first, 0).x, texelFetch(map, ivec2(next.x, first.y), 0).x,
                texelFetch(map, ivec2(first.x, next.y), 0).x, texelFetch(map, next, 0).x);
}

vec4 lvsm_fourTexelsArray(LVSM_HIGHP sampler2DArray map, vec2 corner, vec2 size, int slice)
{
    ivec2 last = ivec2(size) - 1;
    ivec2 first = clamp(ivec2(corner), ivec2(0, 0), last);
    ivec2 next = clamp(ivec2(corner) + 1, ivec2(0, 0), last);
    return vec4(texelFetch(map, ivec3(first, slice), 0).x, texelFetch(map, ivec3(next.x, first.y, slice), 0).x,
                texelFetch(map, ivec3(first.x, next.y, slice), 0).x, texelFetch(map, ivec3(next, slice), 0).x);
}
#endif

/// First components of the four texels around a position, unfiltered, of level 0.
/// map: of 1 component or more. uv: texture coordinates. border: what an empty texel holds.
/// Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
vec4 lvsm_gatherMap(LVSM_HIGHP sampler2D map, vec2 uv, float border)
{
    vec2 size = lvsm_mapSize(map);
    vec2 corner = lvsm_firstCorner(uv, size);
    return lvsm_maskCorners(lvsm_fourTexels(map, corner, size), corner, size, border);
}

/// First components of the four texels around a point of a map, unfiltered, of level 0.
/// map: of 1 component or more. at: where, see mapPoint. index: of the slice among the map's. border: what an empty
/// texel holds. Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
vec4 lvsm_gatherSlice(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, int index, float border)
{
    vec2 whole = lvsm_mapArraySize(map);
    vec2 size = lvsm_pointSize(at, whole);
    vec2 corner = lvsm_firstCorner(at.uv, size);
    vec4 texels = lvsm_fourTexelsArray(map, corner + lvsm_pointOrigin(at, whole), whole, at.slice + index);
    return lvsm_maskCorners(texels, corner, size, border);
}

/// One texel of a slice of a map, unfiltered, of level 0.
/// map: of 1 component or more. at: where, see mapPoint; its coordinates count nothing here. index: of the slice among
/// the map's. texel: counted from the map's corner; off the map the nearest one on it is read.
vec4 lvsm_fetchSlice(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, int index, vec2 texel)
{
    vec2 whole = lvsm_mapArraySize(map);
    vec2 place = lvsm_pointOrigin(at, whole) + clamp(texel, vec2(0.0, 0.0), lvsm_pointSize(at, whole) - 1.0);
    return texelFetch(map, ivec3(ivec2(place), at.slice + index), 0);
}

// Size of each slice of a map of codes in texels, and one of its texels.
vec2 lvsm_mapCodesSize(LVSM_HIGHP usampler2DArray map)
{
    return vec2(textureSize(map, 0).xy);
}

uvec4 lvsm_codeAt(LVSM_HIGHP usampler2DArray map, ivec3 texel)
{
    return texelFetch(map, texel, 0);
}

#endif
