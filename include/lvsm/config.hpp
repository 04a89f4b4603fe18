// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM.
// Settings and constants that every topic shares.
#ifndef LVSM_CONFIG_HPP
#define LVSM_CONFIG_HPP

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/trigonometric.hpp>

// Version of the library: 10000 times the major number, 100 times the minor one, and the patch.
#define LVSM_VERSION 100

// Settings. Define any of them before the first include.

// Checks the preconditions that a function cannot make good, such as a pointer that must not be null.
#ifndef LVSM_ASSERT
#include <cassert>
#define LVSM_ASSERT(condition) assert(condition)
#endif

namespace lvsm
{

// Smallest normal float, 2^-126: GPUs may flush what is smaller, and promise nothing for division by it.
template <typename T>
constexpr T kTiny = T(1.17549435082228750797e-38);

// 2^-63, the square root of 2^-126: a smaller distance has no normal square.
template <typename T>
constexpr T kRootTiny = T(1.08420217248550443401e-19);

// 2^126: the largest divisor for which Vulkan promises the precision of a division.
template <typename T>
constexpr T kHuge = T(8.50705917302346158658e37);

// Most layers that uniform splits are counted for: far more than any memory holds, and safe to multiply in float.
constexpr int kMaxUniformLayers = 65536;

namespace detail
{

// The shaders' built-ins, with a defined answer to NaN: clamp gives lo, so that every range below holds.
template <typename T>
constexpr T min(T a, T b)
{
    return b < a ? b : a;
}

template <typename T>
constexpr T max(T a, T b)
{
    return b > a ? b : a;
}

template <typename T>
constexpr T clamp(T x, T lo, T hi)
{
    return min(max(lo, x), hi);
}

} // namespace detail
} // namespace lvsm

#endif
