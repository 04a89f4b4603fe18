// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, esm, sampling/common, sampling/separate/maps.
// Exponential shadow maps with the fallback for where they fail.
//
// The fallback judges four texels apart, and so needs them as they were stored: blurred ones hold light from all
// around, see ESM, section 3.4. Where a map is blurred, keep the unblurred one beside it; where it is not, pass it
// twice. With no such map there is no fallback to take: exponentialShadow of sampleSlice.
#ifndef LVSM_SAMPLING_SEPARATE_ESM_HLSLI
#define LVSM_SAMPLING_SEPARATE_ESM_HLSLI

#include "../../esm.hlsli"
#include "maps.hlsli"

// The fallback: four terms judged apart.
// map: of 1 component or more, as they were stored.
float lvsm_sampleFourTerms(Texture2DArray<float> map, SamplerState filtering, lvsm_MapPoint at, float depth,
                           float exponent)
{
    float2 fraction = lvsm_mapFraction(at.uv, lvsm_pointSize(at, lvsm_mapArraySize(map)));
    float4 terms = lvsm_gatherSlice(map, filtering, at, 0, lvsm_occluderTerm(1.0, exponent));
    return lvsm_exponentialShadow2x2(terms, fraction, depth, exponent);
}

float lvsm_sampleFourTerms(Texture2DArray<float2> map, SamplerState filtering, lvsm_MapPoint at, float depth,
                           float exponent)
{
    float2 fraction = lvsm_mapFraction(at.uv, lvsm_pointSize(at, lvsm_mapArraySize(map)));
    float4 terms = lvsm_gatherSlice(map, filtering, at, 0, lvsm_occluderTerm(1.0, exponent));
    return lvsm_exponentialShadow2x2(terms, fraction, depth, exponent);
}

float lvsm_sampleFourTerms(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at, float depth,
                           float exponent)
{
    float2 fraction = lvsm_mapFraction(at.uv, lvsm_pointSize(at, lvsm_mapArraySize(map)));
    float4 terms = lvsm_gatherSlice(map, filtering, at, 0, lvsm_occluderTerm(1.0, exponent));
    return lvsm_exponentialShadow2x2(terms, fraction, depth, exponent);
}

/// Visibility from an exponential shadow map, with the 2x2 filter where the threshold test finds the map at fault.
/// map: of 1 component or more, occluder terms filtered in any way. unfiltered: the terms as they were stored; map
/// itself where it has not been blurred. at: where, see mapPoint. depth: the receiver's, in [0,1]. exponent: c as when
/// stored. threshold: of violatesThreshold, which the paper has at 0.02.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: ESM section 3.3.
float lvsm_sampleEsm(Texture2DArray<float> map, Texture2DArray<float> unfiltered, SamplerState filtering,
                     lvsm_MapPoint at, float depth, float exponent, float threshold)
{
    float empty = lvsm_occluderTerm(1.0, exponent);
    float occluder = lvsm_sampleSlice(map, filtering, at, 0, float4(empty, empty, empty, empty)).x;
    if (!lvsm_violatesThreshold(occluder, depth, exponent, threshold))
        return lvsm_exponentialShadow(occluder, depth, exponent);
    return lvsm_sampleFourTerms(unfiltered, filtering, at, depth, exponent);
}

float lvsm_sampleEsm(Texture2DArray<float2> map, Texture2DArray<float2> unfiltered, SamplerState filtering,
                     lvsm_MapPoint at, float depth, float exponent, float threshold)
{
    float empty = lvsm_occluderTerm(1.0, exponent);
    float occluder = lvsm_sampleSlice(map, filtering, at, 0, float4(empty, empty, empty, empty)).x;
    if (!lvsm_violatesThreshold(occluder, depth, exponent, threshold))
        return lvsm_exponentialShadow(occluder, depth, exponent);
    return lvsm_sampleFourTerms(unfiltered, filtering, at, depth, exponent);
}

float lvsm_sampleEsm(Texture2DArray<float4> map, Texture2DArray<float4> unfiltered, SamplerState filtering,
                     lvsm_MapPoint at, float depth, float exponent, float threshold)
{
    float empty = lvsm_occluderTerm(1.0, exponent);
    float occluder = lvsm_sampleSlice(map, filtering, at, 0, float4(empty, empty, empty, empty)).x;
    if (!lvsm_violatesThreshold(occluder, depth, exponent, threshold))
        return lvsm_exponentialShadow(occluder, depth, exponent);
    return lvsm_sampleFourTerms(unfiltered, filtering, at, depth, exponent);
}

// The greatest depth under all texels that a sample blends: four of level 0 and, where it is minified, four of the
// coarser of its two levels, which hold those of the finer.
// map: of 1 component or more.
float lvsm_greatestDepth(Texture2DArray<float> map, SamplerState filtering, lvsm_MapPoint at)
{
    float greatest = lvsm_maxDepth(lvsm_gatherSlice(map, filtering, at, 0, 1.0));
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float level = ceil(log2(lvsm_levelTexels(at.dx, at.dy, size)) - 0.01);
    if (level < 0.5)
        return greatest;
    float texels = exp2(level);
    float2 levelSize = max(floor((size + 0.5) / texels), 1.0);
    float2 corner = lvsm_firstCorner(at.uv, levelSize);
    lvsm_MapPoint centre = at;
    centre.dx = float2(texels / size.x, 0.0);
    centre.dy = float2(0.0, texels / size.y);
    float4 four = float4(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; ++i)
    {
        centre.uv = (corner + float2(float(i & 1), float(i >> 1)) + 0.5) / levelSize;
        four[i] = lvsm_sampleSlice(map, filtering, centre, 0, float4(1.0, 1.0, 1.0, 1.0)).x;
    }
    return max(greatest, lvsm_maxDepth(four));
}

