#include <lvsm/bracket.hpp>
#include <lvsm/optimal.hpp>

#include <doctest/doctest.h>

#include "distributions.hpp"

namespace lvsm::unit
{
namespace
{

Vec2<double> momentsOf(const DepthWindow& window, double begin, double end)
{
    return window.mean([&](double depth) { return layerMoments(depth, Vec2<double>(begin, end)); });
}

// A layer with all that a bracketed estimate reads.
struct Bracket
{
    Vec2<double> front, moments, behind, interval;

    Bracket(const DepthWindow& window, const double* splits, int layer, int layerCount)
        : front(layer > 0 ? momentsOf(window, splits[layer - 1], splits[layer]) : Vec2<double>(1)),
          moments(momentsOf(window, splits[layer], splits[layer + 1])),
          behind(layer + 1 < layerCount ? momentsOf(window, splits[layer + 1], splits[layer + 2]) : Vec2<double>(0)),
          interval(splits[layer], splits[layer + 1])
    {
    }

    double visibility(double depth, double floor) const
    {
        return bracketedVisibility(front, moments, behind, depth, interval, floor);
    }
    double bounded(double depth, double floor) const
    {
        return bracketedBoundedVisibility(front, moments, behind, depth, interval, floor);
    }
};

// Rising splits on the grid.
int randomSplits(Random& random, double* splits)
{
    const int layerCount = random.between(1, 6);
    bool taken[DepthWindow::kSteps + 1] = {};
    for (int i = 1; i < layerCount; ++i)
        taken[random.between(1, DepthWindow::kSteps - 1)] = true;
    int count = 0;
    splits[0] = 0;
    for (int step = 1; step < DepthWindow::kSteps; ++step)
        if (taken[step])
            splits[++count] = step / double(DepthWindow::kSteps);
    splits[++count] = 1;
    return count;
}

// Warped depths are 1/32 or more and shares 1/161 or more, so that a mean off an end is over 2^-13. The moments are off
// by a few 2^-53, a share of a neighbour by under 2^-36, d by under 2^-35; against a floor of 2^-40 / length^2 that
// takes away at most 2^-70 / 2^-40.
constexpr double kFloor = 0x1p-40;
constexpr double kBracketRounding = 0x1p-29;

TEST_CASE("bracketed visibility bounds every distribution for any contiguous layers")
{
    Random random(111);
    Tally tally;
    for (int i = 0; i < drawsOf(1000000); ++i)
    {
        double splits[8];
        const int layerCount = randomSplits(random, splits);
        const DepthWindow window = DepthWindow::onGrid(random);
        const int step = random.between(0, DepthWindow::kSteps);
        const double depth = step / double(DepthWindow::kSteps);
        const Bracket bracket(window, splits, layerIndex(depth, splits, layerCount), layerCount);
        const double truth = window.tail(depth);
        const double visibility = bracket.visibility(depth, kFloor);
        const double bounded = bracket.bounded(depth, kFloor);
        tally.claim(visibility >= truth - kBracketRounding, depth, truth, visibility, layerCount);
        tally.claim(bounded >= truth - kBracketRounding, depth, truth, bounded, layerCount);
        tally.claim(bounded <= visibility, depth, bounded, visibility);
        const double layered = layeredVisibility(bracket.moments, depth, bracket.interval, kFloor);
        tally.claim(visibility <= layered + 0x1p-12, depth, visibility, layered);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("a placement made for one map gives bounded results on another")
{
    Random random(112);
    Tally tally;
    for (int map = 0; map < 50; ++map)
    {
        double depths[256];
        for (double& depth : depths)
            depth = std::pow(random.unit<double>(), 1.0 + map % 5);
        double splits[5];
        REQUIRE(optimalSplits(depths, 16, 16, splits, 4));
        for (int i = 0; i < 2000; ++i)
        {
            const DepthWindow window = DepthWindow::onGrid(random);
            const int step = random.between(0, DepthWindow::kSteps);
            const double depth = step / double(DepthWindow::kSteps);
            const Bracket bracket(window, splits, layerIndex(depth, splits, 4), 4);
            // The splits are off the grid now, and a sample can be as near to a split as rounding: hence the higher floor.
            const double visibility = bracket.visibility(depth, 1e-10);
            tally.claim(visibility >= window.tail(depth) - 1e-4 && visibility <= 1, depth, window.tail(depth),
                        visibility);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("bracketing is exact for a planar occluder, a planar receiver and what lies behind", T, float,
                   double)
{
    // Four uniform layers; a quarter of the window in front, a half at the receiver, a quarter behind.
    const T depths[] = {T(0.3), T(0.6), T(0.85)};
    const T shares[] = {T(0.25), T(0.5), T(0.25)};
    const auto moments = [&](T begin, T end)
    {
        Vec2<T> sums(0);
        for (int i = 0; i < 3; ++i)
            sums += shares[i] * layerMoments(depths[i], Vec2<T>(begin, end));
        return sums;
    };
    const Vec2<T> front = moments(T(0.25), T(0.5));
    const Vec2<T> own = moments(T(0.5), T(0.75));
    const Vec2<T> behind = moments(T(0.75), T(1));
    const Vec4<T> left = bracketMoments(front, own, behind, T(0));
    const Exact tolerance = 32 * kRoundoff<T>;
    CHECK(std::abs(Exact(left.x) - 0.25L) <= tolerance);
    CHECK(std::abs(Exact(left.y) - 0.5L) <= tolerance);
    CHECK(std::abs(Exact(left.z) - 0.5L * 0.4L) <= 2 * tolerance);
    CHECK(std::abs(Exact(left.w) - 0.5L * 0.16L) <= 2 * tolerance);
    const auto seen = [&](T depth, T minVariance)
    {
        return bracketedVisibility(front, own, behind, depth, Vec2<T>(T(0.5), T(0.75)), minVariance);
    };
    CHECK(seen(T(0.6), T(1e-6)) == doctest::Approx(0.75).epsilon(1e-4));
    // Between them and behind the receiver's plane, the window's own surfaces are all that is left to bound.
    CHECK(seen(T(0.55), T(1e-6)) == doctest::Approx(0.75).epsilon(1e-4));
    CHECK(seen(T(0.74), T(1e-8)) == doctest::Approx(0.25).epsilon(1e-3));
}

TEST_CASE_TEMPLATE("bracketing is exact where the paper's single layer is not", T, float, double)
{
    // Half the window at depth 0, half at 1: the receiver's layer alone has 0.96, see layers_test.
    const Vec2<T> half(T(0.5), T(0.5));
    const Vec2<T> interval(T(1) / T(3), T(2) / T(3));
    CHECK(layeredVisibility(half, T(0.52), interval, T(0)) > T(0.9));
    CHECK(bracketedVisibility(half, half, half, T(0.52), interval, T(0)) == T(0.5));
    CHECK(bracketedVisibility2(packLayers(half, half), T(0.52), T(0.5), T(0)) == T(0.5));
}

TEST_CASE_TEMPLATE("layers that overlap are no brackets: a lit surface goes dark", T, float, double)
{
    // All of the window at 0.55, the receiver in front of it at 0.52. The overlap makes the layer in front reach to 0.6,
    // where 0.55 counts as in front of the receiver's layer.
    const T surface = T(0.55);
    const Vec2<T> front = layerMoments(surface, layerInterval(T(0), T(0.5), T(0.1)));
    const Vec2<T> interval = layerInterval(T(0.5), T(1), T(0.1));
    const Vec2<T> own = layerMoments(surface, interval);
    CHECK(layeredVisibility(own, T(0.52), interval, T(1e-6)) == T(1));
    CHECK(bracketedVisibility(front, own, Vec2<T>(0), T(0.52), interval, T(1e-6)) < T(0.7));
    // Without overlap the same surface is lit.
    const Vec2<T> exact = layerMoments(surface, Vec2<T>(T(0.5), T(1)));
    CHECK(bracketedVisibility(Vec2<T>(1), exact, Vec2<T>(0), T(0.52), Vec2<T>(T(0.5), T(1)), T(1e-6)) == T(1));
}

TEST_CASE("the neighbours' variance floor keeps a flat surface on a split lit")
{
    // A surface at the split, which storage has moved in front of it by its rounding.
    const double e = 7.62951094e-6;
    const double floor = recommendedMinVariance(e, 0.01);
    const Vec2<double> front(1 - e, 1 - e);
    // In units of depth the floor of a layer half as long is a quarter.
    const Vec2<double> none(0);
    CHECK(bracketedVisibility(front, none, none, 0.5, Vec2<double>(0.5, 1.0), 0.25 * floor) >= 0.99);
    CHECK(bracketedVisibility2(packLayers(front, none), 0.5, 0.5, 0.25 * floor) >= 0.99);
}

TEST_CASE_TEMPLATE("one code of rounding in a neighbour hides no lit surface", T, float, double)
{
    // Nothing of weight in front, and the second moment rounded one code further down than the first.
    const Vec2<T> front(T(65534) / T(65535), T(65533) / T(65535));
    const Vec2<T> own(T(0.5), T(0.25));
    CHECK(bracketedVisibility(front, own, Vec2<T>(0), T(0.7), Vec2<T>(T(0.5), T(1)), T(1e-8)) > T(0.999));
    CHECK(bracketedVisibility2(packLayers(front, own), T(0.7), T(0.5), T(1e-8)) > T(0.999));
    CHECK(bracketMoments(front, own, Vec2<T>(0), T(0)).y < T(0.6));
}

// The window's own surface, at the receiver: no variance at all, and none is asked for.
TEST_CASE_TEMPLATE("a flat lit surface is lit without any floor, at the ends of its layer too", T, float, double)
{
    const T splits[] = {T(0), T(0.25), T(0.5), T(0.75), T(1)};
    for (int step = 0; step <= 16; ++step)
    {
        const T depth = T(step) / T(16);
        const int layer = layerIndex(depth, splits, 4);
        const auto seen = [&](int i)
        {
            return i < 0 ? Vec2<T>(1) : i > 3 ? Vec2<T>(0) : layerMoments(depth, Vec2<T>(splits[i], splits[i + 1]));
        };
        const Vec2<T> interval(splits[layer], splits[layer + 1]);
        CAPTURE(depth);
        CHECK(bracketedVisibility(seen(layer - 1), seen(layer), seen(layer + 1), depth, interval, T(0)) == T(1));
        CHECK(bracketedBoundedVisibility(seen(layer - 1), seen(layer), seen(layer + 1), depth, interval, T(0)) == T(1));
        const Vec4<T> texel =
            packLayers(layerMoments(depth, Vec2<T>(0, T(0.5))), layerMoments(depth, Vec2<T>(T(0.5), 1)));
        CHECK(bracketedVisibility2(texel, depth, T(0.5), T(0)) == T(1));
    }
}

// A receiver at the layer's begin has nothing of the layer in front of it, whatever is left there.
TEST_CASE_TEMPLATE("at its begin all that is left in a layer is lit", T, float, double)
{
    const Vec2<T> front(T(0.5), T(0.5)), own(T(0.25), T(0.125)), interval(T(0.5), T(1));
    // Half is in front; the other half is in the layer.
    CHECK(bracketedBoundedVisibility(front, own, Vec2<T>(0), T(0.5), interval, T(0)) == T(0.5));
    CHECK(bracketedVisibility(front, own, Vec2<T>(0), T(0.5), interval, T(0)) == T(0.5));
    CHECK(bracketedBoundedVisibility(front, own, Vec2<T>(0), T(0.25), interval, T(0.25)) == T(0.5));
}

// Neighbours from another window, or overlapping, can claim more than the layer's own moments leave room for.
TEST_CASE_TEMPLATE("no more is in front or behind than the layer's own moments allow", T, float, double)
{
    const Vec2<T> own(T(0.75), T(0.625)), all(0), none(1);
    const Vec4<T> dark = bracketMoments(all, own, all, T(0));
    CHECK(dark == Vec4<T>(0, T(0.75), T(0.75), T(0.625)));
    const Vec4<T> lit = bracketMoments(none, own, none, T(0));
    CHECK(lit == Vec4<T>(T(0.625), T(0.375), T(0.125), 0));
    // Both at once: what is behind keeps its share of it all.
    CHECK(bracketMoments(all, own, none, T(0)) == Vec4<T>(T(0.625), T(0.125), T(0.125), 0));
}

// A share in front is the squared mean off the split over the mean square. Rounding to unorm16 moves the first moment
// by half a step e, and with it the second, counted from the split, by 3 e at most: a share at a mean square of s is
// overstated by 1 / (1 - 3 e / s). The floor lets no share be overstated whose s is less: (1/64)^2 makes it 1.11 at most,
// half of that 1.23.
TEST_CASE("rounding to unorm16 overstates no share in front by more than an eighth")
{
    const double e = 0.5 / 65535;
    Tally tally;
    for (int i = 1; i <= 64; ++i)
    {
        const double share = i / 64.0;
        for (int k = 1; k <= 1024; ++k)
        {
            const double distance = k / 1024.0;
            const double mean = share * distance, square = share * distance * distance;
            for (const double first : {-e, 0.0, e})
            {
                for (const double second : {-e, 0.0, e})
                {
                    // The front's moments are 1 - mean and 1 - 2 mean + square.
                    const Vec2<double> front(1 - mean + first, 1 - 2 * mean + square + second);
                    const Vec4<double> left =
                        bracketMoments(front, Vec2<double>(0), Vec2<double>(0), kNeighbourMinVariance<double>);
                    tally.claim(1 - left.y <= 1.125 * share + 1e-5, share, distance, first, second, 1 - left.y);
                }
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("with all of the depth in one layer the bounded estimate is boundedUpperBound")
{
    Random random(118);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const double t = random.unit<double>();
        const double floor = i % 3 == 0 ? 0.0 : 0.25 * random.unit<double>() * random.unit<double>();
        const Vec2<double> moments = momentsOf(DepthWindow::onGrid(random), 0, 1);
        const double bounded =
            bracketedBoundedVisibility(Vec2<double>(1), moments, Vec2<double>(0), t, Vec2<double>(0, 1), floor);
        const double bound = boundedUpperBound(moments, t, floor);
        tally.claim(std::abs(bounded - bound) < 1e-9, moments.x, moments.y, t, floor, bounded, bound);
    }
    LVSM_CHECK_TALLY(tally);
}

// What is left is bounded as its own mean moments are, and what is behind is lit.
TEST_CASE("the bounded estimate bounds what is left as boundedUpperBound does its mean")
{
    Random random(119);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const DepthWindow window = DepthWindow::onGrid(random);
        const double splits[] = {0, 0.25, 0.75, 1};
        const double t = 0.26 + 0.48 * random.unit<double>();
        const Bracket bracket(window, splits, 1, 3);
        const double floor = 0.01 * random.unit<double>();
        const double own = layerMinVariance(floor, bracket.interval);
        const Vec4<double> left = bracketMoments(bracket.front, bracket.moments, bracket.behind,
                                                 std::max(own, kNeighbourMinVariance<double>));
        if (left.y < 1e-3)
            continue;
        const Vec2<double> mean(left.z / left.y, left.w / left.y);
        const double bound = boundedUpperBound(mean, layerWarp(t, bracket.interval), own / left.y);
        // A floor of more than 1/4 over what is left says nothing more than that.
        if (own / left.y <= 1)
            tally.claim(std::abs(bracket.bounded(t, floor) - (left.x + left.y * bound)) < 1e-9, t, floor, left.y,
                        bracket.bounded(t, floor), left.x + left.y * bound);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("what exceeds its range is taken to its end in what layers are made of", T, float, double)
{
    const Vec2<T> a(T(0.5), T(0.375)), b(T(0.25), T(0.125)), none(1), nothing(0);
    CHECK(mergeLayers(a, b, T(3), T(0.5)) == mergeLayers(a, b, T(1), T(0.5)));
    CHECK(mergeLayers(a, b, T(-3), T(0.5)) == mergeLayers(a, b, T(0), T(0.5)));
    CHECK(mergeLayers(a, b, T(0.5), T(3)) == mergeLayers(a, b, T(0.5), T(1)));
    CHECK(mergeLayers(a, b, T(0.5), T(-3)) == mergeLayers(a, b, T(0.5), T(0)));
    CHECK(mergeLayers(a, b, T(0.5), T(-0.25)) == mergeLayers(a, b, T(0.5), T(0)));
    CHECK(compactMoments(Vec2<T>(T(0.125), T(-2))) == compactMoments(Vec2<T>(T(0.125), T(0))));
    CHECK(expandMoments(Vec2<T>(T(0.75), T(3))) == expandMoments(Vec2<T>(T(0.75), T(1))));
    CHECK(expandMoments(Vec2<T>(T(0.75), T(-3))) == expandMoments(Vec2<T>(T(0.75), T(0))));
    const Vec2<T> own(T(0.5), T(0.375)), front(T(0.75), T(0.6875)), behind(T(0.25), T(0.1875));
    const auto seen = [&](const Vec2<T>& f, const Vec2<T>& r, T floor)
    {
        return bracketMoments(f, own, r, floor);
    };
    CHECK(seen(front, behind, T(-3)) == seen(front, behind, T(0)));
    CHECK(seen(front, behind, T(3)) == seen(front, behind, T(1)));
    CHECK(seen(front, behind, T(0.75)) != seen(front, behind, T(1)));
    CHECK(seen(Vec2<T>(-1, T(0.5)), behind, T(1)) == seen(Vec2<T>(0, T(0.5)), behind, T(1)));
    CHECK(seen(Vec2<T>(3, T(0.5)), behind, T(1)) == seen(Vec2<T>(1, T(0.5)), behind, T(1)));
    CHECK(seen(Vec2<T>(T(0.25), T(-1)), behind, T(0)) == seen(Vec2<T>(T(0.25), T(0)), behind, T(0)));
    CHECK(seen(Vec2<T>(T(0.25), T(3)), behind, T(0)) == seen(Vec2<T>(T(0.25), T(1)), behind, T(0)));
    CHECK(seen(front, Vec2<T>(3, T(1)), T(1)) == seen(front, Vec2<T>(1, T(1)), T(1)));
    CHECK(seen(front, Vec2<T>(-1, T(1)), T(0)) == seen(front, Vec2<T>(0, T(1)), T(0)));
    const Vec4<T> texel(T(0.75), T(0.6875), T(0.25), T(0.1875));
    CHECK(bracketedVisibility2(texel, T(0.5), T(3), T(0.001)) == bracketedVisibility2(texel, T(0.5), T(1), T(0.001)));
    CHECK(bracketedVisibility2(texel, T(0.5), T(-3), T(0.001)) == bracketedVisibility2(texel, T(0.5), T(0), T(0.001)));
    CHECK(bracketedVisibility2(texel, T(0.9), T(3), T(0.001)) == bracketedVisibility2(texel, T(0.9), T(1), T(0.001)));
    // Where the layer itself is nearly all in front or behind, a neighbour's share is not cut off by that.
    const Vec2<T> nearlyFront(T(0.125), T(0.1)), nearlyBehind(T(0.9), T(0.875)), out(-1, T(0.5)), beyond(3, 1);
    CHECK(bracketMoments(out, nearlyFront, nothing, T(1)) ==
          bracketMoments(Vec2<T>(0, T(0.5)), nearlyFront, nothing, T(1)));
    CHECK(bracketMoments(none, nearlyBehind, beyond, T(1)) == bracketMoments(none, nearlyBehind, none, T(1)));
    CHECK(seen(Vec2<T>(T(0.75), T(0.5)), behind, T(-3)) == seen(Vec2<T>(T(0.75), T(0.5)), behind, T(0)));
    // Two layers in one texel, whose moments a filter may take out of [0,1] as well.
    const auto ofTwo = [](T x, T y, T z, T w, T depth)
    {
        return bracketedVisibility2(Vec4<T>(x, y, z, w), depth, T(0.5), T(0.05));
    };
    const T z = T(0.25), w = T(0.1875);
    CHECK(ofTwo(-1, 0, z, w, T(0.875)) == ofTwo(0, 0, z, w, T(0.875)));
    CHECK(ofTwo(0, 1, z, w, T(0.875)) == ofTwo(0, 0, z, w, T(0.875)));
    CHECK(ofTwo(z, w, T(-0.5), T(0.25), T(0.375)) == ofTwo(z, w, 0, T(0.25), T(0.375)));
    CHECK(ofTwo(z, w, 3, w, T(0.375)) == ofTwo(z, w, 2, w, T(0.375)));
    CHECK(ofTwo(z, w, 1, 9, T(0.375)) == ofTwo(z, w, 1, 4, T(0.375)));
    CHECK(mergedVisibility(a, b, T(0.5), T(0.25), T(0.375), T(0.75), T(0)) ==
          layeredVisibility(mergeLayers(a, b, T(0.125), T(0.375)), T(0.5), Vec2<T>(T(0.25), T(0.75)), T(0)));
}

// Half of the window a 32nd of a layer beyond the split: the variance of that is the floor, (1/64)^2.
TEST_CASE_TEMPLATE("what is a 32nd of a layer beyond the split is told apart", T, float, double)
{
    const T distance = T(1) / T(32);
    const Vec2<T> behind(distance / 2, distance * distance / 2);
    const Vec2<T> front(1 - behind.x, 1 - 2 * behind.x + behind.y);
    CHECK(bracketedVisibility(front, Vec2<T>(T(0.25), T(0.125)), Vec2<T>(0), T(0.75), Vec2<T>(T(0.5), T(1)), T(0)) ==
          T(0.5));
    CHECK(bracketedBoundedVisibility(front, Vec2<T>(T(0.25), T(0.125)), Vec2<T>(0), T(0.75), Vec2<T>(T(0.5), T(1)),
                                     T(0)) == T(0.5));
    // Half lies a little behind the layer and half in front of it, at its begin.
    CHECK(bracketedVisibility(Vec2<T>(1), Vec2<T>(T(0.5)), behind, T(0.4), Vec2<T>(T(0.25), T(0.5)), T(0)) == T(0.5));
    const Vec4<T> texel = packLayers(front, Vec2<T>(T(0.25), T(0.125)));
    CHECK(bracketedVisibility2(texel, T(0.75), T(0.5), T(0)) == T(0.5));
}

TEST_CASE("contiguous layers contain every coarser layering exactly")
{
    Random random(113);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        double splits[8];
        const int layerCount = randomSplits(random, splits);
        const DepthWindow window = DepthWindow::onGrid(random);
        Vec2<double> merged = momentsOf(window, splits[0], splits[1]);
        for (int layer = 1; layer < layerCount; ++layer)
        {
            merged = mergeLayers(merged, momentsOf(window, splits[layer], splits[layer + 1]), splits[layer],
                                 splits[layer + 1] - splits[layer]);
            const Vec2<double> whole = momentsOf(window, 0.0, splits[layer + 1]);
            // A dozen roundings of numbers up to 1 for each of up to six layers.
            tally.claim(std::abs(merged.x - whole.x) < 72 * 0x1p-53 && std::abs(merged.y - whole.y) < 72 * 0x1p-53,
                        merged.x, whole.x, merged.y, whole.y);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("mergeLayers of empty layers changes nothing", T, float, double)
{
    const Vec2<T> moments(T(0.25), T(0.125));
    CHECK(mergeLayers(moments, Vec2<T>(0), T(0), T(0)) == moments);
    CHECK(mergeLayers(moments, moments, T(0.5), T(0)) == moments);
    CHECK(mergeLayers(Vec2<T>(1), moments, T(0), T(0.5)) == moments);
}

TEST_CASE("bracketedVisibility2 is bracketedVisibility for two layers")
{
    Random random(114);
    Tally tally;
    for (int i = 0; i < drawsOf(200000); ++i)
    {
        const DepthWindow window = DepthWindow::onGrid(random);
        const double splits[] = {0, random.between(4, 28) / 32.0, 1};
        const double depth = random.unit<double>();
        const Vec4<double> texel = packLayers(momentsOf(window, 0.0, splits[1]), momentsOf(window, splits[1], 1.0));
        const Bracket bracket(window, splits, layerIndex(depth, splits, 2), 2);
        // The floor reaches up to the largest variance in the receiver's layer.
        const double length = depth < splits[1] ? splits[1] : 1 - splits[1];
        const double floor = 1e-6 * std::pow(0.25 * length * length / 1e-6, random.unit<double>());
        const double two = bracketedVisibility2(texel, depth, splits[1], floor);
        const double general = bracket.visibility(depth, floor);
        // d is off by a few 2^-53 against a least d or deviation of 1e-3.
        tally.claim(std::abs(two - general) < 1e-9, depth, splits[1], two, general);
        // A receiver at the split belongs to the layer behind it.
        const Bracket second(window, splits, 1, 2);
        const double atSplit = bracketedVisibility2(texel, splits[1], splits[1], kFloor);
        tally.claim(std::abs(atSplit - second.visibility(splits[1], kFloor)) < 1e-9, splits[1], atSplit);
        const double last = bracketedVisibility2(texel, 1.0, splits[1], floor);
        const double beyond = bracketedVisibility2(texel, 1 + depth, splits[1], floor);
        tally.claim(beyond >= 0 && beyond <= last, depth, splits[1], beyond, last);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("blending to the union of two layers leaves no seam at their split")
{
    Random random(115);
    Tally tally;
    double largest = 0;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const DepthWindow window = DepthWindow::onGrid(random);
        const double splits[] = {0, 0.5, 1};
        const auto seen = [&](double depth)
        {
            const int layer = layerIndex(depth, splits, 2);
            const Bracket bracket(window, splits, layer, 2);
            const double merged =
                mergedVisibility(momentsOf(window, 0.0, 0.5), momentsOf(window, 0.5, 1.0), depth, 0.0, 0.5, 1.0, 1e-4);
            const double weight = transitionWeight(depth, splits[layer], splits[layer + 1], 0.1);
            tally.claim(merged >= window.tail(depth) - 1e-9, depth, merged);
            const double visibility = bracket.visibility(depth, 1e-4);
            return Vec2<double>(visibility, blendTransition(visibility, merged, 2 * weight));
        };
        const Vec2<double> inFront = seen(std::nextafter(0.5, 0.0));
        const Vec2<double> behind = seen(0.5);
        largest = std::max(largest, std::abs(inFront.x - behind.x));
        // The union's slope over depth is at most 1 / sqrt(1e-4), times one unit in the last place.
        tally.claim(std::abs(inFront.y - behind.y) < 1e-12, inFront.y, behind.y);
    }
    LVSM_CHECK_TALLY(tally);
    CHECK_MESSAGE(largest > 1.0 / 255, "without the blend there is a seam that eight bits show");
}

TEST_CASE_TEMPLATE("compactMoments come back, and fill the unit interval", T, float, double)
{
    Random random(116);
    Tally tally;
    T least = 1, most = 0;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec2<T> moments = GridDistribution(random).moments<T>();
        const Vec2<T> compact = compactMoments(moments);
        // Differences and products by 4 of grid numbers are exact.
        tally.claim(expandMoments(compact) == moments, moments.x, moments.y);
        least = std::min(least, compact.y);
        most = std::max(most, compact.y);
    }
    LVSM_CHECK_TALLY(tally);
    CHECK(least == T(0));
    CHECK(most == T(1));
    CHECK(compactMoments(Vec2<T>(1, 1)) == Vec2<T>(1, 0));
    CHECK(compactMoments(Vec2<T>(0, 0)) == Vec2<T>(0, 0));
}

// With each component off by at most e the variance m1 (1 - m1) - d / 4 is off by (|1 - 2 m1| + 1/4) e at first order,
// where M2 - M1^2 is off by (2 m1 + 1) e.
TEST_CASE("compactMoments keep the variance better in eight bits")
{
    Random random(117);
    const auto unorm8 = [](const Vec2<double>& v)
    {
        return Vec2<double>(std::round(v.x * 255) / 255, std::round(v.y * 255) / 255);
    };
    const auto spread = [](const Vec2<double>& m)
    {
        return m.y - m.x * m.x;
    };
    const double e = 0.5 / 255;
    Tally tally;
    double plain = 0, compact = 0;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec2<double> moments = GridDistribution(random).moments<double>();
        const double error = spread(expandMoments(unorm8(compactMoments(moments)))) - spread(moments);
        const double allowed = (std::abs(1 - 2 * moments.x) + 0.25) * e + e * e + 1e-15;
        tally.claim(std::abs(error) <= allowed, moments.x, moments.y, error);
        compact += error * error;
        const double direct = spread(unorm8(moments)) - spread(moments);
        plain += direct * direct;
    }
    LVSM_CHECK_TALLY(tally);
    CHECK(compact < 0.5 * plain);
}

} // namespace
} // namespace lvsm::unit
