#include <lvsm/layers.hpp>

#include <doctest/doctest.h>

#include "distributions.hpp"

namespace lvsm::unit
{
namespace
{

constexpr int kSteps = GridDistribution::kSteps;

// Splits and their layers, as a renderer keeps them.
template <typename T>
struct Layering
{
    std::vector<T> splits;
    T overlap;

    int count() const { return static_cast<int>(splits.size()) - 1; }
    Vec2<T> interval(int layer) const
    {
        return layerInterval(splits[static_cast<std::size_t>(layer)], splits[static_cast<std::size_t>(layer) + 1],
                             overlap);
    }
};

template <typename T>
Layering<T> randomLayering(Random& random, int layers)
{
    Layering<T> layering{{T(0), T(1)}, random.between(0, 1) == 0 ? T(0) : random.unit<T>() / 16};
    for (int i = 1; i < layers; ++i)
        layering.splits.push_back(random.unit<T>());
    std::sort(layering.splits.begin(), layering.splits.end());
    return layering;
}

template <typename T>
std::vector<T> uniformSplits(int layerCount)
{
    std::vector<T> splits;
    for (int i = 0; i <= layerCount; ++i)
        splits.push_back(uniformSplit<T>(i, layerCount));
    return splits;
}

template <typename T, std::size_t kCount>
Vec2<T> averageLayerMoments(const T (&depths)[kCount], const Vec2<T>& interval)
{
    Vec2<T> sum(0);
    for (const T depth : depths)
        sum += layerMoments(depth, interval);
    return sum / T(kCount);
}

TEST_CASE_TEMPLATE("stepWarp is 0 in front of the split and 1 from it on", T, float, double)
{
    for (const T split : {T(0), T(0.3), T(1)})
    {
        CHECK(stepWarp(split, split) == 1);
        CHECK(stepWarp(std::nextafter(split, T(2)), split) == 1);
        CHECK(stepWarp(justBelow(split), split) == 0);
    }
}

TEST_CASE_TEMPLATE("the step warp gives exactly 0 on object C of figure 2 and 1 on B", T, float, double)
{
    Tally tally;
    for (int a = 0; a < kSteps; ++a)
    {
        for (int b = a + 1; b < kSteps; ++b)
        {
            for (int c = b + 1; c <= kSteps; ++c)
            {
                const auto warped = [c](int step)
                {
                    return stepWarp(T(step) / T(kSteps), T(c) / T(kSteps));
                };
                const Vec2<T> moments = T(0.5) * depthMoments(warped(a)) + T(0.5) * depthMoments(warped(b));
                tally.claim(chebyshevUpperBound(moments, warped(c), T(0)) == T(0), a, b, c);
                tally.claim(chebyshevUpperBound(moments, warped(b), T(0)) == T(1), a, b, c);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("layerWarp is 0 in front of the layer, 1 behind it and linear inside", T, float, double)
{
    const Vec2<T> interval(T(0.25), T(0.75));
    CHECK(layerWarp(T(0), interval) == 0);
    CHECK(layerWarp(T(0.25), interval) == 0);
    CHECK(layerWarp(T(0.375), interval) == T(0.25));
    CHECK(layerWarp(T(0.5), interval) == T(0.5));
    CHECK(layerWarp(T(0.75), interval) == 1);
    CHECK(layerWarp(T(1), interval) == 1);
}

TEST_CASE_TEMPLATE("an empty or inverted layer warps as a step at its end", T, float, double)
{
    Random random(20);
    for (const Vec2<T> interval : {Vec2<T>(T(0.5), T(0.5)), Vec2<T>(T(0.75), T(0.5)), Vec2<T>(0, 0), Vec2<T>(1, 1)})
    {
        for (int i = 0; i < 1000; ++i)
        {
            const T depth = i == 0 ? interval.y : random.unit<T>();
            CHECK(layerWarp(depth, interval) == stepWarp(depth, interval.y));
        }
    }
}

TEST_CASE_TEMPLATE("layerInterval widens inner ends by the overlap and never the outer ones", T, float, double)
{
    const T overlap = T(0.125);
    CHECK(layerInterval(T(0), T(0.25), overlap) == Vec2<T>(0, T(0.375)));
    CHECK(layerInterval(T(0.25), T(0.75), overlap) == Vec2<T>(T(0.125), T(0.875)));
    CHECK(layerInterval(T(0.75), T(1), overlap) == Vec2<T>(T(0.625), 1));
    CHECK(layerInterval(T(0), T(1), overlap) == Vec2<T>(0, 1));
    CHECK(layerInterval(T(0.0625), T(0.9375), overlap) == Vec2<T>(0, 1));
    CHECK(layerInterval(T(0.25), T(0.75), T(0)) == Vec2<T>(T(0.25), T(0.75)));
    CHECK(layerInterval(T(0.25), T(0.75), T(-1)) == Vec2<T>(T(0.25), T(0.75)));
}

TEST_CASE_TEMPLATE("a window inside the overlap looks the same from both layers", T, float, double)
{
    // Around the split at 1/2, all within the overlap of 1/4: neither layer clips anything, each resolves the window as
    // a plain variance shadow map does. Layers 1/2 and 1 long: every number is exact.
    const Layering<T> layering{{T(0), T(0.5), T(1)}, T(0.25)};
    const T floor = T(1) / T(4096);
    Random random(21);
    for (int i = 0; i < 1000; ++i)
    {
        const T depths[4] = {T(random.between(16, 48)) / 64, T(random.between(16, 48)) / 64,
                             T(random.between(16, 48)) / 64, T(random.between(16, 48)) / 64};
        const T receiver = T(random.between(16, 48)) / 64;
        // Intervals [0, 3/4] and [1/4, 1] are of one length; their warps differ by a shift alone.
        T seen[2];
        for (int layer : {0, 1})
        {
            const Vec2<T> interval = layering.interval(layer);
            seen[layer] = layeredVisibility(averageLayerMoments(depths, interval), receiver, interval, floor);
        }
        Vec2<T> plain(0);
        for (const T depth : depths)
            plain += depthMoments(depth) / T(4);
        const T truth = chebyshevUpperBound(plain, receiver, floor);
        // The floor keeps v + d^2 over 1/4096, so a rounding of the moments, 3/4 long at most, counts 4096 fold at most;
        // a dozen of them meet (warps, squares, averages, their difference).
        const T tolerance = static_cast<T>(12 * 4096 * kRoundoff<T>);
        CHECK(std::abs(seen[0] - truth) <= tolerance);
        CHECK(std::abs(seen[1] - truth) <= tolerance);
    }
}

TEST_CASE_TEMPLATE("one layer is a plain variance shadow map, exactly", T, float, double)
{
    Random random(22);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec2<T> interval = layerInterval(T(0), T(1), random.unit<T>());
        const T stored = random.unit<T>();
        const T other = random.unit<T>();
        tally.claim(layerMoments(stored, interval) == depthMoments(stored), stored);
        const Vec2<T> window = T(0.5) * depthMoments(stored) + T(0.5) * depthMoments(other);
        const T depth = random.unit<T>();
        const T floor = i % 4 == 0 ? T(0) : random.unit<T>() / 4;
        tally.claim(layeredVisibility(window, depth, interval, floor) == chebyshevUpperBound(window, depth, floor),
                    stored, other, depth, floor);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("a layer is exact for occluders in front of it and the receiver inside", T, float, double)
{
    // Section 3.3. Occluders at many depths cover part of the window, the receiver the rest. The layer is 1/4 long, so
    // that warped depths are 8ths and everything is exact.
    Random random(23);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const int begin = 8 * random.between(0, 3);
        const int receiver = random.between(begin + 1, begin + 8);
        const Vec2<T> interval = layerInterval(T(begin) / T(kSteps), T(begin + 8) / T(kSteps), T(0));
        Vec2<T> moments(0);
        const int covered = random.between(0, kSteps);
        for (int sample = 0; sample < kSteps; ++sample)
        {
            const int depth = sample < covered ? random.between(0, begin) : receiver;
            moments += layerMoments(T(depth) / T(kSteps), interval) / T(kSteps);
        }
        const T lit = T(kSteps - covered) / T(kSteps);
        tally.claim(layeredVisibility(moments, T(receiver) / T(kSteps), interval, T(0)) == lit, begin, receiver,
                    covered);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("a layer between B and C of figure 2 removes the bleeding", T, float, double)
{
    const T a = T(0.125);
    const T b = T(0.5);
    const T c = T(0.75);
    const Vec2<T> plain = T(0.5) * depthMoments(a) + T(0.5) * depthMoments(b);
    CHECK(chebyshevUpperBound(plain, c, T(0)) > T(0.1));
    for (const T split : {b, T(0.625)})
    {
        const Vec2<T> interval = layerInterval(split, T(1), T(0));
        const Vec2<T> moments = T(0.5) * layerMoments(a, interval) + T(0.5) * layerMoments(b, interval);
        CHECK(layeredVisibility(moments, c, interval, T(0)) == 0);
    }
    // One between A and B still reduces it: there dx is 1/4 of what it was, and equation 4 holds for it.
    const Vec2<T> between = layerInterval(T(0.40625), T(1), T(0));
    const Vec2<T> moments = T(0.5) * layerMoments(a, between) + T(0.5) * layerMoments(b, between);
    const Exact dx = 0.09375L;
    const Exact dy = 0.25L;
    const Exact equation4 = dx * dx / 4 / (dx * dx / 2 + dx * dy + dy * dy);
    // The warp rounds each depth, at most four more roundings count dy / dx fold.
    CHECK(std::abs(Exact(layeredVisibility(moments, c, between, T(0))) - equation4) <= 16 * kRoundoff<T>);
}

TEST_CASE_TEMPLATE("layers behind the receiver say nothing", T, float, double)
{
    Random random(24);
    for (int i = 0; i < 1000; ++i)
    {
        const Vec2<T> interval = layerInterval(T(0.5), T(0.75), T(0));
        const T depths[3] = {random.unit<T>(), random.unit<T>(), random.unit<T>()};
        CHECK(layeredVisibility(averageLayerMoments(depths, interval), random.unit<T>() / 2, interval, T(0)) == 1);
    }
}

TEST_CASE_TEMPLATE("the layer that holds the receiver is not always the least bound", T, float, double)
{
    // Half the window at 0, half at 1. The receiver, at 0.6 of the second of two layers, is half lit. Its own layer
    // cannot tell that the deep half is all behind it; the layer in front can, since both halves are at its ends.
    const Layering<T> layering{{T(0), T(0.5), T(1)}, T(0)};
    const T depths[2] = {T(0), T(1)};
    const T receiver = T(0.5) + T(0.6) * T(0.5);
    const auto seenBy = [&](int layer)
    {
        const Vec2<T> interval = layering.interval(layer);
        return layeredVisibility(averageLayerMoments(depths, interval), receiver, interval, T(0));
    };
    // 0.25 / (0.25 + 0.1^2), where 0.1 is 0.6 less 0.5: a rounding of 0.6 counts 2 d / v = 0.8 fold, twice.
    CHECK(std::abs(Exact(seenBy(1)) - 0.25L / 0.26L) <= 8 * kRoundoff<T>);
    CHECK(seenBy(0) == T(0.5));
    // Without layers it is 0.25 / (0.25 + 0.3^2): the receiver's layer is worse than none.
    const Vec2<T> moments = averageLayerMoments(depths, Vec2<T>(T(0), T(1)));
    CHECK(std::abs(Exact(chebyshevUpperBound(moments, receiver, T(0))) - 0.25L / 0.34L) <= 8 * kRoundoff<T>);
}

TEST_CASE_TEMPLATE("every layer bounds the visibility of every receiver", T, float, double)
{
    Random random(25);
    Tally tally;
    for (int i = 0; i < drawsOf(30000); ++i)
    {
        const Distribution<T> window(random);
        const Layering<T> layering = randomLayering<T>(random, random.between(1, 5));
        const T floor = i % 2 == 0 ? T(0) : T(1.0e-6);
        for (int layer = 0; layer < layering.count(); ++layer)
        {
            const Vec2<T> interval = layering.interval(layer);
            const ExactMoments moments =
                window.moments([interval](T depth) { return Exact(layerWarp(depth, interval)); });
            for (const T depth : window.depths())
            {
                const T visibility = layeredVisibility(moments.template rounded<T>(), depth, interval, floor);
                const Exact least =
                    std::min(window.tail(depth), leastByRounding(moments, layerWarp(depth, interval),
                                                                 Exact(layerMinVariance(floor, interval))));
                tally.claim(Exact(visibility) >= least, depth, interval.x, interval.y, visibility, least);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("layered visibility never rises with depth and never falls with minVariance", T, float, double)
{
    Random random(26);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const Layering<T> layering = randomLayering<T>(random, random.between(1, 4));
        const Vec2<T> interval = layering.interval(random.between(0, layering.count() - 1));
        const T depths[3] = {random.unit<T>(), random.unit<T>(), random.unit<T>()};
        const Vec2<T> moments = averageLayerMoments(depths, interval);
        const T floor = random.unit<T>() / 16;
        T before = 1;
        for (int step = 0; step <= kSteps; ++step)
        {
            const T depth = GridDistribution::depthAt<T>(step);
            const T visibility = layeredVisibility(moments, depth, interval, floor);
            tally.claim(visibility <= before, depth, interval.x, interval.y);
            const T rounding = static_cast<T>(8 * kRoundoff<T>);
            tally.claim(layeredVisibility(moments, depth, interval, 2 * floor) >= visibility - rounding, depth,
                        interval.x, interval.y, floor);
            before = visibility;
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("layerMinVariance divides by the square of the layer's length", T, float, double)
{
    CHECK(layerMinVariance(T(0x1p-10), Vec2<T>(T(0.25), T(0.5))) == T(0x1p-6));
    CHECK(layerMinVariance(T(0x1p-10), Vec2<T>(T(0.5), T(1))) == T(0x1p-8));
    CHECK(layerMinVariance(T(0x1p-10), Vec2<T>(0, 1)) == T(0x1p-10));
    CHECK(layerMinVariance(T(-1), Vec2<T>(0, 1)) == 0);
    // No layer is longer than all depths.
    CHECK(layerMinVariance(T(0x1p-10), Vec2<T>(-1, 1)) == T(0x1p-10));
}

TEST_CASE_TEMPLATE("the floor of a layer is the global floor seen through its warp", T, float, double)
{
    // Inside one layer the warp is linear, so the floored bound is the same in both spaces (section 3.3).
    Random random(27);
    for (int i = 0; i < 1000; ++i)
    {
        const T floor = T(1) / T(1 << random.between(8, 20));
        const Vec2<T> interval(T(0.25), T(0.5));
        const T depths[2] = {T(random.between(16, 32)) / 64, T(random.between(16, 32)) / 64};
        const T receiver = T(random.between(16, 32)) / 64;
        const Vec2<T> plain = T(0.5) * depthMoments(depths[0]) + T(0.5) * depthMoments(depths[1]);
        CHECK(layeredVisibility(averageLayerMoments(depths, interval), receiver, interval, floor) ==
              chebyshevUpperBound(plain, receiver, floor));
    }
}

TEST_CASE_TEMPLATE("layerMinVariance of a vanishing layer is the most that depths can vary", T, float, double)
{
    for (const Vec2<T> interval : {Vec2<T>(T(0.5), T(0.5)), Vec2<T>(T(0.75), T(0.25)), Vec2<T>(0, kTiny<T> / 2)})
    {
        CHECK(layerMinVariance(T(1.0e-5), interval) == T(0.25));
        CHECK(layerMinVariance(kTiny<T>, interval) == T(0.25));
        CHECK(layerMinVariance(T(0), interval) == 0);
    }
    CHECK(layerMinVariance(T(1), Vec2<T>(0, 1)) == T(0.25));
    CHECK(layerMinVariance(T(0x1p-10), Vec2<T>(0, T(0x1p-4))) == T(0.25));
    CHECK(layerMinVariance(T(0x1p-10), Vec2<T>(0, T(0x1p-3))) == T(0x1p-4));
}

TEST_CASE_TEMPLATE("uniformSplit divides the depth range evenly and clamps", T, float, double)
{
    CHECK(uniformSplit<T>(0, 4) == 0);
    CHECK(uniformSplit<T>(1, 4) == T(0.25));
    CHECK(uniformSplit<T>(2, 3) == T(2) / T(3));
    CHECK(uniformSplit<T>(4, 4) == 1);
    CHECK(uniformSplit<T>(9, 4) == 1);
    CHECK(uniformSplit<T>(-9, 4) == 0);
    CHECK(uniformSplit<T>(0, 0) == 0);
    CHECK(uniformSplit<T>(1, -7) == 1);
    CHECK(uniformSplit<T>(1, 1 << 30) == uniformSplit<T>(1, 65536));
    CHECK(uniformSplit<T>(1, 65536) == T(0x1p-16));
}

TEST_CASE_TEMPLATE("layerIndex sends a depth on a split to the layer behind it", T, float, double)
{
    const T splits[] = {T(0), T(0.25), T(0.5), T(0.5), T(1)};
    CHECK(layerIndex(T(0), splits, 4) == 0);
    CHECK(layerIndex(std::nextafter(T(0.25), T(0)), splits, 4) == 0);
    CHECK(layerIndex(T(0.25), splits, 4) == 1);
    // The empty layer between two equal splits holds nothing.
    CHECK(layerIndex(std::nextafter(T(0.5), T(0)), splits, 4) == 1);
    CHECK(layerIndex(T(0.5), splits, 4) == 3);
    CHECK(layerIndex(T(1), splits, 4) == 3);
    CHECK(layerIndex(T(-5), splits, 4) == 0);
    CHECK(layerIndex(T(5), splits, 4) == 3);
    CHECK(layerIndex(T(0.9), splits, 1) == 0);
    CHECK(layerIndex(T(0.9), splits, 0) == 0);
}

// Compares the two searches with a third.
template <typename T>
class IndexAgreement
{
public:
    explicit IndexAgreement(int layerCount) : m_count(layerCount), m_splits(uniformSplits<T>(layerCount)) {}

    void claimAt(T depth, Tally& tally) const
    {
        const auto truth = std::upper_bound(m_splits.begin() + 1, m_splits.end() - 1, depth) - (m_splits.begin() + 1);
        tally.claim(uniformLayerIndex(depth, m_count) == truth, depth, m_count);
        if (m_count <= 64)
            tally.claim(layerIndex(depth, m_splits.data(), m_count) == truth, depth, m_count);
    }

    void claimAround(T depth, int neighbours, Tally& tally) const
    {
        T below = depth;
        T above = depth;
        claimAt(depth, tally);
        for (int i = 0; i < neighbours; ++i)
        {
            claimAt(below = std::nextafter(below, T(-1)), tally);
            claimAt(above = std::nextafter(above, T(2)), tally);
        }
    }

    const std::vector<T>& splits() const { return m_splits; }

private:
    int m_count;
    std::vector<T> m_splits;
};

TEST_CASE_TEMPLATE("uniformLayerIndex agrees with layerIndex around every split of 1 to 64 layers", T, float, double)
{
    Tally tally;
    for (int count = 1; count <= 64; ++count)
    {
        const IndexAgreement<T> agreement(count);
        for (const T split : agreement.splits())
            agreement.claimAround(split, 64, tally);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("uniformLayerIndex agrees with a search around every split of many layers", T, float, double)
{
    Tally tally;
    for (const int count : {100, 255, 256, 1000, 4097, 65535, 65536})
    {
        const IndexAgreement<T> agreement(count);
        for (const T split : agreement.splits())
            agreement.claimAround(split, 3, tally);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("uniformLayerIndex agrees with layerIndex for any depth", T, float, double)
{
    Random random(28);
    Tally tally;
    for (int count = 1; count <= 64; ++count)
    {
        const IndexAgreement<T> agreement(count);
        for (int i = 0; i < drawsOf(20000); ++i)
            agreement.claimAt(random.unit<T>(), tally);
        // Every magnitude, subnormals and depths outside [0,1] too.
        for (int i = 0; i < drawsOf(5000); ++i)
            agreement.claimAt(random.finitePattern<T>(), tally);
        for (const T depth : specialValues<T>())
            if (!std::isnan(depth))
                agreement.claimAt(depth, tally);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("uniformLayerIndex clamps its layer count", T, float, double)
{
    CHECK(uniformLayerIndex(T(0.9), 0) == 0);
    CHECK(uniformLayerIndex(T(0.9), -3) == 0);
    CHECK(uniformLayerIndex(T(0.5), 1 << 30) == 32768);
    CHECK(uniformLayerIndex(T(1), 1 << 30) == 65535);
}

TEST_CASE_TEMPLATE("two layers packed in a texel come back bit for bit", T, float, double)
{
    Random random(29);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        // Quiet or signalling, a NaN's bits may change in a register; all else may not.
        const Vec2<T> even(random.finitePattern<T>(), random.finitePattern<T>());
        const Vec2<T> odd(random.finitePattern<T>(), random.finitePattern<T>());
        const Vec4<T> texel = packLayers(even, odd);
        const int layer = 2 * random.between(0, 1000);
        const Vec2<T> evenAgain = unpackLayer(texel, layer);
        const Vec2<T> oddAgain = unpackLayer(texel, layer + 1);
        tally.claim(bitsOf(even.x) == bitsOf(evenAgain.x) && bitsOf(even.y) == bitsOf(evenAgain.y), even.x, even.y);
        tally.claim(bitsOf(odd.x) == bitsOf(oddAgain.x) && bitsOf(odd.y) == bitsOf(oddAgain.y), odd.x, odd.y);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("a window half empty leaves a layered receiver lit", T, float, double)
{
    const Layering<T> layering{{T(0), T(0.25), T(0.5), T(1)}, T(0.125)};
    for (int step = 0; step <= kSteps; ++step)
    {
        const T surface = GridDistribution::depthAt<T>(step);
        for (int layer = 0; layer < layering.count(); ++layer)
        {
            const Vec2<T> interval = layering.interval(layer);
            const Vec2<T> empty = layerMoments(T(1), interval);
            CHECK(empty == Vec2<T>(1, 1));
            const Vec2<T> window = T(0.5) * layerMoments(surface, interval) + T(0.5) * empty;
            CHECK(layeredVisibility(window, surface, interval, T(0)) == 1);
            for (int behind = step + 1; behind <= kSteps; ++behind)
            {
                const T depth = GridDistribution::depthAt<T>(behind);
                // The second moment is rounded as a square and as a sum.
                const Exact least = leastByRounding(ExactMoments::ofHalves(layerWarp(surface, interval), 1),
                                                    layerWarp(depth, interval), Exact(0), 2);
                CHECK(Exact(layeredVisibility(window, depth, interval, T(0))) >= std::min(Exact(0.5), least));
            }
        }
    }
}

TEST_CASE_TEMPLATE("transitionWeight is half at a split, names the neighbour, and vanishes inside", T, float, double)
{
    const T begin = T(0.25);
    const T end = T(0.75);
    const T width = T(0.125);
    CHECK(transitionWeight(begin, begin, end, width) == T(-0.5));
    CHECK(transitionWeight(T(0.3125), begin, end, width) == T(-0.25));
    CHECK(transitionWeight(T(0.375), begin, end, width) == 0);
    CHECK(transitionWeight(T(0.5), begin, end, width) == 0);
    CHECK(transitionWeight(T(0.625), begin, end, width) == 0);
    CHECK(transitionWeight(T(0.6875), begin, end, width) == T(0.25));
    CHECK(transitionWeight(end, begin, end, width) == T(0.5));
}

TEST_CASE_TEMPLATE("the outer ends of the layers have no transition", T, float, double)
{
    for (const T depth : {T(-1), T(0), T(0.05), T(0.5)})
        CHECK(transitionWeight(depth, T(0), T(1), T(0.5)) == 0);
    CHECK(transitionWeight(T(0), T(0), T(0.5), T(0.125)) == 0);
    CHECK(transitionWeight(T(0.5), T(0), T(0.5), T(0.125)) == T(0.5));
    CHECK(transitionWeight(T(0.5), T(0.5), T(1), T(0.125)) == T(-0.5));
    CHECK(transitionWeight(T(1), T(0.5), T(1), T(0.125)) == 0);
    CHECK(transitionWeight(T(2), T(0.5), T(1), T(0.125)) == 0);
}

TEST_CASE_TEMPLATE("a transition takes at most half of a layer, and none without width or length", T, float, double)
{
    for (const T width : {T(0.25), T(0.375), T(9)})
    {
        CHECK(transitionWeight(T(0.5), T(0.25), T(0.75), width) == 0);
        CHECK(transitionWeight(T(0.375), T(0.25), T(0.75), width) == T(-0.25));
        CHECK(transitionWeight(T(0.625), T(0.25), T(0.75), width) == T(0.25));
    }
    for (const T width : {T(0), T(-1), kTiny<T> / 2})
        CHECK(transitionWeight(T(0.25), T(0.25), T(0.75), width) == 0);
    CHECK(transitionWeight(T(0.5), T(0.5), T(0.5), T(0.1)) == 0);
    CHECK(transitionWeight(T(0.5), T(0.75), T(0.25), T(0.1)) == 0);
}

TEST_CASE_TEMPLATE("blendTransition mixes by the size of the weight", T, float, double)
{
    CHECK(blendTransition(T(0.25), T(0.75), T(0.5)) == T(0.5));
    CHECK(blendTransition(T(0.25), T(0.75), T(-0.5)) == T(0.5));
    CHECK(blendTransition(T(0.25), T(0.75), T(0.25)) == T(0.375));
    CHECK(blendTransition(T(0.25), T(0.75), T(1)) == T(0.75));
    CHECK(blendTransition(T(0.25), T(0.75), T(-7)) == T(0.75));
}

TEST_CASE_TEMPLATE("with weight 0 one sample suffices", T, float, double)
{
    Random random(30);
    for (const T neighbour : {T(0), T(0.3), T(1)})
    {
        for (int i = 0; i < 1000; ++i)
        {
            const T visibility = random.unit<T>();
            CHECK(blendTransition(visibility, neighbour, T(0)) == visibility);
        }
    }
}

TEST_CASE_TEMPLATE("a blend stays in the unit interval whatever it is given", T, float, double)
{
    Random random(31);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const T weight = 2 * random.unit<T>() - 1;
        tally.claim(blendTransition(T(1), T(1), weight) <= T(1), weight);
        const T a = random.pattern<T>();
        const T b = random.pattern<T>();
        const T blended = blendTransition(a, b, weight);
        tally.claim(blended >= T(0) && blended <= T(1), a, b, weight);
    }
    LVSM_CHECK_TALLY(tally);
}

// The visibility of a receiver at one depth, as a renderer evaluates it: one layer, or two near a split.
template <typename T>
T visibilityAcross(const Layering<T>& layering, const std::vector<Vec2<T>>& moments, T depth, T floor, T width)
{
    const auto seen = [&](int layer)
    {
        return layeredVisibility(moments[static_cast<std::size_t>(layer)], depth, layering.interval(layer), floor);
    };
    const int layer = layerIndex(depth, layering.splits.data(), layering.count());
    const auto at = static_cast<std::size_t>(layer);
    const T weight = transitionWeight(depth, layering.splits[at], layering.splits[at + 1], width);
    if (weight == T(0))
        return seen(layer);
    return blendTransition(seen(layer), seen(weight < T(0) ? layer - 1 : layer + 1), weight);
}

TEST_CASE_TEMPLATE("transitions make visibility continuous in depth across every split", T, float, double)
{
    const T floor = T(1.0e-4);
    const T width = T(0.03125);
    const int steps = 100000;
    // The Chebyshev bound v / (v + d^2) is steepest at d^2 = v / 3: 3 sqrt(3) / (8 sqrt(v)). In depth that is at most
    // 3 sqrt(3) / (8 sqrt(floor)) for every layer, for the floor and the slope of the warp scale alike. A blend is no
    // steeper than its two parts, and its weight adds half the difference of the two, at most 1, over the width.
    // Each visibility rounds some warped depths, whose errors the slope and 1 / length multiply.
    const Exact slope = 3 * std::sqrt(Exact(3)) / (8 * std::sqrt(Exact(floor))) + Exact(0.5) / width;
    const Exact most = slope / steps + 64 * slope * kRoundoff<T>;
    Random random(32);
    Tally blended;
    int jumps = 0;
    for (int window = 0; window < 20; ++window)
    {
        const Layering<T> layering{{T(0), T(0.2), T(0.45), T(0.7), T(1)}, T(0.01)};
        const T depths[6] = {random.unit<T>(), random.unit<T>(), random.unit<T>(),
                             random.unit<T>(), random.unit<T>(), random.unit<T>()};
        std::vector<Vec2<T>> moments;
        for (int layer = 0; layer < layering.count(); ++layer)
            moments.push_back(averageLayerMoments(depths, layering.interval(layer)));
        T before = 1;
        T beforeWithout = 1;
        for (int i = 0; i <= steps; ++i)
        {
            const T depth = T(i) / T(steps);
            const T visibility = visibilityAcross(layering, moments, depth, floor, width);
            const T without = visibilityAcross(layering, moments, depth, floor, T(0));
            blended.claim(std::abs(Exact(visibility) - Exact(before)) <= most, window, depth, visibility, before);
            jumps += std::abs(Exact(without) - Exact(beforeWithout)) > 10 * most;
            before = visibility;
            beforeWithout = without;
        }
    }
    LVSM_CHECK_TALLY(blended);
    // Without transitions the seams are there.
    CHECK(jumps > 10);
}

TEST_CASE_TEMPLATE("a flat lit receiver in a low-bit layer stays within the recommended darkening", T, float, double)
{
    // What is rounded is the warped depth, so the floor in depth is that of the format times the squared length.
    Random random(33);
    Tally tally;
    const T worstDarkening = T(0.05);
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec2<T> interval(T(0.5), T(0.625));
        const T length = interval.y - interval.x;
        const T depth = interval.x + length * random.unit<T>();
        const Vec2<T> exact = layerMoments(depth, interval);
        const Vec2<T> stored(std::nearbyint(exact.x * 255) / 255, std::nearbyint(exact.y * 255) / 255);
        const T error = kDepthErrorUnorm8<T> + static_cast<T>(4 * kRoundoff<T>);
        const T floor = recommendedMinVariance(error, worstDarkening) * length * length;
        tally.claim(1 - layeredVisibility(stored, depth, interval, floor) <= worstDarkening + T(16 * kRoundoff<T>),
                    depth);
    }
    LVSM_CHECK_TALLY(tally);
}

} // namespace
} // namespace lvsm::unit
