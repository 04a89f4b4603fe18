// Random discrete depth distributions whose moments and tail P(x >= t) are known.
#ifndef LVSM_TESTS_UNIT_DISTRIBUTIONS_HPP
#define LVSM_TESTS_UNIT_DISTRIBUTIONS_HPP

#include <algorithm>

#include "numbers.hpp"

namespace lvsm::unit
{

// Depths and shares in 32nds. Both moments, the variance, the distance to a 32nd and the sum of its square and the
// variance then need 21 bits or less, so that in float the bounds are one correctly rounded division of exact numbers:
// rounding keeps order, and a bound must hold with no tolerance at all.
class GridDistribution
{
public:
    static constexpr int kSteps = 32;

    explicit GridDistribution(Random& random)
    {
        const int atoms = random.between(1, 5);
        for (int left = kSteps, i = 0; left > 0; ++i)
        {
            const int share = i + 1 < atoms ? random.between(1, left) : left;
            m_share[random.between(0, kSteps)] += share;
            left -= share;
        }
    }

    template <typename T>
    Vec2<T> moments() const
    {
        int first = 0;
        int second = 0;
        for (int depth = 0; depth <= kSteps; ++depth)
        {
            first += m_share[depth] * depth;
            second += m_share[depth] * depth * depth;
        }
        return {T(first) / T(kSteps * kSteps), T(second) / T(kSteps * kSteps * kSteps)};
    }

    // Share at depth step / kSteps or farther.
    template <typename T>
    T tail(int step) const
    {
        int sum = 0;
        for (int depth = step; depth <= kSteps; ++depth)
            sum += m_share[depth];
        return T(sum) / T(kSteps);
    }

    template <typename T>
    static T depthAt(int step)
    {
        return T(step) / T(kSteps);
    }

private:
    int m_share[kSteps + 1] = {};
};

// The variance on its own: as a difference it would lose its digits even here.
struct ExactMoments
{
    Exact mean = 0;
    Exact second = 0;
    Exact variance = 0;

    template <typename T>
    Vec2<T> rounded() const
    {
        return {static_cast<T>(mean), static_cast<T>(second)};
    }

    // Of two depths that cover half a window each.
    static ExactMoments ofHalves(Exact a, Exact b) { return {(a + b) / 2, (a * a + b * b) / 2, (a - b) * (a - b) / 4}; }
};

// Any depths with any shares.
template <typename T>
class Distribution
{
public:
    explicit Distribution(Random& random)
    {
        const int atoms = random.between(1, 12);
        // Some windows are nearly flat: there the variance is all rounding.
        const T centre = random.unit<T>();
        const T spread = std::ldexp(T(1), -random.between(0, 24));
        Exact sum = 0;
        for (int i = 0; i < atoms; ++i)
        {
            m_depths.push_back(std::clamp(centre + spread * (random.unit<T>() - T(0.5)), T(0), T(1)));
            m_shares.push_back(Exact(random.unit<T>()) + Exact(0.001));
            sum += m_shares.back();
        }
        for (Exact& share : m_shares)
            share /= sum;
    }

    const std::vector<T>& depths() const { return m_depths; }

    Exact tail(T t) const
    {
        Exact sum = 0;
        for (std::size_t i = 0; i < m_depths.size(); ++i)
            sum += m_depths[i] >= t ? m_shares[i] : 0;
        return sum;
    }

    // Of the depths as a warp gives them in T.
    template <typename Warp>
    ExactMoments moments(const Warp& warp) const
    {
        ExactMoments result;
        for (std::size_t i = 0; i < m_depths.size(); ++i)
            result.mean += m_shares[i] * Exact(warp(m_depths[i]));
        for (std::size_t i = 0; i < m_depths.size(); ++i)
        {
            const Exact warped = warp(m_depths[i]);
            const Exact distance = warped - result.mean;
            result.second += m_shares[i] * warped * warped;
            result.variance += m_shares[i] * distance * distance;
        }
        return result;
    }

private:
    std::vector<T> m_depths;
    std::vector<Exact> m_shares;
};

// A window of up to six depths with any shares.
struct DepthWindow
{
    static constexpr int kSteps = 32;

    double depths[6];
    double shares[6];
    int count;

    // Any depths, in most windows crowded towards the light.
    explicit DepthWindow(Random& random) : count(random.between(1, 6))
    {
        const double sharpness = random.between(0, 3);
        fill([&] { return std::pow(random.unit<double>(), 1 + sharpness); },
             [&] { return random.unit<double>() + 1e-3; });
    }

    // Depths in 32nds and shares in whole parts. Splits on the same grid keep every warped depth that is not 0 at least
    // 1/32 away from it, so that rounding stays far below what the tests claim.
    static DepthWindow onGrid(Random& random)
    {
        DepthWindow window(random);
        window.fill([&] { return random.between(0, kSteps) / double(kSteps); },
                    [&] { return double(random.between(1, 32)); });
        return window;
    }

    double tail(double t) const
    {
        double sum = 0;
        for (int i = 0; i < count; ++i)
            sum += depths[i] >= t ? shares[i] : 0;
        return sum;
    }

    // Of what is stored for each depth.
    template <typename Store>
    auto mean(const Store& store) const
    {
        auto sum = shares[0] * store(depths[0]);
        for (int i = 1; i < count; ++i)
            sum += shares[i] * store(depths[i]);
        return sum;
    }

    // A depth of the window, or any other.
    double receiver(Random& random) const
    {
        return random.between(0, 1) == 0 ? random.unit<double>() : depths[random.between(0, count - 1)];
    }

private:
    template <typename Depth, typename Share>
    void fill(const Depth& depth, const Share& share)
    {
        double sum = 0;
        for (int i = 0; i < count; ++i)
        {
            depths[i] = depth();
            shares[i] = share();
            sum += shares[i];
        }
        for (int i = 0; i < count; ++i)
            shares[i] /= sum;
    }
};

inline Vec4<double> unorm16(const Vec4<double>& v)
{
    Vec4<double> rounded;
    for (int i = 0; i < 4; ++i)
        rounded[i] = std::round(v[i] * 65535) / 65535;
    return rounded;
}

// The least that rounding can make of a bound that in exact arithmetic holds: chebyshevUpperBound of moments that were
// rounded to T a few times, for a receiver at t. With k roundings of each moment, and M1^2, the difference and the
// distance rounded once, v is off by at most u (k M2 + 2 k M1^2 + M1^2 + v) <= (3 k + 2) u M2 and the distance by
// u (k |M1| + |d|). What is of second order is covered by 1%. Three roundings follow: d^2, sum and quotient. The bound
// rises with v and falls with d, so that the worst is where v is least and d greatest.
template <typename T>
Exact leastByRounding(const ExactMoments& moments, T t, Exact minVariance, int roundings = 1)
{
    constexpr Exact u = Exact(1.01) * kRoundoff<T> + 16 * std::numeric_limits<Exact>::epsilon();
    const Exact v = std::max({moments.variance - (3 * roundings + 2) * u * moments.second, minVariance, Exact(0)});
    const Exact distance = Exact(t) - moments.mean;
    const Exact d = distance + u * (roundings * std::abs(moments.mean) + std::abs(distance));
    return (1 - 4 * u) * (d > 0 ? v / (v + d * d) : Exact(1));
}

} // namespace lvsm::unit

#endif
