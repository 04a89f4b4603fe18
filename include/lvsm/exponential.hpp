// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments.
// Exponential variance shadow maps: moments of a positive and a negative exponential warp.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, section 7.
#ifndef LVSM_EXPONENTIAL_HPP
#define LVSM_EXPONENTIAL_HPP

#include "moments.hpp"

#include <glm/vec4.hpp>

namespace lvsm
{

// Largest finite value of a storage format, for maxExponent.
template <typename T>
constexpr T kLargestFp16 = T(65504.0);
template <typename T>
constexpr T kLargestFp32 = T(3.4028234663852885981e38);

// Largest exponent in fp32. The second moments would be finite up to ln(FLT_MAX) / 2 = 44.36, but the bound divides by
// up to 2 e^(2c), and Vulkan promises nothing for divisors over 2^126. So c is 125 ln 2 / 2 = 43.32170, less 1.1e-5 for
// the error of exp, 3 + 2 |x| units in the last place. The smallest square, e^(-2c), is then a normal float too.
template <typename T>
constexpr T kMaxExponent = T(43.3216);

/// The two exponential warps of a depth: e^(cx) and -e^(-cx), for x the depth remapped to [-1,1].
/// depth: in [0,1], clamped to it. exponents: c of the positive and of the negative warp, each clamped to [0, 43.3216].
/// Result: (positive, negative); the positive in (0, 6.6e18], the negative in [-6.6e18, 0); both rise with depth.
/// Source: LVSM section 7.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> exponentialWarp(T depth, const glm::vec<2, T, Q>& exponents)
{
    using glm::exp;
    const T x = signedDepth(depth);
    return {exp(detail::clamp(exponents.x, T(0), kMaxExponent<T>) * x),
            -exp(-detail::clamp(exponents.y, T(0), kMaxExponent<T>) * x)};
}

/// Moments to store for one depth: each warp and its square.
/// depth: in [0,1], clamped to it. exponents: of the two warps, each clamped to [0, 43.3216].
/// Result: (positive, positive^2, negative, negative^2), in [-6.6e18, 4.3e37]; fp16 holds it up to exponents of 5.545.
/// A texel without any surface stores depth 1; the clear colour is this function's result for it.
/// Source: LVSM section 7.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> exponentialMoments(T depth, const glm::vec<2, T, Q>& exponents)
{
    const glm::vec<2, T, Q> warped = exponentialWarp(depth, exponents);
    return {warped.x, warped.x * warped.x, warped.y, warped.y * warped.y};
}

namespace detail
{

template <typename T>
T warpedMinVariance(T minVariance, T warped, T exponent)
{
    const T c = clamp(exponent, T(0), kMaxExponent<T>);
    return minimum(T(1), T(4) * c * c * maximum(T(0), minVariance)) * (warped * warped);
}

} // namespace detail

/// Variance floors in the two warped spaces that equal a global floor in depth: carried through each warp's slope.
/// minVariance: the global floor in depth squared, >= 0, less counts as 0. depth: the receiver's, in [0,1].
/// exponents: of the two warps, each clamped to [0, 43.3216].
/// Result: (positive, negative), each in [0, 4.3e37]: (2 c w)^2 minVariance for a warp w, at most w^2.
/// Source: first-order propagation through the slope of each warp of LVSM section 7, d/dx e^(c (2x - 1)) = 2 c w.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> exponentialMinVariance(T minVariance, T depth, const glm::vec<2, T, Q>& exponents)
{
    const glm::vec<2, T, Q> warped = exponentialWarp(depth, exponents);
    return {detail::warpedMinVariance(minVariance, warped.x, exponents.x),
            detail::warpedMinVariance(minVariance, warped.y, exponents.y)};
}

/// Visibility of a receiver from the moments of the positive warp alone (EVSM2).
/// moments: of the positive warp, filtered. depth: the receiver's, in [0,1]. exponent: of the warp, as when stored.
/// minVariance: the global floor in depth squared, >= 0.
/// Result in [0,1], an upper bound on the lit share of the window.
/// Source: LVSM section 7 and equation 3.
template <typename T, glm::qualifier Q>
T exponentialVisibility2(const glm::vec<2, T, Q>& moments, T depth, T exponent, T minVariance)
{
    const glm::vec<2, T, Q> exponents(exponent, T(0));
    const T warped = exponentialWarp(depth, exponents).x;
    return chebyshevUpperBound(moments, warped, exponentialMinVariance(minVariance, depth, exponents).x);
}

/// Visibility of a receiver from the moments of both warps (EVSM4): the lesser of their two upper bounds.
/// moments: as exponentialMoments made them, filtered. depth: the receiver's, in [0,1].
/// exponents: of the two warps, as when stored. minVariance: the global floor in depth squared, >= 0.
/// Result in [0,1], an upper bound on the lit share of the window.
/// Source: LVSM section 7 and equation 3.
template <typename T, glm::qualifier Q, glm::qualifier QE>
T exponentialVisibility4(const glm::vec<4, T, Q>& moments, T depth, const glm::vec<2, T, QE>& exponents, T minVariance)
{
    const glm::vec<2, T, QE> warped = exponentialWarp(depth, exponents);
    const glm::vec<2, T, QE> floors = exponentialMinVariance(minVariance, depth, exponents);
    return detail::minimum(chebyshevUpperBound(glm::vec<2, T, Q>(moments.x, moments.y), warped.x, floors.x),
                       chebyshevUpperBound(glm::vec<2, T, Q>(moments.z, moments.w), warped.y, floors.y));
}

/// Largest exponent whose moments a storage format can hold and a filter can sum.
/// largest: the format's largest finite value, see the kLargest constants; less than 1 counts as 1.
/// headRoom: how often an unnormalised filter sum holds its largest sample, >= 1 (1 for weights that sum to 1). Each
/// rounding to fp16 on the way needs 1/2048 more of it.
/// Result in [0, 43.3216]: 5.545 for fp16 and 43.3216 for fp32 without head room.
/// Source: headRoom e^(2c) <= largest, solved for c; in fp32 the divisor of the bound sets the limit.
template <typename T>
T maxExponent(T largest, T headRoom)
{
    using glm::log;
    const T ratio = detail::maximum(T(1), largest) / detail::clamp(headRoom, T(1), kHuge<T>);
    return detail::clamp(T(0.5) * log(detail::maximum(T(1), ratio)), T(0), kMaxExponent<T>);
}

} // namespace lvsm

#endif
