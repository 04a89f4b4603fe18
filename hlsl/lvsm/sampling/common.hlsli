// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// What reading a map needs beside the texture itself; both forms of the wrappers include it.
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

// The same for the level that a sample with these gradients reads.
float lvsm_levelCoverage(float2 uv, float2 dx, float2 dy, float2 size)
{
    float texels = max(max(length(dx * size), length(dy * size)), 1.0);
    float2 levelSize = max(size / texels, 1.0);
    return lvsm_mapCoverage(clamp(uv, -1.0, 2.0) * levelSize, levelSize);
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

#endif
