// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config.
// The receiver's slope: what keeps a slanted surface from shadowing itself over a filter window.
//
// All functions take the gradient of the receiver's depth over the texels of the map, (dz/dx, dz/dy), from
// receiverGradient or from the surface's normal. They serve every technique: shift the receiver's depth before it is
// judged, or raise the variance floor that the technique is given.
#ifndef LVSM_RECEIVER_HPP
#define LVSM_RECEIVER_HPP

#include "config.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lvsm
{

/// Gradient of the receiver's depth over the map, from screen derivatives.
/// dx, dy: derivatives along the screen's x and y of the receiver's (x, y, depth) in the map, x and y in texels.
/// Components beyond 1e18 count as 1e18. Result: change of depth per texel along the map's x and y, each in [-1,1].
/// Degenerate: a receiver that is a line in the map has no gradient: (0, 0).
/// Source: dx.z = g.x dx.x + g.y dx.y and the same for dy, solved by Cramer's rule.
template <typename T, glm::qualifier Q>
glm::vec<2, T> receiverGradient(const glm::vec<3, T, Q>& dx, const glm::vec<3, T, Q>& dy)
{
    const T limit = T(1.0e18);
    const T xx = detail::clamp(dx.x, -limit, limit);
    const T xy = detail::clamp(dx.y, -limit, limit);
    const T xz = detail::clamp(dx.z, -limit, limit);
    const T yx = detail::clamp(dy.x, -limit, limit);
    const T yy = detail::clamp(dy.y, -limit, limit);
    const T yz = detail::clamp(dy.z, -limit, limit);
    const T determinant = detail::rounded(xx * yy) - detail::rounded(xy * yx);
    if (determinant < kTiny<T> && determinant > -kTiny<T>)
        return {T(0), T(0)};
    const T alongX = detail::rounded(xz * yy) - detail::rounded(yz * xy);
    const T alongY = detail::rounded(yz * xx) - detail::rounded(xz * yx);
    return {detail::clamp(alongX / determinant, T(-1), T(1)), detail::clamp(alongY / determinant, T(-1), T(1))};
}

/// Depth of the receiver's plane at an offset from the receiver: what a tap of the filter should be compared with.
/// depth: the receiver's, in [0,1]. gradient: of the depth per texel, its components clamped to [-1,1].
/// offset: of the tap in texels, clamped to [-1e18, 1e18]. Result in [0,1].
template <typename T, glm::qualifier Q, glm::qualifier QO>
T planeDepth(T depth, const glm::vec<2, T, Q>& gradient, const glm::vec<2, T, QO>& offset)
{
    const T limit = T(1.0e18);
    const T x = detail::clamp(gradient.x, T(-1), T(1)) * detail::clamp(offset.x, -limit, limit);
    const T y = detail::clamp(gradient.y, T(-1), T(1)) * detail::clamp(offset.y, -limit, limit);
    return detail::clamp(depth + detail::rounded(detail::rounded(x) + detail::rounded(y)), T(0), T(1));
}

/// Depth of the receiver moved towards the light, in proportion to its slope.
/// depth: the receiver's, in [0,1]. gradient: of the depth per texel, its components clamped to [-1,1].
/// shift: in texels, >= 0, less counts as 0, more than 1e18 as that. The filter's radius takes the receiver in front of
/// all of its own samples and lifts shadows off their contact as far; 0 to 0.3 suits meshes.
/// Result in [0,1]: depth - shift (|dz/dx| + |dz/dy|).
template <typename T, glm::qualifier Q>
T shiftReceiver(T depth, const glm::vec<2, T, Q>& gradient, T shift)
{
    using glm::abs;
    const T slope = detail::minimum(T(1), abs(gradient.x)) + detail::minimum(T(1), abs(gradient.y));
    return detail::clamp(depth - detail::clamp(shift, T(0), T(1.0e18)) * slope, T(0), T(1));
}

/// Variance floor for a slanted receiver: four times the variance that its own plane has over the filter.
/// minVariance: the global floor in depth squared, >= 0, less counts as 0.
/// gradient: of the depth per texel, its components clamped to [-1,1].
/// deviation: standard deviation of the filter along each axis in texels, in [0, 65536], clamped to it; that of a
/// binomial filter of n taps is sqrt(n - 1) / 2, of a box of n texels sqrt((n^2 - 1) / 12).
/// Result in depth squared: at least minVariance.
/// Source: the variance of a plane's depth under a filter is |gradient|^2 deviation^2. A floor of four times as much
/// leaves its own samples, which reach two deviations in front of it, at least half lit by LVSM equation 3.
template <typename T, glm::qualifier Q>
T receiverMinVariance(T minVariance, const glm::vec<2, T, Q>& gradient, T deviation)
{
    const T x = detail::clamp(gradient.x, T(-1), T(1));
    const T y = detail::clamp(gradient.y, T(-1), T(1));
    const T width = detail::clamp(deviation, T(0), T(65536));
    return detail::maximum(detail::maximum(T(0), minVariance), T(4) * (x * x + y * y) * (width * width));
}

} // namespace lvsm

#endif
