// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter.
// Percentage-closer filtering: the depth comparison first, the filter after it.
// Reeves, Salesin & Cook, Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987.
//
// A filter of N x N texels: start from (0, 0), pcfAdd the texels four at a time with the weights of the filter topic
// (a Gaussian's, or boxWeight of each texel's offset for a box of any width), and end with pcfVisibility. A slanted
// receiver needs a bias for each texel: pass planeDepth of the receiver topic at each, the receiver-plane depth bias.
#ifndef LVSM_PCF_GLSL
#define LVSM_PCF_GLSL

#include "filter.glsl"

/// Plain shadow test of one texel.
/// occluder: depth in the map. depth: the receiver's, clamped to [0,1]. bias: what the receiver is moved towards the
/// light, clamped to [-1,1]. Result in [0,1]: 1 where the receiver is not behind the occluder, else 0.
/// Source: Williams, Casting Curved Shadows on Curved Surfaces, SIGGRAPH 1978.
float lvsm_depthTest(float occluder, float depth, float bias)
{
    return clamp(depth, 0.0, 1.0) - clamp(bias, -1.0, 1.0) <= occluder ? 1.0 : 0.0;
}

// The plain test of four texels.
vec4 lvsm_depthTests(vec4 depths, vec4 receivers, float bias)
{
    return vec4(lvsm_depthTest(depths.x, receivers.x, bias), lvsm_depthTest(depths.y, receivers.y, bias),
                lvsm_depthTest(depths.z, receivers.z, bias), lvsm_depthTest(depths.w, receivers.w, bias));
}

/// Percentage-closer filtering over 2 x 2 texels, continuous in the receiver's position.
/// depths: of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy. fraction: position between the
/// centres of the first and the last, each component clamped to [0,1].
/// receivers: depth of the receiver at each texel, clamped to [0,1]: one depth for all, or that of its plane.
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result in [0,1].
/// Source: Reeves et al. 1987, with bilinear weights.
float lvsm_pcfBilinear(vec4 depths, vec2 fraction, vec4 receivers, float bias)
{
    return lvsm_bilinearVisibility(lvsm_depthTests(depths, receivers, bias), fraction);
}

/// Four more texels of a percentage-closer filter of any shape and size.
/// sum: (weight that is lit, weight of all) so far, (0, 0) at first, each clamped to [0, 2^125].
/// depths: of four texels. weights: theirs in the same order, each clamped to [0, 2^122].
/// receivers: depth of the receiver at each texel, clamped to [0,1]: one depth for all, or that of its plane.
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result: both sums, in [0, 2^126].
/// Source: Reeves et al. 1987.
vec2 lvsm_pcfAdd(vec2 sum, vec4 depths, vec4 weights, vec4 receivers, float bias)
{
    vec2 s = clamp(sum, 0.0, 0.5 * LVSM_HUGE);
    vec4 w = clamp(weights, 0.0, 0.0625 * LVSM_HUGE);
    vec4 lit = w * lvsm_depthTests(depths, receivers, bias);
    return s + vec2(lit.x + lit.y + lit.z + lit.w, w.x + w.y + w.z + w.w);
}

/// Visibility from the sums of pcfAdd.
/// sum: (weight that is lit, weight of all). Result in [0,1]: their ratio.
/// Degenerate: no weight at all (under 2^-126) is lit.
/// Source: Reeves et al. 1987.
float lvsm_pcfVisibility(vec2 sum)
{
    float all = min(sum.y, LVSM_HUGE);
    return all < LVSM_TINY ? 1.0 : clamp(sum.x / all, 0.0, 1.0);
}

#endif
