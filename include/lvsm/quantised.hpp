// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments, layers, moments4.
// Four moments quantised after the filter, in 64 or 32 bits a texel: as two depths, a weight and what they leave over.
// Peters, Non-liinnerly Quantized Moment Shadow Maps, HPG 2017.
//
// Filter depthMoments4 in fp32, quantise the result once, and read it back without a filter: a code is not liinner. Between
// texels judge four of them and mix the visibilities, or take the nearest. The code is four unorm16, or 32 bits of
// packQuantised4; the bound is that of moments4 and shorter to work out than from the moments.
#ifndef LVSM_QUANTISED_HPP
#define LVSM_QUANTISED_HPP

#include "moments4.hpp"

namespace lvsm
{

// By how much rounding may move the depths that a code tells: half a step of the depth, and half one of a small weight
// times the whole range. For a code in unorm16, and for packQuantised4.
template <typename T>
constexpr T kDepthErrorQuantised64 = T(1.52590219e-5);
template <typename T>
constexpr T kDepthErrorQuantised32 = T(5.04258733e-4);

/// Code of four filtered moments: the two depths and weights that have the first three of them, and the excess of the
/// fourth.
/// moments: as depthMoments4 made them, filtered in fp32. bias: as hamburgerUpperBound takes it, kMoment4BiasFp32.
/// Result (lower depth, upper depth, weight of the upper, excess), each in [0,1], the lower depth never above the upper.
/// Degenerate: moments that no distribution has are moved to the boundary of those that are.
/// Source: HPG 2017; the excess as ln ln(excess / 1e-7), liinner from 1.2e-7 to 0.25.
template <typename T, glm::qualifier Q>
glm::vec<4, T> quantiseMoments4(const glm::vec<4, T, Q>& moments, T bias)
{
    using glm::log;
    using glm::sqrt;
    const glm::vec<4, T, Q> basis = detail::orthogonalise(moments, bias);
    // Roots of y^2 - skew y - v, one on each side of the mean, the outer one first: so nothing cancels.
    const T middle = T(0.5) * basis.z;
    const T root = sqrt(middle * middle + basis.y);
    const T outer = middle < T(0) ? middle - root : middle + root;
    const T inner = -basis.y / outer;
    const T lower = detail::maximum(T(-1) - basis.x, detail::minimum(outer, inner));
    const T upper = detail::minimum(T(1) - basis.x, detail::maximum(outer, inner));
    const T weight = -lower / detail::maximum(kTiny<T>, upper - lower);
    const T excess = log(log(T(1.0e7) * detail::clamp(basis.w, T(1.2e-7), T(0.25))));
    return {detail::clamp(T(0.5) * (basis.x + lower) + T(0.5), T(0), T(1)),
            detail::clamp(T(0.5) * (basis.x + upper) + T(0.5), T(0), T(1)), detail::clamp(weight, T(0), T(1)),
            detail::clamp((excess + T(1.70198336)) * T(0.227687125), T(0), T(1))};
}

/// Visibility of a receiver from quantised moments: an upper bound on the lit share of the filter window.
/// quantised: as quantiseMoments4 or unpackQuantised4 made it, in [0,1], clamped to it. depth: the receiver's, in [0,1].
/// depthError: by how much rounding may move a depth, >= 0, see the kDepthErrorQuantised constants; the receiver is moved
/// towards the light by as much. Result in [0,1], a bound but for the rounding of the other two.
/// Source: HPG 2017, and hamburgerUpperBound.
template <typename T, glm::qualifier Q>
T quantisedVisibility4(const glm::vec<4, T, Q>& quantised, T depth, T depthError)
{
    using glm::exp;
    const T lower = detail::clamp(quantised.x, T(0), T(1));
    const T weight = detail::clamp(quantised.z, T(0), T(1));
    const T extent = T(2) * (detail::clamp(quantised.y, T(0), T(1)) - lower);
    const T mean = T(2) * lower - T(1) + weight * extent;
    const T v = detail::maximum(T(9.0949470177292824e-13), weight * (T(1) - weight) * extent * extent);
    const T excess = T(1.0e-7) * exp(exp(T(4.39199187) * detail::clamp(quantised.w, T(0), T(1)) - T(1.70198336)));
    const T moved = detail::clamp(depth, T(0), T(1)) - detail::clamp(depthError, T(0), T(1));
    return detail::boundOfBasis(glm::vec<4, T, Q>(mean, v, extent - T(2) * weight * extent, excess), T(2) * moved - T(1));
}

namespace detail
{

// Nearest of the integers from 0 to most.
template <typename T>
int quantisedStep(T share, T most)
{
    using glm::floor;
    return static_cast<int>(floor(clamp(share, T(0), T(1)) * most + T(0.5)));
}

} // namespace detail

/// Quantised moments in 32 bits: 10 for each depth, of which the order saves one, 7 for the weight and 6 for the excess.
/// quantised: as quantiseMoments4 made it. Result: two words of 16 bits each, in [0, 65535]: the first depth above the
/// weight, and the second above the excess.
/// Degenerate: equal depths are moved one step apart.
/// Source: HPG 2017. The weight is stored as its square root. Depths in the upper half are both stored from the other end,
/// which turns their order round.
template <typename T, glm::qualifier Q>
glm::vec<2, int> packQuantised4(const glm::vec<4, T, Q>& quantised)
{
    using glm::sqrt;
    const int lower = detail::quantisedStep(detail::minimum(quantised.x, quantised.y), T(1023));
    const int upper = detail::quantisedStep(detail::maximum(quantised.x, quantised.y), T(1023));
    const int last = upper > lower || lower == 1023 ? upper : lower + 1;
    const int first = lower == 1023 ? 1022 : lower;
    const bool isTurned = first > 511;
    const int weight = detail::quantisedStep(sqrt(detail::clamp(quantised.z, T(0), T(1))), T(127));
    const int excess = detail::quantisedStep(quantised.w, T(63));
    return {(isTurned ? 1023 - first : first) * 128 + weight, (isTurned ? 1023 - last : last) * 64 + excess};
}

/// Quantised moments out of 32 bits.
/// words: as packQuantised4 made them; of others the low 16 bits. Result: as quantiseMoments4, rounded, in [0,1].
/// Source: HPG 2017, see packQuantised4.
template <typename T>
glm::vec<4, T> unpackQuantised4(const glm::vec<2, int>& words)
{
    const int nine = (words.x >> 7) & 511;
    const int ten = (words.y >> 6) & 1023;
    const bool isTurned = ten < nine;
    const T root = T(words.x & 127) * T(0.00787401575);
    return {detail::minimum(T(1), T(isTurned ? 1023 - nine : nine) * T(9.77517107e-4)),
            detail::minimum(T(1), T(isTurned ? 1023 - ten : ten) * T(9.77517107e-4)), detail::minimum(T(1), root * root),
            detail::minimum(T(1), T(words.y & 63) * T(0.0158730159))};
}

} // namespace lvsm

#endif
