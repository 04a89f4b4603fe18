#include <lvsm/esm.hpp>
#include <lvsm/exponential.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cfloat>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

// Relative error of e^(c d) in T: the product's rounding, scaled by the exponent, and a unit for exp.
template <typename T>
Exact termError(T exponent)
{
    return Exact(1.01) * kRoundoff<T> * (Exact(exponent) + 2);
}

struct Window
{
    std::vector<double> depths;
    std::vector<double> weights;
};

Window randomWindow(Random& random)
{
    Window window;
    double sum = 0;
    for (int i = random.between(1, 25); i > 0; --i)
    {
        window.depths.push_back(random.unit<double>());
        window.weights.push_back(random.unit<double>() + 1e-3);
        sum += window.weights.back();
    }
    for (double& weight : window.weights)
        weight /= sum;
    return window;
}

template <typename T>
T filteredInLogSpace(const Window& window, T exponent)
{
    Vec2<T> sum(0);
    for (std::size_t i = 0; i < window.depths.size(); ++i)
        sum = logAdd(sum, T(window.depths[i]), T(window.weights[i]), exponent);
    return logFiltered(sum, exponent);
}

TEST_CASE_TEMPLATE("an occluder darkens exponentially with its distance", T, float, double)
{
    Tally tally;
    for (const T c : {T(1), T(11), T(40), T(80), T(87)})
    {
        for (int z = 0; z <= 16; ++z)
        {
            for (int d = z; d <= 16; ++d)
            {
                const Exact expected = std::exp(-Exact(c) * (d - z) / 16);
                const Exact shadow = exponentialShadow(occluderTerm(T(z) / 16, c), T(d) / 16, c);
                tally.claim(std::abs(shadow - expected) <= expected * (2 * termError(c) + kRoundoff<T>), c, z, d,
                            shadow);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("a planar occluder over the receiver's own plane bleeds only e^(-c distance)", T, float, double)
{
    const T c = 80;
    for (int share = 0; share <= 16; ++share)
    {
        const T lit = T(share) / 16;
        const T filtered = lit * occluderTerm(T(0.75), c) + (1 - lit) * occluderTerm(T(0.5), c);
        const Exact expected = Exact(lit) + (1 - Exact(lit)) * std::exp(Exact(-20));
        CHECK(std::abs(Exact(exponentialShadow(filtered, T(0.75), c)) - expected) <=
              2 * termError(c) + 4 * kRoundoff<T>);
    }
}

TEST_CASE_TEMPLATE("depths beyond the receiver light it wrongly, both tests find them, the 2x2 filter mends it", T,
                   float, double)
{
    // Figure 3(a) of the paper: half of the window in front of the receiver, half far behind it.
    const T c = 80;
    const T receiver = T(0.5);
    const Vec4<T> depths(T(0.25), T(0.875), T(0.25), T(0.875));
    Vec4<T> terms;
    for (int i = 0; i < 4; ++i)
        terms[i] = occluderTerm(depths[i], c);
    const T filtered = (terms.x + terms.y + terms.z + terms.w) / 4;
    CHECK(exponentialShadow(filtered, receiver, c) == 1);
    CHECK(violatesThreshold(filtered, receiver, c, T(0.02)));
    CHECK(violatesZMax(receiver, maxDepth(depths), T(0.001)));
    const Exact mended = exponentialShadow2x2(terms, Vec2<T>(T(0.5), T(0.5)), receiver, c);
    CHECK(std::abs(mended - (0.5 + 0.5 * std::exp(Exact(-20)))) <= 4 * kRoundoff<T>);
}

TEST_CASE_TEMPLATE("neither test flags a window that holds nothing beyond the receiver", T, float, double)
{
    Random random(7);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const Window window = randomWindow(random);
        const T receiver = T(*std::max_element(window.depths.begin(), window.depths.end()));
        Exact filtered = 0;
        Vec4<T> greatest(0);
        for (std::size_t k = 0; k < window.depths.size(); ++k)
        {
            filtered += Exact(window.weights[k]) * Exact(occluderTerm(T(window.depths[k]), T(80)));
            greatest = Vec4<T>(maxDepth(greatest), T(window.depths[k]), 0, 0);
        }
        tally.claim(!violatesThreshold(T(filtered), receiver, T(80), T(0.02)), receiver, filtered);
        tally.claim(!violatesZMax(receiver, maxDepth(greatest), T(0)), receiver);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("the threshold test misses what the Z-Max test finds")
{
    const double filtered = 0.9 * occluderTerm(0.25, 80.0) + 0.1 * occluderTerm(0.52, 80.0);
    CHECK_FALSE(violatesThreshold(filtered, 0.5, 80.0, 0.02));
    CHECK(violatesZMax(0.5, 0.52, 0.001));
    CHECK_FALSE(violatesZMax(0.5, 0.52, 0.03));
}

TEST_CASE_TEMPLATE("maxDepth is the greatest of four, wherever it stands", T, float, double)
{
    for (int place = 0; place < 4; ++place)
    {
        Vec4<T> depths(T(0.25), T(0.125), T(0.375), T(0.5));
        depths[place] = T(0.75);
        CHECK(maxDepth(depths) == T(0.75));
        depths[place] = T(7);
        CHECK(maxDepth(depths) == T(1));
    }
    CHECK(maxDepth(Vec4<T>(-4, -3, -2, -1)) == T(0));
}

TEST_CASE_TEMPLATE("what exceeds its range is taken to its end in exponential shadow maps", T, float, double)
{
    CHECK(occluderTerm(T(1), T(-3)) == T(1));
    CHECK(occluderTerm(T(0.5), T(0.5)) == doctest::Approx(std::exp(0.25)).epsilon(1e-6));
    CHECK(exponentialShadow(T(0.5), T(1), T(-3)) == T(0.5));
    CHECK(exponentialShadow(T(0.5), T(-1), T(10)) == T(0.5));
    CHECK(exponentialShadow(T(100), T(3), T(10)) == exponentialShadow(T(100), T(1), T(10)));
    CHECK(exponentialShadow(T(0.5), T(1), T(0.5)) == doctest::Approx(0.5 * std::exp(-0.5)).epsilon(1e-6));

    CHECK(violatesZMax(T(-3), T(0.5), T(0)));
    CHECK_FALSE(violatesZMax(T(-3), T(0.5), T(0.5)));
    CHECK(violatesZMax(T(0.5), T(0.6), T(-3)));
    CHECK_FALSE(violatesZMax(T(0.5), T(0.5), T(-3)));
    CHECK_FALSE(violatesZMax(T(3), T(7), T(0)));
    CHECK_FALSE(violatesZMax(T(0.25), T(7), T(0.75)));
    CHECK_FALSE(violatesZMax(T(0), T(-1), T(0)));
    CHECK(violatesZMax(T(0), T(0.9), T(0.75)));

    CHECK(logShadow(T(0.5), T(1), T(-3)) == logShadow(T(0.5), T(1), T(1)));
    CHECK(logShadow(T(0.5), T(1), T(1)) == doctest::Approx(std::exp(-0.5)).epsilon(1e-6));
    CHECK(logShadow(T(-3), T(0.5), T(1)) == logShadow(T(0), T(0.5), T(1)));
    CHECK(logShadow(T(0.5), T(3), T(1)) == logShadow(T(0.5), T(1), T(1)));
    const Vec2<T> sum(T(0.5), T(0.75));
    CHECK(logFiltered(sum, T(-3)) == logFiltered(sum, T(1)));
    CHECK(logFiltered(sum, T(1)) == doctest::Approx(0.5 + std::log(0.75)).epsilon(1e-6));
    CHECK(logFiltered(Vec2<T>(T(3), T(0.5)), T(2)) == logFiltered(Vec2<T>(T(1), T(0.5)), T(2)));
    CHECK(logFiltered(Vec2<T>(T(-3), T(2)), T(2)) == logFiltered(Vec2<T>(T(0), T(2)), T(2)));
    CHECK(logFiltered(Vec2<T>(T(1), T(0)), T(1)) == T(0));

    // The filter in log space: exponents, and sums and weights of up to 2^125.
    for (const T less : {T(-3), T(0.75)})
        CHECK(logAdd(sum, T(0.25), T(0.5), less) == logAdd(sum, T(0.25), T(0.5), T(1)));
    CHECK(logAdd(Vec2<T>(T(0.5), T(0x1p126)), T(0.5), T(0), T(2)) == Vec2<T>(T(0.5), T(0x1p125)));
    CHECK(logAdd(Vec2<T>(0), T(0.5), T(0x1p126), T(2)) == Vec2<T>(T(0.5), T(0x1p125)));
    const T most = std::numeric_limits<T>::max();
    CHECK(logFiltered(Vec2<T>(0, 2), most) == logFiltered(Vec2<T>(0, 2), T(0x1p126)));
    CHECK(logShadow(T(0), T(0x1p-124), most) == logShadow(T(0), T(0x1p-124), T(0x1p126)));
    CHECK(logShadow(T(0), T(0x1p-124), most) == doctest::Approx(std::exp(-4.0)).epsilon(1e-6));

    CHECK(maxTermExponent(T(100), T(0.25)) == maxTermExponent(T(100), T(1)));
    CHECK(maxTermExponent(T(0), T(1)) == T(0));
    CHECK(maxTermExponent(T(1), T(1)) == T(0));
    CHECK(maxTermExponent(T(1), T(4)) == T(0));
}

TEST_CASE_TEMPLATE("the threshold is an excess over 1, and a negative one counts as 0", T, float, double)
{
    // At depth 0 the shadow is the occluder's term itself.
    for (const T threshold : {T(-1), T(-0.02), T(0)})
    {
        CHECK_FALSE(violatesThreshold(T(0.99), T(0), T(80), threshold));
        CHECK_FALSE(violatesThreshold(T(1), T(0), T(80), threshold));
        CHECK(violatesThreshold(T(1.001), T(0), T(80), threshold));
    }
    CHECK_FALSE(violatesThreshold(T(1.25), T(0), T(80), T(0.25)));
    CHECK(violatesThreshold(T(1.26), T(0), T(80), T(0.25)));
}

TEST_CASE("maxTermExponent is the largest that a format bears")
{
    CHECK(maxTermExponent(65504.0, 1.0) == doctest::Approx(std::log(65504.0)).epsilon(1e-12));
    CHECK(maxTermExponent(65504.0, 1.0) == doctest::Approx(11.09).epsilon(1e-4));
    for (double headRoom : {1.0, 9.0, 25.0, 81.0, 256.0})
    {
        const double c = maxTermExponent(65504.0, headRoom);
        CHECK(headRoom * std::exp(c) <= 65504.0 * (1 + 1e-12));
        CHECK(headRoom * std::exp(c + 1e-6) > 65504.0);
    }
    CHECK(maxTermExponent(65504.0, 1e9) == 0);
    CHECK(maxTermExponent(double(FLT_MAX), 6141.0) >= 80);
    CHECK(maxTermExponent(double(FLT_MAX), 6142.0) < 80);
}

TEST_CASE("the largest exponent's terms are finite in fp16, head room and its roundings included")
{
    for (int samples = 1; samples <= 1024; ++samples)
    {
        // One rounding to fp16 in the store and one in the sum: each relative 2^-11.
        const double headRoom = samples == 1 ? 1.0 : samples * (1 + 2 * 0x1p-11);
        const double c = maxTermExponent(kLargestFp16<double>, headRoom);
        CAPTURE(samples);
        CHECK(isFinite(toFp16(samples * toFp16(occluderTerm(1.0, c)))));
        CHECK(!isFinite(toFp16(samples * toFp16(occluderTerm(1.0, c + 0.004)))));
    }
    // Without its roundings in the head room a sum can overflow.
    bool overflows = false;
    for (int samples = 2; samples <= 1024; ++samples)
    {
        const double c = maxTermExponent(kLargestFp16<double>, double(samples));
        overflows |= !isFinite(toFp16(samples * toFp16(occluderTerm(1.0, c))));
    }
    CHECK(overflows);
}

TEST_CASE("at the largest exponent both factors are normal floats")
{
    const float c = maxTermExponent(kLargestFp32<float>, 1.0f);
    CHECK(c == kMaxTermExponent<float>);
    CHECK(std::isnormal(std::exp(-c)));
    CHECK(std::exp(-double(c)) >= double(FLT_MIN));
    CHECK(exponentialShadow(occluderTerm(1.0f, c), 1.0f, c) == doctest::Approx(1.0).epsilon(1e-5));
    // It is the largest, but for the error that exp may have.
    CHECK(std::exp(-double(c) - 1e-4) < double(FLT_MIN));
    // And larger ones count as it.
    CHECK(occluderTerm(1.0f, 200.0f) == occluderTerm(1.0f, c));
    CHECK(exponentialShadow(1.0e30f, 1.0f, 200.0f) == exponentialShadow(1.0e30f, 1.0f, c));
}

TEST_CASE_TEMPLATE("the log-space filter agrees with the linear one where that is possible", T, float, double)
{
    Random random(8);
    Tally tally;
    for (int i = 0; i < drawsOf(5000); ++i)
    {
        const Window window = randomWindow(random);
        const T c = T(1 + 80 * random.unit<double>());
        Exact filtered = 0;
        for (std::size_t k = 0; k < window.depths.size(); ++k)
            filtered += Exact(T(window.weights[k])) * std::exp(Exact(c) * Exact(T(window.depths[k])));
        const Exact expected = std::log(filtered) / Exact(c);
        const Exact depth = filteredInLogSpace(window, c);
        // An error of c roundings in each exponent, two more for each of 25 samples and their rescaling, and a few for exp
        // and log, all of which c divides; then the last sum.
        const Exact error = Exact(1.01) * kRoundoff<T> * ((2 * 25 * (Exact(c) + 4)) / Exact(c) + 4);
        tally.claim(std::abs(depth - expected) <= error, c, depth, expected);
        const T receiver = random.unit<T>();
        const Exact shadow = logShadow(T(depth), receiver, c);
        const Exact direct = std::min(Exact(1), filtered * std::exp(-Exact(c) * Exact(receiver)));
        tally.claim(std::abs(shadow - direct) <= Exact(c) * (error + kRoundoff<T>)+4 * kRoundoff<T>, c, shadow, direct);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("the log-space filter is stable for any c", T, float, double)
{
    Random random(9);
    Tally tally;
    for (int i = 0; i < drawsOf(5000); ++i)
    {
        const Window window = randomWindow(random);
        const auto [least, greatest] = std::minmax_element(window.depths.begin(), window.depths.end());
        T last = 0;
        for (const T c : {T(1), T(80), T(1e4), T(1e9), T(1e30), std::numeric_limits<T>::max()})
        {
            const T depth = filteredInLogSpace(window, c);
            const T slack = T(200 * kRoundoff<T>);
            tally.claim(depth >= T(*least) - slack && depth <= T(*greatest) + slack, c, depth);
            tally.claim(depth >= last - slack, c, depth, last);
            tally.claim(logShadow(depth, depth, c) == 1, c, depth);
            last = depth;
        }
        // What the greatest depth's weight costs vanishes with c.
        tally.claim(last == T(*greatest), last, *greatest);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("a separable log-space filter is the two-dimensional one")
{
    Random random(10);
    for (double c : {2.0, 80.0, 500.0})
    {
        double depths[5][5];
        for (auto& row : depths)
            for (double& depth : row)
                depth = random.unit<double>();
        Vec2<double> columns(0);
        Vec2<double> whole(0);
        for (int y = 0; y < 5; ++y)
        {
            Vec2<double> row(0);
            for (int x = 0; x < 5; ++x)
            {
                row = logAdd(row, depths[y][x], binomialWeight<double>(x, 5), c);
                whole = logAdd(whole, depths[y][x], binomialWeight<double>(x, 5) * binomialWeight<double>(y, 5), c);
            }
            columns = logAdd(columns, logFiltered(row, c), binomialWeight<double>(y, 5), c);
        }
        CHECK(logFiltered(columns, c) == doctest::Approx(logFiltered(whole, c)).epsilon(1e-12));
    }
}

TEST_CASE_TEMPLATE("exponential shadow maps stay in range for any arguments", T, float, double)
{
    Tally tally;
    const std::vector<T> values = specialValues<T>();
    Random random(11);
    const auto any = [&]
    {
        return values[std::size_t(random.between(0, int(values.size()) - 1))];
    };
    const auto visible = [&](T visibility)
    {
        tally.claim(visibility >= 0 && visibility <= 1, visibility);
    };
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        visible(exponentialShadow(any(), any(), any()));
        visible(exponentialShadow2x2(Vec4<T>(any(), any(), any(), any()), Vec2<T>(any(), any()), any(), any()));
        visible(logShadow(any(), any(), any()));
        visible(logFiltered(Vec2<T>(any(), any()), any()));
        visible(maxDepth(Vec4<T>(any(), any(), any(), any())));
        const T term = occluderTerm(any(), any());
        tally.claim(term >= 1 && term <= kHuge<T>, term);
        const T exponent = maxTermExponent(any(), any());
        tally.claim(exponent >= 0 && exponent <= kMaxTermExponent<T>, exponent);
        const Vec2<T> sum = logAdd(Vec2<T>(any(), any()), any(), any(), any());
        tally.claim(sum.x >= 0 && sum.x <= 1 && sum.y >= 0 && sum.y <= kHuge<T>, sum.x, sum.y);
    }
    LVSM_CHECK_TALLY(tally);
}

} // namespace
} // namespace lvsm::unit
