#include <lvsm/convolution.hpp>

#include <doctest/doctest.h>

#include <algorithm>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

constexpr Exact kPiExact = Exact(3.14159265358979323846264338327950288L);

// The cut series of a step at t = 0, term by term.
Exact series(Exact t, int order)
{
    Exact sum = Exact(0.5);
    for (int k = 1; k <= order; ++k)
        sum += 2 / (kPiExact * (2 * k - 1)) * std::sin((2 * k - 1) * kPiExact * t);
    return sum;
}

struct Texel
{
    double depth;
    double weight;
};

// The sum at a receiver over a filtered window, as a shader makes it: four terms at a time.
template <typename T>
T windowSum(const std::vector<Texel>& window, T depth, T offset, int order, T strength)
{
    T sum = 0;
    for (int first = 1; first <= order; first += 4)
    {
        Vec4<T> sines(0);
        Vec4<T> cosines(0);
        for (const Texel& texel : window)
        {
            sines += T(texel.weight) * fourierSines(T(texel.depth), first, order);
            cosines += T(texel.weight) * fourierCosines(T(texel.depth), first, order);
        }
        sum += fourierSum(sines, cosines, depth, offset, first, order, strength);
    }
    return sum;
}

template <typename T>
Exact shrunk(T depth, int order)
{
    return Exact(depth) * (1 - Exact(1) / order);
}

// Of one term's angle: up to 2 order half turns, rounded four times on the way. Sine, cosine and a product follow.
template <typename T>
Exact termError(int order)
{
    return kRoundoff<T> * (4 * kPiExact * 2 * order + 6);
}

