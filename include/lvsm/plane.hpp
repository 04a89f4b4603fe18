// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments, layers, bracket.
// Bracketed layers judged relative to the receiver's plane: a slanted surface is neither its own shadow nor its own
// variance.
//
// Over the filter window a receiver's plane departs from the receiver's depth by u, the gradient times the offset from
// the receiver. Depth less u has the same mean, and a variance that differs by the covariance of depth and u. A
// Gaussian filter makes that known: it is the filter's variance times the gradient of the filtered mean, along u. So
// the four neighbouring texels of the same map tell it, and nothing more needs to be stored.
#ifndef LVSM_PLANE_HPP
#define LVSM_PLANE_HPP

#include "bracket.hpp"

#include <glm/vec3.hpp>

namespace lvsm
{

/// Covariance of a filtered mean with the receiver's plane over the filter window.
/// neighbours: the filtered first moment of a layer one texel to the right, left, up and down, each in [0,1], clamped
/// to it. gradient: of the receiver's depth per texel, right and up, each clamped to [-1,1].
/// deviation: standard deviation of the filter along each axis in texels, in [0, 65536], clamped to it.
/// Result: in depth times the unit of the mean, in [-4.3e9, 4.3e9].
/// Source: for a Gaussian filter E[offset x] is the gradient of E[x] times the filter's variance, by parts; central
/// differences.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T planeCovariance(const glm::vec<4, T, Q>& neighbours, const glm::vec<2, T, QG>& gradient, T deviation)
{
    const T width = detail::clamp(deviation, T(0), T(65536));
    const T x = detail::clamp(neighbours.x, T(0), T(1)) - detail::clamp(neighbours.y, T(0), T(1));
    const T y = detail::clamp(neighbours.z, T(0), T(1)) - detail::clamp(neighbours.w, T(0), T(1));
    const T along = detail::clamp(gradient.x, T(-1), T(1)) * x + detail::clamp(gradient.y, T(-1), T(1)) * y;
    return T(0.5) * (width * width) * along;
}

/// Variance of the receiver's plane over the filter window.
/// gradient: of the receiver's depth per texel, its components clamped to [-1,1]. deviation: standard deviation of the
/// filter along each axis in texels, in [0, 65536], clamped to it. Result in depth squared, in [0, 8.6e9].
/// Source: the variance of a linear function under a filter of equal deviations.
template <typename T, glm::qualifier Q>
T planeVariance(const glm::vec<2, T, Q>& gradient, T deviation)
{
    const T x = detail::clamp(gradient.x, T(-1), T(1));
    const T y = detail::clamp(gradient.y, T(-1), T(1));
    const T width = detail::clamp(deviation, T(0), T(65536));
    return (x * x + y * y) * (width * width);
}

/// Visibility of a slanted receiver from the moments of its layer and of the two neighbours, relative to its plane.
/// front, moments, behind: as bracketMoments takes them. covariances: of the three with the plane, as planeCovariance
/// gives them, each clamped to [-1,1]. depth: the receiver's, in [0,1]. interval: begin and end of the layer, or of the
/// union of layers that the plane reaches; its length counts as 2^-10 at least. variance: of the plane, clamped to
/// [0,1]. minVariance: the global floor in depth squared, >= 0. amount: light that what is left in the layer is reduced
/// by, as reduceLightBleeding takes it: occluders in the receiver's own layer are often spread from contact on, which
/// the bound takes for light; 0.15 suits meshes. Result in [0,1], an estimate and no bound.
/// Source: bracketMoments; boundedUpperBound of depth less the plane, whose departure is shared out among what is in
/// front, behind and left; the floor takes a tenth of the plane's variance, for what bends and for what is no Gaussian.
template <typename T, glm::qualifier Q, glm::qualifier QI>
T planeBracketedVisibility(const glm::vec<2, T, Q>& front, const glm::vec<2, T, Q>& moments,
                           const glm::vec<2, T, Q>& behind, const glm::vec<3, T, Q>& covariances, T depth,
                           const glm::vec<2, T, QI>& interval, T variance, T minVariance, T amount)
{
    const T spread = detail::clamp(variance, T(0), T(1));
    const T least = layerMinVariance(detail::maximum(minVariance, T(0.1) * spread), interval);
    const glm::vec<4, T, Q> left = bracketMoments(front, moments, behind, least);
    const T scale = T(1) / detail::clamp(interval.y - interval.x, T(0.0009765625), T(1));

    // Departures of the plane where the window is in front of the layer, behind it, and in it.
    const T shareInFront = detail::maximum(T(0), T(1) - left.x - left.y);
    const T inFront = scale * detail::clamp(covariances.x, T(-1), T(1)) * shareInFront /
                      detail::clamp(T(1) - front.x, T(0.001), T(1));
    const T own = scale * detail::clamp(covariances.y, T(-1), T(1));
    const T beyond = scale * detail::clamp(covariances.z, T(-1), T(1)) * left.x /
                     detail::clamp(behind.x, T(0.001), T(1));
    const T inverse = T(1) / detail::maximum(T(0.001), left.y);
    const T m1 = (left.z + (beyond - inFront)) * inverse;
    const T m2 = ((left.w - T(2) * (own - beyond)) + left.y * (spread * (scale * scale))) * inverse;

    const T bound = boundedUpperBound(glm::vec<2, T, Q>(m1, m2), layerWarp(depth, interval), least * inverse);
    return detail::clamp(left.x + left.y * reduceLightBleeding(bound, amount), T(0), T(1));
}

} // namespace lvsm

#endif
