// Numbers to test with, and the tally of tests too many for a doctest check each.
#ifndef LVSM_TESTS_UNIT_NUMBERS_HPP
#define LVSM_TESTS_UNIT_NUMBERS_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace lvsm::unit
{

template <typename T>
using Vec2 = glm::vec<2, T>;
template <typename T>
using Vec3 = glm::vec<3, T>;
template <typename T>
using Vec4 = glm::vec<4, T>;

// Truth is worked out in this type.
using Exact = long double;

// How many of this many random inputs are drawn: all, but for an emulated processor (tests/configurations).
#ifndef LVSM_UNIT_SHARE
#define LVSM_UNIT_SHARE 1
#endif
constexpr int drawsOf(int count)
{
    return count / LVSM_UNIT_SHARE;
}

// Largest relative error of one rounding.
template <typename T>
constexpr Exact kRoundoff = std::numeric_limits<T>::epsilon() / Exact(2);

template <typename T>
using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

template <typename T>
Bits<T> bitsOf(T value)
{
    Bits<T> bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

// By its bits: -ffast-math takes NaN and infinity for impossible, and answers for them what is fastest.
template <typename T>
bool isFinite(T value)
{
    const T infinity = std::numeric_limits<T>::infinity();
    return (bitsOf(value) & bitsOf(infinity)) != bitsOf(infinity);
}

// -ffast-math takes NaN and infinity for impossible and subnormal numbers for 0. So nothing is promised for them there,
// and the tests leave them out.
#ifdef __FAST_MATH__
constexpr bool kFastMath = true;
#else
constexpr bool kFastMath = false;
#endif

template <typename T>
bool isBorne(T value)
{
    const Bits<T> magnitude = bitsOf(value) & ~bitsOf(T(-0.0));
    return !kFastMath || (isFinite(value) && (magnitude == 0 || magnitude >= bitsOf(std::numeric_limits<T>::min())));
}

// The largest number under x that the compiler's settings bear.
template <typename T>
T justBelow(T x)
{
    const T next = std::nextafter(x, std::numeric_limits<T>::lowest());
    return isBorne(next) ? next : -std::numeric_limits<T>::min();
}

// The standard fixes the engine's output but not the distributions'; the numbers are the same everywhere.
class Random
{
public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}

    int between(int low, int high)
    {
        const auto choices = static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
        return static_cast<int>(low + static_cast<std::int64_t>(m_engine() % choices));
    }

    // In [0,1), as fine as T holds.
    template <typename T>
    T unit()
    {
        constexpr int digits = std::numeric_limits<T>::digits;
        return std::ldexp(static_cast<T>(m_engine() >> (64 - digits)), -digits);
    }

    // Any bit pattern, NaN and infinity included where they are borne.
    template <typename T>
    T pattern()
    {
        T value;
        do
        {
            const auto bits = static_cast<Bits<T>>(m_engine() >> (64 - 8 * sizeof(T)));
            std::memcpy(&value, &bits, sizeof value);
        } while (!isBorne(value));
        return value;
    }

    template <typename T>
    T finitePattern()
    {
        T value = pattern<T>();
        while (!isFinite(value))
            value = pattern<T>();
        return value;
    }

private:
    std::mt19937_64 m_engine;
};

// Where arithmetic turns: ends, subnormals, the library's own limits, overflow, infinity and NaN.
template <typename T>
std::vector<T> specialValues()
{
    using Limits = std::numeric_limits<T>;
    std::vector<T> values{T(0),
                          T(1),
                          T(2),
                          T(0.25),
                          T(0.5),
                          T(43.3216),
                          T(65536),
                          T(1.0e18),
                          T(0x1p-63),
                          T(0x1p-126),
                          T(0x1p-127),
                          T(0x1p126),
                          Limits::min(),
                          Limits::denorm_min(),
                          Limits::epsilon(),
                          Limits::max(),
                          Limits::infinity(),
                          std::nextafter(T(1), T(0)),
                          std::nextafter(T(1), T(2))};
    for (std::size_t i = 0, count = values.size(); i < count; ++i)
        values.push_back(-values[i]);
    values.push_back(Limits::quiet_NaN());
    values.erase(std::remove_if(values.begin(), values.end(), [](T value) { return !isBorne(value); }), values.end());
    return values;
}

// Rounds to the 11 significant bits of fp16, to infinity past its largest value.
inline double toFp16(double x)
{
    if (!isFinite(x))
        return x;
    const double step = std::ldexp(1.0, std::max(std::ilogb(x), -14) - 10);
    const double nearest = std::nearbyint(x / step) * step;
    return nearest > 65504.0 ? std::numeric_limits<double>::infinity() : nearest;
}

// Many claims of one kind: how many were made, and the values at the first that failed.
class Tally
{
public:
    template <typename... Values>
    void claim(bool holds, const Values&... values)
    {
        ++m_claims;
        if (!holds && m_failures++ == 0)
        {
            std::ostringstream text;
            text.precision(20);
            ((text << values << ' '), ...);
            m_first = text.str();
        }
    }

    // That no claim was made must not pass either.
    bool holds() const { return m_claims > 0 && m_failures == 0; }

    std::string summary() const
    {
        return std::to_string(m_failures) + " of " + std::to_string(m_claims) + " failed, first at " + m_first;
    }

private:
    long m_claims = 0;
    long m_failures = 0;
    std::string m_first;
};

} // namespace lvsm::unit

// Ends a test of what -ffast-math does not promise, and says so.
#define LVSM_NOT_WITH_FAST_MATH(why) \
    if (kFastMath) \
    { \
        MESSAGE("left out with -ffast-math: " why); \
        return; \
    }

#define LVSM_CHECK_TALLY(tally) CHECK_MESSAGE((tally).holds(), (tally).summary())

#endif
