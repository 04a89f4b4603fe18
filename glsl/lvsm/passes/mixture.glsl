// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, components, mixture, sampling/highp, depth, passes/depths.
// What mixture.comp and mixture.frag share: the block, the mixtures that depths begin with, and how a component lies in
// 128 bits in shared memory and between passes.
//
// mixturePasses and mixtureDraws of include/lvsm/passes_mixture.hpp fill the block and say what to run. Settings, in
// front of this file:
//   #define LVSM_MIXTURE_COUNT 2             two planes in 64 bits; without, four in 128
//   #define LVSM_MIXTURE_FROM_MIXTURES       for all passes but the first: they read mixtures and not depths
//   #define LVSM_MIXTURE_TO_MIXTURES         for all passes but the last: they write mixtures and not codes
#ifndef LVSM_PASSES_MIXTURE_GLSL
#define LVSM_PASSES_MIXTURE_GLSL

#include "../mixture.glsl"
#include "../sampling/highp.glsl"
#include "depths.glsl"

#ifndef LVSM_MIXTURE_COUNT
#define LVSM_MIXTURE_COUNT 4
#endif
#if LVSM_DEPTH_SAMPLES > 1
#error a map of mixtures is made from one depth a texel
#endif

// Where the resources are: define all of these or none, in front of this file. Vulkan's sets go in here, too:
//   #define LVSM_MIXTURE_SOURCE layout(set = 1, binding = 4)
#if defined(LVSM_MIXTURE_SOURCE) != defined(LVSM_MIXTURE_BLOCK)
#error define all of LVSM_MIXTURE_SOURCE, LVSM_MIXTURE_BLOCK and, for mixture.comp, LVSM_MIXTURE_TARGET, or none
#elif !defined(LVSM_MIXTURE_SOURCE) && (__VERSION__ < 310 || !defined(GL_ES) && __VERSION__ < 420)
#define LVSM_MIXTURE_SOURCE
#define LVSM_MIXTURE_BLOCK layout(std140)
#elif !defined(LVSM_MIXTURE_SOURCE)
#define LVSM_MIXTURE_SOURCE layout(binding = 0)
#define LVSM_MIXTURE_TARGET layout(binding = 1)
#define LVSM_MIXTURE_BLOCK layout(binding = 2, std140)
#endif

#ifdef LVSM_MIXTURE_FROM_MIXTURES
#define LVSM_MIXTURE_TEXTURE LVSM_HIGHP usampler2DArray
#else
#define LVSM_MIXTURE_TEXTURE LVSM_DEPTH_TEXTURE
#endif

// MixingBlock of include/lvsm/passes_mixture.hpp.
LVSM_MIXTURE_BLOCK uniform lvsm_Mixing
{
    // First texel and end of the map in the texture of depths.
    ivec4 lvsm_map;
    // First texel and end of what the pass writes, in texels of the codes.
    ivec4 lvsm_region;
    // The texel of the codes that lies at the first texel of the source, and of the target.
    ivec4 lvsm_origins;
    // Of the two rounds of a dispatch, in spacings; of a draw along x and along y. 0 where there is none.
    ivec2 lvsm_steps;
    // Texels from one thread to the next.
    int lvsm_spacing;
    // Of the depths to one of the codes along each axis: 1 or 2.
    int lvsm_texels;
    // Of the window, in texels of the depths.
    float lvsm_deviation;
    // Of the target that takes the codes.
    int lvsm_slice;
    // What each of the outer two texels gets of the window: in the two rounds of a dispatch; in a draw the first.
    vec2 lvsm_shares;
};

// How a component lies in 128 bits. From bit 0: depth 20 and weight 12; place 12 + 12 and correlation 8; slope 16 + 16;
// extents 10 + 10 and deviation 12. Depth is linear and at the coded place, places are linear to 32 texels, weight,
// extents to 32 texels, slope and deviation coded by their square roots. Slope and deviation stand for tilt and variance,
// whose rounding would not cancel.
const float LVSM_PACKED_WEIGHTS = 3072.0;
const float LVSM_PACKED_PLACES = 2047.0;
const float LVSM_PACKED_REACH = 32.0;
const float LVSM_PACKED_CORRELATIONS = 124.0;
const float LVSM_PACKED_SLOPES = 32767.0;
const float LVSM_PACKED_EXTENTS = 1023.0;
const float LVSM_PACKED_DEVIATIONS = 4095.0;
const float LVSM_PACKED_DEPTHS = 1048575.0;

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

