// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth.
// Variance shadow maps: two moments of depth and the one-tailed Chebyshev bound.
// Donnelly & Lauritzen, Variance Shadow Maps, I3D 2006; Lauritzen & McCool, Layered Variance Shadow Maps,
// Graphics Interface 2008, section 3; Lauritzen, Summed-Area Variance Shadow Maps, GPU Gems 3 (2007), chapter 8.
#ifndef LVSM_MOMENTS_HPP
#define LVSM_MOMENTS_HPP

#include "depth.hpp"

#include <glm/vec2.hpp>

namespace lvsm
{

// Largest rounding error of a depth in [0,1] stored in a format: half a step of 2^b - 1 equal ones for unorm,
// half a unit in the last place below 1 for floating point. For recommendedMinVariance.
template <typename T>
constexpr T kDepthErrorUnorm8 = T(0.00196078431372549020);
template <typename T>
constexpr T kDepthErrorUnorm16 = T(7.62951094834821088731e-6);
template <typename T>
constexpr T kDepthErrorFp16 = T(0.000244140625);
template <typename T>
constexpr T kDepthErrorFp32 = T(2.98023224e-8);

/// Moments to store for one depth: the depth and its square.
/// depth: in [0,1], clamped to it. Result: (M1, M2), each in [0,1]. A texel without any surface stores depth 1: (1, 1).
/// Source: LVSM equation 1.
template <typename T>
glm::vec<2, T> depthMoments(T depth)
{
    const T m1 = detail::clamp(depth, T(0), T(1));
    return {m1, m1 * m1};
}

/// Moments to store for a texel that a slanted surface fills: the second carries the variance inside the texel.
/// depth: in [0,1], clamped to it. dx, dy: change of depth from one texel to the next (screen derivatives).
/// Result: (M1, M2), each in [0,1]; M2 is at most M1, which no distribution of depths in [0,1] exceeds.
/// Source: GPU Gems 3, section 8.4.2: M2 + (dx^2 + dy^2) / 4.
template <typename T>
glm::vec<2, T> depthMomentsSloped(T depth, T dx, T dy)
{
    const T m1 = detail::clamp(depth, T(0), T(1));
    return {m1, detail::minimum(m1, m1 * m1 + T(0.25) * (dx * dx + dy * dy))};
}

/// Mean depth of filtered moments.
/// moments: (M1, M2). Result: M1, unchanged.
/// Source: LVSM equation 2.
template <typename T, glm::qualifier Q>
T mean(const glm::vec<2, T, Q>& moments)
{
    return moments.x;
}

/// Variance of filtered moments, with a floor.
/// moments: (M1, M2). minVariance: the floor, in depth squared of the moments' space, >= 0 (less counts as 0).
/// Result: at least minVariance, never negative. Rounding can make M2 - M1^2 negative: the floor takes its place.
/// Source: LVSM equation 2 and the clamp that follows equation 3.
template <typename T, glm::qualifier Q>
T variance(const glm::vec<2, T, Q>& moments, T minVariance)
{
    const T difference = detail::rounded(moments.y) - detail::rounded(moments.x * moments.x);
    return detail::maximum(detail::maximum(T(0), minVariance), difference);
}

/// Upper bound on the share of the filter window that is at depth t or farther: the visibility of a receiver at t.
/// moments: (M1, M2) filtered. t: the receiver's depth in the moments' space. minVariance: floor of the variance, >= 0.
/// Result in [0,1]: 1 for t <= M1. Exact for one planar occluder over one planar receiver at t.
/// Degenerate: zero variance is a step, 1 up to M1 and 0 beyond. Up to 2^-63 beyond counts as M1 itself: what float
/// cannot resolve does not darken.
/// Source: LVSM equation 3 (one-tailed Chebyshev inequality, also called Cantelli's).
template <typename T, glm::qualifier Q>
T chebyshevUpperBound(const glm::vec<2, T, Q>& moments, T t, T minVariance)
{
    const T v = variance(moments, minVariance);
    const T d = t - moments.x;
    const T tail = detail::clamp(v / detail::maximum(kTiny<T>, v + d * d), T(0), T(1));
    return d > kRootTiny<T> ? tail : T(1);
}

/// Lower bound on the share of the filter window that is at depth t or farther: the mirror of chebyshevUpperBound.
/// moments: (M1, M2) filtered. t: the receiver's depth in the moments' space. minVariance: floor of the variance, >= 0.
/// Result in [0,1]: 0 for t >= M1, where the inequality says nothing.
/// Degenerate: zero variance is a step, 1 below M1 and 0 from M1 on. Up to 2^-63 below counts as M1 itself.
/// Source: LVSM equation 3 applied to -x: P(x >= t) >= 1 - v / (v + d^2).
template <typename T, glm::qualifier Q>
T chebyshevLowerBound(const glm::vec<2, T, Q>& moments, T t, T minVariance)
{
    const T v = variance(moments, minVariance);
    const T d = moments.x - t;
    const T tail = detail::clamp(v / detail::maximum(kTiny<T>, v + d * d), T(0), T(1));
    return d > kRootTiny<T> ? T(1) - tail : T(0);
}

/// Upper bound on the share of the filter window that is at depth t or farther, for depths known to lie in [0,1].
/// moments: (M1, M2) filtered, of a depth in [0,1]. t: the receiver's depth in the moments' space.
/// minVariance: floor of the variance, >= 0. Result in [0,1]: 1 for t <= 0, never above chebyshevUpperBound.
/// Exact for samples at 0 and 1 alone; without a floor no bound from two moments is less anywhere.
/// Degenerate: zero variance is a step, 1 up to M1 and 0 beyond.
/// Source: the least mean of three parabolas that are nowhere less than the step at t: Cantelli's; x / t (Markov's);
/// x (1 + t - x) / t. Together they are the bound of Markov and Krein for the support [0,1]. The floor adds
/// 9/4 minVariance / t^2 to the last two, which makes up for the same depth error as it does in Cantelli's.
template <typename T, glm::qualifier Q>
T boundedUpperBound(const glm::vec<2, T, Q>& moments, T t, T minVariance)
{
    const T tail = chebyshevUpperBound(moments, t, minVariance);
    const T m1 = detail::clamp(moments.x, T(0), T(1));
    const T m2 = detail::clamp(moments.y, T(0), T(1));
    const T at = detail::clamp(t, T(0), T(1));
    const T inverse = T(1) / detail::maximum(kTiny<T>, at);
    const T room = T(2.25) * detail::clamp(minVariance, T(0), T(1)) * inverse;
    const T parabolas = (detail::minimum(m1, m1 * at + detail::rounded(m1 - m2)) + room) * inverse;
    return t > T(0) ? detail::clamp(detail::minimum(tail, parabolas), T(0), T(1)) : T(1);
}

/// Visibility with its low end cut off and the rest stretched back to [0,1]: less bleeding, darker penumbrae.
/// visibility: in [0,1]. amount: what counts as no light, in [0,1), less counts as 0.
/// Result in [0,1]: 0 up to amount, 1 at 1; rises with visibility and falls with amount.
/// Degenerate: amount >= 1 leaves only full visibility lit.
/// Source: GPU Gems 3, section 8.4.3.
template <typename T>
T reduceLightBleeding(T visibility, T amount)
{
    return linstep(visibility, detail::maximum(T(0), amount), T(1));
}

/// Least variance floor with which rounding alone never darkens a flat lit receiver by more than a stated amount.
/// depthError: largest error of the stored depth, in [0,1], see the kDepthError constants; add those of all passes.
/// worstDarkening: accepted loss of visibility, in (0,1), clamped to [2^-24, 1].
/// Result in the square of the stored depth's unit, in [0, 2^24]. A layer stores its warped depth: the global floor
/// that layeredVisibility takes is the result times the square of the layer's length.
/// Source: solves v / (v + depthError^2) = 1 - worstDarkening, LVSM equation 3, for v.
template <typename T>
T recommendedMinVariance(T depthError, T worstDarkening)
{
    const T e = detail::clamp(depthError, T(0), T(1));
    const T darkening = detail::clamp(worstDarkening, T(5.9604644775390625e-8), T(1));
    return e * e * ((T(1) - darkening) / darkening);
}

} // namespace lvsm

#endif
