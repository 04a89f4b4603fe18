// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments, layers.
// Moment shadow maps: four moments of depth and the sharp bound they give.
// Peters & Klein, Moment Shadow Mapping, I3D 2015; Peters, Muenstermann, Wetzstein & Klein, Improved Moment Shadow Maps
// for Translucent Occluders, Soft Shadows and Single Scattering, JCGT 6(1), 2017 (JCGT below).
//
// The moments are those of the depth remapped to [-1,1], as in JCGT, where they lose the least to rounding. Store them
// as they are in fp32, or in the basis of encodeMoments4 in unorm16.
#ifndef LVSM_MOMENTS4_HPP
#define LVSM_MOMENTS4_HPP

#include "layers.hpp"

namespace lvsm
{

// Bias that makes up for the rounding of a storage format, as published. Source: JCGT section 2. It is what
// recommendedMoment4Bias gives for 1.6 roundings to unorm16, and for 0.9 roundings of the plain moments to fp32.
template <typename T>
constexpr T kMoment4BiasUnorm16 = T(6.0e-5);
template <typename T>
constexpr T kMoment4BiasFp32 = T(3.0e-7);

/// Least bias with which rounding never makes the moments of a window invalid, so that their bound stays a bound.
/// encodedError: largest error of a stored component of encodeMoments4, in [0,1], clamped to it; half a step of unorm,
/// times one and the number of blurs that round again. For plain moments pass 2.385 times their error.
/// Result in [0,1].
/// Source: bias H(w) + H(error) has no negative eigenvalue, for H the Hankel matrix, w = (0, 0.63, 0, 0.63), and any
/// error of that size.
template <typename T>
T recommendedMoment4Bias(T encodedError)
{
    return detail::minimum(T(1), T(4.865) * detail::clamp(encodedError, T(0), T(1)));
}

/// Four moments to store for one depth: the powers of the depth remapped to [-1,1].
/// depth: in [0,1], clamped to it. Result: (x, x^2, x^3, x^4), each in [-1,1].
/// A texel without any surface stores depth 1: (1, 1, 1, 1).
/// Source: JCGT section 2.
template <typename T>
glm::vec<4, T> depthMoments4(T depth)
{
    const T x = signedDepth(depth);
    const T squared = x * x;
    return {x, squared, squared * x, squared * squared};
}

/// Four moments in the basis that loses least to 16 bits.
/// moments: as depthMoments4 made them, filtered or not. Result: each in [0,1] and filtered as linearly as the moments.
/// A texel without any surface stores (0, 0, 0.98112522, 1).
/// Source: JCGT section 2, the optimised quantisation transform.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> encodeMoments4(const glm::vec<4, T, Q>& moments)
{
    const T b1 = detail::clamp(moments.x, T(-1), T(1));
    const T b2 = detail::clamp(moments.y, T(0), T(1));
    const T b3 = detail::clamp(moments.z, T(-1), T(1));
    const T b4 = detail::clamp(moments.w, T(0), T(1));
    return {detail::clamp(detail::rounded(T(1.5) * b1 - T(2) * b3) + T(0.5), T(0), T(1)),
            detail::clamp(T(4) * (b2 - b4), T(0), T(1)),
            detail::clamp(detail::rounded(T(0.866025404) * b1 - T(0.384900179) * b3) + T(0.5), T(0), T(1)),
            detail::clamp(T(0.5) * (b2 + b4), T(0), T(1))};
}

/// Four moments out of the basis that loses least to 16 bits.
/// encoded: as encodeMoments4 made it, filtered. Result: four moments, each in [-1,1].
/// Source: JCGT section 2, the inverse of the optimised quantisation transform.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> decodeMoments4(const glm::vec<4, T, Q>& encoded)
{
    const T odd1 = encoded.x - T(0.5);
    const T odd2 = encoded.z - T(0.5);
    return {detail::clamp(T(1.73205081) * odd2 - T(0.333333333) * odd1, T(-1), T(1)),
            detail::clamp(encoded.w + T(0.125) * encoded.y, T(0), T(1)),
            detail::clamp(T(1.29903811) * odd2 - T(0.75) * odd1, T(-1), T(1)),
            detail::clamp(encoded.w - T(0.125) * encoded.y, T(0), T(1))};
}

namespace detail
{

// The orthogonal polynomials of a distribution with four moments, in y = x - mean: 1, y and P(y) = y^2 - skew y - v,
// of norms 1, v and d. They are what the LDL^T decomposition of the Hankel matrix holds. The moments are first mixed
// with a share (the bias) of moments far from the boundary of the valid ones. Result: (mean, v, skew, d).
// The skew of a distribution on [-1,1] is at most 2. The mixed-in share alone brings v to 0.63 bias and d to
// (0.63 - 0.63^2) bias: what is less is rounding, and contraction in shaders. The constants keep products normal floats
// where there is no bias.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> orthogonalise(const glm::vec<4, T, Q>& moments, T bias)
{
    const T share = clamp(bias, T(0), T(1));
    const T odd1 = clamp(moments.x, T(-1), T(1));
    const T even1 = clamp(moments.y, T(0), T(1));
    const T odd2 = clamp(moments.z, T(-1), T(1));
    const T even2 = clamp(moments.w, T(0), T(1));
    const T b1 = odd1 - rounded(share * odd1);
    const T b2 = even1 + share * rounded(T(0.63) - even1);
    const T b3 = odd2 - rounded(share * odd2);
    const T b4 = even2 + share * rounded(T(0.63) - even2);
    const T v = maximum(maximum(T(9.0949470177292824e-13), T(0.63) * share), rounded(b2) - rounded(b1 * b1));
    const T e = rounded(b3) - rounded(b1 * b2);
    const T slope = e / v;
    const T least = maximum(T(8.6736173798840355e-19), T(0.2331) * share);
    const T d = clamp(rounded(rounded(b4) - rounded(b2 * b2)) - rounded(e * slope), least, T(1));
    return {b1, v, clamp(slope - (b1 + b1), T(-2), T(2)), d};
}

// The most mass that such a distribution can have at a single y: one over the sum of the squared polynomials there.
// p: the value of P there.
template <typename T, glm::qualifier Q>
T largestMass(const glm::vec<4, T, Q>& basis, T y, T p)
{
    const T others = basis.w * y * y + basis.y * p * p;
    return basis.y * basis.w / (basis.y * basis.w + others);
}

// The bound of hamburgerUpperBound for a distribution with this basis.
template <typename T, glm::qualifier Q>
T boundOfBasis(const glm::vec<4, T, Q>& basis, T t)
{
    using glm::sqrt;
    const T v = basis.y;
    const T d = basis.w;
    const T y = clamp(t, T(-1), T(1)) - basis.x;
    const T p = y * y - basis.z * y - v;
    const T mass = clamp(largestMass(basis, y, p), T(0), T(1));

    // Where P is negative at t, there is a root on each side of it. In p x^2 + 2 half x + (d - v p) nothing cancels.
    const T half = T(0.5) * (d * y / v - basis.z * p);
    const T root = sqrt(maximum(kTiny<T>, half * half - p * (d - v * p)));
    const T skewed = (mass * y * p - (T(1) - mass) * half) / root;
    const T between = clamp(T(0.5) * (T(1) + mass + skewed), T(0), T(1));
    return p < T(0) ? between : y > T(0) ? mass : T(1);
}

} // namespace detail

/// Upper bound on the share of the filter window that is at depth t or farther, from four moments.
/// moments: as depthMoments4 made them, filtered. t: the receiver's depth remapped to [-1,1], clamped to it.
/// bias: share of moments of a wide distribution that is mixed in against rounding, in [0,1], see the kMoment4Bias
/// constants. Result in [0,1]. Exact for up to two occluder depths and the receiver's, but for the bias.
/// Degenerate: moments that no distribution has are moved to the boundary of those that are.
/// Source: Peters & Klein 2015, algorithm 3 (the bound of the Hamburger moment problem), in terms of the orthogonal
/// polynomials: the distribution that meets the bound has an atom at t and two at the roots of the kernel polynomial.
template <typename T, glm::qualifier Q>
T hamburgerUpperBound(const glm::vec<4, T, Q>& moments, T t, T bias)
{
    return detail::boundOfBasis(detail::orthogonalise(moments, bias), t);
}

/// Visibility of a receiver from four moments (MSM4): an upper bound on the lit share of the filter window.
/// moments: as depthMoments4 made them, filtered. depth: the receiver's, in [0,1].
/// bias: as hamburgerUpperBound takes it. Result in [0,1].
/// Source: JCGT section 2.
template <typename T, glm::qualifier Q>
T momentVisibility4(const glm::vec<4, T, Q>& moments, T depth, T bias)
{
    return hamburgerUpperBound(moments, T(2) * depth - T(1), bias);
}

/// Four moments to store in a layer for one depth.
/// depth: in [0,1]. interval: begin and end of the layer. Result: four moments of the warped depth, each in [-1,1].
/// A texel without any surface stores depth 1: (1, 1, 1, 1) in every layer.
/// Source: depthMoments4 of LVSM equation 6.
template <typename T, glm::qualifier Q>
glm::vec<4, T> layerMoments4(T depth, const glm::vec<2, T, Q>& interval)
{
    return depthMoments4(layerWarp(depth, interval));
}

/// Visibility of a receiver from the four moments of one layer: an upper bound on the lit share of the filter window.
/// moments: of the layer, filtered. depth: the receiver's, in [0,1]. interval: begin and end of the layer.
/// bias: as hamburgerUpperBound takes it. Result in [0,1].
/// Source: hamburgerUpperBound in the warp of LVSM equation 6.
template <typename T, glm::qualifier Q, glm::qualifier QI>
T layeredVisibility4(const glm::vec<4, T, Q>& moments, T depth, const glm::vec<2, T, QI>& interval, T bias)
{
    return momentVisibility4(moments, layerWarp(depth, interval), bias);
}

namespace detail
{

// Share of the window that is not at an end of the layer, end = -1 or 1, at least; what the bias mixed in is no share.
template <typename T, glm::qualifier Q>
T shareOffEnd(const glm::vec<4, T, Q>& moments, T end, T bias)
{
    const glm::vec<4, T, Q> basis = orthogonalise(moments, bias);
    const T y = end - basis.x;
    const T mass = largestMass(basis, y, y * y - basis.z * y - basis.y);
    return clamp(T(1) - mass - bias, T(0), T(1));
}

} // namespace detail

/// Visibility of a receiver from the four moments of its layer and of the two neighbours.
/// front: of the layer in front, filtered, (1, 1, 1, 1) for the first layer. moments: of the layer.
/// behind: of the layer behind it, (-1, 1, -1, 1) for the last layer. depth: the receiver's, in [0,1].
/// interval: begin and end of the layer, which holds the receiver. bias: as hamburgerUpperBound takes it.
/// Result in [0,1], an upper bound on the lit share of the window for layers without overlap, but for rounding.
/// Source: the largest mass that four moments allow at the end of each neighbour, and hamburgerUpperBound for what is
/// left in the layer, see bracketMoments.
template <typename T, glm::qualifier Q, glm::qualifier QI>
T bracketedVisibility4(const glm::vec<4, T, Q>& front, const glm::vec<4, T, Q>& moments,
                       const glm::vec<4, T, Q>& behind, T depth, const glm::vec<2, T, QI>& interval, T bias)
{
    const T share = detail::clamp(bias, T(0), T(1));
    const T b1 = detail::clamp(moments.x, T(-1), T(1));
    const T b2 = detail::clamp(moments.y, T(0), T(1));
    const T b3 = detail::clamp(moments.z, T(-1), T(1));
    const T b4 = detail::clamp(moments.w, T(0), T(1));
    // No more at an end than the first two moments allow.
    const T dark = detail::minimum(T(0.5) - T(0.5) * b1, detail::shareOffEnd(front, T(1), share));
    const T lit = detail::minimum(detail::clamp(T(0.25) + T(0.5) * b1 + T(0.25) * b2, T(0), T(0.5) + T(0.5) * b1),
                              detail::shareOffEnd(behind, T(-1), share));
    const T left = detail::clamp(T(1) - dark - lit, T(0), T(1));
    const T inverse = T(1) / detail::maximum(kTiny<T>, left);
    const glm::vec<4, T, Q> rest((b1 + dark - lit) * inverse, (b2 - dark - lit) * inverse,
                                 (b3 + dark - lit) * inverse, (b4 - dark - lit) * inverse);
    // Rounding errors grow as the share that is left shrinks, and the bias with them.
    const T bound = momentVisibility4(rest, layerWarp(depth, interval), share * inverse);
    return detail::clamp(lit + left * bound, T(0), T(1));
}

} // namespace lvsm

#endif