uvec4 lvsm_packComponent(lvsm_MixtureComponent c)
{
    vec2 slope = lvsm_componentSlope(c);
    float deviation = sqrt(sqrt(lvsm_componentResidual(c, slope)));
    float correlation = c.spread.y / sqrt(max(c.spread.x * c.spread.z, LVSM_TINY));
    vec2 extent = sqrt(sqrt(c.spread.xz) / LVSM_PACKED_REACH);
    uint x = lvsm_packed(c.place.x / LVSM_PACKED_REACH, LVSM_PACKED_PLACES, LVSM_PACKED_PLACES);
    uint y = lvsm_packed(c.place.y / LVSM_PACKED_REACH, LVSM_PACKED_PLACES, LVSM_PACKED_PLACES);
    vec2 place = (vec2(float(int(x)), float(int(y))) - LVSM_PACKED_PLACES) / LVSM_PACKED_PLACES * LVSM_PACKED_REACH;
    float depth = clamp(c.depth + dot(slope, place - c.place), 0.0, 1.0);
    return uvec4(lvsm_packed(depth, LVSM_PACKED_DEPTHS, 0.0) | (lvsm_packed(sqrt(c.weight), LVSM_PACKED_WEIGHTS, 0.0) << 20u),
                 x | (y << 12u) | (lvsm_packed(correlation, LVSM_PACKED_CORRELATIONS, LVSM_PACKED_CORRELATIONS) << 24u),
                 lvsm_packed(lvsm_signedRoot(slope.x), LVSM_PACKED_SLOPES, LVSM_PACKED_SLOPES) |
                     (lvsm_packed(lvsm_signedRoot(slope.y), LVSM_PACKED_SLOPES, LVSM_PACKED_SLOPES) << 16u),
                 lvsm_packed(extent.x, LVSM_PACKED_EXTENTS, 0.0) | (lvsm_packed(extent.y, LVSM_PACKED_EXTENTS, 0.0) << 10u) |
                     (lvsm_packed(deviation, LVSM_PACKED_DEVIATIONS, 0.0) << 20u));
}