float lvsm_greatestDepth(Texture2DArray<float2> map, SamplerState filtering, lvsm_MapPoint at)
{
    float greatest = lvsm_maxDepth(lvsm_gatherSlice(map, filtering, at, 0, 1.0));
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float level = ceil(log2(lvsm_levelTexels(at.dx, at.dy, size)) - 0.01);
    if (level < 0.5)
        return greatest;
    float texels = exp2(level);
    float2 levelSize = max(floor((size + 0.5) / texels), 1.0);
    float2 corner = lvsm_firstCorner(at.uv, levelSize);
    lvsm_MapPoint centre = at;
    centre.dx = float2(texels / size.x, 0.0);
    centre.dy = float2(0.0, texels / size.y);
    float4 four = float4(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; ++i)
    {
        centre.uv = (corner + float2(float(i & 1), float(i >> 1)) + 0.5) / levelSize;
        four[i] = lvsm_sampleSlice(map, filtering, centre, 0, float4(1.0, 1.0, 1.0, 1.0)).x;
    }
    return max(greatest, lvsm_maxDepth(four));
}

float lvsm_greatestDepth(Texture2DArray<float4> map, SamplerState filtering, lvsm_MapPoint at)
{
    float greatest = lvsm_maxDepth(lvsm_gatherSlice(map, filtering, at, 0, 1.0));
    float2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float level = ceil(log2(lvsm_levelTexels(at.dx, at.dy, size)) - 0.01);
    if (level < 0.5)
        return greatest;
    float texels = exp2(level);
    float2 levelSize = max(floor((size + 0.5) / texels), 1.0);
    float2 corner = lvsm_firstCorner(at.uv, levelSize);
    lvsm_MapPoint centre = at;
    centre.dx = float2(texels / size.x, 0.0);
    centre.dy = float2(0.0, texels / size.y);
    float4 four = float4(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; ++i)
    {
        centre.uv = (corner + float2(float(i & 1), float(i >> 1)) + 0.5) / levelSize;
        four[i] = lvsm_sampleSlice(map, filtering, centre, 0, float4(1.0, 1.0, 1.0, 1.0)).x;
    }
    return max(greatest, lvsm_maxDepth(four));
}

/// Visibility from an exponential shadow map, with the 2x2 filter where a map of greatest depths finds it at fault.
/// map: of 1 component or more, occluder terms filtered in any way. unfiltered: the terms as they were stored; map
/// itself where it has not been blurred. greatest: of 1 component or more, the greatest depth under map's blur at each
/// texel, by passes/blur with LVSM_BLUR_MAXIMUM, and where map has levels, by passes/mip with LVSM_MIP_MAXIMUM; the
/// depths themselves where map has not been blurred. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// exponent: c as when stored. offset: of violatesZMax, at least by what a lit receiver's plane rises under the filter.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: ESM section 3.3.
float lvsm_sampleEsmZMax(Texture2DArray<float> map, Texture2DArray<float> unfiltered, Texture2DArray<float> greatest,
                         SamplerState filtering, lvsm_MapPoint at, float depth, float exponent, float offset)
{
    if (lvsm_violatesZMax(depth, lvsm_greatestDepth(greatest, filtering, at), offset))
        return lvsm_sampleFourTerms(unfiltered, filtering, at, depth, exponent);
    float empty = lvsm_occluderTerm(1.0, exponent);
    float occluder = lvsm_sampleSlice(map, filtering, at, 0, float4(empty, empty, empty, empty)).x;
    return lvsm_exponentialShadow(occluder, depth, exponent);
}

float lvsm_sampleEsmZMax(Texture2DArray<float2> map, Texture2DArray<float2> unfiltered,
                         Texture2DArray<float2> greatest, SamplerState filtering, lvsm_MapPoint at, float depth,
                         float exponent, float offset)
{
    if (lvsm_violatesZMax(depth, lvsm_greatestDepth(greatest, filtering, at), offset))
        return lvsm_sampleFourTerms(unfiltered, filtering, at, depth, exponent);
    float empty = lvsm_occluderTerm(1.0, exponent);
    float occluder = lvsm_sampleSlice(map, filtering, at, 0, float4(empty, empty, empty, empty)).x;
    return lvsm_exponentialShadow(occluder, depth, exponent);
}

float lvsm_sampleEsmZMax(Texture2DArray<float4> map, Texture2DArray<float4> unfiltered,
                         Texture2DArray<float4> greatest, SamplerState filtering, lvsm_MapPoint at, float depth,
                         float exponent, float offset)
{
    if (lvsm_violatesZMax(depth, lvsm_greatestDepth(greatest, filtering, at), offset))
        return lvsm_sampleFourTerms(unfiltered, filtering, at, depth, exponent);
    float empty = lvsm_occluderTerm(1.0, exponent);
    float occluder = lvsm_sampleSlice(map, filtering, at, 0, float4(empty, empty, empty, empty)).x;
    return lvsm_exponentialShadow(occluder, depth, exponent);
}

#endif
