// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers.
// Moment shadow maps: four moments of depth and the sharp bound they give.
// Peters & Klein, Moment Shadow Mapping, I3D 2015; Peters, Muenstermann, Wetzstein & Klein, Improved Moment Shadow Maps
// for Translucent Occluders, Soft Shadows and Single Scattering, JCGT 6(1), 2017 (JCGT below).
//
// The moments are those of the depth remapped to [-1,1], as in JCGT, where they lose the least to rounding. Store them
// as they are in fp32, or in the basis of encodeMoments4 in unorm16.
#ifndef LVSM_MOMENTS4_GLSL
#define LVSM_MOMENTS4_GLSL

#include "layers.glsl"

// Bias that makes up for the rounding of a storage format, as published. Source: JCGT section 2. It is what
// recommendedMoment4Bias gives for 1.6 roundings to unorm16, and for 0.9 roundings of the plain moments to fp32.
const float LVSM_MOMENT4_BIAS_UNORM16 = 6.0e-5;
const float LVSM_MOMENT4_BIAS_FP32 = 3.0e-7;

/// Least bias with which rounding never makes the moments of a window invalid, so that their bound stays a bound.
/// encodedError: largest error of a stored component of encodeMoments4, in [0,1], clamped to it; half a step of unorm,
/// times one and the number of blurs that round again. For plain moments pass 2.385 times their error.
/// Result in [0,1].
/// Source: bias H(w) + H(error) has no negative eigenvalue, for H the Hankel matrix, w = (0, 0.63, 0, 0.63), and any
/// error of that size.
float lvsm_recommendedMoment4Bias(float encodedError)
{
    return min(4.865 * clamp(encodedError, 0.0, 1.0), 1.0);
}

/// Four moments to store for one depth: the powers of the depth remapped to [-1,1].
/// depth: in [0,1], clamped to it. Result: (x, x^2, x^3, x^4), each in [-1,1].
/// A texel without any surface stores depth 1: (1, 1, 1, 1).
/// Source: JCGT section 2.
vec4 lvsm_depthMoments4(float depth)
{
    float x = lvsm_signedDepth(depth);
    float squared = x * x;
    return vec4(x, squared, squared * x, squared * squared);
}

// Nearest to arbitrary moments in the box that holds all valid ones.
vec4 lvsm_boxedMoments4(vec4 moments)
{
    return clamp(moments, vec4(-1.0, 0.0, -1.0, 0.0), vec4(1.0, 1.0, 1.0, 1.0));
}

/// Four moments in the basis that loses least to 16 bits.
/// moments: as depthMoments4 made them, filtered or not. Result: each in [0,1] and filtered as linearly as the moments.
/// A texel without any surface stores (0, 0, 0.98112522, 1).
/// Source: JCGT section 2, the optimised quantisation transform.
vec4 lvsm_encodeMoments4(vec4 moments)
{
    vec4 b = lvsm_boxedMoments4(moments);
    LVSM_PRECISE vec4 encoded = vec4(1.5 * b.x - 2.0 * b.z + 0.5,
                                     4.0 * (b.y - b.w),
                                     0.866025404 * b.x - 0.384900179 * b.z + 0.5,
                                     0.5 * (b.y + b.w));
    return clamp(encoded, 0.0, 1.0);
}

/// Four moments out of the basis that loses least to 16 bits.
/// encoded: as encodeMoments4 made it, filtered. Result: four moments, each in [-1,1].
/// Source: JCGT section 2, the inverse of the optimised quantisation transform.
vec4 lvsm_decodeMoments4(vec4 encoded)
{
    vec2 odd = encoded.xz - 0.5;
    return lvsm_boxedMoments4(vec4(1.73205081 * odd.y - 0.333333333 * odd.x,
                                   encoded.w + 0.125 * encoded.y,
                                   1.29903811 * odd.y - 0.75 * odd.x,
                                   encoded.w - 0.125 * encoded.y));
}

// The orthogonal polynomials of a distribution with four moments, in y = x - mean: 1, y and P(y) = y^2 - skew y - v,
// of norms 1, v and d. They are what the LDL^T decomposition of the Hankel matrix holds. The moments are first mixed
// with a share (the bias) of moments far from the boundary of the valid ones. Result: (mean, v, skew, d).
// The skew of a distribution on [-1,1] is at most 2. The mixed-in share alone brings v to 0.63 bias and d to
// (0.63 - 0.63^2) bias: what is less is rounding. The constants keep products normal floats where there is no bias.
vec4 lvsm_orthogonalise(vec4 moments, float bias)
{
    float share = clamp(bias, 0.0, 1.0);
    vec4 valid = lvsm_boxedMoments4(moments);
    vec4 b = valid + share * (vec4(0.0, 0.63, 0.0, 0.63) - valid);
    float v = max(max(b.y - b.x * b.x, 0.63 * share), 9.09494702e-13);
    float e = b.z - b.x * b.y;
    float slope = e / v;
    float norm = (b.w - b.y * b.y) - e * slope;
    float least = max(0.2331 * share, 8.67361738e-19);
    return vec4(b.x, v, clamp(slope - (b.x + b.x), -2.0, 2.0), clamp(norm, least, 1.0));
}

// The most mass that such a distribution can have at a single y: one over the sum of the squared polynomials there.
// p: the value of P there.
float lvsm_largestMass(vec4 basis, float y, float p)
{
    float others = basis.w * y * y + basis.y * p * p;
    return basis.y * basis.w / (basis.y * basis.w + others);
}

