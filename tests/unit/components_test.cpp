// Components of mixtures: moments that merge exactly, planes that fit, and what is merged first.
#include <lvsm/components.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "numbers.hpp"
#include "windows.hpp"

namespace lvsm::unit
{
namespace
{

// The ten sums over weighted taps: weight, places, depths and their products.
struct Sums
{
    Exact weight = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;

    void add(Exact w, Exact px, Exact py, Exact depth)
    {
        weight += w;
        x += w * px;
        y += w * py;
        z += w * depth;
        xx += w * px * px;
        xy += w * px * py;
        yy += w * py * py;
        xz += w * px * depth;
        yz += w * py * depth;
        zz += w * depth * depth;
    }

    template <typename T>
    void add(const MixtureComponent<T>& c)
    {
        const Exact w = c.weight, px = c.place.x, py = c.place.y, depth = c.depth;
        add(w, px, py, depth);
        xx += w * Exact(c.spread.x);
        xy += w * Exact(c.spread.y);
        yy += w * Exact(c.spread.z);
        xz += w * Exact(c.tilt.x);
        yz += w * Exact(c.tilt.y);
        zz += w * Exact(c.variance);
    }

    std::array<Exact, 10> all() const { return {weight, x, y, z, xx, xy, yy, xz, yz, zz}; }

