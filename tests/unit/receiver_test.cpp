#include <lvsm/moments.hpp>
#include <lvsm/receiver.hpp>

#include <doctest/doctest.h>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

TEST_CASE_TEMPLATE("receiverGradient recovers the plane of a receiver", T, float, double)
{
    Random random(121);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        // The Jacobian in whole numbers and the gradient in 1024ths: both derivatives of depth are exact.
        const auto number = [&]
        {
            return T(random.between(-8, 8));
        };
        const Vec2<T> gradient(number() / T(1024), number() / T(1024));
        Vec3<T> dx(number(), number(), 0);
        Vec3<T> dy(number(), number(), 0);
        dx.z = gradient.x * dx.x + gradient.y * dx.y;
        dy.z = gradient.x * dy.x + gradient.y * dy.y;
        const Vec2<T> found = receiverGradient(dx, dy);
        const bool isLine = dx.x * dy.y == dx.y * dy.x;
        // All is exact but the division, which -ffast-math makes an inverse and a product.
        const auto near = [](T a, T b)
        {
            const Exact roundings = kFastMath ? 2 + kRoundoff<T> : Exact(1);
            return std::abs(Exact(a) - Exact(b)) <= roundings * kRoundoff<T> * std::abs(Exact(b));
        };
        tally.claim(isLine ? found == Vec2<T>(0) : near(found.x, gradient.x) && near(found.y, gradient.y), dx.x, dx.y,
                    dy.x, dy.y);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("receiverGradient of a receiver that is steeper than any quotient can say ends at one per texel")
{
    // A determinant of 1.2e-38, hardly over 2^-126, under cofactors of 1e10 and 1e-12.
    const auto found = [](float x, float y)
    {
        return receiverGradient(Vec3<float>(1.2e-30f, 0, x), Vec3<float>(0, 1.0e-8f, y));
    };
    CHECK(found(1.0e18f, -1.0e18f) == Vec2<float>(1, -1));
    CHECK(found(-3.0e38f, 3.0e38f) == Vec2<float>(-1, 1));
    CHECK(found(0, 0) == Vec2<float>(0));
}

TEST_CASE_TEMPLATE("components, offsets and shifts beyond 1e18 count as 1e18", T, float, double)
{
    const T far = T(1.0e30), limit = T(1.0e18), quarter = T(0.25e18), half = T(0.5);
    for (const T sign : {T(1), T(-1)})
    {
        const auto near = [&](const Vec2<T>& found, T x, T y)
        {
            CAPTURE(found.x);
            CAPTURE(found.y);
            CHECK(std::abs(found.x - sign * x) < T(1e-6));
            CHECK(std::abs(found.y - sign * y) < T(1e-6));
        };
        near(receiverGradient(Vec3<T>(sign * far, 0, quarter), Vec3<T>(0, 1, 0)), T(0.25), 0);
        near(receiverGradient(Vec3<T>(0, sign * far, quarter), Vec3<T>(1, 0, 0)), 0, T(0.25));
        near(receiverGradient(Vec3<T>(0, 1, 0), Vec3<T>(sign * far, 0, quarter)), T(0.25), 0);
        near(receiverGradient(Vec3<T>(1, 0, 0), Vec3<T>(0, sign * far, quarter)), 0, T(0.25));
        // Of two that cancel in part the larger is cut to twice the half of the other.
        const T byInverse = kFastMath ? half * 3 * static_cast<T>(kRoundoff<T>) : T(0);
        const T x = receiverGradient(Vec3<T>(limit, half, sign * far), Vec3<T>(0, 1, sign * limit)).x;
        const T y = receiverGradient(Vec3<T>(1, 0, sign * limit), Vec3<T>(half, limit, sign * far)).y;
        CHECK(std::abs(x - sign * half) <= byInverse);
        CHECK(std::abs(y - sign * half) <= byInverse);

        const T small = T(0x1p-62);
        const T reached = T(0.5) + sign * limit * small;
        CHECK(planeDepth(T(0.5), Vec2<T>(small, 0), Vec2<T>(sign * far, 0)) == reached);
        CHECK(planeDepth(T(0.5), Vec2<T>(0, small), Vec2<T>(0, sign * far)) == reached);
    }
    CHECK(shiftReceiver(T(0.5), Vec2<T>(T(0x1p-62), 0), far) == T(0.5) - limit * T(0x1p-62));
}

TEST_CASE_TEMPLATE("shiftReceiver by the filter's reach goes in front of all of the receiver's own samples", T, float,
                   double)
{
    Random random(122);
    Tally tally;
    for (int i = 0; i < drawsOf(10000); ++i)
    {
        const Vec2<T> gradient(T(random.between(-16, 16)) / T(1024), T(random.between(-16, 16)) / T(1024));
        const T depth = T(random.between(0, 64)) / T(64);
        T nearest = 1;
        for (int y = -3; y <= 3; ++y)
            for (int x = -3; x <= 3; ++x)
                nearest = std::min(nearest, planeDepth(depth, gradient, Vec2<T>(T(x), T(y))));
        // Exact, and reached by a corner of the window.
        tally.claim(shiftReceiver(depth, gradient, T(3)) == nearest, depth, gradient.x, gradient.y);
    }
    LVSM_CHECK_TALLY(tally);
    CHECK(shiftReceiver(T(0.5), Vec2<T>(T(0.25), T(0.125)), T(0)) == T(0.5));
    CHECK(shiftReceiver(T(0.5), Vec2<T>(T(0.25), T(-0.125)), T(1)) == T(0.125));
}

TEST_CASE_TEMPLATE("planeDepth follows the gradient", T, float, double)
{
    CHECK(planeDepth(T(0.5), Vec2<T>(T(0.125), T(-0.25)), Vec2<T>(2, 1)) == T(0.5));
    CHECK(planeDepth(T(0.5), Vec2<T>(T(0.125), T(0)), Vec2<T>(1, 7)) == T(0.625));
    CHECK(planeDepth(T(0.5), Vec2<T>(T(0.125), T(0)), Vec2<T>(100, 0)) == T(1));
    CHECK(planeDepth(T(0.5), Vec2<T>(T(0.125), T(0)), Vec2<T>(-100, 0)) == T(0));
}

TEST_CASE_TEMPLATE("a gradient beyond one per texel counts as one, either way and along either axis", T, float, double)
{
    const T size = T(0.0625);
    for (const T steep : {T(1), T(3), std::numeric_limits<T>::max()})
    {
        for (const T sign : {T(1), T(-1)})
        {
            const Vec2<T> alongX(sign * steep, 0), alongY(0, sign * steep);
            CHECK(planeDepth(T(0.5), alongX, Vec2<T>(size, T(0.25))) == T(0.5) + sign * size);
            CHECK(planeDepth(T(0.5), alongY, Vec2<T>(T(0.25), size)) == T(0.5) + sign * size);
            CHECK(shiftReceiver(T(0.5), alongX, size) == T(0.5) - size);
            CHECK(shiftReceiver(T(0.5), alongY, size) == T(0.5) - size);
            CHECK(receiverMinVariance(T(0), alongX, T(1)) == T(4));
            CHECK(receiverMinVariance(T(0), alongY, T(1)) == T(4));
        }
    }
    CHECK(shiftReceiver(T(0.5), Vec2<T>(T(0.25), T(0.25)), T(-1)) == T(0.5));
    CHECK(shiftReceiver(T(0.5), Vec2<T>(T(1), T(1)), T(100)) == T(0));
    CHECK(receiverMinVariance(T(-1), Vec2<T>(0), T(1)) == T(0));
    CHECK(receiverMinVariance(T(0), Vec2<T>(1, 0), T(-1)) == T(0));
    CHECK(receiverMinVariance(T(0), Vec2<T>(1, 0), T(1e6)) == T(4) * T(65536) * T(65536));
}

TEST_CASE("receiverMinVariance is four times the variance of a plane under the filter")
{
    // 7 taps of a binomial filter: standard deviation sqrt(6) / 2.
    const double taps[] = {1 / 64.0, 6 / 64.0, 15 / 64.0, 20 / 64.0, 15 / 64.0, 6 / 64.0, 1 / 64.0};
    const Vec2<double> gradient(0.01, -0.02);
    double m1 = 0, m2 = 0;
    for (int y = 0; y < 7; ++y)
    {
        for (int x = 0; x < 7; ++x)
        {
            const double z = planeDepth(0.5, gradient, Vec2<double>(x - 3, y - 3));
            m1 += taps[x] * taps[y] * z;
            m2 += taps[x] * taps[y] * z * z;
        }
    }
    const double floor = receiverMinVariance(0.0, gradient, std::sqrt(6.0) / 2);
    CHECK(floor == doctest::Approx(4 * (m2 - m1 * m1)).epsilon(1e-9));
    CHECK(receiverMinVariance(1.0, gradient, 1.0) == 1.0);
    // Two deviations in front of the mean a receiver is half lit at least.
    const double deviation = std::sqrt(m2 - m1 * m1);
    CHECK(chebyshevUpperBound(Vec2<double>(m1, m2), m1 + 2 * deviation, floor) == doctest::Approx(0.5).epsilon(1e-9));
}

} // namespace
} // namespace lvsm::unit
