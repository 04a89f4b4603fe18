#include <lvsm/layers.hpp>
#include <lvsm/placement.hpp>

#include <doctest/doctest.h>

#include <glm/common.hpp>

#include "distributions.hpp"

namespace lvsm::unit
{
namespace
{

constexpr int kSteps = GridDistribution::kSteps;

// Moments of depths a and b that cover covered and kSteps - covered 32nds, in 32nds of depth. Exact.
template <typename T>
Vec2<T> twoDepths(int a, int b, int covered)
{
    const int rest = kSteps - covered;
    return {T(covered * a + rest * b) / T(kSteps * kSteps),
            T(covered * a * a + rest * b * b) / T(kSteps * kSteps * kSteps)};
}

template <typename T>
std::vector<T> sortedSplits(Random& random, int layerCount)
{
    std::vector<T> splits{T(0), T(1)};
    for (int i = 1; i < layerCount; ++i)
        splits.push_back(random.unit<T>());
    std::sort(splits.begin(), splits.end());
    return splits;
}

template <typename T>
bool areValid(const std::vector<T>& splits)
{
    return splits.front() == T(0) && splits.back() == T(1) && std::is_sorted(splits.begin(), splits.end());
}

// Teleportation as the documentation words it, on a list: erase, weigh, insert.
template <typename T>
std::vector<T> teleported(const std::vector<T>& splits, const std::vector<T>& weights)
{
    const auto inner = splits.size() - 2;
    std::size_t empty = 1;
    while (empty <= inner && weights[empty] >= kTiny<T>)
        ++empty;
    if (empty > inner)
        return splits;
    std::vector<T> merged = splits;
    std::vector<T> kept = weights;
    kept.front() = kept.back() = T(0);
    merged.erase(merged.begin() + static_cast<std::ptrdiff_t>(empty));
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(empty));
    std::size_t heaviest = 0;
    T most = 0;
    for (std::size_t layer = 0; layer + 1 < merged.size(); ++layer)
    {
        const T weight = kept[layer] / 2 + kept[layer + 1] / 2;
        if (weight > most)
        {
            most = weight;
            heaviest = layer;
        }
    }
    if (most == T(0))
        return splits;
    merged.insert(merged.begin() + static_cast<std::ptrdiff_t>(heaviest) + 1,
                  merged[heaviest] / 2 + merged[heaviest + 1] / 2);
    return merged;
}

TEST_CASE_TEMPLATE("a bilinear sample at neighbourhoodTexCoord averages the four texels", T, float, double)
{
    // Bilinear filtering by its definition: weights from the fraction of u size - 1/2, addresses clamped. In powers of
    // two everything is exact.
    for (const glm::ivec2 size : {glm::ivec2(8, 4), glm::ivec2(1, 16), glm::ivec2(1, 1), glm::ivec2(64, 2)})
    {
        const auto texelAt = [size](int x, int y)
        {
            return Vec2<T>(T(std::min(x, size.x - 1) % 7) / 8, T(std::min(y, size.y - 1) % 5) / 8);
        };
        for (int y = 0; y < size.y; ++y)
        {
            for (int x = 0; x < size.x; ++x)
            {
                const Vec2<T> place = neighbourhoodTexCoord<T>(glm::ivec2(x, y), size) * Vec2<T>(size) - T(0.5);
                const Vec2<T> fraction = place - glm::floor(place);
                CHECK(fraction == Vec2<T>(T(0.5)));
                CHECK(glm::floor(place) == Vec2<T>(x, y));
                const Vec2<T> top = texelAt(x, y) * (1 - fraction.x) + texelAt(x + 1, y) * fraction.x;
                const Vec2<T> bottom = texelAt(x, y + 1) * (1 - fraction.x) + texelAt(x + 1, y + 1) * fraction.x;
                CHECK(neighbourhoodMoments(texelAt(x, y), texelAt(x + 1, y), texelAt(x, y + 1),
                                           texelAt(x + 1, y + 1)) == top * (1 - fraction.y) + bottom * fraction.y);
            }
        }
    }
}

TEST_CASE_TEMPLATE("neighbourhoodTexCoord clamps texels and sizes", T, float, double)
{
    const glm::ivec2 size(10, 20);
    CHECK(neighbourhoodTexCoord<T>(glm::ivec2(9, 19), size) == Vec2<T>(1, 1));
    CHECK(neighbourhoodTexCoord<T>(glm::ivec2(77, 77), size) == Vec2<T>(1, 1));
    CHECK(neighbourhoodTexCoord<T>(glm::ivec2(-5, -5), size) == Vec2<T>(T(1) / T(10), T(1) / T(20)));
    CHECK(neighbourhoodTexCoord<T>(glm::ivec2(0, 0), glm::ivec2(0, -7)) == Vec2<T>(1, 1));
    CHECK(neighbourhoodTexCoord<T>(glm::ivec2(0, 0), glm::ivec2(-7, 0)) == Vec2<T>(1, 1));
    // Any size, the largest included: within (0,1], and midway between two texels.
    CHECK(neighbourhoodTexCoord<T>(glm::ivec2(0), glm::ivec2(std::numeric_limits<int>::max())).x > 0);
    CHECK(neighbourhoodTexCoord<T>(glm::ivec2(1000), glm::ivec2(1920, 1080)).x == T(1001) / T(1920));
}

TEST_CASE_TEMPLATE("secondOccluder recovers the deeper of two depths that cover half each", T, float, double)
{
    for (int a = 0; a <= kSteps; ++a)
        for (int b = 0; b <= kSteps; ++b)
            CHECK(secondOccluder(twoDepths<T>(a, b, kSteps / 2)) == T(std::max(a, b)) / T(kSteps));
}

TEST_CASE_TEMPLATE("secondOccluder follows the closed form for other coverages", T, float, double)
{
    Tally tally;
    for (int a = 0; a <= kSteps; ++a)
    {
        for (int b = 0; b <= kSteps; ++b)
        {
            for (int covered = 0; covered <= kSteps; ++covered)
            {
                const Exact alpha = Exact(covered) / kSteps;
                const Exact x = Exact(a) / kSteps;
                const Exact y = Exact(b) / kSteps;
                const Exact truth = alpha * x + (1 - alpha) * y + std::sqrt(alpha * (1 - alpha)) * std::abs(x - y);
                // The root and the sum round, each by u at most.
                const Exact occluder = secondOccluder(twoDepths<T>(a, b, covered));
                tally.claim(std::abs(occluder - std::min(truth, Exact(1))) <= 2 * kRoundoff<T>, a, b, covered);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("secondOccluder stays in the unit interval", T, float, double)
{
    CHECK(secondOccluder(Vec2<T>(T(0.9), T(0.9))) == 1);
    CHECK(secondOccluder(Vec2<T>(-3, 9)) == 0);
    CHECK(secondOccluder(Vec2<T>(T(0.5), 0)) == T(0.5));
}

TEST_CASE_TEMPLATE("occluderWeight is the variance between its floor and its cap", T, float, double)
{
    const Vec2<T> quarter = twoDepths<T>(0, kSteps / 2, kSteps / 2); // variance 1/16
    CHECK(occluderWeight(quarter, T(0), T(1)) == T(0.0625));
    CHECK(occluderWeight(quarter, T(0.0625), T(1)) == T(0.0625));
    CHECK(occluderWeight(quarter, T(0.07), T(1)) == 0);
    CHECK(occluderWeight(quarter, T(0), T(0.03125)) == T(0.03125));
    CHECK(occluderWeight(quarter, T(0), T(0)) == 0);
    CHECK(occluderWeight(quarter, T(0), T(-1)) == 0);
    CHECK(occluderWeight(depthMoments(T(0.5)), T(1.0e-6), T(1)) == 0);
    CHECK(occluderWeight(Vec2<T>(T(0.5), 0), T(-1), T(1)) == 0);
}

TEST_CASE_TEMPLATE("nearestSplit is the lower of the nearest inner splits", T, float, double)
{
    const T splits[] = {T(0), T(0.25), T(0.5), T(0.75), T(1)};
    CHECK(nearestSplit(T(0), splits, 4) == 1);
    CHECK(nearestSplit(T(0.25), splits, 4) == 1);
    CHECK(nearestSplit(T(0.375), splits, 4) == 1);
    CHECK(nearestSplit(std::nextafter(T(0.375), T(1)), splits, 4) == 2);
    CHECK(nearestSplit(T(0.6), splits, 4) == 2);
    CHECK(nearestSplit(T(1), splits, 4) == 3);
    CHECK(nearestSplit(T(-9), splits, 4) == 1);
    CHECK(nearestSplit(T(9), splits, 4) == 3);
    // The outer splits never move, so nothing belongs to them.
    CHECK(nearestSplit(T(0), splits, 2) == 1);
    CHECK(nearestSplit(T(0.5), splits, 1) == 0);
    CHECK(nearestSplit(T(0.5), splits, 0) == 0);
    CHECK(nearestSplit(T(0.5), splits, -4) == 0);
}

TEST_CASE_TEMPLATE("accumulateSplits adds a neighbourhood to the sums of its own split only", T, float, double)
{
    CHECK(accumulateSplits(T(0.5), T(0.25), 2, 2, 3) == Vec4<T>(T(0.125), T(0.25), 0, 0));
    CHECK(accumulateSplits(T(0.5), T(0.25), 3, 2, 3) == Vec4<T>(0, 0, T(0.125), T(0.25)));
    CHECK(accumulateSplits(T(0.5), T(0.25), 1, 2, 3) == Vec4<T>(0));
    CHECK(accumulateSplits(T(0.5), T(0.25), 2, 2, 2) == Vec4<T>(T(0.125), T(0.25), T(0.125), T(0.25)));
    CHECK(accumulateSplits(T(7), T(0.25), 2, 2, 3) == Vec4<T>(T(0.25), T(0.25), 0, 0));
    CHECK(accumulateSplits(T(-7), T(0.25), 2, 2, 3) == Vec4<T>(0, T(0.25), 0, 0));
}

TEST_CASE_TEMPLATE("updateSplit moves to the weighted mean and stays where its cluster is empty", T, float, double)
{
    CHECK(updateSplit(T(0.25), T(0.375), T(0.5)) == T(0.75));
    CHECK(updateSplit(T(0.25), T(0), T(0.5)) == 0);
    CHECK(updateSplit(T(0.25), T(0), T(0)) == T(0.25));
    CHECK(updateSplit(T(0.25), kTiny<T> / 2, kTiny<T> / 2) == T(0.25));
    CHECK(updateSplit(T(0.25), T(0.1), T(-1)) == T(0.25));
    CHECK(updateSplit(T(0.25), kTiny<T> / 2, kTiny<T>) == T(0.5));
    CHECK(updateSplit(T(7), T(0), T(0)) == 1);
    CHECK(updateSplit(T(0.25), T(3), T(2)) == 1);
    CHECK(updateSplit(T(0.25), T(-3), T(2)) == 0);
}

TEST_CASE("scheduledSplits gives every inner split its turn")
{
    for (int layerCount = 3; layerCount <= 40; ++layerCount)
    {
        const int inner = layerCount - 1;
        for (const int start : {0, 1, 1000, std::numeric_limits<int>::max() - 2 * inner})
        {
            std::vector<int> turns(static_cast<std::size_t>(layerCount) + 1);
            for (int frame = start; frame < start + inner; ++frame)
            {
                const glm::ivec2 pair = scheduledSplits(frame, layerCount);
                REQUIRE(pair.x >= 1);
                REQUIRE(pair.x <= inner);
                REQUIRE(pair.y >= 1);
                REQUIRE(pair.y <= inner);
                CHECK(pair.x != pair.y);
                ++turns[static_cast<std::size_t>(pair.x)];
                ++turns[static_cast<std::size_t>(pair.y)];
            }
            for (int split = 1; split <= inner; ++split)
                CHECK(turns[static_cast<std::size_t>(split)] == 2);
        }
        // And as soon as can be: half as many frames, rounded up, reach them all.
        std::vector<bool> reached(static_cast<std::size_t>(layerCount) + 1);
        for (int frame = 0; frame < (inner + 1) / 2; ++frame)
        {
            const glm::ivec2 pair = scheduledSplits(frame, layerCount);
            reached[static_cast<std::size_t>(pair.x)] = reached[static_cast<std::size_t>(pair.y)] = true;
        }
        CHECK(std::count(reached.begin(), reached.end(), true) == inner);
    }
}

TEST_CASE("scheduledSplits with one or no inner split, and with frames that make no sense")
{
    CHECK(scheduledSplits(5, 2) == glm::ivec2(1, 1));
    CHECK(scheduledSplits(5, 1) == glm::ivec2(0, 0));
    CHECK(scheduledSplits(5, 0) == glm::ivec2(0, 0));
    CHECK(scheduledSplits(5, -5) == glm::ivec2(0, 0));
    CHECK(scheduledSplits(-5, 4) == scheduledSplits(0, 4));
    CHECK(scheduledSplits(32767, 65536) == glm::ivec2(65535, 1));
    CHECK(scheduledSplits(1000, 100000) == scheduledSplits(1000, 65536));
    CHECK(scheduledSplits(40000, 100000) == scheduledSplits(40000, 65536));
    const glm::ivec2 many = scheduledSplits(std::numeric_limits<int>::max(), std::numeric_limits<int>::max());
    CHECK(many.x >= 1);
    CHECK(many.x <= 65535);
    CHECK(many.y >= 1);
    CHECK(many.y <= 65535);
}

TEST_CASE_TEMPLATE("monotoneSplits leaves valid splits and repairs the others", T, float, double)
{
    T valid[] = {T(0), T(0.25), T(0.25), T(0.5), T(1)};
    const std::vector<T> before(valid, valid + 5);
    monotoneSplits(valid, 4);
    CHECK(std::vector<T>(valid, valid + 5) == before);

    T broken[] = {T(3), T(0.5), T(0.25), T(7), T(-1)};
    monotoneSplits(broken, 4);
    CHECK(std::vector<T>(broken, broken + 5) == std::vector<T>{T(0), T(0.5), T(0.5), T(1), T(1)});

    T one[] = {T(9), T(9)};
    monotoneSplits(one, -2);
    CHECK(one[0] == 0);
    CHECK(one[1] == 1);
}

TEST_CASE_TEMPLATE("monotoneSplits makes any values valid", T, float, double)
{
    Random random(50);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const int count = random.between(1, 8);
        std::vector<T> splits;
        for (int k = 0; k <= count; ++k)
            splits.push_back(i % 2 == 0 ? random.pattern<T>() : 3 * random.unit<T>() - 1);
        monotoneSplits(splits.data(), count);
        tally.claim(areValid(splits), i, count);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("teleportSplits merges the layers of an empty split and halves the heaviest", T, float, double)
{
    const auto teleport = [](std::vector<T> splits, std::vector<T> weights)
    {
        teleportSplits(splits.data(), weights.data(), static_cast<int>(splits.size()) - 1);
        return splits;
    };
    // Towards the light, away from it, and back into the layer that the merge has made.
    CHECK(teleport({0, T(0.25), T(0.5), T(0.75), 1}, {0, 8, 1, 0, 0}) ==
          std::vector<T>{0, T(0.25), T(0.375), T(0.5), 1});
    CHECK(teleport({0, T(0.25), T(0.5), T(0.75), 1}, {0, 0, 1, 8, 0}) ==
          std::vector<T>{0, T(0.5), T(0.625), T(0.75), 1});
    CHECK(teleport({0, T(0.25), T(0.5), T(0.75), 1}, {0, 4, 0, 8, 0}) ==
          std::vector<T>{0, T(0.25), T(0.5), T(0.75), 1});
    CHECK(teleport({0, T(0.25), T(0.375), T(0.75), 1}, {0, 4, 0, 8, 0}) ==
          std::vector<T>{0, T(0.25), T(0.5), T(0.75), 1});
    // The first of two empty ones moves; the layer in front of the only full one is the first of the heaviest.
    CHECK(teleport({0, T(0.25), T(0.5), T(0.75), 1}, {0, 0, 0, 2, 0}) ==
          std::vector<T>{0, T(0.5), T(0.625), T(0.75), 1});
    // Less than no weight is none.
    CHECK(teleport({0, T(0.25), T(0.5), T(0.75), 1}, {0, -9, -8, 2, 0}) ==
          teleport({0, T(0.25), T(0.5), T(0.75), 1}, {0, 0, 0, 2, 0}));
    // The middle is that of splits in [0,1].
    CHECK(teleport({0, 5, 6, 7, 1}, {0, 1, 9, 0, 0}) == std::vector<T>{0, 5, 1, 6, 1});
    CHECK(teleport({0, -6, -5, -4, 1}, {0, 1, 9, 0, 0}) == std::vector<T>{0, -6, 0, -5, 1});
    // What stands beside the inner weights is not read.
    CHECK(teleport({0, T(0.25), T(0.5), 1}, {99, 3, 0, 99}) == teleport({0, T(0.25), T(0.5), 1}, {0, 3, 0, 0}));
}

TEST_CASE_TEMPLATE("teleportSplits changes nothing where no cluster is empty or all are", T, float, double)
{
    for (const T weight : {T(0), T(1)})
    {
        T splits[] = {T(0), T(0.25), T(0.5), T(1)};
        const T weights[] = {weight, weight, weight, weight};
        teleportSplits(splits, weights, 3);
        CHECK(splits[1] == T(0.25));
        CHECK(splits[2] == T(0.5));
    }
    T two[] = {T(0), T(0.25), T(1)};
    const T none[] = {T(0), T(0), T(0)};
    teleportSplits(two, none, 2);
    CHECK(two[1] == T(0.25));
    teleportSplits(two, none, 1);
    teleportSplits(two, none, 0);
    CHECK(two[1] == T(0.25));
}

TEST_CASE_TEMPLATE("teleportSplits does what erase and insert on a list do", T, float, double)
{
    Random random(51);
    Tally tally;
    for (int i = 0; i < drawsOf(50000); ++i)
    {
        const int count = random.between(1, 9);
        std::vector<T> splits = sortedSplits<T>(random, count);
        std::vector<T> weights;
        for (int k = 0; k <= count; ++k)
            weights.push_back(random.between(0, 2) == 0 ? T(0) : T(random.between(1, 4)));
        const std::vector<T> truth = teleported(splits, weights);
        const auto inner = [&](auto begin)
        {
            return std::count(begin + 1, begin + count, T(0));
        };
        const auto empty = inner(weights.begin());
        std::vector<T> copy = splits;
        const bool moved = detail::teleport(copy.data(), count, [&](int k) { return weights[std::size_t(k)]; });
        tally.claim(moved == (empty > 0 && empty < count - 1) && copy == truth, i, count);
        teleportSplits(splits.data(), weights.data(), count);
        tally.claim(splits == truth, i, count);
        tally.claim(areValid(splits), i, count);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("assign, accumulate and update never raise the spread of the clusters", T, float, double)
{
    // What makes Lloyd's relaxation converge: the weighted squared distance to the nearest split cannot grow.
    Random random(52);
    Tally tally;
    for (int i = 0; i < 300; ++i)
    {
        const int layers = random.between(2, 6);
        std::vector<T> splits = sortedSplits<T>(random, layers);
        std::vector<T> values;
        std::vector<T> weights;
        for (int k = 0; k < 200; ++k)
        {
            values.push_back(random.unit<T>());
            weights.push_back(random.unit<T>());
        }
        const auto spread = [&]
        {
            Exact sum = 0;
            for (std::size_t k = 0; k < values.size(); ++k)
            {
                const int nearest = nearestSplit(values[k], splits.data(), layers);
                const Exact gap = Exact(values[k]) - splits[static_cast<std::size_t>(nearest)];
                sum += weights[k] * gap * gap;
            }
            return sum;
        };
        Exact before = spread();
        for (int frame = 0; frame < 12; ++frame)
        {
            const glm::ivec2 pair = scheduledSplits(frame, layers);
            Vec4<T> sums(0);
            for (std::size_t k = 0; k < values.size(); ++k)
            {
                const int nearest = nearestSplit(values[k], splits.data(), layers);
                sums += accumulateSplits(values[k], weights[k], nearest, pair.x, pair.y);
            }
            T& first = splits[static_cast<std::size_t>(pair.x)];
            T& second = splits[static_cast<std::size_t>(pair.y)];
            first = updateSplit(first, sums.x, sums.y);
            second = updateSplit(second, sums.z, sums.w);
            tally.claim(std::is_sorted(splits.begin(), splits.end()), i, frame);
            // Sums of 200 terms of at most 1: their rounding, first order, in each of the two means.
            const Exact after = spread();
            tally.claim(after <= before + 4 * 200 * kRoundoff<T> * 200, i, frame, after, before);
            before = after;
        }
    }
    LVSM_CHECK_TALLY(tally);
}

} // namespace
} // namespace lvsm::unit
