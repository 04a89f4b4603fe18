#include <lvsm/config.hpp>

#include <doctest/doctest.h>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

TEST_CASE_TEMPLATE("the limits are powers of two that every format of 32 bits holds", T, float, double)
{
    CHECK(kTiny<T> == T(std::numeric_limits<float>::min()));
    CHECK(kRootTiny<T> * kRootTiny<T> == kTiny<T>);
    CHECK(kTiny<T> * kHuge<T> == 1);
    CHECK(double(kMaxUniformLayers) == 0x1p16);
}

TEST_CASE_TEMPLATE("minimum, maximum and clamp are the shaders', and give an answer to NaN", T, float, double)
{
    CHECK(detail::minimum(T(1), T(2)) == 1);
    CHECK(detail::minimum(T(2), T(1)) == 1);
    CHECK(detail::maximum(T(1), T(2)) == 2);
    CHECK(detail::maximum(T(2), T(1)) == 2);
    CHECK(detail::clamp(T(3), T(1), T(2)) == 2);
    CHECK(detail::clamp(T(-3), T(1), T(2)) == 1);
    CHECK(detail::clamp(T(1.5), T(1), T(2)) == T(1.5));
    CHECK(detail::rounded(T(0.1)) == T(0.1));
    LVSM_NOT_WITH_FAST_MATH("NaN");
    const T nan = std::numeric_limits<T>::quiet_NaN();
    CHECK(detail::minimum(T(1), nan) == 1);
    CHECK(detail::maximum(T(1), nan) == 1);
    CHECK(detail::clamp(nan, T(1), T(2)) == 1);
}

TEST_CASE_TEMPLATE("isFinite tells NaN and infinity by their bits, whatever a NaN carries", T, float, double)
{
    using Limits = std::numeric_limits<T>;
    for (const T value : {T(0), T(1), Limits::max(), Limits::lowest(), Limits::min(), Limits::denorm_min()})
        CHECK(detail::isFinite(value));
    for (const Bits<T> carried : {Bits<T>(0), Bits<T>(1), Bits<T>(2), Bits<T>(0x155555)})
    {
        for (const T sign : {T(1), T(-1)})
        {
            const Bits<T> bits = bitsOf(sign * Limits::infinity()) | carried;
            T value;
            std::memcpy(&value, &bits, sizeof value);
            CHECK_FALSE(detail::isFinite(value));
        }
    }
}

} // namespace
} // namespace lvsm::unit
