// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, components, mixture, depth, passes/depths.
// Makes a map of mixtures of planes from one texture of depths, linear ones or a depth buffer (see depths.hlsli).
//
// Entry point: lvsm_mixtureCompute makes two rounds of the tree a dispatch, in groupshared memory. mixturePasses of
// include/lvsm/passes_mixture.hpp fills the constant buffer and says how many groups to run. Settings, in front of this
// file:
//   #define LVSM_MIXTURE_COUNT 2             two planes in 64 bits; without, four in 128
//   #define LVSM_MIXTURE_FROM_MIXTURES       for all passes but the first: they read mixtures and not depths
//   #define LVSM_MIXTURE_TO_MIXTURES         for all passes but the last: they write mixtures and not codes
#include "../mixture.hlsli"
#include "depths.hlsli"

#ifndef LVSM_MIXTURE_COUNT
#define LVSM_MIXTURE_COUNT 4
#endif
#if LVSM_DEPTH_SAMPLES > 1
#error a map of mixtures is made from one depth a texel
#endif

// Where the resources are: define all of these or none, in front of this file. The numbers differ, so that they serve as
// Vulkan's bindings too; a space goes in here as well:
//   #define LVSM_MIXTURE_SOURCE t4, space1
#if defined(LVSM_MIXTURE_SOURCE) && defined(LVSM_MIXTURE_TARGET) && defined(LVSM_MIXTURE_BLOCK)
#elif defined(LVSM_MIXTURE_SOURCE) || defined(LVSM_MIXTURE_TARGET) || defined(LVSM_MIXTURE_BLOCK)
#error define all of LVSM_MIXTURE_SOURCE, LVSM_MIXTURE_TARGET and LVSM_MIXTURE_BLOCK, or none
#else
#define LVSM_MIXTURE_SOURCE t0
#define LVSM_MIXTURE_TARGET u1
#define LVSM_MIXTURE_BLOCK b2
#endif

#ifdef LVSM_MIXTURE_FROM_MIXTURES
Texture2DArray<uint4> lvsm_source : register(LVSM_MIXTURE_SOURCE);
#else
LVSM_DEPTH_TEXTURE lvsm_source : register(LVSM_MIXTURE_SOURCE);
#endif
#if LVSM_MIXTURE_COUNT == 2 && !defined(LVSM_MIXTURE_TO_MIXTURES)
RWTexture2DArray<uint2> lvsm_target : register(LVSM_MIXTURE_TARGET);
#else
RWTexture2DArray<uint4> lvsm_target : register(LVSM_MIXTURE_TARGET);
#endif
// MixingBlock of include/lvsm/passes_mixture.hpp.
cbuffer lvsm_Mixing : register(LVSM_MIXTURE_BLOCK)
{
    // First texel and end of the map in the texture of depths.
    int4 lvsm_map;
    // First texel and end of what the pass writes, in texels of the codes.
    int4 lvsm_region;
    // The texel of the codes that lies at the first texel of the source, and of the target.
    int4 lvsm_origins;
    // Of the two rounds of a dispatch, in spacings. 0 where there is none.
    int2 lvsm_steps;
    // Texels from one thread to the next.
    int lvsm_spacing;
    // Of the depths to one of the codes along each axis: 1 or 2.
    int lvsm_texels;
    // Of the window, in texels of the depths.
    float lvsm_deviation;
    // Of the target that takes the codes.
    int lvsm_slice;
    // What each of the outer two texels gets of the window: in the two rounds of a dispatch.
    float2 lvsm_shares;
};

// How a component lies in 128 bits. From bit 0: depth 20 and weight 12; place 12 + 12 and correlation 8; slope 16 + 16;
// extents 10 + 10 and deviation 12. Depth is linear and at the coded place, places are linear to 32 texels, weight,
// extents to 32 texels, slope and deviation coded by their square roots. Slope and deviation stand for tilt and variance,
// whose rounding would not cancel.
static const float LVSM_PACKED_WEIGHTS = 3072.0;
static const float LVSM_PACKED_PLACES = 2047.0;
static const float LVSM_PACKED_REACH = 32.0;
static const float LVSM_PACKED_CORRELATIONS = 124.0;
static const float LVSM_PACKED_SLOPES = 32767.0;
static const float LVSM_PACKED_EXTENTS = 1023.0;
static const float LVSM_PACKED_DEVIATIONS = 4095.0;
static const float LVSM_PACKED_DEPTHS = 1048575.0;

