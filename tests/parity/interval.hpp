// What Vulkan lets a device answer: an interval for every float operation, and every outcome of an unsure comparison.
//
// The library's templates run on Interval as they run on double. Where an operation is inexact, its interval grows as
// far as the specification allows (Vulkan 1.3, appendix "Precision and Operation of SPIR-V Instructions"): add, subtract
// and multiply give one of the two neighbouring floats, divide 2.5 ULP for divisors from 2^-126 to 2^126, exp
// 3 + 2 |x| ULP, log 3 ULP or 2^-21 near 1, sin and cos 2^-11, and a number under 2^-126 may be flushed to 0. A fused
// multiply-add lies inside. So the tolerance of a result follows from the formula and its input, from no device.
//
// Compilers also factor and cancel terms (Mesa turns a/4 + b/4 into (a + b)/4, and 1 + x - 1 into x) where a formula
// does not say precise; such results lie inside too, unless the formula cancels, and then it has to say precise.
//
// Where a language cannot say precise, Order::Any lets every term that the formula rounds on its own be off by a few units.
//
// A comparison of overlapping intervals has two outcomes. enumerateOutcomes runs a function once for each combination.
#ifndef LVSM_PARITY_INTERVAL_HPP
#define LVSM_PARITY_INTERVAL_HPP

#include <lvsm/config.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

namespace parity
{

// Of sums and products: as they are written, or as a language without `precise` leaves them to its compiler.
enum class Order
{
    AsWritten,
    Any
};

// What another order costs, in units of 2^-24: at most four terms, each rounded, and once more by what follows.
constexpr double kOtherOrder = 8.0 / (1 << 24);

// The decisions of one run, and the way to the next run.
class Decisions
{
public:
    static Decisions& current()
    {
        static thread_local Decisions decisions;
        return decisions;
    }

    void start()
    {
        m_taken.clear();
        m_position = 0;
    }

    // One of count outcomes, 0 first.
    int choose(int count)
    {
        if (m_position == m_taken.size())
            m_taken.push_back({0, count});
        return m_taken[m_position++].outcome;
    }

    // Moves on to the next combination; false after the last.
    bool next()
    {
        while (!m_taken.empty() && m_taken.back().outcome + 1 >= m_taken.back().count)
            m_taken.pop_back();
        if (m_taken.empty())
            return false;
        ++m_taken.back().outcome;
        m_position = 0;
        return true;
    }

private:
    struct Decision
    {
        int outcome;
        int count;
    };
    std::vector<Decision> m_taken;
    std::size_t m_position = 0;
};

// Calls run() for every combination of outcomes, at most limit times. False where there are more.
template <typename Run>
bool enumerateOutcomes(int limit, const Run& run)
{
    Decisions& decisions = Decisions::current();
    decisions.start();
    for (int i = 0; i < limit; ++i)
    {
        run();
        if (!decisions.next())
            return true;
    }
    return false;
}

class Interval
{
public:
    Interval() = default;
    // A constant, which a shader's compiler rounds to the nearest float.
    constexpr explicit Interval(double value)
        : m_lo(static_cast<float>(value) < value ? static_cast<float>(value) : value),
          m_hi(static_cast<float>(value) > value ? static_cast<float>(value) : value)
    {
    }
    constexpr explicit Interval(int value) : m_lo(value), m_hi(value) {}
    constexpr Interval(double lo, double hi) : m_lo(lo), m_hi(hi) {}

    constexpr double lo() const { return m_lo; }
    constexpr double hi() const { return m_hi; }

    // An argument: a subnormal one may reach the operation as 0.
    static Interval argument(float value) { return flushed(static_cast<double>(value), static_cast<double>(value)); }

    explicit operator int() const
    {
        const int first = static_cast<int>(std::clamp(m_lo, -2147483648.0, 2147483647.0));
        const int last = static_cast<int>(std::clamp(m_hi, -2147483648.0, 2147483647.0));
        if (first == last)
            return first;
        // Of many outcomes the least few and the greatest.
        const int outcome = Decisions::current().choose(std::min(last - first, 7) + 1);
        return outcome < 7 ? first + outcome : last;
    }

