// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter.
// Percentage-closer filtering: the depth comparison first, the filter after it.
// Reeves, Salesin & Cook, Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987.
//
// A filter of N x N texels: start from (0, 0), pcfAdd the texels four at a time with the weights of the filter topic
// (a Gaussian's, or boxWeight of each texel's offset for a box of any width), and end with pcfVisibility. A slanted
// receiver needs a bias for each texel: pass planeDepth of the receiver topic at each, the receiver-plane depth bias.

/// Plain shadow test of one texel.
/// occluder: depth in the map. depth: the receiver's, clamped to [0,1]. bias: what the receiver is moved towards the
/// light, clamped to [-1,1]. Result in [0,1]: 1 where the receiver is not behind the occluder, else 0.
/// Source: Williams, Casting Curved Shadows on Curved Surfaces, SIGGRAPH 1978.
fn lvsm_depthTest(occluder: f32, depth: f32, bias: f32) -> f32
{
    return select(0.0, 1.0, clamp(depth, 0.0, 1.0) - clamp(bias, -1.0, 1.0) <= occluder);
}

// The plain test of four texels.
fn lvsm_depthTests(depths: vec4f, receivers: vec4f, bias: f32) -> vec4f
{
    return vec4f(lvsm_depthTest(depths.x, receivers.x, bias), lvsm_depthTest(depths.y, receivers.y, bias),
                 lvsm_depthTest(depths.z, receivers.z, bias), lvsm_depthTest(depths.w, receivers.w, bias));
}

/// Percentage-closer filtering over 2 x 2 texels, continuous in the receiver's position.
/// depths: of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy. fraction: position between the
/// centres of the first and the last, each component clamped to [0,1].
/// receivers: depth of the receiver at each texel, clamped to [0,1]: one depth for all, or that of its plane.
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result in [0,1].
/// Source: Reeves et al. 1987, with bilinear weights.
fn lvsm_pcfBilinear(depths: vec4f, fraction: vec2f, receivers: vec4f, bias: f32) -> f32
{
    return lvsm_bilinearVisibility(lvsm_depthTests(depths, receivers, bias), fraction);
}

/// Four more texels of a percentage-closer filter of any shape and size.
/// sum: (weight that is lit, weight of all) so far, (0, 0) at first, each clamped to [0, 2^125].
/// depths: of four texels. weights: theirs in the same order, each clamped to [0, 2^122].
/// receivers: depth of the receiver at each texel, clamped to [0,1]: one depth for all, or that of its plane.
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result: both sums, in [0, 2^126].
/// Source: Reeves et al. 1987.
fn lvsm_pcfAdd(sum: vec2f, depths: vec4f, weights: vec4f, receivers: vec4f, bias: f32) -> vec2f
{
    let s = clamp(sum, vec2f(0.0), vec2f(0.5 * LVSM_HUGE));
    let w = clamp(weights, vec4f(0.0), vec4f(0.0625 * LVSM_HUGE));
    let lit = w * lvsm_depthTests(depths, receivers, bias);
    return s + vec2f(lit.x + lit.y + lit.z + lit.w, w.x + w.y + w.z + w.w);
}

/// Visibility from the sums of pcfAdd.
/// sum: (weight that is lit, weight of all). Result in [0,1]: their ratio.
/// Degenerate: no weight at all (under 2^-126) is lit.
/// Source: Reeves et al. 1987.
fn lvsm_pcfVisibility(sum: vec2f) -> f32
{
    let all = min(sum.y, LVSM_HUGE);
    return select(clamp(sum.x / all, 0.0, 1.0), 1.0, all < LVSM_TINY);
}
