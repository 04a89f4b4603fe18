// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/highp.
// One texel of a separable blur, for blur.comp and blur.frag.
//
// The kernel comes from the host: blurPasses of include/lvsm/passes.hpp fills the block for both directions, and says
// how many groups to run and which rectangle to draw. What is off the map is empty, as sampling/common.glsl has it.
// The map's sampler filters linearly, which 16-bit formats allow everywhere; a kernel that is not paired does without.
#ifndef LVSM_PASSES_BLUR_GLSL
#define LVSM_PASSES_BLUR_GLSL

#include "../sampling/highp.glsl"

// Where the resources are: define all of these or none, in front of this file. Vulkan's sets go in here, too:
//   #define LVSM_BLUR_SOURCE layout(set = 1, binding = 4)
#if defined(LVSM_BLUR_SOURCE) != defined(LVSM_BLUR_BLOCK)
#error define all of LVSM_BLUR_SOURCE, LVSM_BLUR_BLOCK and, for blur.comp, LVSM_BLUR_TARGET, or none
#elif !defined(LVSM_BLUR_SOURCE) && (__VERSION__ < 310 || !defined(GL_ES) && __VERSION__ < 420)
#define LVSM_BLUR_SOURCE
#define LVSM_BLUR_BLOCK layout(std140)
#elif !defined(LVSM_BLUR_SOURCE)
#define LVSM_BLUR_SOURCE layout(binding = 0)
#define LVSM_BLUR_TARGET layout(binding = 1)
#define LVSM_BLUR_BLOCK layout(binding = 2, std140)
#endif

// How many fetches a texel takes; a constant, which has to be that of the kernel, lets the compiler unroll them:
//   #define LVSM_BLUR_FETCHES 5
#ifndef LVSM_BLUR_FETCHES
#define LVSM_BLUR_FETCHES lvsm_fetchCount
#endif

// BlurBlock of include/lvsm/passes.hpp.
LVSM_BLUR_BLOCK uniform lvsm_Blur
{
    // What an empty texel holds.
    vec4 lvsm_border;
    // First texel and end of the map: a whole texture, or its rectangle of an atlas.
    ivec4 lvsm_map;
    // First texel and end of what the compute shader writes.
    ivec4 lvsm_region;
    // (1, 0) or (0, 1).
    vec2 lvsm_direction;
    // The slice that is blurred; for the compute shader the first one.
    int lvsm_slice;
    int lvsm_fetchCount;
    // Offset in texels and weight of two fetches each.
    vec4 lvsm_taps[33];
};

vec2 lvsm_blurTap(int fetch)
{
    vec4 two = lvsm_taps[fetch >> 1];
    return (fetch & 1) == 0 ? two.xy : two.zw;
}

vec4 lvsm_blurredTexel(LVSM_HIGHP sampler2DArray source, ivec3 texel)
{
    vec2 texelSize = 1.0 / vec2(textureSize(source, 0).xy);
    // Along the direction of the blur; across it the texel's own centre.
    vec2 centre = vec2(texel.xy) + 0.5;
    float at = dot(centre, lvsm_direction);
    float first = dot(vec2(lvsm_map.xy), lvsm_direction) + 0.5;
    float last = dot(vec2(lvsm_map.zw), lvsm_direction) - 0.5;
    vec2 origin = (centre - at * lvsm_direction) * texelSize;
    vec2 along = lvsm_direction * texelSize;
    vec4 sum = vec4(0.0);
    // No tap reaches farther than there are fetches.
    float reach = float(LVSM_BLUR_FETCHES);
    if (at - reach > first && at + reach < last)
    {
        for (int fetch = 0; fetch < LVSM_BLUR_FETCHES; ++fetch)
        {
            vec2 tap = lvsm_blurTap(fetch);
            sum += tap.y * textureLod(source, vec3(origin + (at + tap.x) * along, float(texel.z)), 0.0);
        }
        return sum;
    }
    // At the edge, border takes what weight of a fetch is off the map.
    float empty = 0.0;
    for (int fetch = 0; fetch < lvsm_fetchCount; ++fetch)
    {
        vec2 tap = lvsm_blurTap(fetch);
        float inside = clamp(at + tap.x, first, last);
        float off = tap.y * min(abs(at + tap.x - inside), 1.0);
        sum += (tap.y - off) * textureLod(source, vec3(origin + inside * along, float(texel.z)), 0.0);
        empty += off;
    }
    return sum + empty * lvsm_border;
}

// Where LVSM_BLUR_MAXIMUM is defined, the passes find the largest of the texels under the kernel, each component for
// itself, as the Z-Max test of ESM needs. The kernel is not paired, such as boxKernel(5, false), and its weights are not
// read.
vec4 lvsm_largestTexel(LVSM_HIGHP sampler2DArray source, ivec3 texel)
{
    vec4 largest = lvsm_border;
    for (int fetch = 0; fetch < LVSM_BLUR_FETCHES; ++fetch)
    {
        ivec2 place = texel.xy + ivec2(lvsm_blurTap(fetch).x * lvsm_direction);
        bool isOn = all(greaterThanEqual(place, lvsm_map.xy)) && all(lessThan(place, lvsm_map.zw));
        vec4 found = isOn ? texelFetch(source, ivec3(place, texel.z), 0) : lvsm_border;
        largest = fetch == 0 ? found : max(largest, found);
    }
    return largest;
}

#ifdef LVSM_BLUR_MAXIMUM
#define LVSM_BLUR_TEXEL lvsm_largestTexel
#else
#define LVSM_BLUR_TEXEL lvsm_blurredTexel
#endif

#endif