// x in [-1,1] or, with middle 0, in [0,1] as a whole number.
uint lvsm_packed(float x, float levels, float middle)
{
    return uint(int(floor(clamp(x, -1.0, 1.0) * levels + (middle + 0.5))));
}

float lvsm_unpacked(uint bits, int begin, uint mask, float levels, float middle)
{
    return (float(int((bits >> uint(begin)) & mask)) - middle) / levels;
}

float lvsm_signedRoot(float x)
{
    return x < 0.0 ? -sqrt(-x) : sqrt(x);
}

uint4 lvsm_packComponent(lvsm_MixtureComponent c)
{
    float2 slope = lvsm_componentSlope(c);
    float deviation = sqrt(sqrt(lvsm_componentResidual(c, slope)));
    float correlation = c.spread.y / sqrt(max(c.spread.x * c.spread.z, LVSM_TINY));
    float2 extent = sqrt(sqrt(c.spread.xz) / LVSM_PACKED_REACH);
    uint x = lvsm_packed(c.place.x / LVSM_PACKED_REACH, LVSM_PACKED_PLACES, LVSM_PACKED_PLACES);
    uint y = lvsm_packed(c.place.y / LVSM_PACKED_REACH, LVSM_PACKED_PLACES, LVSM_PACKED_PLACES);
    float2 place = (float2(float(int(x)), float(int(y))) - LVSM_PACKED_PLACES) / LVSM_PACKED_PLACES * LVSM_PACKED_REACH;
    float depth = clamp(c.depth + dot(slope, place - c.place), 0.0, 1.0);
    return uint4(lvsm_packed(depth, LVSM_PACKED_DEPTHS, 0.0) | (lvsm_packed(sqrt(c.weight), LVSM_PACKED_WEIGHTS, 0.0) << 20u),
                 x | (y << 12u) | (lvsm_packed(correlation, LVSM_PACKED_CORRELATIONS, LVSM_PACKED_CORRELATIONS) << 24u),
                 lvsm_packed(lvsm_signedRoot(slope.x), LVSM_PACKED_SLOPES, LVSM_PACKED_SLOPES) |
                     (lvsm_packed(lvsm_signedRoot(slope.y), LVSM_PACKED_SLOPES, LVSM_PACKED_SLOPES) << 16u),
                 lvsm_packed(extent.x, LVSM_PACKED_EXTENTS, 0.0) | (lvsm_packed(extent.y, LVSM_PACKED_EXTENTS, 0.0) << 10u) |
                     (lvsm_packed(deviation, LVSM_PACKED_DEVIATIONS, 0.0) << 20u));
}

lvsm_MixtureComponent lvsm_unpackComponent(uint4 bits)
{
    float weight = lvsm_unpacked(bits.x, 20, 4095u, LVSM_PACKED_WEIGHTS, 0.0);
    float2 place = float2(lvsm_unpacked(bits.y, 0, 4095u, LVSM_PACKED_PLACES, LVSM_PACKED_PLACES),
                      lvsm_unpacked(bits.y, 12, 4095u, LVSM_PACKED_PLACES, LVSM_PACKED_PLACES));
    float2 root = float2(lvsm_unpacked(bits.z, 0, 65535u, LVSM_PACKED_SLOPES, LVSM_PACKED_SLOPES),
                     lvsm_unpacked(bits.z, 16, 65535u, LVSM_PACKED_SLOPES, LVSM_PACKED_SLOPES));
    float2 extent = float2(lvsm_unpacked(bits.w, 0, 1023u, LVSM_PACKED_EXTENTS, 0.0),
                       lvsm_unpacked(bits.w, 10, 1023u, LVSM_PACKED_EXTENTS, 0.0));
    extent = LVSM_PACKED_REACH * (extent * extent);
    float deviation = lvsm_unpacked(bits.w, 20, 4095u, LVSM_PACKED_DEVIATIONS, 0.0);
    deviation = deviation * deviation;
    float correlation = lvsm_unpacked(bits.y, 24, 255u, LVSM_PACKED_CORRELATIONS, LVSM_PACKED_CORRELATIONS);
    float2 slope = root * abs(root);

    lvsm_MixtureComponent c;
    c.weight = weight * weight;
    c.place = LVSM_PACKED_REACH * place;
    c.depth = lvsm_unpacked(bits.x, 0, 1048575u, LVSM_PACKED_DEPTHS, 0.0);
    c.spread = float3(extent.x * extent.x, correlation * (extent.x * extent.y), extent.y * extent.y);
    // The ridge of componentSlope, so that it finds this slope again.
    float ridge = max(0.5 - 0.5 * c.weight, 0.000244140625);
    float2 across = float2(c.spread.x * slope.x + c.spread.y * slope.y, c.spread.y * slope.x + c.spread.z * slope.y);
    c.tilt = across + ridge * slope;
    c.variance = deviation * deviation + (dot(slope, across) + 2.0 * ridge * dot(slope, slope));
    return c;
}

