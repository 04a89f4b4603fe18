// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: lvsm.
// What one texel of a map stores for a depth, for store.comp and store.frag: all layers of any technique from one
// texture of unwarped depths.
// Lauritzen & McCool, Layered Variance Shadow Maps, section 5, the second way to make the layers.
#ifndef LVSM_PASSES_STORE_GLSL
#define LVSM_PASSES_STORE_GLSL

#include "../lvsm.glsl"

layout(binding = 2, std140) uniform lvsm_Store
{
    // The splits 0 to LVSM_MAX_LAYERS, four to a vector.
    vec4 lvsm_splits[(LVSM_MAX_LAYERS + 4) / 4];
    int lvsm_layerCount;
    float lvsm_overlap;
    int lvsm_slice;
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

// What slice number slice of the array holds for a depth: two layers. Define it for another technique, such as
//   #define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, vec2(42.0, 10.0))
#ifndef LVSM_STORE
#define LVSM_STORE(depth, slice) \
    lvsm_packLayers(lvsm_storedLayer(depth, 2 * (slice)), lvsm_storedLayer(depth, 2 * (slice) + 1))
#endif

#endif
