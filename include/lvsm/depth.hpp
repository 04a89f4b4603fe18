// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config.
// Depth metrics: linear in light space, in [0,1], 0 at the light.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, section 5.
#ifndef LVSM_DEPTH_HPP
#define LVSM_DEPTH_HPP

#include "config.hpp"

#include <glm/vec3.hpp>

namespace lvsm
{

/// Linear step: 0 at and below lo, 1 at and above hi, linear between.
/// x, lo, hi: any unit, the same for the three. Result in [0,1].
/// Degenerate: an empty or inverted range is a step, 0 below hi and 1 from hi on; one longer than 2^126 ends there.
/// Source: Lauritzen, Summed-Area Variance Shadow Maps, GPU Gems 3 (2007), section 8.4.3.
template <typename T>
T linstep(T x, T lo, T hi)
{
    const T range = detail::minimum(kHuge<T>, hi - lo);
    if (range < kTiny<T>)
        return x >= hi ? T(1) : T(0);
    return detail::clamp((x - lo) / range, T(0), T(1));
}

/// Depth below a point or spot light: the Euclidean distance to the light, normalised between two distances.
/// position, light: world or light space, the same for both. nearDistance, farDistance: in its unit, 0 <= near < far.
/// Result in [0,1]: 0 at nearDistance or closer, 1 at farDistance or beyond.
/// Degenerate: near >= far is a step at farDistance.
/// Source: LVSM section 5.
template <typename T, glm::qualifier Q>
T pointLightDepth(const glm::vec<3, T, Q>& position, const glm::vec<3, T, Q>& light, T nearDistance, T farDistance)
{
    using glm::sqrt;
    const T x = position.x - light.x;
    const T y = position.y - light.y;
    const T z = position.z - light.z;
    return linstep(sqrt(x * x + y * y + z * z), nearDistance, farDistance);
}

/// Depth below a directional light: the distance to the light plane, normalised between two distances.
/// position, light: a point and any point of the light plane, in one space. direction: unit vector along the light.
/// nearDistance, farDistance: distances from the plane, near < far. Result in [0,1].
/// Degenerate: near >= far is a step at farDistance; a direction that is not of unit length scales the distance;
/// components of position - light and direction beyond 1e18 count as 1e18.
/// Source: LVSM section 5.
template <typename T, glm::qualifier Q>
T planeLightDepth(const glm::vec<3, T, Q>& position, const glm::vec<3, T, Q>& light,
                  const glm::vec<3, T, Q>& direction, T nearDistance, T farDistance)
{
    const T limit = T(1.0e18);
    const T along = detail::clamp(position.x - light.x, -limit, limit) * detail::clamp(direction.x, -limit, limit) +
                    detail::clamp(position.y - light.y, -limit, limit) * detail::clamp(direction.y, -limit, limit) +
                    detail::clamp(position.z - light.z, -limit, limit) * detail::clamp(direction.z, -limit, limit);
    return linstep(along, nearDistance, farDistance);
}

/// Linear depth from the projected depth of a perspective light: the distance along the light's axis, normalised.
/// z: depth after division in [0,1], 0 at the near plane (for a clip space of [-1,1] pass z / 2 + 1/2).
/// nearPlane, farPlane: distances, 0 < near < far. Result in [0,1]: 0 at the near plane, 1 at the far plane.
/// Degenerate: planes that are not positive count as 0, and two planes at 0 give z itself.
/// Source: the inverse of the perspective projection, z n / (z n + (1 - z) f).
template <typename T>
T linearDepth(T z, T nearPlane, T farPlane)
{
    const T depth = detail::clamp(z, T(0), T(1));
    const T atFar = depth * detail::clamp(nearPlane, T(0), kHuge<T>);
    const T atNear = (T(1) - depth) * detail::clamp(farPlane, T(0), kHuge<T>);
    const T sum = atFar + atNear;
    return sum < kTiny<T> ? depth : detail::clamp(atFar / sum, T(0), T(1));
}

/// Linear depth from the reversed projected depth of a perspective light, 1 at the near plane and 0 at the far plane.
/// z: depth after division in [0,1]. nearPlane, farPlane: distances, 0 < near < far.
/// Result in [0,1]: 0 at the near plane, 1 at the far plane.
/// Degenerate: planes that are not positive count as 0, and two planes at 0 give 1 - z.
/// Source: linearDepth of 1 - z, without the cancellation that 1 - z brings near the far plane.
template <typename T>
T linearDepthReversed(T z, T nearPlane, T farPlane)
{
    const T depth = detail::clamp(z, T(0), T(1));
    const T atFar = (T(1) - depth) * detail::clamp(nearPlane, T(0), kHuge<T>);
    const T atNear = depth * detail::clamp(farPlane, T(0), kHuge<T>);
    const T sum = atFar + atNear;
    return sum < kTiny<T> ? T(1) - depth : detail::clamp(atFar / sum, T(0), T(1));
}

/// Depth remapped from [0,1] to [-1,1], where both exponential warps have the same reach.
/// depth: in [0,1], clamped to it. Result in [-1,1].
/// Source: the range over which LVSM section 7 warps by e^(cx) and -e^(-cx).
template <typename T>
T signedDepth(T depth)
{
    return T(2) * detail::clamp(depth, T(0), T(1)) - T(1);
}

} // namespace lvsm

#endif
