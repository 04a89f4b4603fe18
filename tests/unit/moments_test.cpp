#include <lvsm/moments.hpp>

#include <doctest/doctest.h>

#include "distributions.hpp"

namespace lvsm::unit
{
namespace
{

constexpr int kSteps = GridDistribution::kSteps;

// Rounds to the nearest of the values that a storage format holds.
template <int kBits>
Exact unorm(Exact x)
{
    constexpr Exact last = (1 << kBits) - 1;
    return std::nearbyint(x * last) / last;
}

template <int kSignificandBits, int kLeastExponent>
Exact floating(Exact x)
{
    const int exponent = x == 0 ? kLeastExponent : std::max(std::ilogb(x), kLeastExponent);
    const Exact step = std::ldexp(Exact(1), exponent - kSignificandBits + 1);
    return std::nearbyint(x / step) * step;
}

template <typename T>
struct Format
{
    const char* name;
    T depthError;
    Exact (*store)(Exact);
};

template <typename T>
std::vector<Format<T>> formats()
{
    return {{"unorm8", kDepthErrorUnorm8<T>, unorm<8>},
            {"unorm16", kDepthErrorUnorm16<T>, unorm<16>},
            {"fp16", kDepthErrorFp16<T>, floating<11, -14>},
            {"fp32", kDepthErrorFp32<T>, floating<24, -126>}};
}

TEST_CASE_TEMPLATE("depthMoments are the depth and its square", T, float, double)
{
    CHECK(depthMoments(T(0)) == Vec2<T>(0, 0));
    CHECK(depthMoments(T(0.75)) == Vec2<T>(T(0.75), T(0.5625)));
    CHECK(depthMoments(T(1)) == Vec2<T>(1, 1));
    CHECK(depthMoments(T(-2)) == Vec2<T>(0, 0));
    CHECK(depthMoments(T(7)) == Vec2<T>(1, 1));
}

TEST_CASE_TEMPLATE("depthMomentsSloped adds a quarter of the squared slope to the variance", T, float, double)
{
    // Exact in float: the depth in 32nds, the slopes in 64ths.
    for (int depth = 0; depth <= 32; ++depth)
    {
        for (int dx = -8; dx <= 8; ++dx)
        {
            for (int dy = -8; dy <= 8; ++dy)
            {
                const T z = T(depth) / T(32);
                const Vec2<T> moments = depthMomentsSloped(z, T(dx) / T(64), T(dy) / T(64));
                CHECK(moments.x == z);
                CHECK(moments.y == std::min(z, z * z + T(dx * dx + dy * dy) / T(4 * 64 * 64)));
            }
        }
    }
}

TEST_CASE_TEMPLATE("depthMomentsSloped stays within what depths in the unit interval can have", T, float, double)
{
    Random random(2);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const T depth = random.unit<T>();
        const Vec2<T> moments = depthMomentsSloped(depth, 4 * random.unit<T>() - 2, 4 * random.unit<T>() - 2);
        tally.claim(moments.x == depth && moments.y <= moments.x && moments.y >= moments.x * moments.x, depth);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("mean is the first moment and variance the spread of a distribution", T, float, double)
{
    Random random(3);
    Tally tally;
    for (int i = 0; i < drawsOf(10000); ++i)
    {
        const GridDistribution window(random);
        const Vec2<T> moments = window.moments<T>();
        // E[(x - mean)^2], the other definition. All of it is exact.
        T spread = 0;
        for (int step = 0; step <= kSteps; ++step)
        {
            const T share = window.tail<T>(step) - (step < kSteps ? window.tail<T>(step + 1) : T(0));
            const T distance = GridDistribution::depthAt<T>(step) - moments.x;
            spread += share * distance * distance;
        }
        tally.claim(mean(moments) == moments.x, moments.x);
        tally.claim(variance(moments, T(0)) == spread, moments.x, moments.y, spread);
        tally.claim(variance(moments, T(0.0625)) == std::max(spread, T(0.0625)), moments.x, moments.y, spread);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("variance puts its floor in place of a difference that rounding made negative", T, float, double)
{
    const Vec2<T> impossible(T(0.5), T(0.25) - std::numeric_limits<T>::epsilon());
    CHECK(variance(impossible, T(0)) == 0);
    CHECK(variance(impossible, T(0.001)) == T(0.001));
    CHECK(variance(impossible, T(-1)) == 0);
}

TEST_CASE_TEMPLATE("chebyshevUpperBound is exact for one planar occluder over one planar receiver", T, float, double)
{
    Tally tally;
    for (int occluder = 0; occluder < kSteps; ++occluder)
    {
        for (int receiver = occluder + 1; receiver <= kSteps; ++receiver)
        {
            for (int covered = 0; covered <= kSteps; ++covered)
            {
                const int lit = kSteps - covered;
                const Vec2<T> moments(T(covered * occluder + lit * receiver) / T(kSteps * kSteps),
                                      T(covered * occluder * occluder + lit * receiver * receiver) /
                                          T(kSteps * kSteps * kSteps));
                const T t = GridDistribution::depthAt<T>(receiver);
                tally.claim(chebyshevUpperBound(moments, t, T(0)) == T(lit) / T(kSteps), occluder, receiver, covered);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("light bleeds onto the third plane of figure 2 as equation 4 says", T, float, double)
{
    Tally tally;
    for (int a = 0; a < kSteps; ++a)
    {
        for (int b = a + 1; b < kSteps; ++b)
        {
            // A covers half of the window, B the rest.
            const Vec2<T> moments(T(a + b) / T(2 * kSteps), T(a * a + b * b) / T(2 * kSteps * kSteps));
            tally.claim(chebyshevUpperBound(moments, T(a) / T(kSteps), T(0)) == T(1), a, b);
            tally.claim(chebyshevUpperBound(moments, T(b) / T(kSteps), T(0)) == T(0.5), a, b);
            for (int c = b + 1; c <= kSteps; ++c)
            {
                const T dx = T(b - a) / T(kSteps);
                const T dy = T(c - b) / T(kSteps);
                const T equation4 = (dx * dx / 4) / (dx * dx / 2 + dx * dy + dy * dy);
                tally.claim(chebyshevUpperBound(moments, T(c) / T(kSteps), T(0)) == equation4, a, b, c);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("the bleeding of figure 2 falls off with the square of the distance", T, float, double)
{
    // Equation 4 over its value at twice the distance is 4 (1 + r/2 + r^2/8) / (1 + r + r^2/2) for r = dx/dy, so the
    // measured order lacks less than r of 2: log2(1 + r + r^2/2) <= r / ln 2 and
    // log2(1 + r/2 + r^2/8) >= r / (2 ln 2) - r^3.
    const T dx = T(1) / T(1024);
    const Vec2<T> moments(dx / 2, dx * dx / 2);
    for (T dy = 4 * dx; dy < T(0.5); dy *= 2)
    {
        const T here = chebyshevUpperBound(moments, dx + dy, T(0));
        const T further = chebyshevUpperBound(moments, dx + 2 * dy, T(0));
        const T order = std::log2(here / further);
        MESSAGE("dy / dx = ", dy / dx, ": order ", order);
        CHECK(order < 2);
        CHECK(order > 2 - dx / dy);
    }
}

TEST_CASE_TEMPLATE("zero variance makes both bounds a step at the mean", T, float, double)
{
    for (const T depth : {T(0), T(0.25), T(0.75)})
    {
        const Vec2<T> moments = depthMoments(depth);
        CHECK(chebyshevUpperBound(moments, depth, T(0)) == 1);
        CHECK(chebyshevUpperBound(moments, depth / 2, T(0)) == 1);
        CHECK(chebyshevUpperBound(moments, depth + std::numeric_limits<T>::epsilon(), T(0)) == 0);
        CHECK(chebyshevUpperBound(moments, T(1), T(0)) == 0);
        CHECK(chebyshevLowerBound(moments, depth, T(0)) == 0);
        CHECK(chebyshevLowerBound(moments, T(1), T(0)) == 0);
        CHECK(chebyshevLowerBound(moments, depth - std::numeric_limits<T>::epsilon(), T(0)) == 1);
        CHECK(chebyshevLowerBound(moments, T(-1), T(0)) == 1);
    }
}

TEST_CASE_TEMPLATE("no distribution breaks the Chebyshev bounds", T, float, double)
{
    Random random(4);
    Tally upper;
    Tally lower;
    for (int i = 0; i < drawsOf(200000); ++i)
    {
        const GridDistribution window(random);
        const Vec2<T> moments = window.moments<T>();
        const T floor = i % 3 == 0 ? T(0) : T(i % 3) / T(1024);
        for (int step = 0; step <= kSteps; ++step)
        {
            const T t = GridDistribution::depthAt<T>(step);
            const T lit = window.tail<T>(step);
            upper.claim(chebyshevUpperBound(moments, t, floor) >= lit, moments.x, moments.y, t, lit, floor);
            lower.claim(chebyshevLowerBound(moments, t, floor) <= lit, moments.x, moments.y, t, lit, floor);
        }
    }
    LVSM_CHECK_TALLY(upper);
    LVSM_CHECK_TALLY(lower);
}

TEST_CASE_TEMPLATE("rounded moments break the Chebyshev bound by no more than the rounding", T, float, double)
{
    Random random(5);
    Tally tally;
    const auto identity = [](T depth)
    {
        return Exact(depth);
    };
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Distribution<T> window(random);
        const ExactMoments moments = window.moments(identity);
        const T floor = i % 2 == 0 ? T(0) : T(1.0e-6);
        for (const T t : window.depths())
        {
            const T visibility = chebyshevUpperBound(moments.template rounded<T>(), t, floor);
            const Exact least = std::min(window.tail(t), leastByRounding(moments, t, floor));
            tally.claim(Exact(visibility) >= least, moments.mean, moments.variance, t, visibility, least);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("chebyshevLowerBound mirrors chebyshevUpperBound at the mean", T, float, double)
{
    // Mirroring the window, x -> 1 - x, turns P(x <= t) into P(x >= 1 - t). The two bounds then share their tail.
    Random random(6);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const GridDistribution window(random);
        const Vec2<T> moments = window.moments<T>();
        const Vec2<T> mirrored(1 - moments.x, 1 - 2 * moments.x + moments.y);
        for (int step = 0; step <= kSteps; ++step)
        {
            const T t = GridDistribution::depthAt<T>(step);
            tally.claim(chebyshevLowerBound(moments, t, T(0)) == 1 - chebyshevUpperBound(mirrored, 1 - t, T(0)),
                        moments.x, moments.y, t);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("the Chebyshev bounds never rise with the receiver's depth", T, float, double)
{
    Random random(7);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const Vec2<T> moments = GridDistribution(random).moments<T>();
        const T floor = random.unit<T>() / 64;
        T t = 0;
        T before = 1;
        T beforeLower = 1;
        while (t < 1)
        {
            t = std::min(T(1), t + random.unit<T>() / 32);
            const T visibility = chebyshevUpperBound(moments, t, floor);
            const T lower = chebyshevLowerBound(moments, t, floor);
            tally.claim(visibility <= before && lower <= beforeLower && lower <= visibility, moments.x, moments.y, t,
                        floor);
            before = visibility;
            beforeLower = lower;
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("more variance never darkens the upper bound nor lights the lower one", T, float, double)
{
    Random random(8);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec2<T> moments = GridDistribution(random).moments<T>();
        const T t = random.unit<T>();
        const T less = random.unit<T>() / 8;
        const T more = less + random.unit<T>() / 8;
        // Numerator and divisor both grow: each bound rounds three times.
        const T rounding = static_cast<T>(6 * kRoundoff<T>);
        tally.claim(chebyshevUpperBound(moments, t, more) >= chebyshevUpperBound(moments, t, less) - rounding,
                    moments.x, moments.y, t, less, more);
        tally.claim(chebyshevLowerBound(moments, t, more) <= chebyshevLowerBound(moments, t, less) + rounding,
                    moments.x, moments.y, t, less, more);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("the upper bound never darkens a receiver that is close to the mean by rounding", T, float, double)
{
    // Where variance and distance are both subnormal, nothing is known but that the receiver is not behind the mean.
    for (const T variance : {T(0), kTiny<T> / 64, kTiny<T> / 2})
    {
        const Vec2<T> moments(0, variance);
        CHECK(chebyshevUpperBound(moments, T(0x1p-63), T(0)) == 1);
        CHECK(chebyshevUpperBound(moments, T(0x1p-64), T(0)) == 1);
        CHECK(chebyshevUpperBound(moments, T(0x1p-100), T(0)) == 1);
        CHECK(chebyshevLowerBound(moments, -T(0x1p-63), T(0)) == 0);
        CHECK(chebyshevLowerBound(moments, -T(0x1p-64), T(0)) == 0);
    }
}

TEST_CASE_TEMPLATE("reduceLightBleeding cuts off the tail and stretches the rest", T, float, double)
{
    CHECK(reduceLightBleeding(T(0.25), T(0.25)) == 0);
    CHECK(reduceLightBleeding(T(0.125), T(0.25)) == 0);
    CHECK(reduceLightBleeding(T(0.625), T(0.25)) == T(0.5));
    CHECK(reduceLightBleeding(T(1), T(0.25)) == 1);
    CHECK(reduceLightBleeding(T(0.625), T(0)) == T(0.625));
    CHECK(reduceLightBleeding(T(0.625), T(-3)) == T(0.625));
    for (const T amount : {T(1), T(2)})
    {
        CHECK(reduceLightBleeding(T(1), amount) == 1);
        CHECK(reduceLightBleeding(std::nextafter(T(1), T(0)), amount) == 0);
    }
}

TEST_CASE_TEMPLATE("reduceLightBleeding rises with visibility and falls with its amount", T, float, double)
{
    Random random(9);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const T visibility = random.unit<T>();
        const T brighter = visibility + random.unit<T>() * (1 - visibility);
        const T amount = random.unit<T>();
        const T larger = amount + random.unit<T>() * (1 - amount);
        const T reduced = reduceLightBleeding(visibility, amount);
        tally.claim(reduceLightBleeding(brighter, amount) >= reduced, visibility, brighter, amount);
        // Two differences and a quotient on each side, each rounded once.
        tally.claim(reduceLightBleeding(visibility, larger) <= reduced + T(6 * kRoundoff<T>), visibility, amount,
                    larger);
        tally.claim(reduced <= visibility + T(3 * kRoundoff<T>), visibility, amount);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("the depth errors are the largest of each format, and reached", T, float, double)
{
    for (const Format<T>& format : formats<T>())
    {
        CAPTURE(format.name);
        Random random(10);
        Exact worst = 0;
        for (int i = 0; i < 200000; ++i)
        {
            // Odd multiples of the error in the upper half lie midway between two stored values, or next to it.
            const Exact error = format.depthError;
            const Exact depth = error * (2 * std::floor(Exact(random.unit<double>()) / (2 * error)) + 1);
            for (const Exact near : {depth, depth * (1 + 1.0e-9L), depth * (1 - 1.0e-9L), Exact(random.unit<double>())})
                if (near <= 1)
                    worst = std::max(worst, std::abs(format.store(near) - near));
        }
        // The constant itself is rounded to T, and a depth of up to 1 to Exact.
        CHECK(worst <= Exact(format.depthError) * (1 + kRoundoff<T>)+2 * std::numeric_limits<Exact>::epsilon());
        CHECK(worst >= Exact(format.depthError) * Exact(0.9999));
    }
}

TEST_CASE_TEMPLATE("recommendedMinVariance keeps a flat lit receiver within the stated darkening", T, float, double)
{
    for (const Format<T>& format : formats<T>())
    {
        for (const T worstDarkening : {T(0.001), T(0.01), T(0.1), T(0.5)})
        {
            CAPTURE(format.name);
            CAPTURE(worstDarkening);
            // A sampler returns the stored value rounded to T: one more pass. For fp32 in float there is none.
            const bool isOwnFormat = format.depthError == kDepthErrorFp32<T> && sizeof(T) == 4;
            const T depthError = format.depthError + (isOwnFormat ? T(0) : static_cast<T>(kRoundoff<T>));
            const T floor = recommendedMinVariance(depthError, worstDarkening);
            Random random(11);
            Tally tally;
            T worst = 0;
            for (int i = 0; i < drawsOf(100000); ++i)
            {
                const T anywhere = random.unit<T>();
                // As often, where rounding is worst: half a step beside a stored value.
                const T depth = i % 2 == 0
                                    ? anywhere
                                    : std::min(T(1), static_cast<T>(format.store(anywhere) + Exact(format.depthError)));
                const T first = static_cast<T>(format.store(depth));
                const T second = static_cast<T>(format.store(Exact(depth) * depth));
                // Both moments stored, or, the least variance, both made of a stored depth (section 5).
                for (const Vec2<T> moments : {Vec2<T>(first, second), depthMoments(first)})
                {
                    const T darkening = 1 - chebyshevUpperBound(moments, depth, floor);
                    worst = std::max(worst, darkening);
                    // The floor is rounded five times, the bound three; none weighs more than the visibility.
                    tally.claim(darkening <= worstDarkening + T(8 * kRoundoff<T>), depth, darkening);
                }
            }
            LVSM_CHECK_TALLY(tally);
            // It is the least such floor: the stated darkening is reached, but where the receiver's depth is a stored one.
            if (!isOwnFormat)
                CHECK(worst >= T(0.98) * worstDarkening);
        }
    }
}

TEST_CASE_TEMPLATE("recommendedMinVariance solves its equation and clamps", T, float, double)
{
    CHECK(recommendedMinVariance(T(0.25), T(0.5)) == T(0.0625));
    CHECK(recommendedMinVariance(T(0.5), T(0.25)) == T(0.75));
    CHECK(recommendedMinVariance(T(0), T(0.5)) == 0);
    CHECK(recommendedMinVariance(T(-1), T(0.5)) == 0);
    CHECK(recommendedMinVariance(T(2), T(0.5)) == 1);
    CHECK(recommendedMinVariance(T(1), T(1)) == 0);
    CHECK(recommendedMinVariance(T(1), T(3)) == 0);
    CHECK(recommendedMinVariance(T(1), T(0)) == recommendedMinVariance(T(1), T(0x1p-24)));
    CHECK(recommendedMinVariance(T(1), T(0)) <= T(0x1p24));
    CHECK(recommendedMinVariance(T(1), T(0)) > T(0x1p23));
}

TEST_CASE_TEMPLATE("a window half empty leaves a variance shadow map's receiver lit", T, float, double)
{
    for (int step = 0; step <= kSteps; ++step)
    {
        const T surface = GridDistribution::depthAt<T>(step);
        const Vec2<T> window = T(0.5) * depthMoments(surface) + T(0.5) * depthMoments(T(1));
        CHECK(chebyshevUpperBound(window, surface, T(0)) == 1);
        CHECK(chebyshevUpperBound(window, surface / 2, T(0)) == 1);
        for (int behind = step + 1; behind <= kSteps; ++behind)
            CHECK(chebyshevUpperBound(window, GridDistribution::depthAt<T>(behind), T(0)) >= T(0.5));
        // Cleared to 0 instead, an empty texel would be an occluder at the light.
        if (step > 0)
            CHECK(chebyshevUpperBound(T(0.5) * depthMoments(surface), surface, T(0)) == T(0.5));
    }
}

} // namespace
} // namespace lvsm::unit