// The bound of hamburgerUpperBound for a distribution with this basis.
float lvsm_boundOfBasis(vec4 basis, float t)
{
    float v = basis.y;
    float d = basis.w;
    float y = clamp(t, -1.0, 1.0) - basis.x;
    float p = y * y - basis.z * y - v;
    float mass = clamp(lvsm_largestMass(basis, y, p), 0.0, 1.0);

    // Where P is negative at t, there is a root on each side of it. In p x^2 + 2 middle x + (d - v p) nothing cancels.
    float middle = 0.5 * (d * y / v - basis.z * p);
    float root = sqrt(max(middle * middle - p * (d - v * p), LVSM_TINY));
    float skewed = (mass * y * p - (1.0 - mass) * middle) / root;
    float between = clamp(0.5 * (1.0 + mass + skewed), 0.0, 1.0);
    return p < 0.0 ? between : y > 0.0 ? mass : 1.0;
}

/// Upper bound on the share of the filter window that is at depth t or farther, from four moments.
/// moments: as depthMoments4 made them, filtered. t: the receiver's depth remapped to [-1,1], clamped to it.
/// bias: share of moments of a wide distribution that is mixed in against rounding, in [0,1], see the LVSM_MOMENT4_BIAS
/// constants. Result in [0,1]. Exact for up to two occluder depths and the receiver's, but for the bias.
/// Degenerate: moments that no distribution has are moved to the boundary of those that are.
/// Source: Peters & Klein 2015, algorithm 3 (the bound of the Hamburger moment problem), in terms of the orthogonal
/// polynomials: the distribution that meets the bound has an atom at t and two at the roots of the kernel polynomial.
float lvsm_hamburgerUpperBound(vec4 moments, float t, float bias)
{
    return lvsm_boundOfBasis(lvsm_orthogonalise(moments, bias), t);
}

/// Visibility of a receiver from four moments (MSM4): an upper bound on the lit share of the filter window.
/// moments: as depthMoments4 made them, filtered. depth: the receiver's, in [0,1].
/// bias: as hamburgerUpperBound takes it. Result in [0,1].
/// Source: JCGT section 2.
float lvsm_momentVisibility4(vec4 moments, float depth, float bias)
{
    return lvsm_hamburgerUpperBound(moments, 2.0 * depth - 1.0, bias);
}

/// Four moments to store in a layer for one depth.
/// depth: in [0,1]. interval: begin and end of the layer. Result: four moments of the warped depth, each in [-1,1].
/// A texel without any surface stores depth 1: (1, 1, 1, 1) in every layer.
/// Source: depthMoments4 of LVSM equation 6.
vec4 lvsm_layerMoments4(float depth, vec2 interval)
{
    return lvsm_depthMoments4(lvsm_layerWarp(depth, interval));
}

/// Visibility of a receiver from the four moments of one layer: an upper bound on the lit share of the filter window.
/// moments: of the layer, filtered. depth: the receiver's, in [0,1]. interval: begin and end of the layer.
/// bias: as hamburgerUpperBound takes it. Result in [0,1].
/// Source: hamburgerUpperBound in the warp of LVSM equation 6.
float lvsm_layeredVisibility4(vec4 moments, float depth, vec2 interval, float bias)
{
    return lvsm_momentVisibility4(moments, lvsm_layerWarp(depth, interval), bias);
}

// Share of the window that is not at an end of the layer, end = -1 or 1, at least; what the bias mixed in is no share.
float lvsm_shareOffEnd(vec4 moments, float end, float bias)
{
    vec4 basis = lvsm_orthogonalise(moments, bias);
    float y = end - basis.x;
    float mass = lvsm_largestMass(basis, y, y * y - basis.z * y - basis.y);
    return clamp(1.0 - mass - bias, 0.0, 1.0);
}

/// Visibility of a receiver from the four moments of its layer and of the two neighbours.
/// front: of the layer in front, filtered, (1, 1, 1, 1) for the first layer. moments: of the layer.
/// behind: of the layer behind it, (-1, 1, -1, 1) for the last layer. depth: the receiver's, in [0,1].
/// interval: begin and end of the layer, which holds the receiver. bias: as hamburgerUpperBound takes it.
/// Result in [0,1], an upper bound on the lit share of the window for layers without overlap, but for rounding.
/// Source: the largest mass that four moments allow at the end of each neighbour, and hamburgerUpperBound for what is
/// left in the layer, see bracketMoments.
float lvsm_bracketedVisibility4(vec4 front, vec4 moments, vec4 behind, float depth, vec2 interval, float bias)
{
    float share = clamp(bias, 0.0, 1.0);
    vec4 b = lvsm_boxedMoments4(moments);
    // No more at an end than the first two moments allow.
    float mean = 0.5 + 0.5 * b.x;
    float dark = min(lvsm_shareOffEnd(front, 1.0, share), 1.0 - mean);
    float lit = min(lvsm_shareOffEnd(behind, -1.0, share), clamp(0.25 + 0.5 * b.x + 0.25 * b.y, 0.0, mean));
    float left = clamp(1.0 - dark - lit, 0.0, 1.0);
    float inverse = 1.0 / max(left, LVSM_TINY);
    vec4 rest = (b + vec4(dark, -dark, dark, -dark) - lit) * inverse;
    // Rounding errors grow as the share that is left shrinks, and the bias with them.
    float bound = lvsm_momentVisibility4(rest, lvsm_layerWarp(depth, interval), share * inverse);
    return clamp(lit + left * bound, 0.0, 1.0);
}

#endif