TEST_CASE_TEMPLATE("the basis is sines and cosines of odd multiples of pi", T, float, double)
{
    Tally tally;
    for (int order : {2, 4, 7, 16, 64})
    {
        for (int first = 1; first <= order; first += 4)
        {
            for (int i = 0; i <= 64; ++i)
            {
                const T depth = T(i) / 64;
                const Vec4<T> sines = fourierSines(depth, first, order);
                const Vec4<T> cosines = fourierCosines(depth, first, order);
                for (int k = 0; k < 4; ++k)
                {
                    const Exact angle = kPiExact * (2 * (first + k) - 1) * shrunk(depth, order);
                    tally.claim(std::abs(sines[k] - std::sin(angle)) <= termError<T>(order + 4), order, first + k,
                                depth);
                    tally.claim(std::abs(cosines[k] - std::cos(angle)) <= termError<T>(order + 4), order, first + k,
                                depth);
                }
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("the sum over all terms is the cut series of the depth test", T, float, double)
{
    Tally tally;
    Random random(12);
    for (int order : {2, 3, 4, 5, 8, 16})
    {
        for (int i = 0; i < 500; ++i)
        {
            const double occluder = double(random.unit<float>());
            const T receiver = random.unit<float>();
            const Exact expected = series(shrunk(occluder, order) - shrunk(receiver, order), order) - Exact(0.5);
            const Exact sum = windowSum<T>({{occluder, 1}}, receiver, T(0), order, T(0));
            // Weights 2 / c_k of the terms' errors, each of four factors, and a rounding or two for each.
            Exact error = 0;
            for (int k = 1; k <= order; ++k)
                error += 2 / (kPiExact * (2 * k - 1)) * (4 * termError<T>(order) + 6 * kRoundoff<T>);
            tally.claim(std::abs(sum - expected) <= error, order, occluder, receiver, sum, expected);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("the series nears the depth test as its remainder bound says")
{
    Tally tally;
    for (int order : {4, 8, 16, 64})
    {
        for (int i = 1; i < 64; ++i)
        {
            for (const double side : {-1.0, 1.0})
            {
                const double distance = 0.5 * i / 64;
                const double sum = windowSum<double>({{0.5 + side * distance, 1}}, 0.5, 0.0, order, 0.0);
                // Abel summation: the first weight left out, times the largest partial sum of sines, 1 / sin(pi t).
                const double t = double(shrunk(distance, order));
                const double bound = 2 / ((2 * order + 1) * double(kPiExact)) / std::sin(double(kPiExact) * t);
                tally.claim(std::abs(0.5 + sum - (side > 0 ? 1.0 : 0.0)) <= bound + 1e-12, order, distance, sum);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("a lit surface is lit with the offset, and half lit without it unless scaled", T, float, double)
{
    Tally tally;
    for (int order : {2, 4, 16, 32})
    {
        for (int i = 0; i <= 128; ++i)
        {
            const T depth = T(i) / 128;
            const std::vector<Texel> self{{double(depth), 1}};
            const T offset = fourierOffset<T>(order);
            tally.claim(fourierVisibility(windowSum<T>(self, depth, offset, order, T(0)), T(1)) == 1, order, depth);
            const T without = windowSum<T>(self, depth, T(0), order, T(0));
            tally.claim(std::abs(Exact(without)) <= 8 * termError<T>(order), order, depth, without);
            tally.claim(fourierVisibility(without, T(2)) >= 1 - T(16 * termError<T>(order)), order, depth, without);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("the offset is where the series has its first crest")
{
    for (int order : {2, 4, 16, 64})
    {
        const Exact crest = fourierOffset<Exact>(order);
        CHECK(series(crest, order) > series(crest * Exact(0.99), order));
        CHECK(series(crest, order) > series(crest * Exact(1.01), order));
        CHECK(series(crest, order) > 1);
    }
}

TEST_CASE("no two depths come so far apart that the series turns back")
{
    for (int order : {2, 4, 8, 16, 64})
    {
        const double offset = fourierOffset<double>(order);
        // The farthest texel over the nearest receiver is on the crest. The nearest occluder over the farthest receiver is
        // two crests from the next step, where the remainder bound allows this ripple.
        const double ripple = 2 / ((2 * order + 1) * double(kPiExact)) / std::sin(double(kPiExact) / order);
        CHECK(windowSum<double>({{1.0, 1}}, 0.0, offset, order, 0.0) >= 0.5 - 1e-12);
        CHECK(windowSum<double>({{0.0, 1}}, 1.0, 0.0, order, 0.0) <= -0.5 + ripple);
    }
}

TEST_CASE("filtering the basis is filtering the shadow")
{
    Random random(13);
    for (int i = 0; i < 200; ++i)
    {
        const double receiver = random.unit<double>();
        std::vector<Texel> window;
        double expected = 0;
        for (int k = 0; k < 9; ++k)
        {
            window.push_back({random.unit<double>(), 1.0 / 9});
            expected += windowSum<double>({{window.back().depth, 1}}, receiver, 0.02, 16, 0.5) / 9;
        }
        CHECK(windowSum<double>(window, receiver, 0.02, 16, 0.5) == doctest::Approx(expected).epsilon(1e-12));
    }
}

TEST_CASE("attenuation takes the crest down, more with more strength, and the first term least")
{
    double last = 2;
    for (double strength : {0.0, 0.25, 0.5, 1.0, 2.0, 4.0})
    {
        double crest = 0;
        for (int i = 0; i <= 256; ++i)
            crest = std::max(crest, windowSum<double>({{i / 256.0, 1}}, 0.0, 0.0, 16, strength));
        CHECK(crest < last);
        last = crest;
        for (int k = 1; k < 16; ++k)
            CHECK(fourierAttenuation(k, 16, strength) >= fourierAttenuation(k + 1, 16, strength));
        CHECK(fourierAttenuation(16, 16, strength) == std::exp(-strength));
    }
    CHECK(fourierAttenuation(3, 16, 0.0) == 1);
    CHECK(fourierAttenuation(4, 16, 2.0) == std::exp(-0.125));
}

TEST_CASE_TEMPLATE("terms beyond the order count nothing", T, float, double)
{
    const Vec4<T> ones(1);
    CHECK(fourierSum(ones, ones, T(0.3), T(0), 5, 4, T(0)) == 0);
    const T two = fourierSum(ones, ones, T(0.3), T(0), 1, 2, T(0));
    CHECK(two == fourierSum(Vec4<T>(1, 1, -1, -1), Vec4<T>(1, 1, -1, -1), T(0.3), T(0), 1, 2, T(0)));
}

// In [-pi, pi] the devices promise how precise their sines are.
TEST_CASE_TEMPLATE("every angle is taken to half a turn, either way", T, float, double)
{
    Tally tally;
    for (int index : {1, 2, 3, 16, 256})
    {
        for (int i = -512; i <= 512; ++i)
        {
            const T angle = detail::fourierAngle(T(i) / 512, index);
            tally.claim(std::abs(Exact(angle)) <= kPiExact * (1 + 2 * kRoundoff<T>), index, i, angle);
            const Exact turns = (Exact(2 * index - 1) * i / 512 - Exact(angle) / kPiExact) / 2;
            tally.claim(std::abs(turns - std::round(turns)) <= 2 * kRoundoff<T>, index, i, angle);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("numbers of terms and their orders out of range count as the ends", T, float, double)
{
    CHECK(fourierOffset<T>(-1) == T(0.25));
    CHECK(fourierOffset<T>(256) == T(1) / 512);
    CHECK(fourierOffset<T>(257) == T(1) / 512);
    const T depth = T(0.3);
    for (const int less : {0, -1, -100})
    {
        CHECK(fourierSines(depth, less, 16) == fourierSines(depth, 1, 16));
        CHECK(fourierCosines(depth, less, 16) == fourierCosines(depth, 1, 16));
        CHECK(fourierAttenuation(less, 16, T(2)) == fourierAttenuation(1, 16, T(2)));
        CHECK(fourierAttenuation(1, less, T(2)) == fourierAttenuation(1, 2, T(2)));
        CHECK(fourierAttenuation(1, 1, T(2)) == fourierAttenuation(1, 2, T(2)));
    }
    CHECK(fourierAttenuation(1, 2, T(2)) == doctest::Approx(std::exp(-0.5)));
    CHECK(fourierAttenuation(5, 4, T(2)) == fourierAttenuation(4, 4, T(2)));
    CHECK(fourierAttenuation(1, 4, T(2)) == doctest::Approx(std::exp(-0.125)));
    CHECK(fourierAttenuation(128, 257, T(2)) == fourierAttenuation(128, 256, T(2)));
    CHECK(fourierAttenuation(128, 256, T(2)) == doctest::Approx(std::exp(-0.5)));
    for (const int more : {257, 300})
    {
        CHECK(fourierSines(depth, more, 256) == fourierSines(depth, 256, 256));
        CHECK(fourierCosines(depth, more, 256) == fourierCosines(depth, 256, 256));
    }
    CHECK(fourierSines(depth, 255, 256).y == fourierSines(depth, 256, 256).x);
    CHECK(fourierCosines(depth, 255, 256).y == fourierCosines(depth, 256, 256).x);
    // At the last number one term of the four counts.
    const Vec4<T> ones(1), one(1, -1, -1, -1);
    for (const int order : {256, 257, 300})
    {
        const T last = fourierSum(ones, ones, depth, T(0), 256, order, T(0));
        CHECK(last != 0);
        CHECK(fourierSum(one, one, depth, T(0), 256, order, T(0)) == last);
        CHECK(fourierSum(ones, ones, depth, T(0), 257, order, T(0)) == last);
    }
    CHECK(fourierSum(ones, ones, depth, T(0), 1, 1, T(0)) == fourierSum(ones, ones, depth, T(0), 1, 2, T(0)));
    // Of four terms depth 1 is moved in front of depth 0 by 3/4.
    CHECK(fourierSum(ones, ones, T(1), T(0.75), 1, 4, T(0)) == fourierSum(ones, ones, T(0), T(0), 1, 4, T(0)));
}

TEST_CASE_TEMPLATE("visibility is a half and the sum, in [0,1], times the scale", T, float, double)
{
    CHECK(fourierVisibility(T(0.125), T(0.5)) == T(0.3125));
    CHECK(fourierVisibility(T(-0.25), T(1)) == T(0.25));
    CHECK(fourierVisibility(T(-0.25), T(2)) == T(0.5));
    CHECK(fourierVisibility(T(0.25), T(2)) == 1);
    CHECK(fourierVisibility(T(0.9), T(0.5)) == T(0.5));
    CHECK(fourierVisibility(T(-0.9), T(2)) == 0);
    CHECK(fourierVisibility(T(0.25), T(-1)) == 0);
}

TEST_CASE_TEMPLATE("8 bits keep a term within half a step, and the middle and ends exactly", T, float, double)
{
    const auto throughUnorm8 = [](T term)
    {
        const T stored = std::round(encodeFourier(Vec4<T>(term)).x * 255) / 255;
        return decodeFourier(Vec4<T>(stored)).x;
    };
    for (T exact : {T(-1), T(0), T(1)})
        CHECK(std::abs(throughUnorm8(exact) - exact) <= 4 * std::numeric_limits<T>::epsilon());
    Random random(14);
    Tally tally;
    for (int i = 0; i < drawsOf(10000); ++i)
    {
        const T term = 2 * random.unit<T>() - 1;
        tally.claim(std::abs(throughUnorm8(term) - term) <= T(0.5) / 127 + 8 * std::numeric_limits<T>::epsilon(), term);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("convolution shadow maps stay in range for any arguments", T, float, double)
{
    Tally tally;
    const std::vector<T> values = specialValues<T>();
    const int integers[] = {0, 1, 2, 16, 255, 256, 257, -1, 2147483647, -2147483647 - 1};
    Random random(15);
    const auto any = [&]
    {
        return values[std::size_t(random.between(0, int(values.size()) - 1))];
    };
    const auto any4 = [&]
    {
        return Vec4<T>(any(), any(), any(), any());
    };
    const auto integer = [&]
    {
        return integers[random.between(0, 9)];
    };
    const auto within = [&](T value, T lo, T hi)
    {
        tally.claim(value >= lo && value <= hi, value, lo, hi);
    };
    for (int i = 0; i < drawsOf(50000); ++i)
    {
        within(fourierSines(any(), integer(), integer()).w, -1, 1);
        within(fourierCosines(any(), integer(), integer()).x, -1, 1);
        within(encodeFourier(any4()).x, T(0), 1);
        within(decodeFourier(any4()).x, -1, 1);
        within(fourierAttenuation(integer(), integer(), any()), 0, 1);
        within(fourierOffset<T>(integer()), 0, T(0.25));
        within(fourierSum(any4(), any4(), any(), any(), integer(), integer(), any()), T(-1.51), T(1.51));
        within(fourierVisibility(any(), any()), 0, 1);
    }
    LVSM_CHECK_TALLY(tally);
}

} // namespace
} // namespace lvsm::unit
