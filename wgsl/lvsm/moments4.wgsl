// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers.
// Moment shadow maps: four moments of depth and the sharp bound they give.
// Peters & Klein, Moment Shadow Mapping, I3D 2015; Peters, Muenstermann, Wetzstein & Klein, Improved Moment Shadow Maps
// for Translucent Occluders, Soft Shadows and Single Scattering, JCGT 6(1), 2017 (JCGT below).
//
// The moments are those of the depth remapped to [-1,1], as in JCGT, where they lose the least to rounding. Store them
// as they are in fp32, or in the basis of encodeMoments4 in unorm16.

// Bias that makes up for the rounding of a storage format, as published. Source: JCGT section 2. It is what
// recommendedMoment4Bias gives for 1.6 roundings to unorm16, and for 0.9 roundings of the plain moments to fp32.
const LVSM_MOMENT4_BIAS_UNORM16: f32 = 6.0e-5;
const LVSM_MOMENT4_BIAS_FP32: f32 = 3.0e-7;

/// Least bias with which rounding never makes the moments of a window invalid, so that their bound stays a bound.
/// encodedError: largest error of a stored component of encodeMoments4, in [0,1], clamped to it; half a step of unorm,
/// times one and the number of blurs that round again. For plain moments pass 2.385 times their error.
/// Result in [0,1].
/// Source: bias H(w) + H(error) has no negative eigenvalue, for H the Hankel matrix, w = (0, 0.63, 0, 0.63), and any
/// error of that size.
fn lvsm_recommendedMoment4Bias(encodedError: f32) -> f32
{
    return min(4.865 * clamp(encodedError, 0.0, 1.0), 1.0);
}

/// Four moments to store for one depth: the powers of the depth remapped to [-1,1].
/// depth: in [0,1], clamped to it. Result: (x, x^2, x^3, x^4), each in [-1,1].
/// A texel without any surface stores depth 1: (1, 1, 1, 1).
/// Source: JCGT section 2.
fn lvsm_depthMoments4(depth: f32) -> vec4f
{
    let x = lvsm_signedDepth(depth);
    let squared = x * x;
    return vec4f(x, squared, squared * x, squared * squared);
}

// Nearest to arbitrary moments in the box that holds all valid ones.
fn lvsm_boxedMoments4(moments: vec4f) -> vec4f
{
    return clamp(moments, vec4f(-1.0, 0.0, -1.0, 0.0), vec4f(1.0, 1.0, 1.0, 1.0));
}

/// Four moments in the basis that loses least to 16 bits.
/// moments: as depthMoments4 made them, filtered or not. Result: each in [0,1] and filtered as linearly as the moments.
/// A texel without any surface stores (0, 0, 0.98112522, 1).
/// Source: JCGT section 2, the optimised quantisation transform.
fn lvsm_encodeMoments4(moments: vec4f) -> vec4f
{
    let b = lvsm_boxedMoments4(moments);
    let encoded = vec4f(1.5 * b.x - 2.0 * b.z + 0.5,
                        4.0 * (b.y - b.w),
                        0.866025404 * b.x - 0.384900179 * b.z + 0.5,
                        0.5 * (b.y + b.w));
    return clamp(encoded, vec4f(0.0), vec4f(1.0));
}

/// Four moments out of the basis that loses least to 16 bits.
/// encoded: as encodeMoments4 made it, filtered. Result: four moments, each in [-1,1].
/// Source: JCGT section 2, the inverse of the optimised quantisation transform.
fn lvsm_decodeMoments4(encoded: vec4f) -> vec4f
{
    let odd = encoded.xz - 0.5;
    return lvsm_boxedMoments4(vec4f(1.73205081 * odd.y - 0.333333333 * odd.x,
                                    encoded.w + 0.125 * encoded.y,
                                    1.29903811 * odd.y - 0.75 * odd.x,
                                    encoded.w - 0.125 * encoded.y));
}

// The orthogonal polynomials of a distribution with four moments, in y = x - mean: 1, y and P(y) = y^2 - skew y - v,
// of norms 1, v and d. They are what the LDL^T decomposition of the Hankel matrix holds. The moments are first mixed
// with a share (the bias) of moments far from the boundary of the valid ones. Result: (mean, v, skew, d).
// The skew of a distribution on [-1,1] is at most 2. The mixed-in share alone brings v to 0.63 bias and d to
// (0.63 - 0.63^2) bias: what is less is rounding. The constants keep products normal floats where there is no bias.
fn lvsm_orthogonalise(moments: vec4f, bias: f32) -> vec4f
{
    let share = clamp(bias, 0.0, 1.0);
    let valid = lvsm_boxedMoments4(moments);
    let b = valid + share * (vec4f(0.0, 0.63, 0.0, 0.63) - valid);
    let v = max(max(b.y - b.x * b.x, 0.63 * share), 9.09494702e-13);
    let e = b.z - b.x * b.y;
    let slope = e / v;
    let norm = (b.w - b.y * b.y) - e * slope;
    let least = max(0.2331 * share, 8.67361738e-19);
    return vec4f(b.x, v, clamp(slope - (b.x + b.x), -2.0, 2.0), clamp(norm, least, 1.0));
}

// The most mass that such a distribution can have at a single y: one over the sum of the squared polynomials there.
// p: the value of P there.
fn lvsm_largestMass(basis: vec4f, y: f32, p: f32) -> f32
{
    let others = basis.w * y * y + basis.y * p * p;
    return basis.y * basis.w / (basis.y * basis.w + others);
}

