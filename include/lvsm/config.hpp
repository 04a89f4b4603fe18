// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM.
// Settings and constants that every topic shares.
#ifndef LVSM_CONFIG_HPP
#define LVSM_CONFIG_HPP

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/trigonometric.hpp>

#include <cstdint>
#include <cstring>
#include <type_traits>

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

// The shaders' built-ins, with a defined answer to NaN: clamp gives lo, so that every range below holds. Not min and
// max, which are macros once Windows' headers are included.
template <typename T>
constexpr T minimum(T a, T b)
{
    return b < a ? b : a;
}

template <typename T>
constexpr T maximum(T a, T b)
{
    return b > a ? b : a;
}

template <typename T>
constexpr T clamp(T x, T lo, T hi)
{
    return minimum(maximum(lo, x), hi);
}

// A value rounded to T before it goes on. Where terms should cancel, they do only if each was rounded: compilers make
// one operation, which rounds once, of a product and a sum (-mfma or -march=native on x86, any build for ARM), and
// another formula with -ffast-math. So such terms pass through here, where no compiler sees through. Shaders say
// LVSM_PRECISE at the same places. x86 without FMA needs nothing, and vectors of receivers stay vectors.
template <typename T>
T rounded(T x)
{
    if constexpr (std::is_floating_point_v<T>)
    {
#if !defined(__GNUC__)
        volatile T kept = x;
        x = kept;
#elif !defined(__SSE2_MATH__) || defined(__FMA__) || defined(__FMA4__) || defined(__FAST_MATH__) || \
    defined(__ASSOCIATIVE_MATH__)
        __asm__("" : "+m"(x));
#endif
    }
    return x;
}

// Whether a number is neither NaN nor infinite, by its bits in memory: -ffast-math takes that for granted.
template <typename T>
bool isFinite(const T& x)
{
    static_assert(sizeof(T) == 4 || sizeof(T) == 8, "float or double");
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    constexpr Bits kExponent = sizeof(T) == 4 ? Bits(0x7F800000) : static_cast<Bits>(0x7FF0000000000000);
    Bits bits;
    std::memcpy(&bits, &x, sizeof bits);
    return (bits & kExponent) != kExponent;
}

} // namespace detail
} // namespace lvsm

#endif
