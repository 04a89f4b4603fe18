#include <lvsm/exponential.hpp>

#include <doctest/doctest.h>

#include "distributions.hpp"

namespace lvsm::unit
{
namespace
{

// Exponents in use: fp16's limit, the usual fp32 pair, equal ones, fp32's limit, and one warp that is flat.
template <typename T>
std::vector<Vec2<T>> exponentPairs()
{
    const T most = kMaxExponent<T>;
    return {{T(5.54), T(5.54)}, {40, 10}, {1, 20}, {42, 42}, {most, most}, {3, 0}};
}

Exact exactWarp(Exact depth, Exact exponent)
{
    return std::exp(exponent * (2 * depth - 1));
}

template <typename T>
Vec2<T> positive(const Vec4<T>& moments)
{
    return {moments.x, moments.y};
}

template <typename T>
Vec2<T> negative(const Vec4<T>& moments)
{
    return {moments.z, moments.w};
}

TEST_CASE_TEMPLATE("exponentialWarp is e^(cx) and -e^(-cx) of the depth remapped to [-1,1]", T, float, double)
{
    Tally tally;
    for (const Vec2<T>& c : exponentPairs<T>())
    {
        for (int i = 0; i <= 1000; ++i)
        {
            const T depth = T(i) / T(1000);
            const Vec2<T> warped = exponentialWarp(depth, c);
            // The exponent rounds twice, an absolute error of 2 u c in it and a relative one here; exp is within 1 ULP.
            const Exact rising = exactWarp(depth, c.x);
            const Exact falling = -exactWarp(1 - Exact(depth), c.y);
            tally.claim(std::abs(warped.x - rising) <= (2 * c.x + 4) * kRoundoff<T> * rising, depth, c.x, warped.x);
            tally.claim(std::abs(warped.y - falling) <= (2 * c.y + 4) * kRoundoff<T> * -falling, depth, c.y, warped.y);
        }
        CHECK(exponentialWarp(T(0.5), c) == Vec2<T>(1, -1));
        CHECK(exponentialWarp(T(-1), c) == exponentialWarp(T(0), c));
        CHECK(exponentialWarp(T(2), c) == exponentialWarp(T(1), c));
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("both exponential warps rise with depth", T, float, double)
{
    for (const Vec2<T>& c : exponentPairs<T>())
    {
        Vec2<T> before = exponentialWarp(T(0), c);
        for (int i = 1; i <= 256; ++i)
        {
            const Vec2<T> warped = exponentialWarp(T(i) / T(256), c);
            CHECK(warped.x > before.x);
            if (c.y > 0)
                CHECK(warped.y > before.y);
            before = warped;
        }
    }
}

TEST_CASE_TEMPLATE("exponents apart, each clamped to what fp32 holds", T, float, double)
{
    const T depth = T(0.875);
    const Vec2<T> mixed = exponentialWarp(depth, Vec2<T>(20, 5));
    CHECK(mixed.x == exponentialWarp(depth, Vec2<T>(20, 20)).x);
    CHECK(mixed.y == exponentialWarp(depth, Vec2<T>(5, 5)).y);
    CHECK(exponentialWarp(depth, Vec2<T>(1000, 1000)) == exponentialWarp(depth, Vec2<T>(kMaxExponent<T>)));
    CHECK(exponentialWarp(depth, Vec2<T>(-5, -5)) == Vec2<T>(1, -1));
}

TEST_CASE_TEMPLATE("exponentialMoments are each warp and its square", T, float, double)
{
    for (const Vec2<T>& c : exponentPairs<T>())
    {
        for (const T depth : {T(0), T(0.3), T(0.5), T(1)})
        {
            const Vec2<T> warped = exponentialWarp(depth, c);
            const Vec4<T> moments = exponentialMoments(depth, c);
            CHECK(positive(moments) == Vec2<T>(warped.x, warped.x * warped.x));
            CHECK(negative(moments) == Vec2<T>(warped.y, warped.y * warped.y));
        }
    }
}

TEST_CASE_TEMPLATE("the variance floor is carried through the slope of each warp", T, float, double)
{
    Tally tally;
    const T minVariance = T(1.0e-5);
    for (const Vec2<T> c : {Vec2<T>(T(5.54), T(2)), Vec2<T>(T(40), T(10))})
    {
        for (int i = 1; i < 100; ++i)
        {
            const T depth = T(i) / T(100);
            const Vec2<T> floors = exponentialMinVariance(minVariance, depth, c);
            // The slope by central differences, whose error is h^2 (2c)^2 / 6 of the slope itself.
            const Exact h = 1.0e-6L;
            const auto slopeSquared = [h](Exact at, Exact exponent)
            {
                const Exact slope = (exactWarp(at + h, exponent) - exactWarp(at - h, exponent)) / (2 * h);
                return slope * slope;
            };
            const auto near = [](Exact value, Exact truth, Exact exponent, Exact step)
            {
                const Exact differences = step * step * 4 * exponent * exponent / 3 + 1.0e-11L;
                return std::abs(value - truth) <= truth * ((4 * exponent + 16) * kRoundoff<T> + differences);
            };
            tally.claim(near(floors.x, minVariance * slopeSquared(depth, c.x), c.x, h), depth, floors.x);
            // -e^(-cx) has the slope of e^(cx) mirrored at x = 0.
            tally.claim(near(floors.y, minVariance * slopeSquared(1 - Exact(depth), c.y), c.y, h), depth, floors.y);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("the carried floor is at most the squared warp and never negative", T, float, double)
{
    for (const Vec2<T>& c : exponentPairs<T>())
    {
        for (const T depth : {T(0), T(0.3), T(1)})
        {
            const Vec2<T> warped = exponentialWarp(depth, c);
            CHECK(exponentialMinVariance(T(-1), depth, c) == Vec2<T>(0, 0));
            const Vec2<T> most = exponentialMinVariance(T(9), depth, c);
            CHECK(most.x == (c.x > 0 ? warped.x * warped.x : T(0)));
            CHECK(most.y == (c.y > 0 ? warped.y * warped.y : T(0)));
        }
    }
    // Exponents out of range count as its ends.
    CHECK(exponentialMinVariance(T(0.001), T(0.75), Vec2<T>(-5)) == Vec2<T>(0));
    CHECK(exponentialMinVariance(T(1.0e-6), T(0.75), Vec2<T>(100)) ==
          exponentialMinVariance(T(1.0e-6), T(0.75), Vec2<T>(kMaxExponent<T>)));
}

TEST_CASE_TEMPLATE("exponential visibility bounds the lit share of every distribution", T, float, double)
{
    Random random(40);
    Tally tally;
    for (const Vec2<T>& c : exponentPairs<T>())
    {
        const auto rising = [c](T depth)
        {
            return Exact(exponentialWarp(depth, c).x);
        };
        const auto falling = [c](T depth)
        {
            return Exact(exponentialWarp(depth, c).y);
        };
        for (int i = 0; i < drawsOf(10000); ++i)
        {
            const Distribution<T> window(random);
            // With -ffast-math exp is not the same everywhere, in vectors and alone, which a floor bears; where it is no
            // subnormal number, which counts as 0 there.
            const T minVariance = kFastMath ? T(1.0e-3) : i % 2 == 0 ? T(0) : T(1.0e-5);
            const ExactMoments p = window.moments(rising);
            const ExactMoments n = window.moments(falling);
            const Vec4<T> stored(T(p.mean), T(p.second), T(n.mean), T(n.second));
            for (const T depth : window.depths())
            {
                const Vec2<T> warped = exponentialWarp(depth, c);
                const Vec2<T> floors = exponentialMinVariance(minVariance, depth, c);
                const Exact lit = window.tail(depth);
                const Exact leastTwo = std::min(lit, leastByRounding(p, warped.x, floors.x));
                const Exact leastFour = std::min(leastTwo, leastByRounding(n, warped.y, floors.y));
                const T two = exponentialVisibility2(positive(stored), depth, c.x, minVariance);
                const T four = exponentialVisibility4(stored, depth, c, minVariance);
                tally.claim(Exact(two) >= leastTwo, depth, c.x, minVariance, two, lit);
                tally.claim(Exact(four) >= leastFour, depth, c.x, c.y, minVariance, four, lit);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("a flat lit receiver stays lit at every depth and exponent", T, float, double)
{
    // The stored warp may be one rounding short of the receiver's: 2 u w. With the floor carried through the slope that
    // darkens by d^2 / v <= (2 u)^2 / min(1, 4 c^2 minVariance), and rounds a few times.
    Random random(41);
    Tally tally;
    const T minVariance = T(1.0e-6);
    for (const Vec2<T>& c : exponentPairs<T>())
    {
        for (int i = 0; i < drawsOf(20000); ++i)
        {
            // As often close to either end, where one warp is least.
            const T near = std::ldexp(random.unit<T>(), -random.between(0, 12));
            const T depth = i % 2 == 0 ? near : 1 - near;
            Vec4<T> stored = exponentialMoments(depth, c);
            stored.x = std::nextafter(stored.x, T(0));
            stored.z = std::nextafter(stored.z, -std::numeric_limits<T>::max());
            const T visibility = exponentialVisibility4(stored, depth, c, minVariance);
            const Exact slope = std::min(c.x, c.y);
            if (slope == 0)
                continue;
            const Exact rounding =
                4 * kRoundoff<T> * kRoundoff<T> / std::min(Exact(1), 4 * slope * slope * minVariance);
            tally.claim(Exact(visibility) >= 1 - Exact(1.01) * rounding - 4 * kRoundoff<T>, depth, c.x, c.y,
                        visibility);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("exponentialVisibility4 is the lesser of the bounds of its two warps", T, float, double)
{
    LVSM_NOT_WITH_FAST_MATH("exp is not the same everywhere");
    Random random(42);
    Tally tally;
    int positiveIsLess = 0;
    int negativeIsLess = 0;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const Vec2<T> c(5 + random.unit<T>(), 5 + random.unit<T>());
        Vec4<T> moments(0);
        for (int sample = 0; sample < 4; ++sample)
            moments += T(0.25) * exponentialMoments(random.unit<T>(), c);
        const T depth = random.unit<T>();
        const T minVariance = T(1.0e-5);
        const Vec2<T> warped = exponentialWarp(depth, c);
        const Vec2<T> floors = exponentialMinVariance(minVariance, depth, c);
        const T p = chebyshevUpperBound(positive(moments), warped.x, floors.x);
        const T n = chebyshevUpperBound(negative(moments), warped.y, floors.y);
        tally.claim(exponentialVisibility4(moments, depth, c, minVariance) == std::min(p, n), depth, p, n);
        tally.claim(exponentialVisibility2(positive(moments), depth, c.x, minVariance) == p, depth, p);
        positiveIsLess += p < n;
        negativeIsLess += n < p;
    }
    LVSM_CHECK_TALLY(tally);
    CHECK(positiveIsLess > drawsOf(1000));
    CHECK(negativeIsLess > drawsOf(1000));
}

TEST_CASE_TEMPLATE("without its minus sign the negative warp would darken what is lit", T, float, double)
{
    // Half the window at 0.2, half at 0.8: the surface at 0.2 is lit in full.
    const Vec2<T> c(5, 5);
    const Vec4<T> window = T(0.5) * exponentialMoments(T(0.2), c) + T(0.5) * exponentialMoments(T(0.8), c);
    CHECK(exponentialVisibility4(window, T(0.2), c, T(0)) == 1);

    // e^(-cx) falls with depth and turns the comparison round: the near half looks deeper than the mean.
    const T unsignedWarp = -exponentialWarp(T(0.2), c).y;
    CHECK(chebyshevUpperBound(Vec2<T>(-window.z, window.w), unsignedWarp, T(0)) < T(0.51));
    // And a receiver behind everything looks lit, so that the minimum would lose the bound altogether.
    const T behind = -exponentialWarp(T(0.9), c).y;
    CHECK(chebyshevUpperBound(Vec2<T>(-window.z, window.w), behind, T(0)) == 1);
    CHECK(chebyshevUpperBound(negative(window), exponentialWarp(T(0.9), c).y, T(0)) < 1);
}

TEST_CASE_TEMPLATE("exponential visibility never rises with the receiver's depth", T, float, double)
{
    // Without a floor: a carried floor grows with the receiver's own warp.
    Random random(43);
    Tally tally;
    for (const Vec2<T>& c : exponentPairs<T>())
    {
        for (int i = 0; i < 500; ++i)
        {
            Vec4<T> moments(0);
            for (int sample = 0; sample < 4; ++sample)
                moments += T(0.25) * exponentialMoments(random.unit<T>(), c);
            T before = 1;
            for (int step = 0; step <= 128; ++step)
            {
                const T visibility = exponentialVisibility4(moments, T(step) / T(128), c, T(0));
                tally.claim(visibility <= before, step, c.x, c.y);
                before = visibility;
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("exponential warps bleed less than plain variance on figure 2", T, float, double)
{
    // Section 7: the positive warp moves B away from A and C still further from both, so dx / dy shrinks as c grows.
    const T a = T(0.1);
    const T b = T(0.6);
    const T receiver = T(0.8);
    const Vec2<T> plain = T(0.5) * depthMoments(a) + T(0.5) * depthMoments(b);
    T before = chebyshevUpperBound(plain, receiver, T(0));
    for (const T exponent : {T(2), T(5), T(10), T(40)})
    {
        const Vec2<T> c(exponent, exponent);
        const Vec4<T> window = T(0.5) * exponentialMoments(a, c) + T(0.5) * exponentialMoments(b, c);
        const T visibility = exponentialVisibility2(positive(window), receiver, exponent, T(0));
        CHECK(visibility < before);
        // Equation 4 in the warped space.
        const Exact dx = exactWarp(b, exponent) - exactWarp(a, exponent);
        const Exact dy = exactWarp(receiver, exponent) - exactWarp(b, exponent);
        const Exact equation4 = dx * dx / 4 / (dx * dx / 2 + dx * dy + dy * dy);
        CHECK(std::abs(visibility - equation4) <= (8 * exponent + 32) * kRoundoff<T>);
        before = visibility;
    }
}

TEST_CASE_TEMPLATE("maxExponent is the largest whose square a format holds", T, float, double)
{
    CHECK(std::abs(maxExponent(kLargestFp16<T>, T(1)) - T(5.5449)) < T(0.0001));
    CHECK(maxExponent(kLargestFp32<T>, T(1)) == kMaxExponent<T>);
    for (const T largest : {T(2), T(255), T(1.0e6), kLargestFp16<T>})
    {
        for (const T headRoom : {T(1), T(1.5), T(16)})
        {
            const T c = maxExponent(largest, headRoom);
            // c is rounded four times, an error of 2 u (c + 1) in it, twice that relative in its square.
            const Exact held = Exact(headRoom) * std::exp(2 * Exact(c));
            const Exact rounding = (4 * c + 8) * kRoundoff<T>;
            CHECK(held <= std::max(Exact(largest), Exact(headRoom)) * (1 + rounding));
            CHECK(held >= std::max(Exact(largest), Exact(headRoom)) * (1 - rounding));
        }
    }
}

TEST_CASE_TEMPLATE("maxExponent clamps what makes no sense", T, float, double)
{
    CHECK(maxExponent(T(0.5), T(1)) == 0);
    CHECK(maxExponent(T(-3), T(1)) == 0);
    CHECK(maxExponent(T(10), T(100)) == 0);
    CHECK(maxExponent(kLargestFp16<T>, T(0)) == maxExponent(kLargestFp16<T>, T(1)));
    CHECK(maxExponent(kLargestFp16<T>, T(-9)) == maxExponent(kLargestFp16<T>, T(1)));
    CHECK(maxExponent(std::numeric_limits<T>::max(), T(1)) == kMaxExponent<T>);
}

TEST_CASE("the largest exponent keeps the bound's divisor within 2^126 and its squares normal, and no more")
{
    // The divisor v + d^2 is at most 2 e^(2c): neither the floor nor the distance exceeds the largest square. The room is
    // for an exp that is off by 3 + 2 |x| ULP of 2^-23.
    const double limit = 125 * std::log(2.0) / 2;
    const double room = (3 + 2 * limit) * 0x1p-23;
    CHECK(static_cast<double>(kMaxExponent<float>) + room < limit);
    CHECK(static_cast<double>(kMaxExponent<double>) + 1.0e-4 > limit);
    for (const float depth : {0.0f, 1.0f})
    {
        const Vec4<float> moments = exponentialMoments(depth, Vec2<float>(kMaxExponent<float>));
        for (const float square : {moments.y, moments.w})
        {
            CHECK(2 * square <= kHuge<float>);
            CHECK(square >= kTiny<float>);
        }
    }
    // What fp32 can store at all: past ln(FLT_MAX) / 2 no square is finite.
    const float above = std::exp(static_cast<float>(std::log(static_cast<double>(kLargestFp32<float>)) / 2 + 1.0e-5));
    CHECK(!isFinite(above * above));
}

TEST_CASE("the largest exponent's moments are finite in fp16, head room and its roundings included")
{
    for (int samples = 1; samples <= 1024; ++samples)
    {
        // One rounding to fp16 in the store and one in the sum: each relative 2^-11.
        const double headRoom = samples == 1 ? 1.0 : samples * (1 + 2 * 0x1p-11);
        const double c = maxExponent(kLargestFp16<double>, headRoom);
        const double stored = toFp16(exponentialMoments(1.0, Vec2<double>(c, c)).y);
        CAPTURE(samples);
        CHECK(isFinite(toFp16(samples * stored)));
        CHECK(!isFinite(toFp16(samples * toFp16(exponentialMoments(1.0, Vec2<double>(c + 0.002, c)).y))));
    }
    const auto c = static_cast<float>(maxExponent(kLargestFp16<float>, 1.0f));
    CHECK(isFinite(toFp16(static_cast<double>(exponentialMoments(1.0f, Vec2<float>(c, c)).y))));
}

TEST_CASE("an unnormalised filter sum stays finite with its head room")
{
    // Under a head room of 8 the divisor of the bound sets the limit, not the sum.
    for (const float headRoom : {9.0f, 49.0f, 1024.0f})
    {
        const float c = maxExponent(kLargestFp32<float>, headRoom);
        const Vec4<float> moments = exponentialMoments(1.0f, Vec2<float>(c, c));
        CAPTURE(headRoom);
        // exp within 1 ULP of a c within 3 ULP of 44: 4 10^-5 relative at most, which the margin of fp32 need not hold
        // once the head room takes c below it; so it is added here.
        const double filled = static_cast<double>(moments.y) * static_cast<double>(headRoom) / kLargestFp32<double>;
        CHECK(filled <= 1 + 4.0e-5);
        CHECK(filled >= 1 - 8.0e-5);
    }
}

TEST_CASE_TEMPLATE("a window half empty leaves an exponential receiver lit", T, float, double)
{
    for (const Vec2<T>& c : exponentPairs<T>())
    {
        const Vec4<T> empty = exponentialMoments(T(1), c);
        for (int step = 0; step < 32; ++step)
        {
            const T surface = T(step) / T(32);
            const Vec4<T> window = T(0.5) * exponentialMoments(surface, c) + T(0.5) * empty;
            CHECK(exponentialVisibility4(window, surface, c, T(0)) == 1);
            CHECK(exponentialVisibility2(positive(window), surface, c.x, T(0)) == 1);
            for (int behind = step + 1; behind <= 32; ++behind)
            {
                const T depth = T(behind) / T(32);
                const Vec2<T> near = exponentialWarp(surface, c);
                const Vec2<T> far = exponentialWarp(T(1), c);
                const Vec2<T> warped = exponentialWarp(depth, c);
                // Each second moment is rounded as a square and as a sum.
                const Exact least =
                    std::min({Exact(0.5), leastByRounding(ExactMoments::ofHalves(near.x, far.x), warped.x, Exact(0), 2),
                              leastByRounding(ExactMoments::ofHalves(near.y, far.y), warped.y, Exact(0), 2)});
                CHECK(Exact(exponentialVisibility4(window, depth, c, T(0))) >= least);
            }
        }
    }
}

} // namespace
} // namespace lvsm::unit
