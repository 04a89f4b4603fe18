// Mixtures of planes: what the codes hold, and what a receiver sees of windows whose answer is known.
#include <lvsm/mixture.hpp>

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cstdint>
#include <vector>

#include "numbers.hpp"
#include "ranges.hpp"
#include "windows.hpp"

namespace lvsm::unit
{
namespace
{

using Code2 = glm::vec<2, std::uint32_t>;
using Code4 = glm::vec<4, std::uint32_t>;

constexpr double kDepthStep = 1.0 / 1024.0;

template <typename T>
MixtureComponent<T> flatComponent(T weight, T depth)
{
    MixtureComponent<T> c = tapComponent(depth);
    c.weight = weight;
    return c;
}

// Uncoded: the mean of planeLight over the components.
double uncodedVisibility(const Mixture<double>& mixture, const Vec2<double>& f, double depth,
                         const Vec2<double>& gradient, double deviation, double bias)
{
    double lit = 0.0;
    double sum = 0.0;
    for (const MixtureComponent<double>& c : mixture.components)
    {
        const MixturePlane<double> plane = componentPlane(c);
        const double weight = planeWeight(plane, f, deviation);
        lit += weight * planeLight(plane, f, depth, gradient, deviation, bias).x;
        sum += weight;
    }
    return lit / sum;
}

// A field of a word, and a word as a code reads a field that begins below bit end: signed, in levels of so many bits.
std::uint32_t field(std::uint32_t word, int at, int bits)
{
    return word >> at & ((1u << bits) - 1u);
}

double signedLevel(std::uint32_t word, int end)
{
    return static_cast<double>(static_cast<std::int32_t>(word << (32 - end))) / 134217728.0;
}

TEST_CASE("encodeMixture2 lays its fields out as its comment says, heaviest first")
{
    Mixture<double> m{};
    m.components[0] = flatComponent(0.25, 0.75);
    m.components[0].place = {2.0, -0.9};
    m.components[0].variance = 0.01;
    m.components[1] = flatComponent(0.75, 0.25);
    m.components[1].place = {0.5, 0.0};
    const Code2 code = encodeMixture2(m, 1.0);
    // 0.25 is 7.5 of 15 levels up to 1/2, rounded up. The place, 1.5 and -0.9 from the heavier one's, is 5 and -3 steps of
    // 0.3: -3 + 7.5 is rounded up to 5, and 5 + 7.97 less the 5/16 below it to 13.
    CHECK(field(code.y, 8, 4) == 8u);
    CHECK(field(code.y, 0, 4) == 5u);
    CHECK(field(code.y, 4, 4) == 13u);
    // The deviation 0.1 is 204.8 of the least one: 128 (1 + 5/8) is nearest.
    CHECK(field(code.x, 0, 6) == 7u * 8u + 5u);
    CHECK(field(code.x, 6, 6) == 0u);
    for (const std::uint32_t word : {code.x, code.y})
    {
        CHECK(std::abs(signedLevel(word, 17)) <= 0.5);
        CHECK(std::abs(signedLevel(word, 22)) <= 0.5);
    }
    CHECK(std::abs(static_cast<double>(code.x) / 4194304.0 - 256.0) <= 0.5);
    CHECK(std::abs(static_cast<double>(code.y) / 4194304.0 - 768.0) <= 0.5);
    const MixturePlanes<double> planes = decodeMixture2(code, 1.0);
    CHECK(planes.planes[0].deviation == kLeastDeviation<double>);
    CHECK(planes.planes[1].deviation == 208.0 * kLeastDeviation<double>);
}

TEST_CASE("encodeMixture4 lays its fields out as its comment says, heaviest first")
{
    Mixture<double> m{};
    const double weights[] = {0.1, 0.2, 0.3, 0.4};
    const double deviations[] = {kLeastDeviation<double>, 0.0, 0.03, 0.9};
    for (int i = 0; i < 4; ++i)
    {
        m.components[i] = flatComponent(weights[i], 0.1 + 0.2 * i);
        m.components[i].place = {0.0, i == 2 ? -2.25 : 0.0};
        m.components[i].variance = deviations[i] * deviations[i];
    }
    const Code4 code = encodeMixture4(m, 1.0);
    const double depths[] = {0.7, 0.5, 0.3, 0.1};
    for (int i = 0; i < 4; ++i)
        CHECK(std::abs(static_cast<double>(code[i]) / 4194304.0 - 1024.0 * depths[i]) <= 0.5);
    // Of the least deviation the heaviest has more than 128 times, the next 61.4 times, which 64 is nearest.
    CHECK(field(code.x, 9, 3) == 7u);
    CHECK(field(code.x, 6, 3) == 6u);
    CHECK(field(code.x, 3, 3) == 0u);
    CHECK(field(code.x, 0, 3) == 0u);
    const double coded[] = {128.0, 64.0, 1.0, 1.0};
    for (int i = 0; i < 4; ++i)
        CHECK(decodeMixture4(code, 1.0).planes[i].deviation == coded[i] * kLeastDeviation<double>);
    // 0.3 of 1/2, 0.2 of 1/3 and 0.1 of 1/4: 9, 9 and 6 of 15.
    CHECK(field(code.y, 8, 4) == 9u);
    CHECK(field(code.z, 8, 4) == 9u);
    CHECK(field(code.w, 8, 4) == 6u);
    CHECK(field(code.y, 0, 4) == 0u);
    CHECK(field(code.z, 0, 4) == 8u);
}

// A component with a slope, of all of the window, beside a light one.
Mixture<double> slopedMixture(const Vec2<double>& g, double residual)
{
    Mixture<double> m{};
    m.components[0] = flatComponent(1.0, 0.5);
    MixtureComponent<double>& c = m.components[0];
    c.spread = {1.0, 0.0, 1.0};
    const double ridge = 1.0 / 4096.0;
    c.tilt = {g.x * (1.0 + ridge), g.y * (1.0 + ridge)};
    c.variance = residual * residual - g.x * g.x - g.y * g.y + 2.0 * (g.x * c.tilt.x + g.y * c.tilt.y);
    return m;
}

TEST_CASE("a coded slope is the nearest by its signed root, and within the rounding that a receiver is allowed")
{
    Random random(910);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const auto any = [&]
        {
            return (random.between(0, 1) == 0 ? 1.0 : -1.0) * std::pow(10.0, -1.1 - 4.0 * random.unit<double>());
        };
        const Vec2<double> g(any(), any());
        const double sigma = 0.5 + 4.0 * random.unit<double>();
        const Mixture<double> m = slopedMixture({g.x / sigma, g.y / sigma}, 0.0);
        const auto check = [&](const MixturePlane<double>& p)
        {
            double squares = 0.0;
            double allowed = 4.0 / 32 / 32 / 32 / 32;
            for (int k = 0; k < 2; ++k)
            {
                const double root = std::sqrt(std::abs(g[k]) / kMostCodedRise<double>);
                const double slope = p.slope[k] * sigma;
                const double coded =
                    std::sqrt(std::abs(slope) / kMostCodedRise<double>) * (slope * g[k] < 0.0 ? -1 : 1);
                // The highest level ends a level below 1, the lowest at -1.
                const bool isTop = std::abs(root) > 30.5 / 32;
                tally.claim(std::abs(coded - root) <= (isTop ? 1.0 / 16 : 0.5 / 16) + 1e-9, g[k], slope, sigma);
                squares += (slope - g[k]) * (slope - g[k]) / kMostCodedRise<double> / kMostCodedRise<double>;
                allowed += 8.0 / 32 / 32 * root * root;
                if (isTop)
                    squares = 0.0;
            }
            tally.claim(squares <= allowed + 1e-12, squares, allowed);
        };
        check(decodeMixture2(encodeMixture2(m, sigma), sigma).planes[0]);
        check(decodeMixture4(encodeMixture4(m, sigma), sigma).planes[0]);
    }
    LVSM_CHECK_TALLY(tally);
    // Steeper ones count as the steepest.
    const MixturePlane<double> steep =
        decodeMixture2(encodeMixture2(slopedMixture({1.0, -1.0}, 0.0), 1.0), 1.0).planes[0];
    CHECK(steep.slope.x > kMostCodedRise<double> * 0.85);
    CHECK(steep.slope.x <= kMostCodedRise<double>);
    CHECK(steep.slope.y < kMostCodedRise<double> * -0.85);
    CHECK(steep.slope.y >= -kMostCodedRise<double>);
}

TEST_CASE("a coded deviation is the nearest of its octave's parts, and at least half a step of depth")
{
    const auto coded2 = [](double d)
    {
        return decodeMixture2(encodeMixture2(slopedMixture({0, 0}, d), 1.0), 1.0).planes[0].deviation;
    };
    const auto coded4 = [](double d)
    {
        return decodeMixture4(encodeMixture4(slopedMixture({0, 0}, d), 1.0), 1.0).planes[0].deviation;
    };
    const double least = kLeastDeviation<double>;
    CHECK(least == 0.5 / 1024);
    for (int octave = 0; octave < 8; ++octave)
    {
        const double start = least * (1 << octave);
        for (int part = 0; part < 8; ++part)
        {
            const double d = start * (1.0 + part / 8.0);
            CHECK(coded2(d) == doctest::Approx(d).scale(0));
            CHECK(coded2(d + start * 0.06) == doctest::Approx(d).scale(0));
        }
        CHECK(coded4(start) == doctest::Approx(start).scale(0));
        CHECK(coded4(1.49 * start) == doctest::Approx(start).scale(0));
        CHECK(coded4(0.76 * start) == doctest::Approx(start).scale(0));
    }
    CHECK(coded2(0.0) == least);
    CHECK(coded4(0.0) == least);
    CHECK(coded2(0.9) == doctest::Approx(least * 240));
    CHECK(coded4(0.9) == doctest::Approx(least * 128));
}

// Two components of a window of deviation 1: the lighter one as given, the heavier one what is left.
Mixture<double> splitWindow(double weight, const Vec2<double>& place)
{
    Mixture<double> m{};
    m.components[0] = flatComponent(1.0 - weight, 0.8);
    m.components[1] = flatComponent(weight, 0.3);
    m.components[1].place = place;
    m.components[0].place = -place * (weight / (1.0 - weight));
    return m;
}

TEST_CASE("the heaviest plane takes what the others leave of share and place")
{
    // From the heavier one's place: 4.47 and -2.5 steps of 0.3, so that the first needs the fraction that the other is.
    const Vec2<double> from(0.3 * (12 + 5.0 / 16 - 7.96875), 0.3 * (5 - 7.5));
    const Mixture<double> m = splitWindow(1.0 / 3.0, from * (2.0 / 3.0));
    for (const MixturePlanes<double>& p :
         {decodeMixture2(encodeMixture2(m, 1.0), 1.0), decodeMixture4(encodeMixture4(m, 1.0), 1.0)})
    {
        CHECK(p.planes[1].weight == doctest::Approx(1.0 / 3.0));
        CHECK(p.planes[1].place.x == doctest::Approx(from.x * 2.0 / 3.0));
        CHECK(p.planes[1].place.y == doctest::Approx(from.y * 2.0 / 3.0));
        CHECK(p.planes[0].weight == doctest::Approx(2.0 / 3.0));
        CHECK(p.planes[0].place.x == doctest::Approx(from.x / -3.0));
        CHECK(p.planes[0].place.y == doctest::Approx(from.y / -3.0));
        CHECK(p.planes[2].weight == 0.0);
        CHECK(p.planes[3].weight == 0.0);
    }
    // Everything in one: the whole window, at its centre.
    Mixture<double> one{};
    one.components[2] = flatComponent(0.7, 0.4);
    const MixturePlanes<double> whole = decodeMixture4(encodeMixture4(one, 2.0), 2.0);
    CHECK(whole.planes[0].weight == 1.0);
    CHECK(whole.planes[0].place == Vec2<double>(0.0));
    for (int i = 1; i < 4; ++i)
        CHECK(whole.planes[i].weight == 0.0);
    // More than a window has leaves nothing.
    CHECK(decodeMixture4(Code4(0u, ~0u, ~0u, ~0u), 1.0).planes[0].weight == 0.0);
    // Places end at 16 levels either way, and the share beside them is what it is: 7.5 of 15 levels to 1/2, rounded up.
    for (const double end : {9.0, -9.0})
    {
        const MixturePlanes<double> far = decodeMixture2(encodeMixture2(splitWindow(0.25, {end, -end}), 1.0), 1.0);
        const Vec2<double> apart = far.planes[1].place - far.planes[0].place;
        // Along x the field below adds its fraction.
        CHECK(apart.x == doctest::Approx(end > 0.0 ? 0.3 * (15 - 7.96875) : 0.3 * (15.0 / 16 - 7.96875)));
        CHECK(apart.y == doctest::Approx(end > 0.0 ? 0.3 * -7.5 : 0.3 * 7.5));
        CHECK(far.planes[1].weight == doctest::Approx(8.0 / 30));
    }
    // What is there at all has a level of share.
    CHECK(decodeMixture2(encodeMixture2(splitWindow(1.0e-4, {0.0, 0.0}), 1.0), 1.0).planes[1].weight ==
          doctest::Approx(1.0 / 30));
}

TEST_CASE("mixtureVisibility is the mean of planeLight by planeWeight, but for what a slope's rounding may be off")
{
    Random random(917);
    Tally tally;
    for (int i = 0; i < drawsOf(5000); ++i)
    {
        const auto unit = [&]
        {
            return 2.0 * random.unit<double>() - 1.0;
        };
        const auto bits = [&]
        {
            return static_cast<std::uint32_t>(random.between(0, 65535) << 16 | random.between(0, 65535));
        };
        const double sigma = 0.5 + 4.0 * random.unit<double>();
        const Code4 code(bits(), bits() & 0xFFFFF7FFu, bits() & 0xFFFFF7FFu, bits() & 0xFFFFF7FFu);
        const Vec2<double> f(0.5 * unit(), 0.5 * unit());
        const Vec2<double> g(0.08 / sigma * unit(), 0.08 / sigma * unit());
        const double depth = random.unit<double>();
        const double bias = 0.01 * random.unit<double>();
        const auto check = [&](const MixturePlanes<double>& m, double visibility, double occluder)
        {
            // Each plane's difference of slopes lies between what it is and that less the rounding, as the variance does.
            double lit[2] = {0.0, 0.0};
            double dark[2] = {0.0, 0.0};
            bool isPlain = true;
            for (const MixturePlane<double>& p : m.planes)
            {
                if (p.weight == 0.0)
                    continue;
                const double weight = planeWeight(p, f, sigma);
                const Vec2<double> light = planeLight(p, f, depth, g, sigma, bias);
                const Vec2<double> d = (p.slope - g) * (sigma / kMostCodedRise<double>);
                const Vec2<double> u = glm::abs(g) * (sigma / kMostCodedRise<double>);
                const double rounding = 8.0 / 32 / 32 * (u.x + u.y) + 4.0 / 32 / 32 / 32 / 32;
                const double squares = d.x * d.x + d.y * d.y;
                const double scale = 0.5 * kMostCodedRise<double> * kMostCodedRise<double>;
                const double variance = scale * std::max(0.0, squares - rounding) + p.deviation * p.deviation;
                const double share = 0.5 + (light.y + 0.6 * p.deviation + bias) / std::sqrt(12.0 * variance);
                lit[0] += weight * std::min(1.0, std::max(0.0, share));
                lit[1] += weight * light.x;
                const double unlit = std::max(0.0, weight) * (1.0 - std::min(1.0, std::max(0.0, share)));
                dark[0] += unlit;
                dark[1] += unlit * std::max(0.0, -light.y);
                isPlain = isPlain && p.depth > 0.0 && p.depth < 1.0;
            }
            if (!isPlain)
                return;
            const double expected = std::min(1.0, std::max(0.0, lit[0]));
            tally.claim(std::abs(visibility - expected) < 1e-9, visibility, expected, lit[1]);
            const double away = dark[0] > 0.0 ? dark[1] / dark[0] : 0.0;
            tally.claim(std::abs(occluder - std::min(1.0, std::max(0.0, depth - away))) < 1e-9, occluder, away);
        };
        check(decodeMixture4(code, sigma), mixtureVisibility4(code, f, depth, g, sigma, bias),
              mixtureOccluder4(code, f, depth, g, sigma, bias));
        const Code2 two(code.x, code.y);
        check(decodeMixture2(two, sigma), mixtureVisibility2(two, f, depth, g, sigma, bias),
              mixtureOccluder2(two, f, depth, g, sigma, bias));
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("planeWeight tilts a window towards the receiver")
{
    MixturePlane<double> p = componentPlane(flatComponent(0.25, 0.5));
    p.place = {1.0, -2.0};
    CHECK(planeWeight(p, Vec2<double>(0.0, 0.0), 2.0) == 0.25);
    CHECK(planeWeight(p, Vec2<double>(0.5, 0.25), 2.0) == 0.25);
    CHECK(planeWeight(p, Vec2<double>(0.5, -0.25), 2.0) == doctest::Approx(0.25 * (1.0 + 1.0 / 4.0)));
    CHECK(planeWeight(p, Vec2<double>(30.0, 0.0), 0.1) == doctest::Approx(0.25 * (1.0 + 16.0 * 16.0)));
    CHECK(planeWeight(p, Vec2<double>(-30.0, 0.0), 0.1) == doctest::Approx(0.25 * (1.0 - 16.0 * 16.0)));
}

TEST_CASE("planeLight is the share of evenly spread samples that are behind the receiver's plane")
{
    MixturePlane<double> p{};
    p.weight = 1.0;
    p.depth = 0.5;
    p.place = {1.0, 0.5};
    p.slope = {0.02, -0.01};
    const Vec2<double> g(-0.01, 0.03);
    const Vec2<double> f(0.25, -0.5);
    const double sigma = 1.5;
    // The taps, spread by half of the window's variance: their difference from the receiver's plane has this mean and
    // variance.
    const Vec2<double> d(0.03, -0.04);
    const double variance = 0.5 * sigma * sigma * (d.x * d.x + d.y * d.y);
    for (const double depth : {0.35, 0.45, 0.5, 0.52, 0.6})
    {
        const double mean = 0.5 - (depth + g.x * (1.0 - f.x) + g.y * (0.5 - f.y)) + 0.5 * (d.x * f.x + d.y * f.y);
        const Vec2<double> light = planeLight(p, f, depth, g, sigma, 0.0);
        CHECK(light.y == doctest::Approx(mean).epsilon(1e-9));
        int behind = 0;
        const int samples = 100000;
        for (int i = 0; i < samples; ++i)
            behind += mean + std::sqrt(12.0 * variance) * ((i + 0.5) / samples - 0.5) > 0.0;
        CHECK(light.x == doctest::Approx(behind / double(samples)).epsilon(1e-4));
    }
    // A deviation spreads the samples and moves them back by 0.6 of itself; a bias moves them back.
    p.slope = g;
    p.place = {0.0, 0.0};
    p.deviation = 0.01;
    CHECK(planeLight(p, Vec2<double>(0.0), 0.5, g, sigma, 0.0).x == doctest::Approx(0.5 + 0.6 / std::sqrt(12.0)));
    CHECK(planeLight(p, Vec2<double>(0.0), 0.5, g, sigma, 0.005).x == doctest::Approx(0.5 + 1.1 / std::sqrt(12.0)));
    p.deviation = 0.0;
    CHECK(planeLight(p, Vec2<double>(0.0), 0.5 + 1.0e-5, g, sigma, 0.0).x ==
          doctest::Approx(0.5 - 1.0 / std::sqrt(12.0)).epsilon(1e-6));
}

TEST_CASE_TEMPLATE("a plane of any slope is not its own shadow, wherever in a window of whatever width", T, float,
                   double)
{
    Random random(911);
    Tally tally;
    for (int i = 0; i < 900; ++i)
    {
        const int rounds = 1 + i % 3;
        const double reach = (2 << rounds) - 2 + 1; // the farthest tap along both axes, and the receiver
        const double steepest = 0.5 / reach;        // 0.167 a texel for the narrowest: 89.9 degrees in a map of 10000
        const auto unit = [&]
        {
            return 2.0 * random.unit<double>() - 1.0;
        };
        const double scale = steepest * std::pow(10.0, -3.0 * random.unit<double>());
        const Vec2<double> g(0.5 * scale * unit(), 0.5 * scale * unit());
        const double middle = 0.25 + 0.5 * random.unit<double>();
        const DepthMap map = [&](int x, int y)
        {
            return std::min(1.0, std::max(0.0, middle + g.x * x + g.y * y));
        };
        const int count = 1 + i / 3 % 4;
        const T sigma = mixtureDeviation<T>(rounds);
        const Mixture<T> mixture = WindowTree<T>(map, rounds, count).mixture();
        const Vec2<T> f(T(0.5 * unit()), T(0.5 * unit()));
        const Vec2<T> gradient(static_cast<T>(g.x), static_cast<T>(g.y));
        const T depth = static_cast<T>(middle) + gradient.x * f.x + gradient.y * f.y;
        const Code4 code4 = encodeMixture4(mixture, sigma);
        const T four = mixtureVisibility4(code4, f, depth, gradient, sigma, kMixtureBias<T>);
        tally.claim(four == T(1), four, g.x, g.y, rounds, count);
        if (count <= 2)
        {
            const Code2 code2 = encodeMixture2(mixture, sigma);
            const T two = mixtureVisibility2(code2, f, depth, gradient, sigma, kMixtureBias<T>);
            tally.claim(two == T(1), two, g.x, g.y, rounds, count);
        }
        // And behind it all is dark, by twice the bias and what rounding may do.
        const T behind = depth + T(2) * kMixtureBias<T> + T(0.008);
        const T dark = mixtureVisibility4(code4, f, behind, gradient, sigma, kMixtureBias<T>);
        tally.claim(dark == T(0), dark, g.x, g.y, rounds, count);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("two planes are exact in share, and coded within half a level of it")
{
    Random random(912);
    Tally tally;
    for (int i = 0; i < 300; ++i)
    {
        const int rounds = 1 + i % 3;
        const int cut = random.between(-3, 3);
        const int other = random.between(-3, 3);
        const bool isCorner = i % 2 == 0;
        // A straight edge, a corner, or a bar as thin as a texel.
        const DepthMap map = [&](int x, int y)
        {
            const bool front = i % 5 == 0 ? x == cut : isCorner ? x < cut && y < other : x < cut;
            return front ? 0.25 + 0.004 * x : 0.75;
        };
        const Mixture<double> mixture = WindowTree<double>(map, rounds, 2).mixture();
        const double sigma = mixtureDeviation<double>(rounds);
        const Vec2<double> still(0.0);
        const double exact = shareOfWindow(map, rounds, still, [](int, int, double depth) { return depth > 0.5; });
        const double uncoded = uncodedVisibility(mixture, still, 0.5, still, sigma, kMixtureBias<double>);
        tally.claim(std::abs(uncoded - exact) < 1e-12, uncoded, exact, rounds, cut, other);
        const double coded =
            mixtureVisibility2(encodeMixture2(mixture, sigma), still, 0.5, still, sigma, kMixtureBias<double>);
        // Levels of 1/30; what is there at all is a level at least.
        tally.claim(std::abs(coded - exact) <= 1.0 / 60.0 + 1e-9 || std::min(exact, 1.0 - exact) < 1.0 / 30.0, coded,
                    exact);
        tally.claim(std::abs(coded - exact) <= 1.0 / 30.0 + 1e-9, coded, exact);
        const double coded4 =
            mixtureVisibility4(encodeMixture4(mixture, sigma), still, 0.5, still, sigma, kMixtureBias<double>);
        tally.claim(std::abs(coded4 - coded) < 1e-12, coded, coded4);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("moving a receiver between texels takes away most of the error of not moving it")
{
    Random random(913);
    for (int rounds = 2; rounds <= 3; ++rounds)
    {
        double moved = 0.0;
        double still = 0.0;
        for (int i = 0; i < 400; ++i)
        {
            const double angle = 6.2831853 * random.unit<double>();
            const double cut = 3.0 * random.unit<double>() - 1.5;
            const DepthMap map = [&](int x, int y)
            {
                return std::cos(angle) * x + std::sin(angle) * y < cut ? 0.2 : 0.8;
            };
            const Vec2<double> f(random.unit<double>() - 0.5, random.unit<double>() - 0.5);
            const Vec2<double> flat(0.0);
            const double exact = shareOfWindow(map, rounds, f, [](int, int, double depth) { return depth > 0.5; });
            const double sigma = mixtureDeviation<double>(rounds);
            const Code2 code = encodeMixture2(WindowTree<double>(map, rounds, 2).mixture(), sigma);
            const auto error = [&](const Vec2<double>& offset)
            {
                const double v = mixtureVisibility2(code, offset, 0.5, flat, sigma, kMixtureBias<double>);
                return (v - exact) * (v - exact);
            };
            moved += error(f);
            still += error(flat);
        }
        CHECK(moved < 0.25 * still); // half of the root mean square
    }
}

TEST_CASE_TEMPLATE("an empty map is lit, and so is what is coded from nothing", T, float, double)
{
    const T sigma = mixtureDeviation<T>(2);
    const Mixture<T> empty = WindowTree<T>([](int, int) { return 1.0; }, 1, 4).mixture();
    CHECK(encodeMixture4(empty, sigma) == encodeMixture4(Mixture<T>{}, sigma));
    CHECK(encodeMixture2(empty, sigma) == encodeMixture2(Mixture<T>{}, sigma));
    Random random(914);
    for (int i = 0; i < 1000; ++i)
    {
        const Vec2<T> f(random.unit<T>() - T(0.5), random.unit<T>() - T(0.5));
        const Vec2<T> g(T(0.1) * random.unit<T>() - T(0.05), T(0.1) * random.unit<T>() - T(0.05));
        const T depth = i == 0 ? T(1) : T(0.8) * random.unit<T>();
        const Vec2<T> slope = i == 0 ? Vec2<T>(0) : g;
        CHECK(mixtureVisibility4(encodeMixture4(empty, sigma), f, depth, slope, sigma, kMixtureBias<T>) == T(1));
        CHECK(mixtureVisibility2(encodeMixture2(empty, sigma), f, depth, slope, sigma, kMixtureBias<T>) == T(1));
    }
}

TEST_CASE("the occluder is the mean of what is in front, and the receiver where nothing is")
{
    const Vec2<double> still(0.0);
    Mixture<double> m{};
    m.components[0] = flatComponent(0.6, 0.8);
    m.components[1] = flatComponent(0.4, 0.2);
    const Code2 two = encodeMixture2(m, 1.0);
    const Code4 four = encodeMixture4(m, 1.0);
    for (const auto& [depth, mean] : {std::pair{0.9, 0.56}, std::pair{0.5, 0.2}, std::pair{0.1, 0.1}})
    {
        CHECK(std::abs(mixtureOccluder2(two, still, depth, still, 1.0, 0.0) - mean) <= 0.5 * kDepthStep);
        CHECK(std::abs(mixtureOccluder4(four, still, depth, still, 1.0, 0.0) - mean) <= 0.5 * kDepthStep);
    }
    // Of a slanted receiver the distance is counted from its plane: 0.3 everywhere under a parallel occluder.
    const Vec2<double> g(0.02, 0.01);
    const DepthMap map = [&](int x, int y)
    {
        return 0.4 + g.x * x + g.y * y;
    };
    const double sigma = mixtureDeviation<double>(2);
    const Code4 parallel = encodeMixture4(WindowTree<double>(map, 2, 4).mixture(), sigma);
    CHECK(std::abs(mixtureOccluder4(parallel, still, 0.7, g, sigma, 0.0) - 0.4) <= 0.5 * kDepthStep);
}

TEST_CASE("a mixture that matters is dark and light where its surfaces say so, and its bias is two steps of depth")
{
    CHECK(kMixtureBias<double> == 2.0 * kDepthStep);
    const Vec2<double> still(0.0);
    Mixture<double> m{};
    m.components[0] = flatComponent(0.5, 0.7);
    m.components[1] = flatComponent(0.3, 0.4);
    m.components[2] = flatComponent(0.2, 0.1);
    const Code4 code = encodeMixture4(m, 1.0);
    for (const auto& [depth, lit] :
         {std::pair{0.05, 1.0}, std::pair{0.2, 0.8}, std::pair{0.5, 0.5}, std::pair{0.8, 0.0}})
        CHECK(mixtureVisibility4(code, still, depth, still, 1.0, 0.0) == doctest::Approx(lit).epsilon(1e-9));
    // A bias of any size up to 1 counts.
    for (const auto& [bias, lit] :
         {std::pair{0.45, 0.5}, std::pair{0.65, 0.8}, std::pair{0.95, 1.0}, std::pair{9.0, 1.0}})
        CHECK(mixtureVisibility4(code, still, 1.0, still, 1.0, bias) == doctest::Approx(lit).epsilon(1e-9));
}

TEST_CASE_TEMPLATE("any bits are a code, and any numbers a receiver, NaN and infinity too", T, float, double)
{
    Random random(915);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const auto any = [&]
        {
            return random.pattern<T>();
        };
        const auto bits = [&]
        {
            return static_cast<std::uint32_t>(random.between(0, 65535) << 16 | random.between(0, 65535));
        };
        const Code4 four(bits(), bits(), bits(), bits());
        const Vec2<T> f(any(), any()), g(any(), any());
        const T depth = any(), deviation = any(), bias = any();
        const Code2 two(four.x, four.y);
        for (const T result : {mixtureVisibility2(two, f, depth, g, deviation, bias),
                               mixtureVisibility4(four, f, depth, g, deviation, bias),
                               mixtureOccluder2(two, f, depth, g, deviation, bias),
                               mixtureOccluder4(four, f, depth, g, deviation, bias)})
            tally.claim(result >= T(0) && result <= T(1), result);
        // And any component is coded; what comes out is a code of finite planes.
        Mixture<T> m{};
        for (MixtureComponent<T>& c : m.components)
            insertComponent(m, MixtureComponent<T>{any(), f, any(), {any(), any(), any()}, g, any()}, 3), (void)c;
        simplifyMixture(m, 4);
        const MixturePlanes<T> planes = decodeMixture4(encodeMixture4(m, deviation), deviation);
        for (const MixturePlane<T>& p : planes.planes)
            tally.claim(p.weight >= T(0) && p.weight <= T(1) && p.depth >= T(0) && p.depth <= T(1) &&
                            std::isfinite(p.place.x + p.place.y),
                        p.weight, p.depth);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("a plane is coded at its coded place, so that rounding of the place does not move it")
{
    Random random(916);
    Tally tally;
    for (int i = 0; i < 2000; ++i)
    {
        Mixture<double> m{};
        for (int k = 0; k < 4; ++k)
        {
            MixtureComponent<double>& c = m.components[k];
            c = flatComponent(k == 0 ? 0.55 : 0.1 + 0.01 * k, 0.3 + 0.4 * random.unit<double>());
            c.place = {2.0 * random.unit<double>() - 1.0, 2.0 * random.unit<double>() - 1.0};
            c.spread = {1.0, 0.0, 1.0};
            c.tilt = {0.05 * random.unit<double>(), -0.05 * random.unit<double>()};
            c.variance = 0.01;
        }
        const auto check = [&](const MixturePlanes<double>& planes, int count)
        {
            for (int k = 0; k < count; ++k)
            {
                // Lighter ones are coded by weight: 3, 2, 1 of four, and 1 of two.
                const MixtureComponent<double>& c = m.components[k == 0 || count == 2 ? k : 4 - k];
                MixtureComponent<double> whole = c;
                double sum = 0.0;
                for (int j = 0; j < count; ++j)
                    sum += m.components[j].weight;
                whole.weight = c.weight / sum;
                const Vec2<double> g = componentSlope(whole);
                const MixturePlane<double>& p = planes.planes[k];
                const double depth = c.depth + g.x * (p.place.x - c.place.x) + g.y * (p.place.y - c.place.y);
                tally.claim(std::abs(p.depth - depth) <= 0.5 * kDepthStep + 1e-12, k, count, p.depth, depth);
            }
        };
        check(decodeMixture4(encodeMixture4(m, 1.2), 1.2), 4);
        check(decodeMixture2(encodeMixture2(m, 1.2), 1.2), 2);
        // Shares are relative to their sum.
        Mixture<double> half = m;
        for (MixtureComponent<double>& c : half.components)
            c.weight *= 0.5;
        tally.claim(encodeMixture4(half, 1.2) == encodeMixture4(m, 1.2), i);
        tally.claim(encodeMixture2(half, 1.2) == encodeMixture2(m, 1.2), i);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("a receiver outside its ranges, and a plane outside its own, count as the ends of these")
{
    MixturePlane<double> wild = {3.0, {400.0, -400.0}, -2.0, {2.0, -2.0}, 7.0};
    MixturePlane<double> tame = {1.0, {256.0, -256.0}, 0.0, {1.0, -1.0}, 1.0};
    for (int side = 0; side < 2; ++side)
    {
        const double s = side == 0 ? 1.0 : -1.0;
        const Vec2<double> far(40.0 * s, -40.0 * s), near(16.0 * s, -16.0 * s), steep(2.0 * s, -3.0 * s), slope(s, -s);
        const double depth = side == 0 ? 1.0 : 0.0;
        CHECK(planeWeight(wild, far, 1.0e3 * s) == planeWeight(tame, near, side == 0 ? 64.0 : 0.25));
        CHECK(planeLight(wild, far, 2.0 * s, steep, 1.0e3 * s, 5.0 * s) ==
              planeLight(tame, near, depth, slope, side == 0 ? 64.0 : 0.25, depth));
        for (const std::uint32_t word : {0x12345678u, 0x9ABCDEF0u, 0x0F0F0F0Fu})
        {
            const Code4 code(word, word * 3u, word * 5u, word * 7u);
            CHECK(mixtureVisibility4(code, far, 2.0 * s, steep, 1.0e3 * s, 5.0 * s) ==
                  mixtureVisibility4(code, near, depth, slope, side == 0 ? 64.0 : 0.25, depth));
            CHECK(mixtureOccluder4(code, far, 2.0 * s, steep, 1.0e3 * s, 5.0 * s) ==
                  mixtureOccluder4(code, near, depth, slope, side == 0 ? 64.0 : 0.25, depth));
        }
        wild = {-3.0, {-400.0, 400.0}, 2.0, {-2.0, 2.0}, -7.0};
        tame = {0.0, {-256.0, 256.0}, 1.0, {-1.0, 1.0}, 0.0};
    }
}

Code4 randomCode(Random& random)
{
    const auto word = [&]
    {
        return std::uint32_t(random.between(0, 65535)) << 16 | std::uint32_t(random.between(0, 65535));
    };
    return {word(), word(), word(), word()};
}

TEST_CASE("what exceeds its range is taken to its end in planes and codes")
{
    const Range<double> unit{0, 1}, whole{-1, 1}, place{-256, 256}, offset{-16, 16};
    const Range<double> deviation{0.25, 64}, weight{0, 1, false, false};
    checkEnds<double, 10>({place, place, unit, whole, whole, unit, offset, offset, unit, weight},
                          [](const auto& a)
                          {
                              const MixturePlane<double> p{a[9], {a[0], a[1]}, a[2], {a[3], a[4]}, a[5]};
                              return planeLight(p, Vec2<double>(a[6], a[7]), a[8], Vec2<double>(0.1, -0.1), 16.0, 0.1);
                          });
    // Flat planes, so that what adds to their deviation and the bias is seen.
    checkEnds<double, 4>({whole, whole, unit, deviation},
                         [](const auto& a)
                         {
                             const MixturePlane<double> p{1.0, {1.0, 2.0}, 0.5, {}, 0.5};
                             return planeLight(p, Vec2<double>(0.01, 0.02), 0.6, Vec2<double>(a[0], a[1]), a[3], a[2]);
                         });
    checkEnds<double, 2>(
        {unit, deviation},
        [](const auto& a) {
            return planeWeight(MixturePlane<double>{a[0], {0.01, 0.02}, 0, {}, 0}, Vec2<double>(1.0, 1.0), a[1]);
        });
    checkEnds<double, 2>(
        {offset, offset},
        [](const auto& a) {
            return planeWeight(MixturePlane<double>{1, {0.01, 0.02}, 0, {}, 0}, Vec2<double>(a[0], a[1]), 1.0);
        });
    // A code of planes at either end of the depth range.
    Mixture<double> ends{};
    const double depths[] = {0.01, 0.4, 0.6, 0.99};
    for (int i = 0; i < 4; ++i)
    {
        ends.components[i] = flatComponent(0.25, depths[i]);
        ends.components[i].place = {0.5 - 0.25 * i, 0.3};
        ends.components[i].spread = {8.0, 0.0, 8.0};
        ends.components[i].variance = 0.01;
    }
    const Code4 code = encodeMixture4(ends, 4.0);
    const Range<double> bias{0, 1, true, false}, steep{-1, 1, false, false};
    checkEnds<double, 6>({offset, offset, unit, steep, steep, bias},
                         [code](const auto& a)
                         {
                             const Vec2<double> f(a[0], a[1]), g(a[3], a[4]);
                             return Vec2<double>(mixtureVisibility4(code, f, a[2], g, 4.0, a[5]),
                                                 mixtureOccluder4(code, f, a[2], g, 4.0, a[5]));
                         });
}

TEST_CASE("light is the same in a mirror, along either axis")
{
    Random random(182);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const auto one = [&]
        {
            return 2.0 * random.unit<double>() - 1.0;
        };
        const MixturePlane<double> p{1.0, {one(), one()}, random.unit<double>(), {one(), one()}, 0.01};
        const Vec2<double> f(one(), one()), g(0.3 * one(), 0.3 * one());
        const double depth = random.unit<double>();
        const Vec2<double> light = planeLight(p, f, depth, g, 1.0, 0.0);
        for (const Vec2<double> m : {Vec2<double>(-1, 1), Vec2<double>(1, -1), Vec2<double>(-1, -1)})
        {
            MixturePlane<double> mirrored = p;
            mirrored.place = m * p.place;
            mirrored.slope = m * p.slope;
            const Vec2<double> other = planeLight(mirrored, m * f, depth, m * g, 1.0, 0.0);
            tally.claim(std::abs(other.x - light.x) < 1e-12 && std::abs(other.y - light.y) < 1e-12, i, m.x, m.y);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

// A window four times as wide, with slopes a quarter as steep.
TEST_CASE("a window in proportion has the same code, and its planes are in proportion")
{
    Random random(183);
    Tally tally;
    for (int i = 0; i < 2000; ++i)
    {
        Mixture<double> m{}, wide{};
        for (int k = 0; k < 4; ++k)
        {
            MixtureComponent<double> c = flatComponent(0.25 + 0.01 * k, random.unit<double>());
            c.place = {random.unit<double>() - 0.5, random.unit<double>() - 0.5};
            c.spread = {random.unit<double>(), 0.0, random.unit<double>()};
            m.components[k] = c;
            wide.components[k] = c;
            wide.components[k].place = 4.0 * c.place;
            wide.components[k].spread = 16.0 * c.spread;
        }
        tally.claim(encodeMixture2(m, 1.0) == encodeMixture2(wide, 4.0), i, 2);
        tally.claim(encodeMixture4(m, 1.0) == encodeMixture4(wide, 4.0), i, 4);
        const Code4 code = randomCode(random);
        const MixturePlanes<double> planes = decodeMixture4(code, 1.0), others = decodeMixture4(code, 4.0);
        for (int k = 0; k < 4; ++k)
        {
            const MixturePlane<double>&p = planes.planes[k], &q = others.planes[k];
            tally.claim(glm::distance(4.0 * p.place, q.place) < 1e-9, i, k);
            tally.claim(glm::distance(p.slope, 4.0 * q.slope) < 1e-9, i, k);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("a plane that leaves the depth range at its coded place is coded at its end")
{
    for (const double side : {-1.0, 1.0})
    {
        Mixture<double> m{};
        m.components[0] = flatComponent(0.75, 0.5 + 0.49 * side);
        m.components[0].place = {-2.0 * side, 0.0};
        m.components[0].spread = {1.0, 0.0, 1.0};
        m.components[0].tilt = {0.05, 0.0};
        m.components[1] = flatComponent(0.25, 0.5);
        const Code2 code = encodeMixture2(m, 1.0);
        CHECK((code.x >> 22) == (side > 0 ? 1023u : 0u));
    }
}

TEST_CASE("a component's plane is its own: of its slope exactly, and of the deviation that is left")
{
    MixtureComponent<double> c = flatComponent(1.0, 0.5);
    c.variance = 0.04;
    const MixturePlane<double> p = componentPlane(c);
    CHECK(p.deviation == doctest::Approx(0.2));
    // Slopes that differ by 1/2 spread a plane's taps: by half of the window's variance: 1/8, and a tenth of depth between.
    const MixturePlane<double> slanted{1.0, {}, 0.6, {0.5, 0.0}, 0.0};
    CHECK(planeLight(slanted, Vec2<double>(0.0, 0.0), 0.5, Vec2<double>(0.0, 0.0), 1.0, 0.0).x ==
          doctest::Approx(0.5 + 0.1 / std::sqrt(12.0 / 8)));
}

} // namespace
} // namespace lvsm::unit
