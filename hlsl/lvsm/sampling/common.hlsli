// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// What reading a map needs beside the texture itself; both forms of the wrappers include it.
//
// A map is one slice of an array of textures or several that follow one another, all of it or a rectangle of each: the
// same for cascades, atlases and the faces of a cube. A point says where to read it.
//
// Borders, one rule for every wrapper and pass: what is off the map is an empty texel. All read as if the map went on
// on every side with texels of border, such as depthMoments(1). So a filtered sample blends from the outermost texel to
// border within one texel of the level that is read, half of it off the map, and every tap of a wider filter that is
// off the map takes border. The map's sampler wraps by clamping to its edge and knows nothing of this: a sampler with a
// border colour would blend twice. Minified maps blend as the nearest level does, whose texels the longer gradient
// measures. A blur that clamps to the edge instead leaves slanted ground too little variance there, and a dark line of
// dots, one a texel, on what is lit.
#ifndef LVSM_SAMPLING_COMMON_HLSLI
#define LVSM_SAMPLING_COMMON_HLSLI

// Floors of the variance to begin with, for maps of half floats and of anything better, over the whole range of depth;
// a layer takes it times its squared length. The first is recommendedMinVariance of three roundings, which storing and
// two passes of a blur make, and a lit flat receiver that darkens by 1/100. By rounding alone the second would be less;
// it is a little over 2^-24, which also covers a compiler without precise, see config.hlsli.
static const float LVSM_MIN_VARIANCE_FP16 = 5.4e-5;
static const float LVSM_MIN_VARIANCE = 6.0e-8;

/// Where a map is read, made by mapPoint, atlasPoint or cubePoint.
struct lvsm_MapPoint
{
    // Texture coordinates in the map, which goes from 0 to 1, and their change to the next pixel in x and in y.
    float2 uv;
    float2 dx;
    float2 dy;
    // Corner and extent of the map in its slices, in texture coordinates of the whole.
    float4 rectangle;
    // The map's first slice.
    int slice;
};

/// Point of a map that has its slices for itself.
/// uv: texture coordinates. dx, dy: their change to the next pixel in x and in y. slice: the map's first one, such as a
/// cascade's number times the slices of each.
lvsm_MapPoint lvsm_mapPoint(float2 uv, float2 dx, float2 dy, int slice)
{
    lvsm_MapPoint at;
    at.uv = uv;
    at.dx = dx;
    at.dy = dy;
    at.rectangle = float4(0.0, 0.0, 1.0, 1.0);
    at.slice = slice;
    return at;
}

/// Point of a map that is a rectangle of an atlas; no wrapper reads what is around it.
/// uv: texture coordinates in the map, which goes from 0 to 1. dx, dy: their change to the next pixel in x and in y.
/// slice: the map's first one. rectangle: its corner, and its width and height, in texture coordinates of the atlas;
/// whole texels, and where there are levels, whole texels of the smallest that is read.
lvsm_MapPoint lvsm_atlasPoint(float2 uv, float2 dx, float2 dy, int slice, float4 rectangle)
{
    lvsm_MapPoint at = lvsm_mapPoint(uv, dx, dy, slice);
    at.rectangle = rectangle;
    return at;
}

// A vector by the axes of the face of a cube that it points to: s and t in the face, and the distance to it. axis: the
// face's, 0 to 2. isNegative: which of the two.
float3 lvsm_alongFace(float3 along, int axis, bool isNegative)
{
    float3 turned = isNegative ? float3(-along.x, along.y, -along.z) : along;
    if (axis == 0)
        return float3(-turned.z, -along.y, turned.x);
    if (axis == 2)
        return float3(turned.x, -along.y, turned.z);
    return float3(along.x, turned.z, isNegative ? -along.y : along.y);
}

/// Point of a cube map, whose faces are six maps in one array: +x, -x, +y, -y, +z, -z, each turned as the faces of cube
/// textures are.
/// direction: from the light to the receiver, of any length. dx, dy: its change to the next pixel in x and in y.
/// slice: the first one of +x. slicesOfFace: how many each face has, at least 1. tangent: of half the angle that a face
/// is drawn with, at least 1: size / (size - 2 margin) makes it a margin of texels larger than its share of the cube,
/// and with one as wide as the blur reaches, and a texel of the smallest level more, there is no seam.
lvsm_MapPoint lvsm_cubePoint(float3 direction, float3 dx, float3 dy, int slice, int slicesOfFace, float tangent)
{
    float3 size = abs(direction);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    bool isNegative = (axis == 0 ? direction.x : axis == 1 ? direction.y : direction.z) < 0.0;
    float3 at = lvsm_alongFace(direction, axis, isNegative);
    float3 alongX = lvsm_alongFace(dx, axis, isNegative);
    float3 alongY = lvsm_alongFace(dy, axis, isNegative);
    // The quotient's derivative. No direction is the centre of +x.
    float inverse = 1.0 / max(at.z, 1.0e-18);
    float2 place = at.xy * inverse;
    float scale = 0.5 / max(tangent, 1.0);
    return lvsm_mapPoint(0.5 + scale * place, scale * inverse * (alongX.xy - alongX.z * place),
                         scale * inverse * (alongY.xy - alongY.z * place),
                         slice + slicesOfFace * (2 * axis + (isNegative ? 1 : 0)));
}