lvsm_Mixture lvsm_noMixture()
{
    lvsm_Mixture none;
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
        none.components[i] = lvsm_noComponent();
    return none;
}

lvsm_Mixture lvsm_unpackMixture(uint4 components[LVSM_MIXTURE_COUNT])
{
    lvsm_Mixture mixture = lvsm_noMixture();
    for (int i = 0; i < LVSM_MIXTURE_COUNT; ++i)
        mixture.components[i] = lvsm_unpackComponent(components[i]);
    return mixture;
}

// One direction of a round. offset: from the middle to the one after it, in texels of the codes; share: of each outer one.
lvsm_Mixture lvsm_mixThree(uint4 middle[LVSM_MIXTURE_COUNT], uint4 before[LVSM_MIXTURE_COUNT],
                           uint4 after[LVSM_MIXTURE_COUNT], int2 offset, float share)
{
    return lvsm_mixtureStep(lvsm_unpackMixture(middle), lvsm_unpackMixture(before), lvsm_unpackMixture(after),
                            float2(offset) * float(lvsm_texels), share, LVSM_MIXTURE_COUNT);
}

// 64 bits fill the first two words.
uint4 lvsm_codeOf(lvsm_Mixture mixture)
{
    lvsm_Mixture simple = mixture;
    lvsm_simplifyMixture(simple, LVSM_MIXTURE_COUNT);
#if LVSM_MIXTURE_COUNT == 2
    return uint4(lvsm_encodeMixture2(simple, lvsm_deviation), 0u, 0u);
#else
    return lvsm_encodeMixture4(simple, lvsm_deviation);
#endif
}

// A texel of the source, in texels of the codes, as packed components.
#ifdef LVSM_MIXTURE_FROM_MIXTURES
void lvsm_readMixture(int2 texel, out uint4 components[LVSM_MIXTURE_COUNT])
{
    for (int i = 0; i < LVSM_MIXTURE_COUNT; ++i)
        components[i] = lvsm_source.Load(int4(texel - lvsm_origins.xy, i, 0));
}
#else
// Off the map is no surface, as depth 1 has none.
float lvsm_depthOrEmpty(int2 texel)
{
    if (any(texel < lvsm_map.xy) || any(texel >= lvsm_map.zw))
        return 1.0;
    return clamp(lvsm_depthAt(lvsm_source, texel, 0), 0.0, 1.0);
}

void lvsm_readMixture(int2 texel, out uint4 components[LVSM_MIXTURE_COUNT])
{
    int2 first = lvsm_texels * texel;
    lvsm_Mixture mixture = lvsm_noMixture();
    mixture.components[0] = lvsm_tapComponent(lvsm_depthOrEmpty(first));
    if (lvsm_texels == 2)
    {
        float4 four = float4(mixture.components[0].depth, lvsm_depthOrEmpty(first + int2(1, 0)),
                         lvsm_depthOrEmpty(first + int2(0, 1)), lvsm_depthOrEmpty(first + int2(1, 1)));
        mixture = lvsm_mixtureOfTaps(four, float4(-0.5, 0.5, -0.5, 0.5), float4(-0.5, -0.5, 0.5, 0.5), LVSM_MIXTURE_COUNT);
    }
    for (int i = 0; i < LVSM_MIXTURE_COUNT; ++i)
        components[i] = lvsm_packComponent(mixture.components[i]);
}
#endif

// The group's texels and a halo of three, at most: 12.25 KiB of four components.
static const int LVSM_MIXTURE_TILE = 14;
groupshared uint4 lvsm_tile[LVSM_MIXTURE_TILE * LVSM_MIXTURE_TILE * LVSM_MIXTURE_COUNT];

int lvsm_placeInTile(int2 at)
{
    return (at.y * LVSM_MIXTURE_TILE + at.x) * LVSM_MIXTURE_COUNT;
}

