// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config.
// Convolution shadow maps: the depth test as a Fourier series, whose terms in the occluder's depth filter linearly.
// Annen, Mertens, Bekaert, Seidel & Kautz, Convolution Shadow Maps, Eurographics Symposium on Rendering 2007.
//
// The test of t = z - d, 1 for t >= 0, is 1/2 + 2 sum of sin(c_k t) / c_k, with c_k = (2k - 1) pi for k = 1 to the
// order. sin(c_k (z - d)) separates into sines and cosines of z, which are stored, four terms to a texel each, and
// those of d. The series has period 2, and towards -1 and 1 it turns back to 1/2: depths are shrunk here by twice the
// distance from a step to its crest, so that no two depths, with that offset between them, come so far apart.
#ifndef LVSM_CONVOLUTION_HPP
#define LVSM_CONVOLUTION_HPP

#include "config.hpp"

#include <glm/vec4.hpp>

namespace lvsm
{

// Most terms: far more than any memory holds.
constexpr int kMaxFourierOrder = 256;

template <typename T>
constexpr T kPi = T(3.14159265358979323846);

/// What a receiver is moved towards the light so that a lit surface is on the first crest of the series, not at 1/2.
/// order: number of terms, from 2 to 256, clamped to it. Result in depth, in (0, 1/4]: 1 / (2 order), 0.031 for 16.
/// Source: the first zero of the derivative of the series, sin(2 order pi t) / sin(pi t).
template <typename T = float>
T fourierOffset(int order)
{
    return T(0.5) / static_cast<T>(detail::clamp(order, 2, kMaxFourierOrder));
}

namespace detail
{

// The angle c_k of one term times a depth, in [-pi, pi], where sines and cosines have their stated precision.
template <typename T>
T fourierAngle(T depth, int index)
{
    const T halfTurns = depth * static_cast<T>(2 * index - 1);
    const T wanted = T(0.5) * halfTurns + T(0.5);
    const int towardsZero = static_cast<int>(wanted);
    const int turns = static_cast<T>(towardsZero) > wanted ? towardsZero - 1 : towardsZero;
    return kPi<T> * (halfTurns - T(2) * static_cast<T>(turns));
}

// Depth shrunk so that the series does not reach its next step.
template <typename T>
T fourierDepth(T depth, int order)
{
    return (T(1) - T(2) * fourierOffset<T>(order)) * clamp(depth, T(0), T(1));
}

} // namespace detail

/// Sines to store of four terms for one depth.
/// depth: in [0,1], clamped to it. first: number of the first of the four terms, counted from 1, clamped to [1, 256].
/// order: number of all terms, from 2 to 256, clamped to it. Result: each in [-1,1]; terms beyond the order are unused.
/// A texel without any surface stores depth 1.
/// Source: CSM's basis functions sin(c_k z).
template <typename T>
glm::vec<4, T> fourierSines(T depth, int first, int order)
{
    using glm::sin;
    const int k = detail::clamp(first, 1, kMaxFourierOrder);
    const T z = detail::fourierDepth(depth, order);
    const auto sine = [z](int index) { return detail::clamp(sin(detail::fourierAngle(z, index)), T(-1), T(1)); };
    return {sine(k), sine(k + 1), sine(k + 2), sine(k + 3)};
}

/// Cosines to store of four terms for one depth.
/// depth: in [0,1], clamped to it. first: number of the first of the four terms, counted from 1, clamped to [1, 256].
/// order: number of all terms, from 2 to 256, clamped to it. Result: each in [-1,1]; terms beyond the order are unused.
/// A texel without any surface stores depth 1.
/// Source: CSM's basis functions cos(c_k z).
template <typename T>
glm::vec<4, T> fourierCosines(T depth, int first, int order)
{
    using glm::cos;
    const int k = detail::clamp(first, 1, kMaxFourierOrder);
    const T z = detail::fourierDepth(depth, order);
    const auto cosine = [z](int index) { return detail::clamp(cos(detail::fourierAngle(z, index)), T(-1), T(1)); };
    return {cosine(k), cosine(k + 1), cosine(k + 2), cosine(k + 3)};
}

/// Sines or cosines as an unsigned 8-bit format holds them: -1, 0 and 1 fall on whole codes, 1, 128 and 255.
/// terms: each clamped to [-1,1]. Result: each in [1/255, 1]. Filtering may come after it.
/// Source: (127 x + 128) / 255.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> encodeFourier(const glm::vec<4, T, Q>& terms)
{
    // At most 1 also where -ffast-math multiplies by a rounded inverse.
    const auto encode = [](T x) {
        return detail::minimum(T(1), (T(127) * detail::clamp(x, T(-1), T(1)) + T(128)) / T(255));
    };
    return {encode(terms.x), encode(terms.y), encode(terms.z), encode(terms.w)};
}

/// Sines or cosines back from an unsigned 8-bit format.
/// texel: as encodeFourier made it, filtered; each clamped to [0,1]. Result: each in [-1,1].
/// Source: the inverse of encodeFourier.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> decodeFourier(const glm::vec<4, T, Q>& texel)
{
    const auto decode = [](T x) {
        return detail::clamp((T(255) * detail::clamp(x, T(0), T(1)) - T(128)) / T(127), T(-1), T(1));
    };
    return {decode(texel.x), decode(texel.y), decode(texel.z), decode(texel.w)};
}

/// Factor of one term that suppresses the ringing of the cut series, at the cost of a softer step.
/// index: of the term, counted from 1, clamped to [1, order]. order: number of terms, from 2 to 256, clamped to it.
/// strength: 0 leaves the term as it is, less counts as 0; at most 2^126. Result in [0,1], falling with index.
/// Source: CSM's attenuation e^(-strength (k / order)^2).
template <typename T>
T fourierAttenuation(int index, int order, T strength)
{
    using glm::exp;
    const int count = detail::clamp(order, 2, kMaxFourierOrder);
    const T ratio = static_cast<T>(detail::clamp(index, 1, count)) / static_cast<T>(count);
    return detail::clamp(exp(-detail::clamp(strength, T(0), kHuge<T>) * (ratio * ratio)), T(0), T(1));
}

namespace detail
{

// Share of one term in the sum, 0 beyond the order.
template <typename T>
T fourierShare(T sine, T cosine, T receiver, int index, int order, T strength)
{
    using glm::cos;
    using glm::sin;
    if (index > order)
        return T(0);
    const T angle = fourierAngle(receiver, index);
    const T weight = T(2) * fourierAttenuation(index, order, strength) / (kPi<T> * static_cast<T>(2 * index - 1));
    return weight * (cos(angle) * clamp(sine, T(-1), T(1)) - sin(angle) * clamp(cosine, T(-1), T(1)));
}

} // namespace detail

/// Share of four terms in the series at a receiver: add those of all terms and pass the sum to fourierVisibility.
/// sines, cosines: as stored for the four terms, filtered, each clamped to [-1,1]. depth: the receiver's, in [0,1],
/// clamped to it. offset: towards the light, clamped to [0,1], see fourierOffset. first: number of the first of the
/// four, counted from 1, clamped to [1, 256]. order: number of all terms, from 2 to 256, clamped to it; terms beyond it
/// count nothing. strength: of fourierAttenuation. Result in [-1.51, 1.51].
/// Source: CSM's reconstruction, 2 / c_k (cos(c_k d) sin(c_k z) - sin(c_k d) cos(c_k z)).
template <typename T, glm::qualifier Q>
T fourierSum(const glm::vec<4, T, Q>& sines, const glm::vec<4, T, Q>& cosines, T depth, T offset, int first, int order,
             T strength)
{
    const int k = detail::clamp(first, 1, kMaxFourierOrder);
    const int count = detail::clamp(order, 2, kMaxFourierOrder);
    const T moved = detail::fourierDepth(depth, count) - detail::clamp(offset, T(0), T(1));
    return detail::fourierShare(sines.x, cosines.x, moved, k, count, strength) +
           detail::fourierShare(sines.y, cosines.y, moved, k + 1, count, strength) +
           detail::fourierShare(sines.z, cosines.z, moved, k + 2, count, strength) +
           detail::fourierShare(sines.w, cosines.w, moved, k + 3, count, strength);
}

/// Visibility of a receiver from the summed series.
/// sum: of fourierSum over all terms. scale: 1, or 2 to take what a surface has of itself without offset, 1/2, for full
/// light; >= 0, less counts as 0, at most 2^126. Result in [0,1].
/// Source: CSM's reconstruction, scaled and clamped.
template <typename T>
T fourierVisibility(T sum, T scale)
{
    return detail::clamp(detail::clamp(scale, T(0), kHuge<T>) * detail::clamp(T(0.5) + sum, T(0), T(1)), T(0), T(1));
}

} // namespace lvsm

#endif
