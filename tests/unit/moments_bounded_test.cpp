#include <lvsm/moments.hpp>

#include <doctest/doctest.h>

#include "distributions.hpp"

namespace lvsm::unit
{
namespace
{

constexpr int kSteps = GridDistribution::kSteps;

// The moments of a grid distribution and what the bound adds of them are exact; then come 1 / t and one product.
template <typename T>
constexpr Exact kBoundRounding = 3 * kRoundoff<T>;

TEST_CASE_TEMPLATE("boundedUpperBound bounds every distribution on the unit interval", T, float, double)
{
    Random random(101);
    Tally tally;
    for (int i = 0; i < drawsOf(1000000); ++i)
    {
        const GridDistribution window(random);
        const Vec2<T> moments = window.moments<T>();
        const int step = random.between(0, kSteps);
        const T t = GridDistribution::depthAt<T>(step);
        const T bound = boundedUpperBound(moments, t, T(0));
        tally.claim(Exact(bound) >= Exact(window.tail<T>(step)) * (1 - kBoundRounding<T>), moments.x, moments.y, t,
                    bound);
        tally.claim(bound <= chebyshevUpperBound(moments, t, T(0)), moments.x, moments.y, t, bound);
    }
    LVSM_CHECK_TALLY(tally);
}

// The distributions of Markov and Krein reach the bound, so that no bound from two moments can be less.
TEST_CASE("boundedUpperBound is reached by a distribution on the unit interval")
{
    Random random(102);
    Tally tally;
    int three = 0;
    for (int i = 0; i < drawsOf(200000); ++i)
    {
        const double m1 = 0.001 + 0.998 * random.unit<double>();
        const double v = m1 * (1 - m1) * (0.001 + 0.998 * random.unit<double>());
        const double m2 = m1 * m1 + v;
        const double t = 0.01 + 0.98 * random.unit<double>();
        const double d = t - m1;
        if (std::abs(d) < 1e-3)
            continue;
        const double other = m1 - v / d;
        double reached;
        if (other >= 0 && other <= 1)
        {
            // Two atoms with these moments: t and the other one.
            reached = d > 0 ? v / (v + d * d) : 1;
        }
        else
        {
            // Three atoms, at 0, t and 1.
            const double atT = (m1 - m2) / (t * (1 - t));
            const double atOne = (m2 - m1 * t) / (1 - t);
            const double atZero = 1 - atT - atOne;
            tally.claim(atT >= -1e-12 && atOne >= -1e-12 && atZero >= -1e-12, m1, m2, t, atZero, atT, atOne);
            reached = atT + atOne;
            ++three;
        }
        // Of order one over the least t and distance above, times a few roundings.
        tally.claim(std::abs(boundedUpperBound(Vec2<double>(m1, m2), t, 0.0) - reached) < 1e-9, m1, m2, t, reached);
    }
    LVSM_CHECK_TALLY(tally);
    CHECK(three > drawsOf(10000));
}

TEST_CASE_TEMPLATE("boundedUpperBound is exact for samples at 0 and 1 alone", T, float, double)
{
    for (int share = 0; share <= 64; ++share)
    {
        const T p = T(share) / T(64);
        for (int step = 1; step <= 64; ++step)
        {
            const T t = T(step) / T(64);
            CHECK(std::abs(Exact(boundedUpperBound(Vec2<T>(p, p), t, T(0))) - Exact(p)) <= kBoundRounding<T>);
        }
        CHECK(boundedUpperBound(Vec2<T>(p, p), T(0), T(0)) == T(1));
        CHECK(boundedUpperBound(Vec2<T>(p, p), T(-1), T(0)) == T(1));
    }
    // Where Chebyshev's inequality is far off: LVSM section 3.3 would have 0.96 here, see layers_test.
    CHECK(chebyshevUpperBound(Vec2<T>(T(0.5), T(0.5)), T(0.625), T(0)) > T(0.9));
    CHECK(boundedUpperBound(Vec2<T>(T(0.5), T(0.5)), T(0.625), T(0)) == T(0.5));
}

TEST_CASE_TEMPLATE("boundedUpperBound adds 9/4 of the floor over t^2 to what samples at 0 and 1 give", T, float, double)
{
    const Vec2<T> moments(T(0.25), T(0.25));
    CHECK(boundedUpperBound(moments, T(0.8), T(0.001)) == doctest::Approx(0.25 + 2.25 * 0.001 / 0.64));
    // Less than no floor counts as none.
    CHECK(boundedUpperBound(moments, T(0.8), T(-0.5)) == doctest::Approx(0.25));
}

TEST_CASE_TEMPLATE("boundedUpperBound takes what exceeds its range to its end", T, float, double)
{
    // A mean below 0 takes nothing from what the floor adds; nor does a mean square over 1.
    const Vec2<T> below(-1, 0);
    CHECK(boundedUpperBound(below, T(0.5), T(0.01)) == chebyshevUpperBound(below, T(0.5), T(0.01)));
    CHECK(boundedUpperBound(Vec2<T>(T(0.5), 5), T(0.8), T(0.1)) ==
          boundedUpperBound(Vec2<T>(T(0.5), 1), T(0.8), T(0.1)));
    // Nothing is lighter beyond the far end than there, even by moments that no window has.
    CHECK(boundedUpperBound(Vec2<T>(T(0.5), 1), T(1), T(0)) == T(0));
    CHECK(boundedUpperBound(Vec2<T>(T(0.5), 1), T(2), T(0)) == T(0));
    // A floor of 1 leaves Cantelli's bound alone, by whatever moments.
    CHECK(boundedUpperBound(Vec2<T>(0, 1), T(1), T(1)) == T(0.5));
    // Nothing is at the least depth there is, where all is at 0.
    if (isBorne(std::numeric_limits<T>::denorm_min()))
        CHECK(boundedUpperBound(Vec2<T>(0), std::numeric_limits<T>::denorm_min(), T(0)) == T(0));
}

// With an error e of each moment and a floor of e^2 (1 - D) / D: Cantelli's bound loses at most D, and the parabolas
// lose at most e^2 / minVariance, which is D / (1 - D).
TEST_CASE("boundedUpperBound keeps flat lit surfaces lit by the floor of Chebyshev's bound")
{
    for (const double e : {7.62951094e-6, 1.96e-3, 2.98e-8})
    {
        for (const double darkening : {0.1, 0.01, 0.001})
        {
            const double floor = recommendedMinVariance(e, darkening);
            Tally tally;
            for (int i = 0; i <= 4000; ++i)
            {
                // Finest near 0, where a small depth divides the error.
                const double z = std::pow(i / 4000.0, 4.0);
                for (const double first : {-e, 0.0, e})
                {
                    for (const double second : {-e, 0.0, e})
                    {
                        const Vec2<double> moments(std::clamp(z + first, 0.0, 1.0),
                                                   std::clamp(z * z + second, 0.0, 1.0));
                        const double least = 1 - darkening / (1 - darkening) - 1e-12;
                        tally.claim(boundedUpperBound(moments, z, floor) >= least, z, first, second);
                    }
                }
            }
            LVSM_CHECK_TALLY(tally);
        }
    }
}

TEST_CASE_TEMPLATE("boundedUpperBound rises with the floor and falls with the receiver's depth", T, float, double)
{
    Random random(103);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const GridDistribution window(random);
        const Vec2<T> moments = window.moments<T>();
        T before = 2;
        for (int step = 0; step <= kSteps; ++step)
        {
            const T t = GridDistribution::depthAt<T>(step);
            const T bound = boundedUpperBound(moments, t, T(0));
            tally.claim(Exact(bound) <= Exact(before) * (1 + 2 * kBoundRounding<T>), moments.x, moments.y, t);
            before = bound;
            tally.claim(boundedUpperBound(moments, t, T(0.001)) >= bound, moments.x, moments.y, t);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

} // namespace
} // namespace lvsm::unit