    // Places are up to 8: a product of two is up to 64.
    bool isNear(const Sums& other, Exact tolerance) const
    {
        for (std::size_t i = 0; i < 10; ++i)
        {
            if (std::abs(all()[i] - other.all()[i]) > Exact(64) * tolerance)
                return false;
        }
        return true;
    }
};

template <typename T>
MixtureComponent<T> tap(T weight, T x, T y, T depth)
{
    return moveComponent(tapComponent(depth), Vec2<T>(x, y), weight);
}

template <typename T>
MixtureComponent<T> randomTap(Random& random)
{
    return tap(random.unit<T>(), T(16) * random.unit<T>() - T(8), T(16) * random.unit<T>() - T(8), random.unit<T>());
}

TEST_CASE_TEMPLATE("mergeComponents keeps the ten sums, in whatever order", T, float, double)
{
    Random random(900);
    Tally tally;
    for (int i = 0; i < 2000; ++i)
    {
        Sums sums;
        std::vector<MixtureComponent<T>> parts;
        for (int k = 0; k < 12; ++k)
        {
            parts.push_back(randomTap<T>(random));
            parts.back().weight /= T(12);
            sums.add(parts.back());
        }
        while (parts.size() > 1)
        {
            const auto at = static_cast<std::size_t>(random.between(0, static_cast<int>(parts.size()) - 2));
            parts[at] = mergeComponents(parts[at], parts.back());
            parts.pop_back();
        }
        Sums merged;
        merged.add(parts[0]);
        tally.claim(merged.isNear(sums, Exact(40) * kRoundoff<T>), i);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("insertComponent and simplifyMixture keep the ten sums of the whole window", T, float, double)
{
    Random random(901);
    Tally tally;
    for (int i = 0; i < 1000; ++i)
    {
        const int count = random.between(1, 4);
        Mixture<T> mixture{};
        Sums sums;
        for (int k = 0; k < 20; ++k)
        {
            MixtureComponent<T> c = randomTap<T>(random);
            c.weight /= T(20);
            sums.add(c);
            insertComponent(mixture, c, count);
        }
        if (i % 2 == 0)
            simplifyMixture(mixture, count);
        Sums kept;
        for (int k = 0; k < kMaxComponents; ++k)
        {
            if (k >= count)
                tally.claim(mixture.components[k].weight == T(0), i);
            kept.add(mixture.components[k]);
        }
        tally.claim(kept.isNear(sums, Exact(60) * kRoundoff<T>), i);
    }
    LVSM_CHECK_TALLY(tally);
}

template <typename T>
Mixture<T> randomMixture(Random& random, int count)
{
    Mixture<T> mixture{};
    for (int k = 0; k < count; ++k)
    {
        mixture.components[k] = randomTap<T>(random);
        mixture.components[k].weight /= T(count);
    }
    return mixture;
}

TEST_CASE_TEMPLATE("mixtureStep keeps the ten sums of three windows, each moved and with its share", T, float, double)
{
    Random random(904);
    Tally tally;
    for (int i = 0; i < 1000; ++i)
    {
        const int count = random.between(1, 4);
        const Mixture<T> three[] = {randomMixture<T>(random, count), randomMixture<T>(random, count),
                                    randomMixture<T>(random, count)};
        const Vec2<T> offset(T(random.between(-4, 4)), T(random.between(-4, 4)));
        const T share = T(0.125) * T(random.between(0, 4));
        Sums sums;
        for (int side = -1; side <= 1; ++side)
        {
            for (const MixtureComponent<T>& c : three[side + 1].components)
                sums.add(Exact(c.weight) * (side == 0 ? Exact(1) - 2 * Exact(share) : Exact(share)),
                         Exact(c.place.x) + side * Exact(offset.x), Exact(c.place.y) + side * Exact(offset.y), c.depth);
        }
        Sums kept;
        const Mixture<T> mixed = mixtureStep(three[1], three[0], three[2], offset, share, count);
        for (int k = 0; k < kMaxComponents; ++k)
        {
            tally.claim(k < count || mixed.components[k].weight == T(0), i);
            kept.add(mixed.components[k]);
        }
        // Places are up to 12.
        tally.claim(kept.isNear(sums, Exact(60 * 144 / 64) * kRoundoff<T>), i);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("mixtureStep does what insertComponent does to the middle's components and then those before and after")
{
    Random random(905);
    Tally tally;
    for (int i = 0; i < 500; ++i)
    {
        const int count = random.between(1, 4);
        const Mixture<double> middle = randomMixture<double>(random, random.between(1, count));
        const Mixture<double> before = randomMixture<double>(random, random.between(1, count));
        const Mixture<double> after = randomMixture<double>(random, random.between(1, count));
        Mixture<double> inserted{};
        for (int side : {0, -1, 1})
        {
            const Mixture<double>& from = side == 0 ? middle : side < 0 ? before : after;
            for (int k = 0; k < count; ++k)
                insertComponent(
                    inserted, moveComponent(from.components[k], Vec2<double>(2.0 * side, 0.0), side == 0 ? 0.5 : 0.25),
                    count);
        }
        const Mixture<double> mixed = mixtureStep(middle, before, after, Vec2<double>(2.0, 0.0), 0.25, count);
        for (int k = 0; k < kMaxComponents; ++k)
        {
            const MixtureComponent<double>& a = mixed.components[k];
            const MixtureComponent<double>& b = inserted.components[k];
            tally.claim(std::abs(a.weight - b.weight) < 1e-14 && std::abs(a.place.x - b.place.x) < 1e-13 &&
                            std::abs(a.depth - b.depth) < 1e-14 && std::abs(a.variance - b.variance) < 1e-14,
                        i, k);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("mixtureStep keeps so many surfaces apart and in order, merges equal ones, and clamps what it is given")
{
    const auto surfaces = [](std::initializer_list<double> depths)
    {
        Mixture<double> mixture{};
        int k = 0;
        for (const double depth : depths)
            mixture.components[k++] = tap(1.0 / static_cast<double>(depths.size()), 0.0, 0.0, depth);
        return mixture;
    };
    const Mixture<double> near = surfaces({0.2});
    const Mixture<double> four = surfaces({0.8, 0.2, 0.6, 0.4});
    const Mixture<double> far = surfaces({0.4, 0.8});
    const Mixture<double> mixed = mixtureStep(four, near, far, Vec2<double>(1.0, 0.0), 0.25, 4);
    const double depths[] = {0.8, 0.2, 0.6, 0.4};
    const double weights[] = {0.25, 0.375, 0.125, 0.25};
    for (int k = 0; k < 4; ++k)
    {
        CHECK(mixed.components[k].depth == doctest::Approx(depths[k]));
        CHECK(mixed.components[k].weight == doctest::Approx(weights[k]));
    }
    // The near one's centroid: 1/8 in the middle and 1/4 a texel before it.
    CHECK(mixed.components[1].place.x == doctest::Approx(-2.0 / 3.0));
    CHECK(mixed.components[0].place.x == doctest::Approx(0.5));

    // K + 1 equal depths, and a second surface.
    const Mixture<double> two =
        mixtureStep(surfaces({0.5, 0.5}), surfaces({0.5, 0.9}), surfaces({0.5, 0.5}), Vec2<double>(0.0), 0.25, 2);
    CHECK(two.components[0].weight + two.components[1].weight == doctest::Approx(1.0));
    CHECK(std::min(two.components[0].depth, two.components[1].depth) == doctest::Approx(0.5));
    CHECK(std::max(two.components[0].depth, two.components[1].depth) == doctest::Approx(0.9));

    CHECK(mixtureStep(near, four, four, Vec2<double>(0.0), -1.0, 4).components[0].weight == 1.0);
    CHECK(mixtureStep(four, near, near, Vec2<double>(0.0), 2.0, 1).components[0].depth == doctest::Approx(0.2));
    CHECK(mixtureStep(four, near, near, Vec2<double>(0.0), 2.0, 1).components[0].weight == 1.0);
    CHECK(mixtureStep(near, near, near, Vec2<double>(0.0), 0.25, 0).components[0].weight == 1.0);
    CHECK(mixtureStep(near, near, near, Vec2<double>(1000.0, 0.0), 0.5, 1).components[0].spread.x == 65536.0);
    CHECK(mixtureStep(four, four, four, Vec2<double>(0.0), 0.25, 0).components[1].weight == 0.0);
    CHECK(mixtureStep(four, four, four, Vec2<double>(0.0), 0.25, 9).components[3].weight == 0.25);
}

TEST_CASE("slopedComponent is the limit of ever finer taps over the texel's plane")
{
    const Vec2<double> gradient(0.02, -0.01);
    const int fine = 64;
    Sums sums;
    for (int y = 0; y < fine; ++y)
    {
        for (int x = 0; x < fine; ++x)
        {
            const double px = (x + 0.5) / fine - 0.5;
            const double py = (y + 0.5) / fine - 0.5;
            sums.add(1.0 / (fine * fine), px, py, 0.5 + gradient.x * px + gradient.y * py);
        }
    }
    const MixtureComponent<double> sloped = slopedComponent(0.5, gradient);
    Sums whole;
    whole.add(sloped);
    // n taps a side have the variance (1 - 1/n^2) / 12.
    const Exact less = Exact(1) - Exact(1) / (fine * fine);
    CHECK(std::abs(sums.xx - less * whole.xx) < 1e-15L);
    CHECK(std::abs(sums.yy - less * whole.yy) < 1e-15L);
    CHECK(std::abs(sums.xz - less * whole.xz) < 1e-15L);
    CHECK(std::abs(sums.yz - less * whole.yz) < 1e-15L);
    CHECK(std::abs(sums.zz - 0.25L - less * (whole.zz - 0.25L)) < 1e-15L);
    CHECK(sloped.weight == 1.0);
    // All of a window: the ridge is 2^-12, beside a variance of 1/12.
    CHECK(componentSlope(sloped).x == doctest::Approx(gradient.x / (1.0 + 12.0 / 4096.0)).epsilon(1e-12));
    CHECK(slopedComponent(2.0, Vec2<double>(3.0, -3.0)).tilt == Vec2<double>(1.0 / 12.0, -1.0 / 12.0));
}

TEST_CASE("moveComponent moves the place, scales the share and leaves the rest")
{
    const MixtureComponent<double> c = mergeComponents(tap(0.25, 1.0, 2.0, 0.3), tap(0.5, -1.0, 0.0, 0.4));
    const MixtureComponent<double> moved = moveComponent(c, Vec2<double>(4.0, -8.0), 0.25);
    CHECK(moved.weight == 0.25 * c.weight);
    CHECK(moved.place == Vec2<double>(c.place.x + 4.0, c.place.y - 8.0));
    CHECK(moved.depth == c.depth);
    CHECK(moved.spread == c.spread);
    CHECK(moved.tilt == c.tilt);
    CHECK(moved.variance == c.variance);
    CHECK(moveComponent(tap(1.0, 8.0, -8.0, 0.5), Vec2<double>(1000.0, -1000.0), 2.0).place ==
          Vec2<double>(256.0, -256.0));
    CHECK(moveComponent(c, Vec2<double>(0.0), 2.0).weight == c.weight);
}

TEST_CASE("componentSlope is least squares with a ridge of half of what the component is not of the window")
{
    // Taps at +-1 along x and +-2 along y: variances 1/2 and 2, on a plane.
    const Vec2<double> g(0.03, -0.05);
    for (const double weight : {1.0, 0.75, 0.5, 0.125})
    {
        MixtureComponent<double> c{};
        for (const Vec2<double> place :
             {Vec2<double>(1, 0), Vec2<double>(-1, 0), Vec2<double>(0, 2), Vec2<double>(0, -2)})
            c = mergeComponents(c, tap(weight / 4, place.x, place.y, 0.5 + g.x * place.x + g.y * place.y));
        const double ridge = std::max(0.5 * (1.0 - weight), 1.0 / 4096.0);
        const Vec2<double> slope = componentSlope(c);
        CHECK(slope.x == doctest::Approx(g.x * 0.5 / (0.5 + ridge)).epsilon(1e-12));
        CHECK(slope.y == doctest::Approx(g.y * 2.0 / (2.0 + ridge)).epsilon(1e-12));
        CHECK(componentResidual(c, g) < 1e-17);
        CHECK(componentResidual(c, Vec2<double>(0.0)) == doctest::Approx(0.5 * g.x * g.x + 2.0 * g.y * g.y));
    }
    CHECK(componentSlope(tap(0.25, 1.0, 1.0, 0.5)) == Vec2<double>(0.0));
    // Correlated places: the plane is found all the same.
    MixtureComponent<double> oblique{};
    for (int i = -2; i <= 2; ++i)
        oblique = mergeComponents(oblique, tap(0.2, 1.0 * i, 1.0 * (i + i % 2), 0.5 + g.x * i + g.y * (i + i % 2)));
    CHECK(componentSlope(oblique).x == doctest::Approx(g.x).epsilon(0.01).scale(0));
    CHECK(componentSlope(oblique).y == doctest::Approx(g.y).epsilon(0.01).scale(0));
}

TEST_CASE("componentResidual is what is left of a plane's taps around it")
{
    MixtureComponent<double> c{};
    for (int i = 0; i < 8; ++i)
    {
        const double x = i % 2 == 0 ? -1.0 : 1.0;
        const double y = i / 2 % 2 == 0 ? -1.0 : 1.0;
        c = mergeComponents(c, tap(0.125, x, y, 0.5 + 0.01 * x - 0.02 * y + (i < 4 ? 0.03 : -0.03)));
    }
    CHECK(componentResidual(c, Vec2<double>(0.01, -0.02)) == doctest::Approx(0.0009).epsilon(1e-9).scale(0));
}

TEST_CASE("mergePrice of two lone taps of one place is half their distance, less the deviation that never counts")
{
    for (const double distance : {0.0, 1.0e-4, 0.01, 0.5})
    {
        const double price = mergePrice(tap(0.5, 0.0, 0.0, 0.25), tap(0.5, 0.0, 0.0, 0.25 + distance));
        CHECK(std::abs(price - (std::sqrt(0.25 * distance * distance + 1.0e-8) - 1.0e-4)) < 1.0e-12);
    }
    // Shares of 1/4 and 3/4 leave a variance of 3/16 of the distance squared.
    CHECK(mergePrice(tap(0.25, 0.0, 0.0, 0.2), tap(0.75, 0.0, 0.0, 0.6)) ==
          doctest::Approx(std::sqrt(0.1875 * 0.16 + 1.0e-8) - 1.0e-4));
}

TEST_CASE("insertComponent merges the first of equal prices, and its count is the limit")
{
    LVSM_NOT_WITH_FAST_MATH("prices that are equal may differ by a rounding");
    Mixture<double> mixture{};
    for (const double weight : {0.5, 0.25, 0.125, 0.0625, 0.03125})
        insertComponent(mixture, tap(weight, 0.0, 0.0, 0.5), 4);
    CHECK(mixture.components[0].weight == 0.75);
    CHECK(mixture.components[1].weight == 0.03125);
    CHECK(mixture.components[2].weight == 0.125);
    CHECK(mixture.components[3].weight == 0.0625);
    for (const auto& c : mixture.components)
        CHECK(c.depth == 0.5);

    Mixture<double> one{};
    insertComponent(one, tap(0.5, 0.0, 0.0, 0.2), 1);
    insertComponent(one, tap(0.0, 0.0, 0.0, 0.9), 1);
    CHECK(one.components[0].weight == 0.5);
    CHECK(one.components[0].depth == doctest::Approx(0.2));
    insertComponent(one, tap(0.5, 0.0, 0.0, 0.4), 0);
    CHECK(one.components[0].depth == doctest::Approx(0.3));
    CHECK(one.components[1].weight == 0.0);
}

TEST_CASE("surfaces far apart stay apart in whatever order their taps come")
{
    Random random(902);
    Tally tally;
    const double depths[] = {0.1, 0.35, 0.6, 0.9};
    for (int i = 0; i < 300; ++i)
    {
        std::vector<MixtureComponent<double>> taps;
        for (int k = 0; k < 40; ++k)
            taps.push_back(tap(1.0 / 40, 1.0 * random.between(-3, 3), 1.0 * random.between(-3, 3),
                               depths[k % 4] + 1e-4 * (k / 4)));
        for (std::size_t k = taps.size() - 1; k > 0; --k)
            std::swap(taps[k], taps[static_cast<std::size_t>(random.between(0, static_cast<int>(k)))]);
        Mixture<double> mixture{};
        for (const auto& t : taps)
            insertComponent(mixture, t, 4);
        std::sort(std::begin(mixture.components), std::end(mixture.components),
                  [](const auto& a, const auto& b) { return a.depth < b.depth; });
        for (int k = 0; k < 4; ++k)
        {
            const auto& c = mixture.components[k];
            tally.claim(std::abs(c.weight - 0.25) < 1e-12 && std::abs(c.depth - depths[k] - 4.5e-4) < 1e-12, i, k,
                        c.weight, c.depth);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("simplifyMixture makes one plane of a plane's parts, and leaves what a code can tell")
{
    const Vec2<double> g(0.01, 0.02);
    Mixture<double> mixture{};
    for (const Vec2<double> at : {Vec2<double>(1, 1), Vec2<double>(-1, 1), Vec2<double>(1, -1), Vec2<double>(-1, -1)})
        insertComponent(mixture, moveComponent(slopedComponent(0.5 + g.x * at.x + g.y * at.y, g), at, 0.25), 4);
    simplifyMixture(mixture, 4);
    CHECK(mixture.components[0].weight == 1.0);
    CHECK(mixture.components[1].weight == 0.0);
    CHECK(mixture.components[2].weight == 0.0);
    CHECK(mixture.components[3].weight == 0.0);
    CHECK(componentSlope(mixture.components[0]).x == doctest::Approx(g.x).epsilon(0.001).scale(0));

    // Halves of the window: half of the distance is the price, less 1e-4.
    const auto left = [](double distance)
    {
        Mixture<double> two{};
        two.components[0] = tap(0.5, 0.0, 0.0, 0.5);
        two.components[1] = tap(0.5, 0.0, 0.0, 0.5 + distance);
        simplifyMixture(two, 4);
        return two.components[1].weight;
    };
    CHECK(left(3.0e-4) == 0.0);
    CHECK(left(4.0e-4) == 0.5);
}

TEST_CASE("mixtureDeviation is that of the tree's window")
{
    for (int rounds = 0; rounds <= 5; ++rounds)
    {
        const std::vector<double> kernel = treeKernel(rounds);
        const double middle = 0.5 * static_cast<double>(kernel.size() - 1);
        double variance = 0.0;
        for (std::size_t i = 0; i < kernel.size(); ++i)
            variance += kernel[i] * (static_cast<double>(i) - middle) * (static_cast<double>(i) - middle);
        CHECK(mixtureDeviation<double>(rounds) == doctest::Approx(std::sqrt(variance)).epsilon(1e-12));
        CHECK(kernel.size() == (std::size_t(2) << rounds) - 1);
    }
    CHECK(mixtureDeviation<double>(-1) == 0.0);
    CHECK(mixtureDeviation<double>(8) == mixtureDeviation<double>(7));
    CHECK(mixtureDeviation<double>(7) == doctest::Approx(std::sqrt(2730.5)));
}

TEST_CASE("mixtureOfTaps has each tap at its place, a quarter each")
{
    const Vec4<double> depths(0.1, 0.4, 0.6, 0.9);
    const Vec4<double> x(-0.5, 0.5, -0.5, 0.5);
    const Vec4<double> y(-0.5, -0.5, 0.5, 0.5);
    const Mixture<double> four = mixtureOfTaps(depths, x, y, 4);
    for (int i = 0; i < 4; ++i)
    {
        CHECK(four.components[i].weight == 0.25);
        CHECK(four.components[i].depth == depths[i]);
        CHECK(four.components[i].place == Vec2<double>(x[i], y[i]));
    }
    const Mixture<double> two = mixtureOfTaps(Vec4<double>(0.1, 0.1, 0.9, 0.9), x, y, 2);
    CHECK(two.components[0].depth == doctest::Approx(0.1));
    CHECK(two.components[1].depth == doctest::Approx(0.9));
}

TEST_CASE("the tree's mixture has the window's first two moments")
{
    Random random(903);
    for (int rounds = 1; rounds <= 2; ++rounds)
    {
        for (int i = 0; i < 20; ++i)
        {
            std::vector<double> depths(15 * 15);
            for (double& d : depths)
                d = random.unit<double>();
            const DepthMap map = [&](int x, int y)
            {
                return depths[static_cast<std::size_t>((y + 7) * 15 + x + 7)];
            };
            Sums sums;
            const std::vector<double> kernel = treeKernel(rounds);
            const int radius = static_cast<int>(kernel.size()) / 2;
            for (int y = -radius; y <= radius; ++y)
            {
                for (int x = -radius; x <= radius; ++x)
                    sums.add(kernel[static_cast<std::size_t>(x + radius)] *
                                 kernel[static_cast<std::size_t>(y + radius)],
                             x, y, map(x, y));
            }
            const WindowTree<double> tree(map, rounds, 3);
            Sums kept;
            for (const auto& c : tree.mixture().components)
                kept.add(c);
            CHECK(kept.isNear(sums, Exact(100) * kRoundoff<double>));
        }
    }
}

// Any members, or those that they count as.
MixtureComponent<double> wildComponent(Random& random, bool isClamped)
{
    const auto member = [&](double low, double high)
    {
        const double wild = (random.between(0, 2) - 1) * 3.0 * high + random.unit<double>() * high;
        return isClamped ? std::min(high, std::max(low, wild)) : wild;
    };
    MixtureComponent<double> c{};
    c.weight = member(0, 1);
    c.place = {member(-256, 256), member(-256, 256)};
    c.depth = member(0, 1);
    c.spread = {member(0, 65536), member(-65536, 65536), member(0, 65536)};
    c.tilt = {member(-256, 256), member(-256, 256)};
    c.variance = member(0, 1);
    return c;
}

bool isSame(const MixtureComponent<double>& a, const MixtureComponent<double>& b)
{
    return a.weight == b.weight && a.place == b.place && a.depth == b.depth && a.spread == b.spread &&
           a.tilt == b.tilt && a.variance == b.variance;
}

TEST_CASE("members outside their ranges count as the ends of these")
{
    Tally tally;
    for (unsigned seed = 0; seed < 2000; ++seed)
    {
        Random first(seed);
        Random second(seed);
        const MixtureComponent<double> a = wildComponent(first, false), b = wildComponent(first, false);
        const MixtureComponent<double> c = wildComponent(second, true), d = wildComponent(second, true);
        tally.claim(isSame(mergeComponents(a, b), mergeComponents(c, d)), seed);
        tally.claim(mergePrice(a, b) == mergePrice(c, d) && std::abs(mergePrice(a, b)) <= 1.0, seed);
        tally.claim(componentSlope(a) == componentSlope(c), seed);
        tally.claim(std::abs(componentSlope(a).x) <= 1.0 && std::abs(componentSlope(a).y) <= 1.0, seed);
        tally.claim(componentResidual(a, Vec2<double>(3.0, -3.0)) == componentResidual(c, Vec2<double>(1.0, -1.0)),
                    seed);
        tally.claim(isSame(moveComponent(a, Vec2<double>(-400.0, 400.0), -2.0),
                           moveComponent(c, Vec2<double>(-256.0, 256.0), 0.0)),
                    seed);
        Mixture<double> wild{{a, b, a, b}};
        Mixture<double> tame{{c, d, c, d}};
        insertComponent(wild, b, 9);
        insertComponent(tame, d, 4);
        simplifyMixture(wild, 9);
        simplifyMixture(tame, 4);
        for (int i = 0; i < 4; ++i)
            tally.claim(isSame(wild.components[i], tame.components[i]), seed, i);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("components beyond the count are neither read nor changed")
{
    const MixtureComponent<double> beyond = tap(0.5, 1.0, 1.0, 0.9);
    Mixture<double> mixture{{tap(0.25, 0.0, 0.0, 0.1), tap(0.25, 0.0, 0.0, 0.6), beyond, beyond}};
    insertComponent(mixture, tap(0.25, 0.0, 0.0, 0.65), 2);
    CHECK(mixture.components[1].weight == 0.5);
    simplifyMixture(mixture, 2);
    CHECK(mixture.components[0].weight == 0.25);
    CHECK(mixture.components[1].weight == 0.5);
    CHECK(isSame(mixture.components[2], beyond));
    CHECK(isSame(mixture.components[3], beyond));
}

TEST_CASE("simplifyMixture sees the whole where no pair shows it: rough taps at the corners of a steep plane")
{
    Mixture<double> mixture{};
    int i = 0;
    for (const Vec2<double> at : {Vec2<double>(1, 1), Vec2<double>(-1, 1), Vec2<double>(1, -1), Vec2<double>(-1, -1)})
    {
        mixture.components[i] = tap(0.25, at.x, at.y, 0.5 + 0.03 * at.x);
        mixture.components[i++].variance = 1.0e-4;
    }
    CHECK(mergePrice(mixture.components[0], mixture.components[1]) > 1.0e-4);
    simplifyMixture(mixture, 4);
    CHECK(mixture.components[0].weight == 1.0);
    CHECK(mixture.components[1].weight == 0.0);
}

TEST_CASE("a whole of which no pair is one surface is one where that costs less than 1e-4")
{
    for (const double price : {0.75e-4, 1.5e-4})
    {
        // Rough taps at the corners of a steep plane, each off it by bend: merged they deviate by that as well.
        const double before = std::sqrt(1.0e-4 + 1.0e-8);
        const double bend = std::sqrt((before + price) * (before + price) - before * before);
        Mixture<double> mixture{};
        for (int i = 0; i < 4; ++i)
        {
            const double x = i % 2 == 0 ? 1.0 : -1.0;
            const double y = i / 2 == 0 ? 1.0 : -1.0;
            mixture.components[i] = tap(0.25, x, y, 0.5 + 0.03 * x + bend * x * y);
            mixture.components[i].variance = 1.0e-4;
        }
        simplifyMixture(mixture, 4);
        CHECK((mixture.components[0].weight == 1.0) == (price < 1.0e-4));
    }
}

TEST_CASE("taps and slopes end where their ranges do")
{
    CHECK(
        isSame(tapComponent(0.25), MixtureComponent<double>{1.0, {0.0, 0.0}, 0.25, {0.0, 0.0, 0.0}, {0.0, 0.0}, 0.0}));
    CHECK(isSame(tapComponent(-2.0), tapComponent(0.0)));
    CHECK(isSame(tapComponent(2.0), tapComponent(1.0)));
    CHECK(isSame(slopedComponent(-2.0, Vec2<double>(-3.0, 3.0)), slopedComponent(0.0, Vec2<double>(-1.0, 1.0))));
    CHECK(isSame(slopedComponent(2.0, Vec2<double>(3.0, -3.0)), slopedComponent(1.0, Vec2<double>(1.0, -1.0))));
    MixtureComponent<double> steep = tapComponent(0.5);
    steep.spread = {1.0, 0.0, 1.0};
    steep.tilt = {200.0, -200.0};
    CHECK(componentSlope(steep) == Vec2<double>(1.0, -1.0));
    steep.tilt = {-200.0, 200.0};
    CHECK(componentSlope(steep) == Vec2<double>(-1.0, 1.0));
    const MixtureComponent<double> none = mergeComponents(tap(0.0, 1.0, 2.0, 0.3), tap(0.0, 5.0, 5.0, 0.6));
    CHECK(isSame(none, tap(0.0, 1.0, 2.0, 0.3)));
}

TEST_CASE("a component's own deviation is no cost of merging it")
{
    // The two flat ones would cost 0.025; the rough one, a deviation of 0.1 at the first's depth, costs 0.0104 with it.
    MixtureComponent<double> rough = tap(0.25, 0.0, 0.0, 0.2);
    rough.variance = 0.01;
    Mixture<double> mixture{{tap(0.25, 0.0, 0.0, 0.2), tap(0.25, 0.0, 0.0, 0.3), {}, {}}};
    insertComponent(mixture, rough, 2);
    CHECK(mixture.components[0].weight == 0.5);
    CHECK(mixture.components[1].depth == 0.3);

    // Two rough ones of one depth are one, beside a third elsewhere.
    Mixture<double> three{{rough, tap(0.5, 0.0, 0.0, 0.9), rough, {}}};
    simplifyMixture(three, 4);
    CHECK(three.components[0].weight == 0.5);
    CHECK(three.components[2].weight == 0.0);
}

TEST_CASE("members count up to the ends of their ranges")
{
    MixtureComponent<double> c = tap(1.0, 0.0, 0.0, 0.5);
    c.variance = 0.75;
    CHECK(componentResidual(c, Vec2<double>(0.0, 0.0)) == 0.75);
    c.spread = {50000.0, 0.0, 0.0};
    CHECK(componentResidual(c, Vec2<double>(1.0, 0.0)) == 50000.75);
    CHECK(componentResidual(c, Vec2<double>(0.75, 0.0)) == 0.75 * 0.75 * 50000.0 + 0.75);
    CHECK(slopedComponent(0.5, Vec2<double>(-0.75, 0.75)).tilt.x == doctest::Approx(-0.0625));
    CHECK(slopedComponent(0.5, Vec2<double>(-0.75, 0.75)).tilt.y == doctest::Approx(0.0625));
    // Two whole windows at either end: a variance of 1/4 for the double weight.
    CHECK(mergePrice(tap(1.0, 0.0, 0.0, 0.0), tap(1.0, 0.0, 0.0, 1.0)) == doctest::Approx(1.0 - 2.0e-4).epsilon(1e-6));
    CHECK(mergePrice(tap(0.0, 0.0, 0.0, 0.0), tap(0.0, 0.0, 0.0, 1.0)) == 0.0);
}

TEST_CASE("components without weight change nothing, nor are they changed")
{
    MixtureComponent<double> none = tap(0.0, 3.0, 4.0, 0.25);
    none.spread = {1.0, 0.5, 2.0};
    CHECK(isSame(mergeComponents(none, tap(0.0, 1.0, 1.0, 0.75)), none));
    const double small = 0x1p-128;
    CHECK(mergeComponents(tap(small, 1.0, 1.0, 0.5), tap(small, 1.0, 1.0, 0.5)).weight == 0.0);

    const Mixture<double> before{{tap(0.5, 1.0, 0.0, 0.25), tap(0.0, 2.0, 0.0, 0.5), tap(0.25, 3.0, 0.0, 0.75), {}}};
    Mixture<double> mixture = before;
    insertComponent(mixture, none, 4);
    simplifyMixture(mixture, 4);
    Mixture<double> full{{before.components[0], before.components[2], before.components[0], before.components[2]}};
    const Mixture<double> whole = full;
    insertComponent(full, none, 4);
    for (int i = 0; i < 4; ++i)
    {
        CHECK(isSame(mixture.components[i], before.components[i]));
        CHECK(isSame(full.components[i], whole.components[i]));
    }
}

TEST_CASE("a count out of range is 1 or 4")
{
    for (const int count : {1, 0, -3})
    {
        MixtureComponent<double> wild = tap(0.25, 0.0, 0.0, 0.5);
        wild.weight = 7.0;
        Mixture<double> mixture{{tap(0.25, 0.0, 0.0, 0.5), wild, tap(0.25, 0.0, 0.0, 0.5), {}}};
        simplifyMixture(mixture, count);
        CHECK(mixture.components[0].weight == 0.25);
        CHECK(mixture.components[2].weight == 0.25);
        insertComponent(mixture, tap(0.25, 0.0, 0.0, 0.5), count);
        CHECK(mixture.components[0].weight == 0.5);
        CHECK(mixture.components[1].weight == 7.0);
        CHECK(mixture.components[2].weight == 0.25);
    }
    for (const int count : {4, 5, 100})
    {
        const MixtureComponent<double> quarter = tap(0.25, 0.0, 0.0, 0.5);
        Mixture<double> mixture{{quarter, quarter, quarter, quarter}};
        simplifyMixture(mixture, count);
        CHECK(mixture.components[0].weight == 1.0);
    }
    // The third is like the second, and not asked for.
    Mixture<double> three{{tap(0.25, 0.0, 0.0, 0.1), tap(0.25, 0.0, 0.0, 0.6), tap(0.25, 0.0, 0.0, 0.6), {}}};
    simplifyMixture(three, 2);
    CHECK(three.components[1].weight == 0.25);
    CHECK(three.components[2].weight == 0.25);
}

// Two halves d apart cost sqrt(d^2 / 4 + 1e-8) - 1e-4 to merge.
TEST_CASE("surfaces are one where that costs less than 1e-4, all or a pair of them")
{
    for (const double price : {0.75e-4, 1.5e-4})
    {
        const double apart = 2.0 * std::sqrt((price + 1.0e-4) * (price + 1.0e-4) - 1.0e-8);
        Mixture<double> whole{{tap(0.5, 0.0, 0.0, 0.25), tap(0.5, 0.0, 0.0, 0.25 + apart), {}, {}}};
        CHECK(mergePrice(whole.components[0], whole.components[1]) == doctest::Approx(price).epsilon(1e-6).scale(0));
        simplifyMixture(whole, 4);
        CHECK((whole.components[0].weight == 1.0) == (price < 1.0e-4));

        // Of a window with a third surface, the pair costs its share.
        const double part = 2.0 * std::sqrt((2.0 * price + 1.0e-4) * (2.0 * price + 1.0e-4) - 1.0e-8);
        Mixture<double> pair{
            {tap(0.25, 0.0, 0.0, 0.25), tap(0.25, 0.0, 0.0, 0.25 + part), tap(0.5, 0.0, 0.0, 0.75), {}}};
        CHECK(mergePrice(pair.components[0], pair.components[1]) == doctest::Approx(price).epsilon(1e-6).scale(0));
        simplifyMixture(pair, 4);
        CHECK((pair.components[0].weight == 0.5) == (price < 1.0e-4));
    }
}

} // namespace
} // namespace lvsm::unit
