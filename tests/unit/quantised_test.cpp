#include <lvsm/quantised.hpp>

#include <doctest/doctest.h>

#include "distributions.hpp"
#include "ranges.hpp"

namespace lvsm::unit
{
namespace
{

Vec4<double> momentsOf(const DepthWindow& window)
{
    return window.mean([](double depth) { return depthMoments4(depth); });
}

Vec4<double> packed(const Vec4<double>& quantised)
{
    return unpackQuantised4<double>(packQuantised4(quantised));
}

} // namespace

TEST_CASE("the code has the first three moments, and the excess is what the fourth has more")
{
    Random random(161);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const double bias = 1e-3;
        const Vec4<double> b = (1 - bias) * momentsOf(DepthWindow(random)) + bias * Vec4<double>(0, 0.63, 0, 0.63);
        const Vec4<double> code = quantiseMoments4(b, 0.0);
        const double lower = 2 * code.x - 1, upper = 2 * code.y - 1;
        tally.claim(lower < upper && code.z > 0 && code.z < 1, lower, upper, code.z);
        double lowerPower = 1, upperPower = 1, difference = 0;
        for (int k = 0; k < 4; ++k)
        {
            lowerPower *= lower;
            upperPower *= upper;
            difference = b[k] - ((1 - code.z) * lowerPower + code.z * upperPower);
            if (k < 3)
                tally.claim(std::abs(difference) < 1e-9, k, b[k], difference);
        }
        // ln ln(excess / 1e-7) is linear in the code from 1.2e-7 to 1/4; its constants have nine digits.
        const double first = std::log(std::log(1.2)), last = std::log(std::log(2.5e6));
        const double excess = 1e-7 * std::exp(std::exp(first + code.w * (last - first)));
        tally.claim(std::abs(excess - difference) < 1e-6 * difference + 1e-9, excess, difference);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("without rounding quantised moments are worth as much as the moments")
{
    Random random(162);
    Tally tally;
    for (int i = 0; i < drawsOf(300000); ++i)
    {
        const DepthWindow window(random);
        const double t = window.receiver(random);
        const double bias = 1e-5;
        const Vec4<double> moments = momentsOf(window);
        const double wanted = momentVisibility4(moments, t, bias);
        const double bound = quantisedVisibility4(quantiseMoments4(moments, bias), t, 0.0);
        // Nine digits of the excess's constants, and what the norms of the bias make of double's rounding.
        tally.claim(std::abs(bound - wanted) < 1e-5, t, bound, wanted);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("every pair of depths comes back from 32 bits within half a step, in order")
{
    Tally tally;
    for (int a = 0; a < 1024; ++a)
    {
        for (int b = a; b < 1024; ++b)
        {
            const Vec4<double> code(a / 1023.0, b / 1023.0, (a % 128) / 127.0, (b % 64) / 63.0);
            const Vec2<int> words = packQuantised4(code);
            tally.claim(words.x >= 0 && words.x < 65536 && words.y >= 0 && words.y < 65536, a, b);
            const Vec4<double> back = unpackQuantised4<double>(words);
            // Equal depths move apart by a step.
            const double room = a == b ? 1.0 / 1023 : 0.0;
            tally.claim(std::abs(back.x - code.x) <= room + 1e-9 && std::abs(back.y - code.y) <= room + 1e-9, a, b,
                        back.x, back.y);
            tally.claim(back.x < back.y, a, b, back.x, back.y);
            tally.claim(std::abs(std::sqrt(back.z) - std::sqrt(code.z)) <= 0.5 / 127 + 1e-9, a, b, back.z);
            tally.claim(std::abs(back.w - code.w) <= 1e-8, a, b, back.w);
            tally.claim(packQuantised4(back) == words, a, b);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("what exceeds its range is taken to its end in quantised moments", T, float, double)
{
    const Range<T> unit{0, 1};
    checkEnds<T, 6>({unit, unit, unit, unit, unit, unit},
                    [](const auto& a) { return quantisedVisibility4(Vec4<T>(a[0], a[1], a[2], a[3]), a[4], a[5]); });
    CHECK(packQuantised4(Vec4<T>(T(0.7), T(0.2), T(0.5), T(0.5))) ==
          packQuantised4(Vec4<T>(T(0.2), T(0.7), T(0.5), T(0.5))));
}

TEST_CASE("the excess of a map that is empty is the least that is coded")
{
    // What the bias brings, 0.2331 times it, is less than 1.2e-7.
    CHECK(quantiseMoments4(depthMoments4(1.0), 3.0e-7).w < 1e-4);
}

TEST_CASE("the depth errors are half a step of a depth, and half one of a small weight over all depths")
{
    CHECK(kDepthErrorQuantised64<double> / (0.5 / 65535 + 0.5 / 65535) == doctest::Approx(1));
    // The weight is coded as its square root.
    CHECK(kDepthErrorQuantised32<double> / (0.5 / 1023 + std::pow(0.5 / 127, 2)) == doctest::Approx(1));
}

TEST_CASE("any words unpack to a code")
{
    Random random(163);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec2<int> words(random.between(-2000000000, 2000000000), random.between(-2000000000, 2000000000));
        const Vec4<float> code = unpackQuantised4<float>(words);
        for (int k = 0; k < 4; ++k)
            tally.claim(code[k] >= 0 && code[k] <= 1, words.x, words.y, k, code[k]);
        tally.claim(code.x <= code.y, words.x, words.y);
        const Vec2<int> low(words.x & 65535, words.y & 65535);
        tally.claim(unpackQuantised4<float>(low) == code, words.x, words.y);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("flat lit surfaces stay lit in 64 and in 32 bits")
{
    Tally tally;
    for (int i = 0; i <= 262144; ++i)
    {
        const float depth = static_cast<float>(i) / 262144.0f;
        const Vec4<float> code = quantiseMoments4(depthMoments4(depth), kMoment4BiasFp32<float>);
        const Vec4<float> wide(unorm16(Vec4<double>(code)));
        tally.claim(quantisedVisibility4(wide, depth, kDepthErrorQuantised64<float>) >= 0.999f, depth, 64);
        const Vec4<float> narrow(unpackQuantised4<float>(packQuantised4(code)));
        tally.claim(quantisedVisibility4(narrow, depth, kDepthErrorQuantised32<float>) >= 0.999f, depth, 32);
    }
    LVSM_CHECK_TALLY(tally);
}

// HPG 2017 says that coding after the filter beats rounding before it at the same size, and at half of it.
TEST_CASE("64 bits after the filter err less than before it, and 32 bits less than 8 bits a moment")
{
    Random random(164);
    double before = 0, after = 0, half = 0, bytes = 0;
    for (int i = 0; i < drawsOf(300000); ++i)
    {
        DepthWindow window(random);
        for (double& depth : window.depths)
            depth = 0.3 + 0.4 * depth;
        const double t = 0.3 + 0.4 * window.receiver(random);
        const double truth = window.tail(t);
        const auto squared = [&](double visibility)
        {
            return (visibility - truth) * (visibility - truth);
        };
        const Vec4<double> moments = momentsOf(window);
        const Vec4<double> encoded = encodeMoments4(moments);
        const Vec4<double> code = quantiseMoments4(moments, kMoment4BiasFp32<double>);
        before += squared(momentVisibility4(decodeMoments4(unorm16(encoded)), t, kMoment4BiasUnorm16<double>));
        after += squared(quantisedVisibility4(unorm16(code), t, kDepthErrorQuantised64<double>));
        half += squared(quantisedVisibility4(packed(code), t, kDepthErrorQuantised32<double>));
        Vec4<double> eight;
        for (int k = 0; k < 4; ++k)
            eight[k] = std::round(encoded[k] * 255) / 255;
        bytes += squared(momentVisibility4(decodeMoments4(eight), t, 257 * kMoment4BiasUnorm16<double>));
    }
    CHECK(after < before);
    CHECK(half < bytes);
}

} // namespace lvsm::unit