// The bound of hamburgerUpperBound for a distribution with this basis.
fn lvsm_boundOfBasis(basis: vec4f, t: f32) -> f32
{
    let v = basis.y;
    let d = basis.w;
    let y = clamp(t, -1.0, 1.0) - basis.x;
    let p = y * y - basis.z * y - v;
    let mass = clamp(lvsm_largestMass(basis, y, p), 0.0, 1.0);

    // Where P is negative at t, there is a root on each side of it. In p x^2 + 2 middle x + (d - v p) nothing cancels.
    let middle = 0.5 * (d * y / v - basis.z * p);
    let root = sqrt(max(middle * middle - p * (d - v * p), LVSM_TINY));
    let skewed = (mass * y * p - (1.0 - mass) * middle) / root;
    let between = clamp(0.5 * (1.0 + mass + skewed), 0.0, 1.0);
    return select(select(1.0, mass, y > 0.0), between, p < 0.0);
}

/// Upper bound on the share of the filter window that is at depth t or farther, from four moments.
/// moments: as depthMoments4 made them, filtered. t: the receiver's depth remapped to [-1,1], clamped to it.
/// bias: share of moments of a wide distribution that is mixed in against rounding, in [0,1], see the LVSM_MOMENT4_BIAS
/// constants. Result in [0,1]. Exact for up to two occluder depths and the receiver's, but for the bias.
/// Degenerate: moments that no distribution has are moved to the boundary of those that are.
/// Source: Peters & Klein 2015, algorithm 3 (the bound of the Hamburger moment problem), in terms of the orthogonal
/// polynomials: the distribution that meets the bound has an atom at t and two at the roots of the kernel polynomial.
fn lvsm_hamburgerUpperBound(moments: vec4f, t: f32, bias: f32) -> f32
{
    return lvsm_boundOfBasis(lvsm_orthogonalise(moments, bias), t);
}

/// Visibility of a receiver from four moments (MSM4): an upper bound on the lit share of the filter window.
/// moments: as depthMoments4 made them, filtered. depth: the receiver's, in [0,1].
/// bias: as hamburgerUpperBound takes it. Result in [0,1].
/// Source: JCGT section 2.
fn lvsm_momentVisibility4(moments: vec4f, depth: f32, bias: f32) -> f32
{
    return lvsm_hamburgerUpperBound(moments, 2.0 * depth - 1.0, bias);
}

/// Four moments to store in a layer for one depth.
/// depth: in [0,1]. interval: begin and end of the layer. Result: four moments of the warped depth, each in [-1,1].
/// A texel without any surface stores depth 1: (1, 1, 1, 1) in every layer.
/// Source: depthMoments4 of LVSM equation 6.
fn lvsm_layerMoments4(depth: f32, interval: vec2f) -> vec4f
{
    return lvsm_depthMoments4(lvsm_layerWarp(depth, interval));
}

/// Visibility of a receiver from the four moments of one layer: an upper bound on the lit share of the filter window.
/// moments: of the layer, filtered. depth: the receiver's, in [0,1]. interval: begin and end of the layer.
/// bias: as hamburgerUpperBound takes it. Result in [0,1].
/// Source: hamburgerUpperBound in the warp of LVSM equation 6.
fn lvsm_layeredVisibility4(moments: vec4f, depth: f32, interval: vec2f, bias: f32) -> f32
{
    return lvsm_momentVisibility4(moments, lvsm_layerWarp(depth, interval), bias);
}

// Share of the window that is not at an end of the layer, end = -1 or 1, at least; what the bias mixed in is no share.
fn lvsm_shareOffEnd(moments: vec4f, end: f32, bias: f32) -> f32
{
    let basis = lvsm_orthogonalise(moments, bias);
    let y = end - basis.x;
    let mass = lvsm_largestMass(basis, y, y * y - basis.z * y - basis.y);
    return clamp(1.0 - mass - bias, 0.0, 1.0);
}

/// Visibility of a receiver from the four moments of its layer and of the two neighbours.
/// front: of the layer in front, filtered, (1, 1, 1, 1) for the first layer. moments: of the layer.
/// behind: of the layer behind it, (-1, 1, -1, 1) for the last layer. depth: the receiver's, in [0,1].
/// interval: begin and end of the layer, which holds the receiver. bias: as hamburgerUpperBound takes it.
/// Result in [0,1], an upper bound on the lit share of the window for layers without overlap, but for rounding.
/// Source: the largest mass that four moments allow at the end of each neighbour, and hamburgerUpperBound for what is
/// left in the layer, see bracketMoments.
fn lvsm_bracketedVisibility4(front: vec4f, moments: vec4f, behind: vec4f, depth: f32, interval: vec2f, bias: f32) -> f32
{
    let share = clamp(bias, 0.0, 1.0);
    let b = lvsm_boxedMoments4(moments);
    // No more at an end than the first two moments allow.
    let mean = 0.5 + 0.5 * b.x;
    let dark = min(lvsm_shareOffEnd(front, 1.0, share), 1.0 - mean);
    let lit = min(lvsm_shareOffEnd(behind, -1.0, share), clamp(0.25 + 0.5 * b.x + 0.25 * b.y, 0.0, mean));
    let left = clamp(1.0 - dark - lit, 0.0, 1.0);
    let inverse = 1.0 / max(left, LVSM_TINY);
    let rest = (b + vec4f(dark, -dark, dark, -dark) - lit) * inverse;
    // Rounding errors grow as the share that is left shrinks, and the bias with them.
    let bound = lvsm_momentVisibility4(rest, lvsm_layerWarp(depth, interval), share * inverse);
    return clamp(lit + left * bound, 0.0, 1.0);
}