    // The result of an operation that may give either float next to the exact value.
    static Interval rounded(double lo, double hi)
    {
        return std::isnan(lo) || std::isnan(hi) ? anything() : flushed(floatBelow(lo), floatAbove(hi));
    }

    // Of the formulas that follow.
    static inline thread_local Order order = Order::AsWritten;

    // A term that `precise` would round on its own.
    static Interval term(Interval x)
    {
        const double more = order == Order::Any ? kOtherOrder : 0.0;
        return {x.lo() - more * std::abs(x.lo()), x.hi() + more * std::abs(x.hi())};
    }

    // The result of an operation with an error of so many units in the last place.
    static Interval within(double lo, double hi, double units)
    {
        return rounded(lo - units * unitInLastPlace(lo), hi + units * unitInLastPlace(hi));
    }

    static Interval anything()
    {
        const double infinity = std::numeric_limits<double>::infinity();
        return {-infinity, infinity};
    }

    static double unitInLastPlace(double x)
    {
        return x == 0.0 || std::isinf(x) ? 0.0 : std::ldexp(1.0, std::max(std::ilogb(x), -126) - 23);
    }

private:
    static Interval flushed(double lo, double hi)
    {
        const double tiny = lvsm::kTiny<double>;
        return {lo > 0.0 && lo < tiny ? 0.0 : lo, hi < 0.0 && hi > -tiny ? 0.0 : hi};
    }

    static double floatBelow(double x)
    {
        const float nearest = static_cast<float>(x);
        return static_cast<double>(nearest) > x ? std::nextafter(nearest, -HUGE_VALF) : nearest;
    }

    static double floatAbove(double x)
    {
        const float nearest = static_cast<float>(x);
        return static_cast<double>(nearest) < x ? std::nextafter(nearest, HUGE_VALF) : nearest;
    }

