// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/common.
// Texels of maps with the border around them: all that the other wrappers read goes through here.
#ifndef LVSM_SAMPLING_SEPARATE_MAPS_HLSLI
#define LVSM_SAMPLING_SEPARATE_MAPS_HLSLI

#include "../common.hlsli"

// A texel of fewer components as one of four, as GLSL samples it.
float4 lvsm_fourComponents(float texel)
{
    return float4(texel, 0.0, 0.0, 1.0);
}

float4 lvsm_fourComponents(float2 texel)
{
    return float4(texel, 0.0, 1.0);
}

float4 lvsm_fourComponents(float4 texel)
{
    return texel;
}

// Size of a map in texels.
// map: of 1 component or more.
float2 lvsm_mapSize(Texture2D<float> map)
{
    uint width;
    uint height;
    map.GetDimensions(width, height);
    return float2(float(width), float(height));
}

float2 lvsm_mapSize(Texture2D<float2> map)
{
    uint width;
    uint height;
    map.GetDimensions(width, height);
    return float2(float(width), float(height));
}

float2 lvsm_mapSize(Texture2D<float4> map)
{
    uint width;
    uint height;
    map.GetDimensions(width, height);
    return float2(float(width), float(height));
}

// Size of each slice of an array of maps in texels.
// map: of 1 component or more.
float2 lvsm_mapArraySize(Texture2DArray<float> map)
{
    uint width;
    uint height;
    uint slices;
    map.GetDimensions(width, height, slices);
    return float2(float(width), float(height));
}

float2 lvsm_mapArraySize(Texture2DArray<float2> map)
{
    uint width;
    uint height;
    uint slices;
    map.GetDimensions(width, height, slices);
    return float2(float(width), float(height));
}

float2 lvsm_mapArraySize(Texture2DArray<float4> map)
{
    uint width;
    uint height;
    uint slices;
    map.GetDimensions(width, height, slices);
    return float2(float(width), float(height));
}

/// Filtered texel of a map.
/// map: of 1 component or more. uv: texture coordinates. dx, dy: their change to the next pixel in x and in y.
/// border: what an empty texel holds. Result: the sample, blended with border at the edge, and border off the map.
float4 lvsm_sampleMap(Texture2D<float> map, SamplerState filtering, float2 uv, float2 dx, float2 dy, float4 border)
{
    float coverage = lvsm_levelCoverage(uv, dx, dy, lvsm_mapSize(map));
    return lvsm_withBorder(lvsm_fourComponents(map.SampleGrad(filtering, uv, dx, dy)), border, coverage);
}

float4 lvsm_sampleMap(Texture2D<float2> map, SamplerState filtering, float2 uv, float2 dx, float2 dy, float4 border)
{
    float coverage = lvsm_levelCoverage(uv, dx, dy, lvsm_mapSize(map));
    return lvsm_withBorder(lvsm_fourComponents(map.SampleGrad(filtering, uv, dx, dy)), border, coverage);
}

float4 lvsm_sampleMap(Texture2D<float4> map, SamplerState filtering, float2 uv, float2 dx, float2 dy, float4 border)
{
    float coverage = lvsm_levelCoverage(uv, dx, dy, lvsm_mapSize(map));
    return lvsm_withBorder(lvsm_fourComponents(map.SampleGrad(filtering, uv, dx, dy)), border, coverage);
}

/// Filtered texel of a slice of a map.
/// map: of 1 component or more. at: where, see mapPoint. index: of the slice among the map's. border: what an empty
/// texel holds. Result: the sample, blended with border at the edge, and border off the map.
float4 lvsm_sampleSlice(Texture2DArray<float> map, SamplerState filtering, lvsm_MapPoint at, int index, float4 border)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float coverage = lvsm_levelCoverage(at.uv, at.dx, at.dy, size);
    float3 place = float3(lvsm_pointInTexture(at, size), float(at.slice + index));
    float4 texel = lvsm_fourComponents(
        map.SampleGrad(filtering, place, at.dx * at.rectangle.zw, at.dy * at.rectangle.zw));
    return lvsm_withBorder(texel, border, coverage);
}

float4 lvsm_sampleSlice(Texture2DArray<float2> map, SamplerState filtering, lvsm_MapPoint at, int index, float4 border)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float coverage = lvsm_levelCoverage(at.uv, at.dx, at.dy, size);
    float3 place = float3(lvsm_pointInTexture(at, size), float(at.slice + index));
    float4 texel = lvsm_fourComponents(
        map.SampleGrad(filtering, place, at.dx * at.rectangle.zw, at.dy * at.rectangle.zw));
    return lvsm_withBorder(texel, border, coverage);
}

float4 lvsm_sampleSlice(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, int index, float4 border)
{
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float coverage = lvsm_levelCoverage(at.uv, at.dx, at.dy, size);
    float3 place = float3(lvsm_pointInTexture(at, size), float(at.slice + index));
    float4 texel = lvsm_fourComponents(
        map.SampleGrad(filtering, place, at.dx * at.rectangle.zw, at.dy * at.rectangle.zw));
    return lvsm_withBorder(texel, border, coverage);
}

