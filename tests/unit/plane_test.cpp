// Receivers judged relative to their plane.
#include <lvsm/plane.hpp>

#include <doctest/doctest.h>

#include <initializer_list>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

// A filter window of samples a texel to the left and to the right of the receiver, half of the weight on each side:
// its deviation is 1, and the receiver's plane departs by its slope, up or down, wherever it is sampled.
struct SlantedWindow
{
    struct Sample
    {
        double side, depth, weight;
    };

    double slope = 0;
    std::vector<Sample> samples;

    // One depth on both sides, or one parallel to the receiver's plane; weights to the left and to the right.
    void add(double depth, double left, double right, bool isParallel)
    {
        samples.push_back({-1, isParallel ? depth - slope : depth, left});
        samples.push_back({1, isParallel ? depth + slope : depth, right});
    }

    Vec2<double> moments(const Vec2<double>& interval) const
    {
        Vec2<double> sums(0);
        for (const Sample& s : samples)
            sums += s.weight * layerMoments(s.depth, interval);
        return sums;
    }

    double covariance(const Vec2<double>& interval) const
    {
        double sum = 0;
        for (const Sample& s : samples)
            sum += s.weight * slope * s.side * layerWarp(s.depth, interval);
        return sum;
    }

    template <typename Counts>
    double share(const Counts& counts) const
    {
        double sum = 0;
        for (const Sample& s : samples)
            sum += counts(s) ? s.weight : 0;
        return sum;
    }

    // splits: begin of the layer in front, of the receiver's, its end, and the end of the layer behind.
    double visibility(const Vec4<double>& splits, double depth, double minVariance, double amount) const
    {
        const Vec2<double> front(splits.x, splits.y), own(splits.y, splits.z), behind(splits.z, splits.w);
        return planeBracketedVisibility(moments(front), moments(own), moments(behind),
                                        Vec3<double>(covariance(front), covariance(own), covariance(behind)), depth,
                                        own, planeVariance(Vec2<double>(slope, 0), 1.0), minVariance, amount);
    }
};

// The window's samples counted one by one: what is not in front of the receiver's plane is lit, and of what lies in
// the receiver's layer only what exceeds the amount.
double countedVisibility(const SlantedWindow& window, const Vec4<double>& splits, double depth, double amount)
{
    const auto inLayer = [&](const SlantedWindow::Sample& s)
    {
        return s.depth > splits.y && s.depth < splits.z;
    };
    const double behind = window.share([&](const auto& s) { return s.depth >= splits.z; });
    const double left = window.share(inLayer);
    const double lit =
        window.share([&](const auto& s) { return inLayer(s) && s.depth >= depth + window.slope * s.side - 1e-12; });
    return behind + left * std::max(0.0, (lit / left - amount) / (1 - amount));
}

