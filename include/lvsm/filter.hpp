// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config.
// Filter kernels: weights of separable blurs, pairs of taps that one bilinear fetch serves, and the head room of sums.
#ifndef LVSM_FILTER_HPP
#define LVSM_FILTER_HPP

#include "config.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace lvsm
{

// Most taps that a kernel is computed for.
constexpr int kMaxFilterSize = 65;

/// Weight of one tap of a binomial filter: a row of Pascal's triangle, normalised.
/// index: of the tap, from 0 to size - 1; any other weighs 0. size: number of taps, from 1 to 65, clamped to it.
/// Result in [0,1]. The weights of a size add up to 1; their variance is (size - 1) / 4 texels squared.
/// Source: the binomial coefficient C(size - 1, index) / 2^(size - 1).
template <typename T = float>
T binomialWeight(int index, int size)
{
    const int last = detail::clamp(size, 1, kMaxFilterSize) - 1;
    if (index < 0 || index > last)
        return T(0);
    const int steps = detail::minimum(index, last - index);
    T weight = T(1);
    for (int j = 1; j <= last; ++j)
    {
        weight = T(0.5) * weight;
        if (j <= steps)
            weight = weight * (static_cast<T>(last + 1 - j) / static_cast<T>(j));
    }
    return weight;
}

namespace detail
{

// A Gaussian at one of count taps, 1 at the tap or taps in the middle. Distances from the middle are m / 2 for integers
// m of one parity: relative to the least of them even a vanishing sigma leaves the middle its weight.
template <typename T>
T gaussianFalloff(int index, int count, T sigma)
{
    using glm::exp;
    const T deviation = clamp(sigma, T(0.015625), T(1048576.0));
    const int m = 2 * index - (count - 1);
    const T squared = T(0.25) * static_cast<T>(m * m - (1 - (count & 1)));
    return exp(T(-0.5) * squared / (deviation * deviation));
}

} // namespace detail

/// Weight of one tap of a Gaussian filter, sampled at the taps' centres and normalised.
/// index: of the tap, from 0 to size - 1; any other weighs 0. size: number of taps, from 1 to 65, clamped to it.
/// sigma: standard deviation in texels, from 1/64 to 2^20, clamped to it.
/// Result in [0,1]. The weights of a size add up to 1.
/// Degenerate: the least sigma leaves the middle alone, the greatest is a box.
/// Source: e^(-x^2 / (2 sigma^2)), x the distance from the middle.
template <typename T>
T gaussianWeight(int index, int size, T sigma)
{
    const int count = detail::clamp(size, 1, kMaxFilterSize);
    if (index < 0 || index >= count)
        return T(0);
    T sum = T(0);
    for (int i = 0; i < count; ++i)
        sum = sum + detail::gaussianFalloff(i, count, sigma);
    return detail::clamp(detail::gaussianFalloff(index, count, sigma) / detail::maximum(T(1), sum), T(0), T(1));
}

/// Weight of one texel of a box filter of any width, whole texels or not.
/// offset: of the texel's centre from the box's, in texels. width: in texels, from 2^-20 to 2^20, clamped to it.
/// Result in [0,1]: the texel's share of the box. The weights of all texels add up to 1 wherever the box is centred.
/// Degenerate: a box inside one texel gives that texel all.
/// Source: the overlap of two intervals, divided by the width.
template <typename T>
T boxWeight(T offset, T width)
{
    using glm::abs;
    const T extent = detail::clamp(width, T(9.5367431640625e-7), T(1048576.0));
    const T reach = T(0.5) * extent;
    const T centre = detail::clamp(abs(offset), T(0), T(2097152.0));
    const T overlap = detail::minimum(centre + T(0.5), reach) - detail::maximum(centre - T(0.5), -reach);
    return detail::clamp(overlap / extent, T(0), T(1));
}

/// Two neighbouring taps as one bilinear fetch.
/// first, second: their weights, from 0 to 2^125, clamped to it.
/// Result: the fetch's offset from the first tap's centre towards the second's, in [0,1] texels, and its weight, the
/// sum of the two, in [0, 2^126]. Hardware that keeps 8 bits of the offset misplaces up to 2^-9 of that weight.
/// Degenerate: two weights of 0 give (0, 0).
/// Source: first a + second b = (first + second) mix(a, b, offset), solved for offset.
template <typename T>
glm::vec<2, T> linearPair(T first, T second)
{
    const T a = detail::clamp(first, T(0), T(0.5) * kHuge<T>);
    const T b = detail::clamp(second, T(0), T(0.5) * kHuge<T>);
    return {detail::clamp(b / detail::maximum(kTiny<T>, a + b), T(0), T(1)), a + b};
}

/// One bilinear fetch of a binomial filter: size taps cost (size + 1) / 2 fetches, so 9 taps cost 5.
/// index: of the fetch, from 0 to (size - 1) / 2; any other gives (0, 0). size: taps, from 1 to 65, clamped to it.
/// Result: the fetch's offset from the filter's centre, in texels, in [-32, 32], and its weight, in [0,1].
/// Source: linearPair of taps 2 index and 2 index + 1.
template <typename T = float>
glm::vec<2, T> binomialTap(int index, int size)
{
    const int last = detail::clamp(size, 1, kMaxFilterSize) - 1;
    if (index < 0 || index > last / 2)
        return {T(0), T(0)};
    const glm::vec<2, T> pair = linearPair(binomialWeight<T>(2 * index, size), binomialWeight<T>(2 * index + 1, size));
    return {static_cast<T>(2 * index) - T(0.5) * static_cast<T>(last) + pair.x, pair.y};
}

/// One bilinear fetch of a Gaussian filter: size taps cost (size + 1) / 2 fetches, so 9 taps cost 5.
/// index: of the fetch, from 0 to (size - 1) / 2; any other gives (0, 0). size: taps, from 1 to 65, clamped to it.
/// sigma: standard deviation in texels, from 1/64 to 2^20, clamped to it.
/// Result: the fetch's offset from the filter's centre, in texels, in [-32, 32], and its weight, in [0,1].
/// Source: linearPair of taps 2 index and 2 index + 1.
template <typename T>
glm::vec<2, T> gaussianTap(int index, int size, T sigma)
{
    const int last = detail::clamp(size, 1, kMaxFilterSize) - 1;
    if (index < 0 || index > last / 2)
        return {T(0), T(0)};
    const glm::vec<2, T> pair =
        linearPair(gaussianWeight(2 * index, size, sigma), gaussianWeight(2 * index + 1, size, sigma));
    return {static_cast<T>(2 * index) - T(0.5) * static_cast<T>(last) + pair.x, detail::minimum(T(1), pair.y)};
}

/// How often a binomial sum with whole weights, not yet divided, holds its largest sample: head room for maxExponent.
/// size: number of taps, from 1 to 65, clamped to it. dimensions: 1 for one pass of a separable blur, 2 for both before
/// the division, from 1 to 3, clamped to it. Result in [1, 2^126]: 2^((size - 1) dimensions).
/// Source: the sum of a row of Pascal's triangle.
template <typename T = float>
T binomialHeadRoom(int size, int dimensions)
{
    const int doublings =
        detail::minimum((detail::clamp(size, 1, kMaxFilterSize) - 1) * detail::clamp(dimensions, 1, 3), 126);
    T room = T(1);
    for (int i = 0; i < doublings; ++i)
        room = T(2) * room;
    return room;
}

/// How often a sum over a rectangle, not yet divided, holds its largest sample: head room for maxExponent.
/// width, height: of the box in texels, or of the whole map for a summed-area table, from 1 to 2^63, clamped to it.
/// Result: width height, in [1, 2^126].
/// Source: the sum of that many samples, each at most the largest.
template <typename T>
T boxHeadRoom(T width, T height)
{
    const T limit = T(9.223372036854775808e18);
    return detail::clamp(width, T(1), limit) * detail::clamp(height, T(1), limit);
}

/// Visibility between four texels, after each has been tested: the order that percentage-closer filtering needs.
/// corners: of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy; each clamped to [0,1].
/// fraction: position between the centres of the first and the last, each component clamped to [0,1]. Result in [0,1].
/// Source: bilinear interpolation.
template <typename T, glm::qualifier Q>
T bilinearVisibility(const glm::vec<4, T, Q>& corners, const glm::vec<2, T, Q>& fraction)
{
    const T x = detail::clamp(fraction.x, T(0), T(1));
    const T y = detail::clamp(fraction.y, T(0), T(1));
    // Rounded: made one with the products, it would cancel where x is 1.
    const T left = detail::rounded(T(1) - x);
    const T top = detail::clamp(corners.x, T(0), T(1)) * left + detail::clamp(corners.y, T(0), T(1)) * x;
    const T bottom = detail::clamp(corners.z, T(0), T(1)) * left + detail::clamp(corners.w, T(0), T(1)) * x;
    return detail::clamp(top * detail::rounded(T(1) - y) + bottom * y, T(0), T(1));
}

} // namespace lvsm

#endif