/// First components of the four texels around a position, unfiltered, of level 0.
/// map: of 1 component or more. uv: texture coordinates. border: what an empty texel holds.
/// Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
float4 lvsm_gatherMap(Texture2D<float> map, SamplerState filtering, float2 uv, float border)
{
    float2 size = lvsm_mapSize(map);
    float2 corner = lvsm_firstCorner(uv, size);
    // The point where the four meet is where rounding the coordinates cannot choose others.
    return lvsm_maskCorners(map.Gather(filtering, (corner + 1.0) / size).wzxy, corner, size, border);
}

float4 lvsm_gatherMap(Texture2D<float2> map, SamplerState filtering, float2 uv, float border)
{
    float2 size = lvsm_mapSize(map);
    float2 corner = lvsm_firstCorner(uv, size);
    // The point where the four meet is where rounding the coordinates cannot choose others.
    return lvsm_maskCorners(map.Gather(filtering, (corner + 1.0) / size).wzxy, corner, size, border);
}

float4 lvsm_gatherMap(Texture2D<float4> map, SamplerState filtering, float2 uv, float border)
{
    float2 size = lvsm_mapSize(map);
    float2 corner = lvsm_firstCorner(uv, size);
    // The point where the four meet is where rounding the coordinates cannot choose others.
    return lvsm_maskCorners(map.Gather(filtering, (corner + 1.0) / size).wzxy, corner, size, border);
}

/// First components of the four texels around a point of a map, unfiltered, of level 0.
/// map: of 1 component or more. at: where, see mapPoint. index: of the slice among the map's. border: what an empty
/// texel holds. Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
float4 lvsm_gatherSlice(Texture2DArray<float> map, SamplerState filtering, lvsm_MapPoint at, int index, float border)
{
    float2 whole = lvsm_mapArraySize(map);
    float2 size = lvsm_pointSize(at, whole);
    float2 corner = lvsm_firstCorner(at.uv, size);
    float2 meeting = (corner + lvsm_pointOrigin(at, whole) + 1.0) / whole;
    float4 texels = map.Gather(filtering, float3(meeting, float(at.slice + index))).wzxy;
    return lvsm_maskCorners(texels, corner, size, border);
}

float4 lvsm_gatherSlice(Texture2DArray<float2> map, SamplerState filtering, lvsm_MapPoint at, int index, float border)
{
    float2 whole = lvsm_mapArraySize(map);
    float2 size = lvsm_pointSize(at, whole);
    float2 corner = lvsm_firstCorner(at.uv, size);
    float2 meeting = (corner + lvsm_pointOrigin(at, whole) + 1.0) / whole;
    float4 texels = map.Gather(filtering, float3(meeting, float(at.slice + index))).wzxy;
    return lvsm_maskCorners(texels, corner, size, border);
}

float4 lvsm_gatherSlice(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, int index, float border)
{
    float2 whole = lvsm_mapArraySize(map);
    float2 size = lvsm_pointSize(at, whole);
    float2 corner = lvsm_firstCorner(at.uv, size);
    float2 meeting = (corner + lvsm_pointOrigin(at, whole) + 1.0) / whole;
    float4 texels = map.Gather(filtering, float3(meeting, float(at.slice + index))).wzxy;
    return lvsm_maskCorners(texels, corner, size, border);
}

/// One texel of a slice of a map, unfiltered, of level 0.
/// map: of 1 component or more. at: where, see mapPoint; its coordinates count nothing here. index: of the slice among
/// the map's. texel: counted from the map's corner; off the map the nearest one on it is read.
float4 lvsm_fetchSlice(Texture2DArray<float> map, SamplerState filtering, lvsm_MapPoint at, int index, float2 texel)
{
    float2 whole = lvsm_mapArraySize(map);
    float2 place = lvsm_pointOrigin(at, whole) + clamp(texel, float2(0.0, 0.0), lvsm_pointSize(at, whole) - 1.0);
    return lvsm_fourComponents(map.Load(int4(int2(place), at.slice + index, 0)));
}

float4 lvsm_fetchSlice(Texture2DArray<float2> map, SamplerState filtering, lvsm_MapPoint at, int index, float2 texel)
{
    float2 whole = lvsm_mapArraySize(map);
    float2 place = lvsm_pointOrigin(at, whole) + clamp(texel, float2(0.0, 0.0), lvsm_pointSize(at, whole) - 1.0);
    return lvsm_fourComponents(map.Load(int4(int2(place), at.slice + index, 0)));
}

float4 lvsm_fetchSlice(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, int index, float2 texel)
{
    float2 whole = lvsm_mapArraySize(map);
    float2 place = lvsm_pointOrigin(at, whole) + clamp(texel, float2(0.0, 0.0), lvsm_pointSize(at, whole) - 1.0);
    return lvsm_fourComponents(map.Load(int4(int2(place), at.slice + index, 0)));
}

// Size of each slice of a map of codes in texels, and one of its texels.
float2 lvsm_mapCodesSize(Texture2DArray<uint2> map)
{
    uint width;
    uint height;
    uint slices;
    map.GetDimensions(width, height, slices);
    return float2(float(width), float(height));
}

uint2 lvsm_codeAt(Texture2DArray<uint2> map, int3 texel)
{
    return map.Load(int4(texel, 0));
}

float2 lvsm_mapCodesSize(Texture2DArray<uint4> map)
{
    uint width;
    uint height;
    uint slices;
    map.GetDimensions(width, height, slices);
    return float2(float(width), float(height));
}

uint4 lvsm_codeAt(Texture2DArray<uint4> map, int3 texel)
{
    return map.Load(int4(texel, 0));
}

#endif