void lvsm_fillTile(int2 first, int side, int thread)
{
    for (int i = thread; i < side * side; i += 64)
    {
        int2 at = int2(i % side, i / side);
        uint4 components[LVSM_MIXTURE_COUNT];
        lvsm_readMixture(first + lvsm_spacing * at, components);
        for (int k = 0; k < LVSM_MIXTURE_COUNT; ++k)
            lvsm_tile[lvsm_placeInTile(at) + k] = components[k];
    }
    GroupMemoryBarrierWithGroupSync();
}

void lvsm_readTile(int2 at, out uint4 components[LVSM_MIXTURE_COUNT])
{
    for (int k = 0; k < LVSM_MIXTURE_COUNT; ++k)
        components[k] = lvsm_tile[lvsm_placeInTile(at) + k];
}

// One direction of a round, in place: a line of texels is read whole by its threads before they write. share: of
// each outer texel. begin, end: of what the tile holds, less in the direction afterwards.
void lvsm_mixTile(int2 along, float share, inout int2 begin, inout int2 end, int thread)
{
    int2 across = int2(1, 1) - min(abs(along), int2(1, 1));
    begin += abs(along);
    end -= abs(along);
    int2 size = end - begin;
    int run = across.x == 0 ? size.x : size.y;
    int lines = across.x == 0 ? size.y : size.x;
    int atOnce = 64 / run;
    for (int done = 0; done < lines; done += atOnce)
    {
        int mine = done + thread / run;
        bool isActive = thread < atOnce * run && mine < lines;
        int2 at = begin + mine * across + (thread % run) * (int2(1, 1) - across);
        lvsm_Mixture mixture = lvsm_noMixture();
        if (isActive)
        {
            uint4 middle[LVSM_MIXTURE_COUNT];
            uint4 before[LVSM_MIXTURE_COUNT];
            uint4 after[LVSM_MIXTURE_COUNT];
            lvsm_readTile(at, middle);
            lvsm_readTile(at - along, before);
            lvsm_readTile(at + along, after);
            mixture = lvsm_mixThree(middle, before, after, lvsm_spacing * along, share);
        }
        GroupMemoryBarrierWithGroupSync();
        for (int k = 0; k < LVSM_MIXTURE_COUNT && isActive; ++k)
            lvsm_tile[lvsm_placeInTile(at) + k] = lvsm_packComponent(mixture.components[k]);
        GroupMemoryBarrierWithGroupSync();
    }
}

void lvsm_writeTexel(int2 at, int2 texel)
{
    if (texel.x >= lvsm_region.z || texel.y >= lvsm_region.w)
        return;
    uint4 components[LVSM_MIXTURE_COUNT];
    lvsm_readTile(at, components);
#ifdef LVSM_MIXTURE_TO_MIXTURES
    for (int k = 0; k < LVSM_MIXTURE_COUNT; ++k)
        lvsm_target[uint3(texel - lvsm_origins.zw, k)] = components[k];
#elif LVSM_MIXTURE_COUNT == 2
    lvsm_target[uint3(texel - lvsm_origins.zw, lvsm_slice)] = lvsm_codeOf(lvsm_unpackMixture(components)).xy;
#else
    lvsm_target[uint3(texel - lvsm_origins.zw, lvsm_slice)] = lvsm_codeOf(lvsm_unpackMixture(components));
#endif
}

[numthreads(8, 8, 1)]
void lvsm_mixtureCompute(uint3 groupId : SV_GroupID, uint3 localId : SV_GroupThreadID)
{
    int2 local = int2(localId.xy);
    int thread = 8 * local.y + local.x;
    int2 group = int2(groupId.xy);
    int2 first = lvsm_region.xy + (group / lvsm_spacing) * (8 * lvsm_spacing) + group % lvsm_spacing;
    int halo = lvsm_steps.x + lvsm_steps.y;
    lvsm_fillTile(first - lvsm_spacing * halo, 8 + 2 * halo, thread);
    int2 begin = int2(0, 0);
    int2 end = int2(8 + 2 * halo, 8 + 2 * halo);
    for (int turn = 0; turn < 4; ++turn)
    {
        int step = turn < 2 ? lvsm_steps.x : lvsm_steps.y;
        float share = turn < 2 ? lvsm_shares.x : lvsm_shares.y;
        if (step > 0)
            lvsm_mixTile((turn & 1) == 0 ? int2(step, 0) : int2(0, step), share, begin, end, thread);
    }
    lvsm_writeTexel(local + halo, first + lvsm_spacing * local);
}