    double m_lo;
    double m_hi;
};

inline Interval operator-(Interval a)
{
    return {-a.hi(), -a.lo()};
}

// The sum in double, moved past the exact one where it is on the wrong side of it: towards -infinity or infinity.
inline double directedSum(double a, double b, double towards)
{
    const double sum = a + b;
    const double fromB = sum - a;
    const double error = (a - (sum - fromB)) + (b - fromB);
    return error != 0.0 && (error < 0.0) == (towards < 0.0) ? std::nextafter(sum, towards) : sum;
}

inline Interval operator+(Interval a, Interval b)
{
    return Interval::rounded(directedSum(a.lo(), b.lo(), -HUGE_VAL), directedSum(a.hi(), b.hi(), HUGE_VAL));
}

inline Interval operator-(Interval a, Interval b)
{
    return a + -b;
}

inline Interval operator*(Interval a, Interval b)
{
    const double corners[] = {a.lo() * b.lo(), a.lo() * b.hi(), a.hi() * b.lo(), a.hi() * b.hi()};
    for (double corner : corners)
    {
        if (std::isnan(corner))
            return Interval::anything();
    }
    const auto [lo, hi] = std::minmax_element(std::begin(corners), std::end(corners));
    return Interval::rounded(*lo, *hi);
}

inline Interval operator/(Interval a, Interval b)
{
    const bool positive = b.lo() >= lvsm::kTiny<double> && b.hi() <= lvsm::kHuge<double>;
    const bool negative = b.hi() <= -lvsm::kTiny<double> && b.lo() >= -lvsm::kHuge<double>;
    if (!positive && !negative)
        return Interval::anything();
    const double corners[] = {a.lo() / b.lo(), a.lo() / b.hi(), a.hi() / b.lo(), a.hi() / b.hi()};
    const auto [lo, hi] = std::minmax_element(std::begin(corners), std::end(corners));
    return Interval::within(*lo, *hi, 2.5);
}

inline Interval& operator+=(Interval& a, Interval b)
{
    return a = a + b;
}

inline Interval& operator-=(Interval& a, Interval b)
{
    return a = a - b;
}

inline Interval& operator*=(Interval& a, Interval b)
{
    return a = a * b;
}

inline Interval& operator/=(Interval& a, Interval b)
{
    return a = a / b;
}

inline bool operator<(Interval a, Interval b)
{
    if (a.hi() < b.lo())
        return true;
    return a.lo() < b.hi() && Decisions::current().choose(2) == 1;
}

inline bool operator>(Interval a, Interval b)
{
    return b < a;
}

inline bool operator<=(Interval a, Interval b)
{
    return !(b < a);
}

inline bool operator>=(Interval a, Interval b)
{
    return !(a < b);
}

inline bool operator==(Interval a, Interval b)
{
    return a <= b && b <= a;
}

inline bool operator!=(Interval a, Interval b)
{
    return !(a == b);
}

inline Interval abs(Interval x)
{
    const double larger = std::max(std::abs(x.lo()), std::abs(x.hi()));
    const double smaller = x.lo() <= 0.0 && x.hi() >= 0.0 ? 0.0 : std::min(std::abs(x.lo()), std::abs(x.hi()));
    return {smaller, larger};
}

inline Interval floor(Interval x)
{
    return {std::floor(x.lo()), std::floor(x.hi())};
}

// As 1 / inversesqrt(x): 2 ULP, then 2.5 ULP. The inner relative error of 2 ULP is at most 4 ULP of the result.
inline Interval sqrt(Interval x)
{
    return Interval::within(std::sqrt(std::max(x.lo(), 0.0)), std::sqrt(std::max(x.hi(), 0.0)), 6.5);
}

inline Interval exp(Interval x)
{
    const Interval lowest = Interval::within(std::exp(x.lo()), std::exp(x.lo()), 3.0 + 2.0 * std::abs(x.lo()));
    const Interval highest = Interval::within(std::exp(x.hi()), std::exp(x.hi()), 3.0 + 2.0 * std::abs(x.hi()));
    return {std::max(lowest.lo(), 0.0), highest.hi()};
}

inline Interval log(Interval x)
{
    if (x.lo() < lvsm::kTiny<double>)
        return Interval::anything();
    const auto error = [](double at)
    {
        const double nearOne = at >= 0.5 && at <= 2.0 ? std::ldexp(1.0, -21) : 0.0;
        return std::max(nearOne, 3.0 * Interval::unitInLastPlace(std::log(at)));
    };
    return Interval::rounded(std::log(x.lo()) - error(x.lo()), std::log(x.hi()) + error(x.hi()));
}

// Error 2^-11 for arguments in [-pi, pi]; nothing is promised outside.
inline Interval cos(Interval x)
{
    const double pi = 3.14159265358979323846;
    if (x.lo() < -pi || x.hi() > pi)
        return {-1.0, 1.0};
    const double error = std::ldexp(1.0, -11);
    const double lo = std::min(std::cos(x.lo()), std::cos(x.hi()));
    const double hi = x.lo() <= 0.0 && x.hi() >= 0.0 ? 1.0 : std::max(std::cos(x.lo()), std::cos(x.hi()));
    return {lo - error, hi + error};
}

inline Interval sin(Interval x)
{
    const double halfPi = 1.57079632679489661923;
    if (x.lo() < -2.0 * halfPi || x.hi() > 2.0 * halfPi)
        return {-1.0, 1.0};
    const double error = std::ldexp(1.0, -11);
    const double atLo = std::sin(x.lo());
    const double atHi = std::sin(x.hi());
    const double lo = x.lo() <= -halfPi && x.hi() >= -halfPi ? -1.0 : std::min(atLo, atHi);
    const double hi = x.lo() <= halfPi && x.hi() >= halfPi ? 1.0 : std::max(atLo, atHi);
    return {lo - error, hi + error};
}

} // namespace parity

// Exact, and without decisions, which the general templates would have to make.
template <>
constexpr parity::Interval lvsm::detail::minimum(parity::Interval a, parity::Interval b)
{
    return {a.lo() < b.lo() ? a.lo() : b.lo(), a.hi() < b.hi() ? a.hi() : b.hi()};
}

template <>
constexpr parity::Interval lvsm::detail::maximum(parity::Interval a, parity::Interval b)
{
    return {a.lo() > b.lo() ? a.lo() : b.lo(), a.hi() > b.hi() ? a.hi() : b.hi()};
}

template <>
inline parity::Interval lvsm::detail::rounded(parity::Interval x)
{
    return parity::Interval::term(x);
}

#endif
