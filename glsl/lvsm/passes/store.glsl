// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm, sampling/highp, config, depth, passes/depths.
// What one texel of a map stores for a depth, for store.comp and store.frag: all layers of any technique from one
// texture of unwarped depths.
// Lauritzen & McCool, Layered Variance Shadow Maps, section 5, the second way to make the layers.
//
// storePass of include/lvsm/passes.hpp fills the block, and says how many groups to run and which rectangle to draw.
#ifndef LVSM_PASSES_STORE_GLSL
#define LVSM_PASSES_STORE_GLSL

#include "../lvsm.glsl"
#include "../sampling/highp.glsl"
#include "depths.glsl"

// Where the resources are: define all of these or none, in front of this file. Vulkan's sets go in here, too:
//   #define LVSM_STORE_DEPTHS layout(set = 1, binding = 4)
#if defined(LVSM_STORE_DEPTHS) != defined(LVSM_STORE_BLOCK)
#error define all of LVSM_STORE_DEPTHS, LVSM_STORE_BLOCK and, for store.comp, LVSM_STORE_TARGET, or none
#elif !defined(LVSM_STORE_DEPTHS) && (__VERSION__ < 310 || !defined(GL_ES) && __VERSION__ < 420)
#define LVSM_STORE_DEPTHS
#define LVSM_STORE_BLOCK layout(std140)
#elif !defined(LVSM_STORE_DEPTHS)
#define LVSM_STORE_DEPTHS layout(binding = 0)
#define LVSM_STORE_TARGET layout(binding = 1)
#define LVSM_STORE_BLOCK layout(binding = 2, std140)
#endif

// StoreBlock of include/lvsm/passes.hpp.
LVSM_STORE_BLOCK uniform lvsm_Store
{
    // First texel and end of what the compute shader writes.
    ivec4 lvsm_region;
    int lvsm_layerCount;
    float lvsm_overlap;
    // The slice of the target where the compute shader begins to write the map.
    int lvsm_firstSlice;
    // The slice of the map that the fragment shader makes.
    int lvsm_slice;
    // The splits 0 to LVSM_MAX_LAYERS, four to a vector.
    vec4 lvsm_splits[(LVSM_MAX_LAYERS + 4) / 4];
};

// Moments of one layer; a layer beyond the last is empty.
vec2 lvsm_storedLayer(float depth, int layer)
{
    if (layer >= min(lvsm_layerCount, LVSM_MAX_LAYERS))
        return vec2(1.0, 1.0);
    float begin = lvsm_splits[layer / 4][layer % 4];
    float end = lvsm_splits[(layer + 1) / 4][(layer + 1) % 4];
    return lvsm_layerMoments(depth, lvsm_layerInterval(begin, end, lvsm_overlap));
}

vec4 lvsm_storedLayers(float depth, int slice)
{
    return lvsm_packLayers(lvsm_storedLayer(depth, 2 * slice), lvsm_storedLayer(depth, 2 * slice + 1));
}

// What slice number slice of the map holds for a depth: two layers, in [0,1], which every format bears. Define it for
// another technique, together with the largest value that the target's format bears: all is clamped to it, so that no
// texel is infinite. In the target's default format, rgba16f, exponents end at 5.545:
//   #define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, vec2(5.54, 5.54))
//   #define LVSM_STORE_LARGEST LVSM_LARGEST_FP16
// and in 32 bits at 43.32:
//   #define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, vec2(42.0, 10.0))
//   #define LVSM_STORE_LARGEST LVSM_LARGEST_FP32
//   #define LVSM_STORE_FORMAT rgba32f
#ifndef LVSM_STORE
#define LVSM_STORE(depth, slice) lvsm_storedLayers(depth, slice)
#define LVSM_STORE_LARGEST 1.0
#elif !defined(LVSM_STORE_LARGEST)
#error define LVSM_STORE_LARGEST together with LVSM_STORE: the largest value that the format of the target bears
#endif

vec4 lvsm_storedTexel(float depth, int slice)
{
    return clamp(LVSM_STORE(depth, slice), -LVSM_STORE_LARGEST, LVSM_STORE_LARGEST);
}

// The texel of a map: what is stored, filtered over the samples of a multisampled texture. Where LVSM_STORE_SLOPED is
// defined, it is stored instead, with the change of depth to the next texel that the four neighbours show:
//   #define LVSM_STORE_SLOPED(depth, slope, slice) vec4(lvsm_depthMomentsSloped(depth, slope.x, slope.y), 0.0, 0.0)
vec4 lvsm_storedFrom(LVSM_DEPTH_TEXTURE depths, ivec2 texel, int slice)
{
    vec4 sum = vec4(0.0);
    for (int i = 0; i < LVSM_DEPTH_SAMPLES; ++i)
    {
        float depth = lvsm_depthAt(depths, texel, i);
#ifdef LVSM_STORE_SLOPED
        vec4 stored = LVSM_STORE_SLOPED(depth, lvsm_slopeAt(depths, texel, i, lvsm_region), slice);
        stored = clamp(stored, -LVSM_STORE_LARGEST, LVSM_STORE_LARGEST);
#else
        vec4 stored = lvsm_storedTexel(depth, slice);
#endif
        sum += stored / float(LVSM_DEPTH_SAMPLES);
    }
    return sum;
}

#endif