// One depth in front of the receiver's layer, one behind it, and in it an occluder parallel to the receiver, each with
// other weights on the two sides, so that none of them has its middle at the receiver: relative to the plane two depths
// are left, which the bound meets. All moments and covariances are off by a few 2^-53, divided by shares and distances
// of a twentieth or more.
TEST_CASE("a slanted receiver sees what the window's samples show, whatever is in front of its layer and behind it")
{
    Random random(151);
    const auto between = [&](double low, double high)
    {
        return low + (high - low) * random.unit<double>();
    };
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        SlantedWindow window;
        window.slope = between(-0.01, 0.01);
        const double begin = between(0.2, 0.4), end = between(0.6, 0.8);
        const Vec4<double> splits(begin - 0.2, begin, end, end + 0.2);
        const double depth = begin + (end - begin) * between(0.6, 0.9);
        const double depths[] = {begin - 0.2 * between(0.4, 1.1), depth - (end - begin) * between(0.3, 0.5), depth,
                                 end + 0.2 * between(0.4, 1.1)};
        // One of the four has much of the window on both sides.
        const int most = random.between(0, 3);
        double weights[2][4];
        for (auto& side : weights)
        {
            double sum = 0;
            for (double& weight : side)
                sum += weight = between(0.2, 1.0) * (&weight - side == most ? 8 : 1);
            for (double& weight : side)
                weight *= 0.5 / sum;
        }
        for (int k = 0; k < 4; ++k)
            window.add(depths[k], weights[0][k], weights[1][k], k == 1 || k == 2);
        for (const double amount : {0.0, 0.15})
        {
            const double seen = window.visibility(splits, depth, 0.0, amount);
            const double counted = countedVisibility(window, splits, depth, amount);
            tally.claim(std::abs(seen - counted) < 1e-9, window.slope, begin, end, depth, amount, seen, counted);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

// The same where next to nothing is in front, behind or left: down to a thousandth each is still told exactly.
TEST_CASE("a slanted receiver sees what the samples show where a share or a neighbour's depth is near a thousandth")
{
    const Vec4<double> splits(0, 0.25, 0.75, 1);
    SlantedWindow window;
    window.slope = 1e-4;
    // In front by 1/250 of the neighbour, behind by 1/125, each for half of the window and more on one side; the mean
    // of the neighbours is 0.002 off the split.
    window.add(0.25 * (1 - 1.0 / 250), 0.3, 0.2, false);
    window.add(0.75 + 0.25 / 125, 0.12, 0.13, false);
    window.add(0.4, 0.03, 0.12, true);
    window.add(0.6, 0.05, 0.05, true);
    CHECK(window.visibility(splits, 0.6, 0.0, 0.0) ==
          doctest::Approx(countedVisibility(window, splits, 0.6, 0.0)).epsilon(1e-7));
    // Of the window 0.0015 is left in the layer.
    SlantedWindow few;
    few.slope = 1e-5;
    few.add(0.1, 0.2, 0.3 - 0.0015 / 2, false);
    few.add(0.9, 0.3, 0.2 - 0.0015 / 2, false);
    few.add(0.4, 0, 0.0015 / 2, true);
    few.add(0.6, 0, 0.0015 / 2, true);
    CHECK(few.visibility(splits, 0.6, 0.0, 0.0) ==
          doctest::Approx(countedVisibility(few, splits, 0.6, 0.0)).epsilon(1e-9));
}

// All of the window on one plane, parallel to the receiver's and a few of its deviations in front of it: the plane
// itself has no variance left, and what lights the receiver is the floor.
TEST_CASE("the floor is a tenth of the plane's variance, or minVariance where that is more")
{
    for (const double slope : {0.002, 0.01})
    {
        for (const double deviations : {1.0, 2.0, 3.0})
        {
            SlantedWindow window;
            window.slope = slope;
            window.add(0.5 - deviations * slope, 0.5, 0.5, true);
            const Vec4<double> splits(0, 0.25, 0.75, 1);
            const double squared = deviations * deviations;
            CHECK(window.visibility(splits, 0.5, 0.0, 0.0) == doctest::Approx(0.1 / (0.1 + squared)).epsilon(1e-6));
            CHECK(window.visibility(splits, 0.5, 0.05 * slope * slope, 0.0) ==
                  doctest::Approx(0.1 / (0.1 + squared)).epsilon(1e-6));
            CHECK(window.visibility(splits, 0.5, 0.7 * slope * slope, 0.0) ==
                  doctest::Approx(0.7 / (0.7 + squared)).epsilon(1e-6));
        }
    }
}

TEST_CASE_TEMPLATE("a lit plane is fully lit, whatever its slope", T, float, double)
{
    for (const double slope : {0.0, 0.001, 0.01, 0.05})
    {
        SlantedWindow window;
        window.slope = slope;
        window.add(0.5, 0.5, 0.5, true);
        CHECK(window.visibility({0, 0, 1, 1}, 0.5, 1e-6, 0.15) == doctest::Approx(1.0).epsilon(1e-5));
    }
}

// What a neighbour tells of the departure is its covariance over its mean distance from the split. Under a thousandth
// that is rounding, and the covariance counts in proportion.
TEST_CASE("a neighbour's mean within a thousandth of the split counts as a thousandth")
{
    const Vec2<double> own(0.5, 0.4), interval(0.25, 0.75);
    const auto seen = [&](const Vec2<double>& front, const Vec2<double>& behind, const Vec3<double>& covariances)
    {
        return planeBracketedVisibility(front, own, behind, covariances, 0.6, interval, 0.0, 0.0, 0.0);
    };
    // Moments of a fifth of the window at one depth, whose mean distance from the split is given.
    const auto before = [](double distance)
    {
        return Vec2<double>(1 - distance, 1 - 2 * distance + 5 * distance * distance);
    };
    const auto beyond = [](double distance)
    {
        return Vec2<double>(distance, 5 * distance * distance);
    };
    const Vec2<double> none(1.0), nothing(0.0);
    const double c = 1e-4;
    const double front = seen(before(0.001), nothing, {c, 0, 0});
    CHECK(seen(before(0.0005), nothing, {c, 0, 0}) == doctest::Approx(front).epsilon(1e-9));
    CHECK(seen(before(0.002), nothing, {2 * c, 0, 0}) == doctest::Approx(front).epsilon(1e-9));
    CHECK(std::abs(seen(before(0.002), nothing, {c, 0, 0}) - front) > 1e-4);
    const double behind = seen(none, beyond(0.001), {0, 0, c});
    CHECK(seen(none, beyond(0.0005), {0, 0, c}) == doctest::Approx(behind).epsilon(1e-9));
    CHECK(seen(none, beyond(0.002), {0, 0, 2 * c}) == doctest::Approx(behind).epsilon(1e-9));
    CHECK(std::abs(seen(none, beyond(0.002), {0, 0, c}) - behind) > 1e-4);
}

// Far beyond what a window can hold, where the result still tells one value from another.
TEST_CASE("covariances beyond 1 count as 1, a variance beyond [0,1] as its end, and moments are those of depths")
{
    struct Case
    {
        Vec2<double> front, own, behind;
        Vec3<double> covariances;
        double length, variance;
    };
    const auto seen = [](const Case& c, double size)
    {
        return planeBracketedVisibility(c.front, c.own, c.behind, size * c.covariances, c.length,
                                        Vec2<double>(0, c.length), c.variance, 0.25 * c.length * c.length, 0.0);
    };
    const Vec2<double> none(1), nothing(0), near(0.9, 0.81), beyond(0.25, 0.0625);
    for (const Case& c :
         {Case{{0.5, 0.5}, {0, 0}, nothing, {1, 0, 0}, 1, 0}, Case{near, {0, 0}, nothing, {-1, 0, 0}, 1, 0},
          Case{none, {0.8, 0.7}, nothing, {0, 1, 0}, 0.25, 1}, Case{none, {0.8, 0.7}, nothing, {0, -1, 0}, 1, 0},
          Case{none, {0.06, 0.05}, beyond, {0, 0, 1}, 1, 0}, Case{none, {0.25, 0.2}, beyond, {0, 0, -1}, 1, 0}})
    {
        CAPTURE(c.covariances.x);
        CAPTURE(c.covariances.y);
        CAPTURE(c.covariances.z);
        CHECK(seen(c, 5) == seen(c, 1));
        CHECK(std::abs(seen(c, 0.75) - seen(c, 1)) > 1e-4);
    }

    const auto spread = [&](double variance)
    {
        return planeBracketedVisibility(none, Vec2<double>(0.8, 0.7), nothing, Vec3<double>(0), 0.95,
                                        Vec2<double>(0, 1), variance, 0.0, 0.0);
    };
    CHECK(spread(5) == spread(1));
    CHECK(spread(1) > spread(0.75));
    CHECK(spread(-1) == spread(0));
    CHECK(spread(0.01) > spread(0));

    const auto neighbours = [&](const Vec2<double>& front, const Vec2<double>& behind)
    {
        return planeBracketedVisibility(front, Vec2<double>(0.5, 0.4), behind, Vec3<double>(0.05, 0, 0.05), 1.0,
                                        Vec2<double>(0, 1), 0.0, 0.01, 0.0);
    };
    CHECK(neighbours({-3, 0}, nothing) == neighbours({0, 0}, nothing));
    CHECK(neighbours(none, {3, 1}) == neighbours(none, {1, 1}));
}

TEST_CASE("an interval's length counts as 2^-10 at least")
{
    const Vec2<double> own(0.5, 0.3);
    const auto seen = [&](double length, double covariance)
    {
        return planeBracketedVisibility(Vec2<double>(1), own, Vec2<double>(0), Vec3<double>(0, covariance, 0),
                                        0.5 + 0.75 * length, Vec2<double>(0.5, 0.5 + length), 0.0, 0.0, 0.0);
    };
    const double c = 0x1p-16;
    CHECK(seen(0x1p-12, c) == seen(0x1p-10, c));
    CHECK(seen(0x1p-9, 2 * c) == seen(0x1p-10, c));
    CHECK(seen(0x1p-9, c) > seen(0x1p-10, c));
    // And as 1 at most, which an interval that ends beyond 1 must not exceed.
    const auto wide = [&](double end)
    {
        return planeBracketedVisibility(Vec2<double>(1), own, Vec2<double>(0), Vec3<double>(0, 0.02, 0), 0.75 * end,
                                        Vec2<double>(0, end), 0.0, 0.0, 0.0);
    };
    CHECK(wide(2) == wide(1));
}

TEST_CASE_TEMPLATE("without slope it is bracketedBoundedVisibility", T, float, double)
{
    for (int i = 0; i < 200; ++i)
    {
        const T a = static_cast<T>((7 * i) % 19) / T(19);
        const T b = static_cast<T>((5 * i) % 23) / T(23);
        const Vec2<T> front(T(1) - T(0.5) * a, T(1) - T(0.6) * a);
        const Vec2<T> moments(b, b * b + T(0.5) * (b - b * b));
        const Vec2<T> behind(T(0.5) * b * a, T(0.4) * b * a);
        const T depth = T(0.25) + T(0.25) * static_cast<T>(i % 7) / T(7);
        const Vec2<T> interval(T(0.25), T(0.5));
        const T plain = bracketedBoundedVisibility(front, moments, behind, depth, interval, T(1e-5));
        const T plane =
            planeBracketedVisibility(front, moments, behind, Vec3<T>(T(0)), depth, interval, T(0), T(1e-5), T(0));
        // What is left can be next to nothing, which the one divides by and the other does not.
        CHECK(plane == doctest::Approx(plain).epsilon(1e-4).scale(0));
    }
}

TEST_CASE_TEMPLATE("planeCovariance is exact for a plane under any filter of that deviation", T, float, double)
{
    const Vec2<T> gradient(T(0.01), T(-0.02));
    const Vec4<T> neighbours(T(0.5) + gradient.x, T(0.5) - gradient.x, T(0.5) + gradient.y, T(0.5) - gradient.y);
    CHECK(planeCovariance(neighbours, gradient, T(1.5)) ==
          doctest::Approx(static_cast<double>(planeVariance(gradient, T(1.5)))).epsilon(1e-5));
}

TEST_CASE_TEMPLATE("planeVariance is that of the plane under a filter", T, float, double)
{
    // A binomial filter of 5 taps has the deviation 1.
    const T taps[] = {T(1) / 16, T(4) / 16, T(6) / 16, T(4) / 16, T(1) / 16};
    const Vec2<T> gradient(T(0.25), T(-0.5));
    T sum = 0;
    for (int y = -2; y <= 2; ++y)
    {
        for (int x = -2; x <= 2; ++x)
        {
            const T departure = gradient.x * T(x) + gradient.y * T(y);
            sum += taps[x + 2] * taps[y + 2] * departure * departure;
        }
    }
    CHECK(planeVariance(gradient, T(1)) == sum);
    CHECK(planeVariance(gradient, T(3)) == 9 * sum);
}

TEST_CASE_TEMPLATE("what exceeds its range is taken to its end in the plane's variance and covariance", T, float,
                   double)
{
    const Vec4<T> steps(1, 0, 1, 0), beyond(7, -5, 3, -2), back(-5, 7, -2, 3), none(T(0.5));
    CHECK(planeCovariance(beyond, Vec2<T>(1, 0), T(1)) == T(0.5));
    CHECK(planeCovariance(beyond, Vec2<T>(0, 1), T(1)) == T(0.5));
    CHECK(planeCovariance(back, Vec2<T>(1, 0), T(1)) == T(-0.5));
    CHECK(planeCovariance(back, Vec2<T>(0, 1), T(1)) == T(-0.5));
    CHECK(planeCovariance(none, Vec2<T>(1, 1), T(1)) == T(0));
    for (const T size : {T(1), T(3)})
    {
        CHECK(planeCovariance(steps, Vec2<T>(size, 0), T(1)) == T(0.5));
        CHECK(planeCovariance(steps, Vec2<T>(-size, 0), T(1)) == T(-0.5));
        CHECK(planeCovariance(steps, Vec2<T>(0, size), T(1)) == T(0.5));
        CHECK(planeCovariance(steps, Vec2<T>(0, -size), T(1)) == T(-0.5));
        for (const Vec2<T>& gradient : {Vec2<T>(size, 0), Vec2<T>(-size, 0), Vec2<T>(0, size), Vec2<T>(0, -size)})
            CHECK(planeVariance(gradient, T(1)) == T(1));
    }
    CHECK(planeCovariance(steps, Vec2<T>(1, 1), T(65536)) == T(4294967296));
    CHECK(planeCovariance(steps, Vec2<T>(1, 1), T(1e6)) == T(4294967296));
    CHECK(planeCovariance(steps, Vec2<T>(1, 1), T(-1)) == T(0));
    CHECK(planeVariance(Vec2<T>(1, 1), T(65536)) == T(8589934592));
    CHECK(planeVariance(Vec2<T>(1, 1), T(1e6)) == T(8589934592));
    CHECK(planeVariance(Vec2<T>(1, 1), T(-1)) == T(0));
}

} // namespace
} // namespace lvsm::unit
