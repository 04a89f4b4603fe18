// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config.
// Trigonometric moments: four numbers in unorm16 that hardware filters, and the bound that they give.
//
// A depth is a point on an arc of the unit circle; stored are the means of that complex number z and of its square. An
// arc is curved alike everywhere, so that rounding costs the same at every depth, and less than it costs the powers of a
// depth. For a third of a window each at depths 0, 0.5 and 1 both means are 0: so the bias against rounding is a factor.
//
// The arc is 4 pi / 3 long. Up to pi the bound would be one without exception, but rounding would cost what is won; here
// it can fall below the truth: by less than 0.01, and by less than 1e-4 where a window's depths are at most 3/4 apart.
#ifndef LVSM_TRIGONOMETRIC_HPP
#define LVSM_TRIGONOMETRIC_HPP

#include "config.hpp"

namespace lvsm
{

/// Least bias with which rounding never makes trigonometric moments invalid.
/// storedError: largest error of a stored component, in [0,1], clamped to it; half a step of unorm, times one and the
/// number of blurs that round again. Result in [0,1].
/// Source: bias I + T(error) has no negative eigenvalue, for T the Toeplitz matrix of any error of that size.
template <typename T>
T recommendedTrigonometricBias(T storedError)
{
    return detail::minimum(T(1), T(5.14974) * detail::clamp(storedError, T(0), T(1)));
}

namespace detail
{

// The point (cos a, sin a) of a depth, for a = (depth - 1/2) 4 pi / 3. Polynomials for the sine and cosine of a / 2, off
// by 2e-8 at most: of its own functions Vulkan promises 2^-11 only.
template <typename T>
glm::vec<2, T> arcPoint(T depth)
{
    const T x = clamp(depth, T(0), T(1)) - T(0.5);
    const T u = x * x;
    const T sine = x * (T(2.09439482) + u * (T(-1.53115888) + u * (T(0.335603377) - u * T(0.0338900668))));
    const T cosine =
        T(1) + u * (T(-2.19324526) + u * (T(0.801715566) + u * (T(-0.117164665) + u * T(0.00890638713))));
    return {T(1) - T(2) * sine * sine, T(2) * sine * cosine};
}

} // namespace detail

/// Trigonometric moments to store for one depth.
/// depth: in [0,1], clamped to it. Result: each in [0,1], from the point (x, y) of the depth on the arc: (2/3 x + 1/3,
/// 1/2 + 1/2 y, x^2, 1/2 + x y), which is linear in the point and in its square.
/// A texel without any surface stores depth 1: (0, 0.9330127, 0.25, 0.0669873).
template <typename T>
glm::vec<4, T> trigonometricMoments(T depth)
{
    const glm::vec<2, T> p = detail::arcPoint(depth);
    return {detail::clamp(T(0.666666667) * p.x + T(0.333333333), T(0), T(1)),
            detail::clamp(T(0.5) + T(0.5) * p.y, T(0), T(1)), detail::clamp(p.x * p.x, T(0), T(1)),
            detail::clamp(T(0.5) + p.x * p.y, T(0), T(1))};
}

/// Visibility of a receiver from trigonometric moments: an upper bound on the lit share of the filter window.
/// moments: as trigonometricMoments made them, filtered. depth: the receiver's, in [0,1], clamped to it.
/// bias: share of a wide distribution that is mixed in against rounding, in [0,1], see recommendedTrigonometricBias.
/// Result in [0,1]. Exact for up to two occluder depths and the receiver's, but for the bias.
/// Degenerate: moments that no distribution has are moved towards the boundary of those that are.
/// Source: Markov's and Krein's bound for two trigonometric moments. The distribution that meets it has an atom at the
/// receiver's point t and two at the zeros of the kernel polynomial, whose coefficients are the inverse of the Toeplitz
/// matrix of the moments times (1, t, t^2). All is times its determinant.
template <typename T, glm::qualifier Q>
T trigonometricVisibility(const glm::vec<4, T, Q>& moments, T depth, T bias)
{
    using glm::sqrt;
    const T keep = T(1) - detail::clamp(bias, T(0), T(1));
    const T two = T(2) * keep;
    const glm::vec<2, T> m(T(1.5) * keep * detail::clamp(moments.x, T(0), T(1)) - T(0.5) * keep,
                           two * detail::clamp(moments.y, T(0), T(1)) - keep);
    const T squareX = two * detail::clamp(moments.z, T(0), T(1)) - keep;
    const T squareY = two * detail::clamp(moments.w, T(0), T(1)) - keep;
    const glm::vec<2, T> t = detail::arcPoint(depth);

    // Variance of z, and the mean of (z - m)^2.
    const T a = detail::maximum(T(1.0e-9), T(1) - (m.x * m.x + m.y * m.y));
    const T ex = squareX - (m.x * m.x - m.y * m.y);
    const T ey = squareY - T(2) * m.x * m.y;
    const T determinant = detail::maximum(T(1.0e-18), (a - ex) * (a + ex) - ey * ey);
    const glm::vec<2, T> d(t.x - m.x, t.y - m.y);
    const glm::vec<2, T> w((a - ex) * d.x - ey * d.y, (a + ex) * d.y - ey * d.x);
    const T mass = determinant / (determinant + detail::maximum(T(0), T(2) * (d.x * w.x + d.y * w.y)));

    // The other two atoms, w (-middle +- i root) / norm, share the rest.
    const T middle = T(0.5) * determinant - (m.x * w.x + m.y * w.y);
    const T norm = w.x * w.x + w.y * w.y;
    const T root = sqrt(detail::maximum(T(1.0e-36), norm - middle * middle));
    const T half = T(0.5) - T(0.5) * mass;
    const T lean = w.x * (m.y - mass * t.y) - w.y * (m.x - mass * t.x);
    const T skewed = detail::clamp(T(0.5) * lean / root, -half, half);

    // What is in front lies beyond the line from the receiver to a point a little before the arc's begin; what is off the
    // arc counts as behind.
    const glm::vec<2, T> chord(T(-0.53) - t.x, T(-0.848) - t.y);
    const T level = -middle * (w.x * chord.y - w.y * chord.x) - norm * (T(0.53) * t.y - T(0.848) * t.x);
    const T rise = -root * (w.x * chord.x + w.y * chord.y);
    const T bound = mass + (level + rise > T(0) ? half + skewed : T(0)) + (level > rise ? half - skewed : T(0));
    return detail::clamp(bound, T(0), T(1));
}

} // namespace lvsm

#endif