lvsm_MixtureComponent lvsm_unpackComponent(uvec4 bits)
{
    float weight = lvsm_unpacked(bits.x, 20, 4095u, LVSM_PACKED_WEIGHTS, 0.0);
    vec2 place = vec2(lvsm_unpacked(bits.y, 0, 4095u, LVSM_PACKED_PLACES, LVSM_PACKED_PLACES),
                      lvsm_unpacked(bits.y, 12, 4095u, LVSM_PACKED_PLACES, LVSM_PACKED_PLACES));
    vec2 root = vec2(lvsm_unpacked(bits.z, 0, 65535u, LVSM_PACKED_SLOPES, LVSM_PACKED_SLOPES),
                     lvsm_unpacked(bits.z, 16, 65535u, LVSM_PACKED_SLOPES, LVSM_PACKED_SLOPES));
    vec2 extent = vec2(lvsm_unpacked(bits.w, 0, 1023u, LVSM_PACKED_EXTENTS, 0.0),
                       lvsm_unpacked(bits.w, 10, 1023u, LVSM_PACKED_EXTENTS, 0.0));
    extent = LVSM_PACKED_REACH * (extent * extent);
    float deviation = lvsm_unpacked(bits.w, 20, 4095u, LVSM_PACKED_DEVIATIONS, 0.0);
    deviation = deviation * deviation;
    float correlation = lvsm_unpacked(bits.y, 24, 255u, LVSM_PACKED_CORRELATIONS, LVSM_PACKED_CORRELATIONS);
    vec2 slope = root * abs(root);

    lvsm_MixtureComponent c;
    c.weight = weight * weight;
    c.place = LVSM_PACKED_REACH * place;
    c.depth = lvsm_unpacked(bits.x, 0, 1048575u, LVSM_PACKED_DEPTHS, 0.0);
    c.spread = vec3(extent.x * extent.x, correlation * (extent.x * extent.y), extent.y * extent.y);
    // The ridge of componentSlope, so that it finds this slope again.
    float ridge = max(0.5 - 0.5 * c.weight, 0.000244140625);
    vec2 across = vec2(c.spread.x * slope.x + c.spread.y * slope.y, c.spread.y * slope.x + c.spread.z * slope.y);
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

lvsm_Mixture lvsm_unpackMixture(uvec4 components[LVSM_MIXTURE_COUNT])
{
    lvsm_Mixture mixture = lvsm_noMixture();
    for (int i = 0; i < LVSM_MIXTURE_COUNT; ++i)
        mixture.components[i] = lvsm_unpackComponent(components[i]);
    return mixture;
}

// One direction of a round. offset: from the middle to the one after it, in texels of the codes; share: of each outer one.
lvsm_Mixture lvsm_mixThree(uvec4 middle[LVSM_MIXTURE_COUNT], uvec4 before[LVSM_MIXTURE_COUNT],
                           uvec4 after[LVSM_MIXTURE_COUNT], ivec2 offset, float share)
{
    return lvsm_mixtureStep(lvsm_unpackMixture(middle), lvsm_unpackMixture(before), lvsm_unpackMixture(after),
                            vec2(lvsm_texels * offset), share, LVSM_MIXTURE_COUNT);
}

// 64 bits fill the first two words.
uvec4 lvsm_codeOf(lvsm_Mixture mixture)
{
    lvsm_Mixture simple = mixture;
    lvsm_simplifyMixture(simple, LVSM_MIXTURE_COUNT);
#if LVSM_MIXTURE_COUNT == 2
    return uvec4(lvsm_encodeMixture2(simple, lvsm_deviation), 0u, 0u);
#else
    return lvsm_encodeMixture4(simple, lvsm_deviation);
#endif
}

// A texel of the source, in texels of the codes, as packed components.
#ifdef LVSM_MIXTURE_FROM_MIXTURES
void lvsm_readMixture(LVSM_MIXTURE_TEXTURE mixtures, ivec2 texel, out uvec4 components[LVSM_MIXTURE_COUNT])
{
    for (int i = 0; i < LVSM_MIXTURE_COUNT; ++i)
        components[i] = texelFetch(mixtures, ivec3(texel - lvsm_origins.xy, i), 0);
}
#else
// Off the map is no surface, as depth 1 has none.
float lvsm_depthOrEmpty(LVSM_MIXTURE_TEXTURE depths, ivec2 texel)
{
    if (any(lessThan(texel, lvsm_map.xy)) || any(greaterThanEqual(texel, lvsm_map.zw)))
        return 1.0;
    return clamp(lvsm_depthAt(depths, texel, 0), 0.0, 1.0);
}

void lvsm_readMixture(LVSM_MIXTURE_TEXTURE depths, ivec2 texel, out uvec4 components[LVSM_MIXTURE_COUNT])
{
    ivec2 first = lvsm_texels * texel;
    lvsm_Mixture mixture = lvsm_noMixture();
    mixture.components[0] = lvsm_tapComponent(lvsm_depthOrEmpty(depths, first));
    if (lvsm_texels == 2)
    {
        vec4 four = vec4(mixture.components[0].depth, lvsm_depthOrEmpty(depths, first + ivec2(1, 0)),
                         lvsm_depthOrEmpty(depths, first + ivec2(0, 1)), lvsm_depthOrEmpty(depths, first + ivec2(1, 1)));
        mixture = lvsm_mixtureOfTaps(four, vec4(-0.5, 0.5, -0.5, 0.5), vec4(-0.5, -0.5, 0.5, 0.5), LVSM_MIXTURE_COUNT);
    }
    for (int i = 0; i < LVSM_MIXTURE_COUNT; ++i)
        components[i] = lvsm_packComponent(mixture.components[i]);
}
#endif

#endif
