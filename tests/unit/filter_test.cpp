#include <lvsm/exponential.hpp>
#include <lvsm/filter.hpp>

#include <doctest/doctest.h>

#include <cfloat>

#include "numbers.hpp"
#include "ranges.hpp"

namespace lvsm::unit
{
namespace
{

// A row of Pascal's triangle; all of them up to C(64, 32) fit.
std::vector<Exact> pascalRow(int size)
{
    std::vector<std::uint64_t> row{1};
    for (int i = 1; i < size; ++i)
    {
        row.push_back(0);
        for (int j = i; j > 0; --j)
            row[std::size_t(j)] += row[std::size_t(j - 1)];
    }
    return {row.begin(), row.end()};
}

// What the fetches of a kernel add to each tap: each spreads its weight over the two taps around it.
template <typename T, typename Tap>
std::vector<Exact> spread(int size, const Tap& tap)
{
    std::vector<Exact> weights(std::size_t(size) + 1, 0);
    for (int fetch = 0; fetch <= (size - 1) / 2; ++fetch)
    {
        const Vec2<T> offsetAndWeight = tap(fetch);
        const Exact position = Exact(offsetAndWeight.x) + Exact(size - 1) / 2;
        const auto left = std::size_t(position);
        const Exact fraction = position - Exact(left);
        weights[left] += Exact(offsetAndWeight.y) * (1 - fraction);
        weights[left + 1] += Exact(offsetAndWeight.y) * fraction;
    }
    return weights;
}

TEST_CASE_TEMPLATE("binomialWeight is a row of Pascal's triangle over its sum", T, float, double)
{
    Tally tally;
    for (int size = 1; size <= kMaxFilterSize; ++size)
    {
        const std::vector<Exact> row = pascalRow(size);
        for (int i = 0; i < size; ++i)
        {
            const Exact exact = std::ldexp(row[std::size_t(i)], 1 - size);
            const Exact weight = binomialWeight<T>(i, size);
            // A quotient and a product for each of at most 32 steps; halving is exact.
            tally.claim(std::abs(weight - exact) <= Exact(1.01) * 64 * kRoundoff<T> * exact, i, size, weight, exact);
            tally.claim(binomialWeight<T>(i, size) == binomialWeight<T>(size - 1 - i, size), i, size);
        }
        tally.claim(binomialWeight<T>(-1, size) == 0 && binomialWeight<T>(size, size) == 0, size);
    }
    LVSM_CHECK_TALLY(tally);
    CHECK(binomialWeight<T>(4, 9) == T(70) / T(256));
}

TEST_CASE("binomialWeight has the variance that its documentation states")
{
    for (int size = 1; size <= kMaxFilterSize; ++size)
    {
        double second = 0;
        for (int i = 0; i < size; ++i)
            second += binomialWeight<double>(i, size) * std::pow(i - 0.5 * (size - 1), 2);
        CHECK(second == doctest::Approx((size - 1) / 4.0).epsilon(1e-12));
    }
}

TEST_CASE_TEMPLATE("gaussianWeight is a normalised Gaussian at the centres of the taps", T, float, double)
{
    Tally tally;
    for (const T sigma : {T(0.3), T(0.7), T(1), T(2.5), T(9), T(1000)})
    {
        for (int size : {1, 2, 3, 5, 7, 8, 9, 21, 65})
        {
            std::vector<Exact> exact;
            Exact sum = 0;
            for (int i = 0; i < size; ++i)
            {
                const Exact x = i - Exact(size - 1) / 2;
                exact.push_back(std::exp(-x * x / (2 * Exact(sigma) * Exact(sigma))));
                sum += exact.back();
            }
            Exact total = 0;
            for (int i = 0; i < size; ++i)
            {
                const Exact expected = exact[std::size_t(i)] / sum;
                const Exact weight = gaussianWeight(i, size, sigma);
                total += weight;
                // Two roundings in the exponent a, scaled by it in the result, and 2 units for exp; the same again in the sum,
                // where a e^-a counts at most 0.37, with a rounding for each term; one for the quotient.
                const Exact a = -std::log(exact[std::size_t(i)]);
                const Exact error = Exact(1.01) * kRoundoff<T> * (2 * a + 2 + 3 + Exact(size) + 1);
                tally.claim(std::abs(weight - expected) <= error * expected + Exact(std::numeric_limits<T>::min()), i,
                            size, sigma, weight, expected);
            }
            tally.claim(std::abs(total - 1) <= Exact(1.01) * kRoundoff<T> * (Exact(size) + 6), size, sigma, total);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("gaussianWeight of a vanishing sigma is the middle, of an endless one a box", T, float, double)
{
    for (const T sigma : {T(0), T(-1), T(1e-30), T(0.001)})
    {
        CHECK(gaussianWeight(2, 5, sigma) == 1);
        CHECK(gaussianWeight(1, 5, sigma) == 0);
        CHECK(gaussianWeight(2, 6, sigma) == T(0.5));
        CHECK(gaussianWeight(3, 6, sigma) == T(0.5));
    }
    for (int i = 0; i < 8; ++i)
        CHECK(std::abs(gaussianWeight(i, 8, std::numeric_limits<T>::max()) - T(0.125)) < T(1e-6));
}

TEST_CASE_TEMPLATE("boxWeight adds up to one wherever the box is centred", T, float, double)
{
    Random random(3);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const T width = T(0.01) + T(12) * random.unit<T>();
        const T centre = random.unit<T>();
        Exact sum = 0;
        for (int texel = -8; texel <= 8; ++texel)
            sum += boxWeight(T(texel) - centre, width);
        // Each of at most 14 texels: numbers up to 8 rounded to T four times, over the width.
        tally.claim(std::abs(sum - 1) <= 14 * 4 * 8 * kRoundoff<T> / Exact(width), width, centre, sum);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("boxWeight shares fractional widths out between the outer texels", T, float, double)
{
    CHECK(boxWeight(T(0), T(2.5)) == T(0.4));
    CHECK(boxWeight(T(1), T(2.5)) == T(0.75) / T(2.5));
    CHECK(boxWeight(T(-1), T(2.5)) == T(0.75) / T(2.5));
    CHECK(boxWeight(T(2), T(2.5)) == 0);
    for (int texel = -1; texel <= 1; ++texel)
        CHECK(boxWeight(T(texel), T(3)) == T(1) / T(3));
    CHECK(boxWeight(T(0.25), T(0.5)) == 1);
    CHECK(boxWeight(T(0.5), T(0.5)) == T(0.5));
    CHECK(boxWeight(T(0), T(0)) == 1);
}

TEST_CASE_TEMPLATE("linearPair gives one fetch that is worth two taps", T, float, double)
{
    Random random(4);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec2<T> w(random.unit<T>(), random.unit<T>());
        const Vec2<T> pair = linearPair(w.x, w.y);
        const Exact first = Exact(pair.y) * (1 - Exact(pair.x));
        const Exact second = Exact(pair.y) * Exact(pair.x);
        // A sum, rounded again inside the quotient that itself is rounded; all of it scales with the sum.
        const Exact error = Exact(1.01) * 3 * kRoundoff<T> * (Exact(w.x) + Exact(w.y));
        tally.claim(std::abs(first - Exact(w.x)) <= error && std::abs(second - Exact(w.y)) <= error, w.x, w.y);
        tally.claim(pair.x >= 0 && pair.x <= 1, w.x, w.y);
    }
    LVSM_CHECK_TALLY(tally);
    CHECK(linearPair(T(0), T(0)) == Vec2<T>(0));
    CHECK(linearPair(T(0), T(2)) == Vec2<T>(1, 2));
}

TEST_CASE_TEMPLATE("half the fetches give every weight of a kernel of any size", T, float, double)
{
    Tally tally;
    for (int size = 1; size <= kMaxFilterSize; ++size)
    {
        const T sigma = T(size) / T(5);
        const auto binomial = spread<T>(size, [size](int fetch) { return binomialTap<T>(fetch, size); });
        const auto gaussian = spread<T>(size, [size, sigma](int fetch) { return gaussianTap(fetch, size, sigma); });
        for (int i = 0; i < size; ++i)
        {
            // The offset, up to 32, is rounded three times, and a whole tap's weight may stand on the far side of it; the
            // pair itself adds three roundings.
            const Exact error = Exact(1.01) * (3 * 32 + 3) * kRoundoff<T>;
            tally.claim(std::abs(binomial[std::size_t(i)] - Exact(binomialWeight<T>(i, size))) <= error, i, size);
            tally.claim(std::abs(gaussian[std::size_t(i)] - Exact(gaussianWeight(i, size, sigma))) <= error, i, size);
        }
        tally.claim(binomialTap<T>(-1, size) == Vec2<T>(0), size);
        tally.claim(binomialTap<T>((size + 1) / 2, size) == Vec2<T>(0), size);
        tally.claim(gaussianTap((size + 1) / 2, size, sigma) == Vec2<T>(0), size);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("the head room is that of the largest sum, and the exponent that it allows stays finite")
{
    for (int size : {3, 5, 7, 9})
    {
        Exact sum = 0;
        for (Exact weight : pascalRow(size))
            sum += weight;
        CHECK(Exact(binomialHeadRoom<double>(size, 1)) == sum);
        CHECK(Exact(binomialHeadRoom<double>(size, 2)) == sum * sum);
    }
    CHECK(binomialHeadRoom<float>(65, 3) == kHuge<float>);
    CHECK(boxHeadRoom(5.0, 5.0) == 25);
    CHECK(boxHeadRoom(0.5, -3.0) == 1);
    CHECK(boxHeadRoom(FLT_MAX, FLT_MAX) == kHuge<float>);

    const float room = boxHeadRoom(4096.0f, 4096.0f);
    const float exponent = maxExponent(kLargestFp32<float>, room);
    CHECK(double(room) * std::exp(2.0 * double(exponent)) <= double(FLT_MAX));
    CHECK(double(room) * std::exp(2.0 * double(exponent) + 1e-4) > double(FLT_MAX));
}

TEST_CASE_TEMPLATE("bilinearVisibility meets its corners and reproduces a plane", T, float, double)
{
    const Vec4<T> corners(T(0.25), 1, 0, T(0.5));
    CHECK(bilinearVisibility(corners, Vec2<T>(0, 0)) == T(0.25));
    CHECK(bilinearVisibility(corners, Vec2<T>(1, 0)) == 1);
    CHECK(bilinearVisibility(corners, Vec2<T>(0, 1)) == 0);
    CHECK(bilinearVisibility(corners, Vec2<T>(1, 1)) == T(0.5));
    for (int y = 0; y <= 8; ++y)
    {
        for (int x = 0; x <= 8; ++x)
        {
            const Vec2<T> f(T(x) / 8, T(y) / 8);
            const Vec4<T> plane(T(0.125), T(0.375), T(0.625), T(0.875));
            CHECK(bilinearVisibility(plane, f) == T(0.125) + T(0.25) * f.x + T(0.5) * f.y);
        }
    }
    CHECK(bilinearVisibility(Vec4<T>(5, 5, -5, -5), Vec2<T>(T(0.5), T(0.25))) == T(0.75));
}

TEST_CASE_TEMPLATE("a kernel of less than one tap has one, and one of more than 65 has 65", T, float, double)
{
    for (const int less : {0, -1, -7})
    {
        CHECK(binomialWeight<T>(0, less) == 1);
        CHECK(gaussianWeight(0, less, T(2)) == 1);
        CHECK(binomialTap<T>(0, less) == Vec2<T>(0, 1));
        CHECK(gaussianTap(0, less, T(2)) == Vec2<T>(0, 1));
        CHECK(binomialHeadRoom<T>(less, 1) == 1);
    }
    for (const int more : {66, 1000})
    {
        for (int i = 0; i <= 66; ++i)
        {
            CHECK(binomialWeight<T>(i, more) == binomialWeight<T>(i, 65));
            CHECK(gaussianWeight(i, more, T(20)) == gaussianWeight(i, 65, T(20)));
            CHECK(binomialTap<T>(i, more) == binomialTap<T>(i, 65));
            CHECK(gaussianTap(i, more, T(20)) == gaussianTap(i, 65, T(20)));
        }
        CHECK(binomialHeadRoom<T>(more, 1) == T(0x1p64));
    }
    CHECK(binomialHeadRoom<T>(65, 1) == T(0x1p64));
    CHECK(binomialHeadRoom<T>(1, 1) == 1);
    for (const int none : {0, -1, 1})
        CHECK(binomialHeadRoom<T>(3, none) == 4);
    for (const int many : {3, 4, 100})
        CHECK(binomialHeadRoom<T>(3, many) == 64);
}

TEST_CASE_TEMPLATE("what exceeds its range is taken to its end in filters", T, float, double)
{
    const Range<T> unit{0, 1};
    checkEnds<T, 2>({Range<T>{0, T(0x1p125)}, Range<T>{0, T(0x1p125)}},
                    [](const auto& a) { return linearPair(a[0], a[1]); });
    checkEnds<T, 6>({unit, unit, unit, unit, unit, unit}, [](const auto& a)
                    { return bilinearVisibility(Vec4<T>(a[0], a[1], a[2], a[3]), Vec2<T>(a[4], a[5])); });
    // A box of 2^20 texels, and one of 2^-20, half of which is in the texel beside.
    CHECK(boxWeight(T(0), T(0x1p21)) == T(0x1p-20));
    CHECK(boxWeight(T(0), T(0x1p20)) == T(0x1p-20));
    for (const T width : {T(0), T(0x1p-21), T(0x1p-20)})
        CHECK(boxWeight(T(0.5) + T(0x1p-22), width) == T(0.25));
    const double most = gaussianWeight(0, 65, 0x1p20);
    CHECK(gaussianWeight(0, 65, 0x1p21) == most);
    CHECK(gaussianWeight(0, 65, 0x1p19) < most);
}

} // namespace
} // namespace lvsm::unit
