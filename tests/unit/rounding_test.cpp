// What should cancel does, under every compiler and its flags: a flat occluder has no variance, a line no gradient.
// tests/configurations builds these with contraction, which makes a product and a sum round once.
#include <lvsm/lvsm.hpp>

#include <doctest/doctest.h>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

// As a map holds it: what comes out of memory is rounded, and the compiler knows nothing of where it came from.
template <typename T>
T stored(T x)
{
    volatile T memory = x;
    return memory;
}

template <glm::length_t N, typename T>
glm::vec<N, T> stored(glm::vec<N, T> x)
{
    for (glm::length_t i = 0; i < N; ++i)
        x[i] = stored(x[i]);
    return x;
}

// A flat occluder at every thousandth of the depth range, and a receiver 1e-4 behind it, without a variance floor.
// visibilityAt(occluder, receiver, fromMemory): whether the moments come from a map or from the same expression.
// Returns the largest.
template <typename T, typename VisibilityAt>
T mostBehindFlat(const VisibilityAt& visibilityAt)
{
    T most = T(0);
    for (const bool fromMemory : {true, false})
    {
        for (int i = 1; i < 1000; ++i)
        {
            const T occluder = stored(static_cast<T>(i) / T(1000));
            const T visibility = visibilityAt(occluder, stored(occluder + T(1.0e-4)), fromMemory);
            most = visibility > most ? visibility : most;
        }
    }
    return most;
}

TEST_CASE_TEMPLATE("a flat occluder is dark right behind it, without a floor", T, float, double)
{
    const auto filtered = [](auto moments, bool fromMemory)
    {
        return fromMemory ? stored(moments) : moments;
    };
    const Vec2<T> front(stored(T(0)), stored(T(0.5)));
    const Vec2<T> back(stored(T(0.5)), stored(T(1)));

    CHECK(mostBehindFlat<T>([&](T z, T t, bool fromMemory)
                            { return chebyshevUpperBound(filtered(depthMoments(z), fromMemory), t, T(0)); }) == 0);
    CHECK(mostBehindFlat<T>([&](T z, T t, bool fromMemory)
                            { return T(1) - chebyshevLowerBound(filtered(depthMoments(t), fromMemory), z, T(0)); }) ==
          0);
    CHECK(mostBehindFlat<T>([&](T z, T t, bool fromMemory)
                            { return boundedUpperBound(filtered(depthMoments(z), fromMemory), t, T(0)); }) == 0);
    CHECK(mostBehindFlat<T>(
              [&](T z, T t, bool fromMemory)
              {
                  const Vec2<T> interval = t < T(0.5) ? front : back;
                  return layeredVisibility(filtered(layerMoments(z, interval), fromMemory), t, interval, T(0));
              }) == 0);
    CHECK(mostBehindFlat<T>(
              [&](T z, T t, bool fromMemory)
              {
                  const Vec2<T> first = filtered(layerMoments(z, front), fromMemory);
                  const Vec2<T> second = filtered(layerMoments(z, back), fromMemory);
                  return t < T(0.5) ? bracketedVisibility(Vec2<T>(1, 1), first, second, t, front, T(0))
                                    : bracketedVisibility(first, second, Vec2<T>(0, 0), t, back, T(0));
              }) == 0);
    // An exponent of 5 keeps the step of 1e-4 over what float resolves of the warp.
    const Vec2<T> exponents(stored(T(5)), stored(T(5)));
    CHECK(mostBehindFlat<T>(
              [&](T z, T t, bool fromMemory)
              {
                  const Vec4<T> moments = filtered(exponentialMoments(z, exponents), fromMemory);
                  return exponentialVisibility2(Vec2<T>(moments.x, moments.y), t, exponents.x, T(0)) +
                         exponentialVisibility4(moments, t, exponents, T(0));
              }) == 0);
    // The least variance of four moments is 2^-40, and the receiver 2e-4 behind: Cantelli's bound is 2.3e-5.
    CHECK(mostBehindFlat<T>([&](T z, T t, bool fromMemory)
                            { return momentVisibility4(filtered(depthMoments4(z), fromMemory), t, T(0)); }) <
          T(2.3e-5));
}

// What a shader may make of M2 - M1^2 where LVSM_PRECISE is empty: one operation, which rounds once.
float contractedVariance(const Vec2<float>& moments, float minVariance)
{
    return std::max(std::fma(-moments.x, moments.x, moments.y), minVariance);
}

TEST_CASE("a floor of 2^-24 covers contraction: a flat occluder is as dark with it as without")
{
    const float floor = 0x1p-24f;
    float largest = 0;
    Tally tally;
    for (int i = 0; i <= 1 << 20; ++i)
    {
        const Vec2<float> moments = stored(depthMoments(stored(static_cast<float>(i) * 0x1p-20f)));
        tally.claim(contractedVariance(moments, floor) == variance(moments, floor), moments.x);
        largest = std::max(largest, contractedVariance(moments, 0.0f));
    }
    LVSM_CHECK_TALLY(tally);
    // One of 2^-26 would not: half a unit in the last place of a square is up to 2^-25.
    CHECK(largest > 0x1p-26f);
}

TEST_CASE("contraction moves the variance of any window by 2^-24 of the squared mean at most")
{
    Random random(16);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const float mean = random.unit<float>();
        const Vec2<float> moments(mean, mean * mean + random.unit<float>() * (mean - mean * mean));
        const Exact change = Exact(contractedVariance(moments, 0.0f)) - Exact(variance(moments, 0.0f));
        // And half a unit in the last place of each of the two differences.
        const Exact rounding = kRoundoff<float> * 2 * Exact(variance(moments, 0.0f));
        tally.claim(std::abs(change) <= 0x1p-24L * Exact(mean) * Exact(mean) + rounding, moments.x, moments.y, change);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("the bias of four moments in fp32 covers contraction, too")
{
    CHECK(0.63f * kMoment4BiasFp32<float> > 0x1p-24f);
}

TEST_CASE_TEMPLATE("a flat neighbourhood is no occluder's edge", T, float, double)
{
    for (int i = 0; i <= 1000; ++i)
    {
        const T depth = stored(static_cast<T>(i) / T(1000));
        const Vec2<T> moments = stored(depthMoments(depth));
        CHECK(secondOccluder(neighbourhoodMoments(moments, moments, moments, moments)) == depth);
        CHECK(occluderWeight(neighbourhoodMoments(moments, moments, moments, moments), T(0), T(1)) == 0);
    }
}

TEST_CASE_TEMPLATE("a receiver that is a line in the map has no gradient, whatever its direction", T, float, double)
{
    Random random(14);
    for (int i = 0; i < 1000; ++i)
    {
        const Vec3<T> line(random.unit<T>(), random.unit<T>(), random.unit<T>());
        CHECK(receiverGradient(line, line) == Vec2<T>(0, 0));
        CHECK(receiverGradient(line, T(-4) * line) == Vec2<T>(0, 0));
    }
}

TEST_CASE_TEMPLATE("along a contour of the receiver's plane its depth stays", T, float, double)
{
    Random random(15);
    for (int i = 0; i < 1000; ++i)
    {
        const T slope = random.unit<T>();
        const T away = T(1.0e18) * random.unit<T>();
        CHECK(planeDepth(T(0.5), Vec2<T>(slope, -slope), Vec2<T>(away, away)) == T(0.5));
    }
}

} // namespace
} // namespace lvsm::unit