// Size of a point's map in texels, from that of the whole texture; and its first texel.
float2 lvsm_pointSize(lvsm_MapPoint at, float2 size)
{
    return max(floor(at.rectangle.zw * size + 0.5), 1.0);
}

float2 lvsm_pointOrigin(lvsm_MapPoint at, float2 size)
{
    return floor(at.rectangle.xy * size + 0.5);
}

// How many texels a position lies off the centres of the outermost texels of a map, in each direction.
// position: in texels from the map's corner. size: of the map in texels, at least 1.
float2 lvsm_texelsBeyond(float2 position, float2 size)
{
    return abs(position - clamp(position, float2(0.5, 0.5), size - 0.5));
}

// The weight that a bilinear sample gives to texels on the map; it gives the rest to border. Exactly 1 and 0 away from
// the edge.
float lvsm_mapCoverage(float2 position, float2 size)
{
    float2 share = 1.0 - min(lvsm_texelsBeyond(position, size), 1.0);
    return share.x * share.y;
}

// How many texels of level 0 those of the level are wide that a sample with these gradients reads.
float lvsm_levelTexels(float2 dx, float2 dy, float2 size)
{
    return max(max(length(dx * size), length(dy * size)), 1.0);
}

// The same as mapCoverage for the level that a sample with these gradients reads.
float lvsm_levelCoverage(float2 uv, float2 dx, float2 dy, float2 size)
{
    float2 levelSize = max(size / lvsm_levelTexels(dx, dy, size), 1.0);
    return lvsm_mapCoverage(clamp(uv, -1.0, 2.0) * levelSize, levelSize);
}

// Texture coordinates of a point in the whole texture, no nearer to the map's edge than the centres of the outermost
// texels of the coarser of the two levels that a sample may read. size: of the map.
float2 lvsm_pointInTexture(lvsm_MapPoint at, float2 size)
{
    float texels = exp2(ceil(log2(lvsm_levelTexels(at.dx, at.dy, size)) - 0.01));
    float2 margin = min(0.5 * texels / size, 0.5);
    return at.rectangle.xy + at.rectangle.zw * clamp(at.uv, margin, 1.0 - margin);
}

// The sample of a map that clamps to its edge as if border lay around it. Exponential terms span the whole range of
// floats: a blend with a large border rounds a small texel away, so inside the map there is none.
float4 lvsm_withBorder(float4 texel, float4 border, float coverage)
{
    return coverage < 1.0 ? texel * coverage + border * (1.0 - coverage) : texel;
}

// The texel (0,0) of the four that surround a position, counted from the map's corner.
float2 lvsm_firstCorner(float2 uv, float2 size)
{
    return floor(clamp(uv, -1.0, 2.0) * size - 0.5);
}

// Four texels around a position with those off the map replaced.
float4 lvsm_maskCorners(float4 texels, float2 corner, float2 size, float border)
{
    bool left = corner.x >= 0.0 && corner.x < size.x;
    bool right = corner.x >= -1.0 && corner.x < size.x - 1.0;
    bool top = corner.y >= 0.0 && corner.y < size.y;
    bool bottom = corner.y >= -1.0 && corner.y < size.y - 1.0;
    return float4(left && top ? texels.x : border, right && top ? texels.y : border,
                  left && bottom ? texels.z : border, right && bottom ? texels.w : border);
}

/// Position between the four texels that gatherMap reads, as bilinearVisibility takes it.
/// uv: texture coordinates. size: of the map in texels. Result: each component in [0,1].
float2 lvsm_mapFraction(float2 uv, float2 size)
{
    return clamp(clamp(uv, -1.0, 2.0) * size - 0.5 - lvsm_firstCorner(uv, size), 0.0, 1.0);
}

// Where the nearest code of a point lies, and how far the point is from its centre, in its texels. size: of the map.
// place: counted from the map's corner. Result: false off the map.
bool lvsm_nearestCode(lvsm_MapPoint at, float2 size, out float2 place, out float2 offset)
{
    float2 position = clamp(at.uv, -1.0, 2.0) * size;
    place = floor(position);
    offset = position - place - 0.5;
    return place.x >= 0.0 && place.y >= 0.0 && place.x < size.x && place.y < size.y;
}

#endif
