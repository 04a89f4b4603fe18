#include <lvsm/lloyd.hpp>

#include <doctest/doctest.h>

#include "distributions.hpp"

namespace lvsm::unit
{
namespace
{

template <typename T>
struct Image
{
    int width;
    int height;
    std::vector<T> depths;

    T& at(int x, int y) { return depths[static_cast<std::size_t>(y * width + x)]; }
    T at(int x, int y) const { return depths[static_cast<std::size_t>(y * width + x)]; }

    RelaxResult<T> relax(std::vector<T>& splits, const RelaxOptions<T>& options = {}) const
    {
        return lloydRelax(depths.data(), width, height, splits.data(), static_cast<int>(splits.size()) - 1, options);
    }
};

template <typename T, typename DepthAt>
Image<T> makeImage(int width, int height, const DepthAt& depthAt)
{
    Image<T> image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.depths.push_back(static_cast<T>(depthAt(x, y)));
    return image;
}

// Stripes of two columns: the background, then each depth in turn. At every edge the second occluder is the deeper of
// the two in equal parts, so the histogram has its peaks at the given depths and nowhere else.
template <typename T>
Image<T> stripes(const std::vector<T>& peaks, T background = T(0))
{
    const int count = static_cast<int>(peaks.size());
    return makeImage<T>(4 * count + 2, 8,
                        [&](int x, int)
                        { return x % 4 < 2 ? background : peaks[static_cast<std::size_t>(x / 4 % count)]; });
}

template <typename T>
Image<T> randomImage(Random& random, int width, int height)
{
    return makeImage<T>(width, height, [&](int, int) { return random.unit<T>(); });
}

template <typename T>
std::vector<T> emptySplits(int layerCount)
{
    return std::vector<T>(static_cast<std::size_t>(layerCount) + 1, T(-1));
}

template <typename T>
bool areValid(const std::vector<T>& splits)
{
    return splits.front() == T(0) && splits.back() == T(1) && std::is_sorted(splits.begin(), splits.end());
}

// Depths pass through M2 - M1^2, a root and a sum, all in double; the mean is rounded to T.
template <typename T>
bool isNear(T split, Exact peak)
{
    return std::abs(split - peak) <= 2 * kRoundoff<T> + 1.0e-12L;
}

template <typename T>
bool hasSplitAt(const std::vector<T>& splits, T peak)
{
    return std::any_of(splits.begin() + 1, splits.end() - 1, [peak](T split) { return isNear(split, peak); });
}

TEST_CASE_TEMPLATE("lloydRelax converges to the peaks of the second-occluder histogram", T, float, double)
{
    for (const std::vector<T>& peaks : {std::vector<T>{T(0.5)},
                                        {T(0.3), T(0.7)},
                                        {T(0.3), T(0.6), T(0.9)},
                                        {T(0.15), T(0.35), T(0.5), T(0.7), T(0.95)}})
    {
        std::vector<T> splits = emptySplits<T>(static_cast<int>(peaks.size()) + 1);
        const RelaxResult<T> result = stripes(peaks).relax(splits);
        CHECK(result.status == RelaxStatus::Converged);
        CHECK(result);
        CHECK(result.movement <= RelaxOptions<T>().tolerance);
        CHECK(areValid(splits));
        for (std::size_t i = 0; i < peaks.size(); ++i)
        {
            CAPTURE(peaks[i]);
            CHECK(isNear(splits[i + 1], peaks[i]));
        }
    }
}

TEST_CASE_TEMPLATE("lloydRelax moves to the weighted mean of peaks that share a cluster", T, float, double)
{
    // Edges 0 to 1/2 weigh 1/16 each and 0 to 1/4 weigh 1/64, as often: the mean is (4 * 1/2 + 1/4) / 5.
    std::vector<T> splits = emptySplits<T>(2);
    CHECK(stripes<T>({T(0.5), T(0.25)}).relax(splits).status == RelaxStatus::Converged);
    CHECK(isNear(splits[1], 0.45L));

    // Weights clamped from above count alike: the mean is in the middle.
    RelaxOptions<T> options;
    options.maxVariance = T(0.015625);
    CHECK(stripes<T>({T(0.5), T(0.25)}).relax(splits, options).status == RelaxStatus::Converged);
    CHECK(isNear(splits[1], 0.375L));

    // And what is under the least variance does not count.
    options.minVariance = T(0.03125);
    options.maxVariance = T(0.25);
    CHECK(stripes<T>({T(0.5), T(0.25)}).relax(splits, options).status == RelaxStatus::Converged);
    CHECK(isNear(splits[1], 0.5L));
}

TEST_CASE_TEMPLATE("by default variances up to 1e-6 weigh nothing and larger ones what they are", T, float, double)
{
    // At an edge of height h two of four texels are h away: the variance is h^2 / 4.
    std::vector<T> splits = emptySplits<T>(2);
    CHECK(stripes<T>({T(0.0019)}).relax(splits).status == RelaxStatus::NoDiscontinuity);
    CHECK(stripes<T>({T(0.0021)}).relax(splits).status == RelaxStatus::Converged);
    // The largest variance there is, 1/4, is not cut: edges to 1 weigh four times as much as edges to 1/2.
    CHECK(stripes<T>({T(1), T(0.5)}).relax(splits).status == RelaxStatus::Converged);
    CHECK(isNear(splits[1], 0.9L));
}

TEST_CASE_TEMPLATE("by default it has converged when no split moves by more than 1e-4, or after 64 iterations", T,
                   float, double)
{
    RelaxOptions<T> options;
    options.keepSplits = true;
    for (const T away : {T(0.00009), T(0.00011)})
    {
        std::vector<T> splits{T(0), T(0.5) + away, T(1)};
        const RelaxResult<T> result = stripes<T>({T(0.5)}).relax(splits, options);
        CHECK(result.status == RelaxStatus::Converged);
        CHECK(result.iterations == (away < T(0.0001) ? 1 : 2));
    }
    Random random(67);
    options = {};
    options.tolerance = T(-1);
    std::vector<T> splits = emptySplits<T>(4);
    CHECK(randomImage<T>(random, 16, 16).relax(splits, options).iterations == 64);
}

TEST_CASE_TEMPLATE("teleportation ends after two for each inner split", T, float, double)
{
    // One peak for many splits: in every iteration one of them has an empty cluster and moves, until that is enough.
    for (int layers = 3; layers <= 12; ++layers)
    {
        std::vector<T> splits = emptySplits<T>(layers);
        const RelaxResult<T> result = stripes<T>({T(0.5)}).relax(splits);
        CAPTURE(layers);
        CHECK(result.status == RelaxStatus::Converged);
        CHECK(result.iterations == 2 * (layers - 1) + 1);
    }
}

TEST_CASE_TEMPLATE("lloydRelax teleports splits that no occluder is near", T, float, double)
{
    // From uniform splits all peaks belong to the last one: the others start with empty clusters.
    const std::vector<T> peaks{T(0.8), T(0.875), T(0.95)};
    std::vector<T> splits = emptySplits<T>(4);
    CHECK(stripes(peaks).relax(splits).status == RelaxStatus::Converged);
    for (std::size_t i = 0; i < peaks.size(); ++i)
        CHECK(isNear(splits[i + 1], peaks[i]));

    // Close to the light variances are small and far apart; the cap on the weight makes the peaks equals.
    const std::vector<T> near{T(0.05), T(0.125), T(0.2)};
    RelaxOptions<T> options;
    options.maxVariance = T(0.0005);
    CHECK(stripes(near).relax(splits, options).status == RelaxStatus::Converged);
    for (std::size_t i = 0; i < near.size(); ++i)
        CHECK(isNear(splits[i + 1], near[i]));
}

TEST_CASE_TEMPLATE("counterexample: a teleported split comes back to its empty cluster", T, float, double)
{
    // A peak for each split. Edges from 0 to 0.05, 0.1 and 0.2 weigh as 1, 4 and 16: the first two share a split at
    // their mean, (0.05 + 4 * 0.1) / 5 = 0.09. The layer between it and the split at 0.2 is the heaviest, so its middle
    // gets the empty split, though no occluder is near: it is taken from there and put back.
    std::vector<T> splits = emptySplits<T>(4);
    CHECK(stripes<T>({T(0.05), T(0.1), T(0.2)}).relax(splits).status == RelaxStatus::Converged);
    CHECK(isNear(splits[1], 0.09L));
    CHECK(isNear(splits[2], 0.145L));
    CHECK(isNear(splits[3], 0.2L));
}

TEST_CASE_TEMPLATE("lloydRelax survives fewer peaks than splits", T, float, double)
{
    for (const T peak : {T(0.05), T(0.5), T(0.97), T(1)})
    {
        for (int layers = 2; layers <= 12; ++layers)
        {
            for (const int perIteration : {0, 2})
            {
                RelaxOptions<T> options;
                options.splitsPerIteration = perIteration;
                options.maxIterations = 400;
                std::vector<T> splits = emptySplits<T>(layers);
                const RelaxResult<T> result = stripes<T>({peak}).relax(splits, options);
                CAPTURE(peak);
                CAPTURE(layers);
                CHECK(result.status == RelaxStatus::Converged);
                CHECK(areValid(splits));
                CHECK(hasSplitAt(splits, peak));
            }
        }
    }
}

TEST_CASE_TEMPLATE("lloydRelax never leaves the unit interval and never disorders the splits", T, float, double)
{
    Random random(60);
    Tally tally;
    for (int i = 0; i < 1500; ++i)
    {
        const int width = random.between(1, 12);
        const int height = random.between(1, 12);
        Image<T> image = randomImage<T>(random, width, height);
        if (i % 3 == 0)
            for (T& depth : image.depths)
                depth = random.between(0, 1) == 0 ? T(0.25) : 4 * depth - 2;
        RelaxOptions<T> options;
        options.maxIterations = random.between(-1, 30);
        options.splitsPerIteration = random.between(0, 2);
        options.minVariance = i % 5 == 0 ? T(0) : T(1.0e-6);
        options.maxVariance = i % 7 == 0 ? std::numeric_limits<T>::max() : T(0.01);
        std::vector<T> splits = emptySplits<T>(random.between(1, 16));
        const RelaxResult<T> result = image.relax(splits, options);
        tally.claim(result && areValid(splits), i, describe(result.status));
        tally.claim(result.iterations >= 0 && result.iterations <= std::max(options.maxIterations, 0), i);
        tally.claim(result.movement >= T(0) && result.movement <= T(1), i);
    }
    LVSM_CHECK_TALLY(tally);
}

// Splits that crowd to one peak come as near to each other as numbers are: the mean of a cluster, rounded, passed by a
// neighbour.
TEST_CASE_TEMPLATE("splits that crowd to one peak stay in order", T, float, double)
{
    Random random(68);
    Tally tally;
    for (int i = 0; i < 2000; ++i)
    {
        RelaxOptions<T> options;
        options.splitsPerIteration = random.between(0, 1) * 2;
        options.minVariance = T(0);
        options.tolerance = T(0);
        options.maxIterations = random.between(1, 100);
        std::vector<T> splits = emptySplits<T>(random.between(3, 20));
        const RelaxResult<T> result = stripes<T>({random.unit<T>()}, random.unit<T>()).relax(splits, options);
        tally.claim(result && areValid(splits), i, describe(result.status));
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("lloydRelax clamps depths outside the unit interval", T, float, double)
{
    std::vector<T> clamped = emptySplits<T>(3);
    std::vector<T> beyond = emptySplits<T>(3);
    stripes<T>({T(0.5), T(1)}, T(0)).relax(clamped);
    stripes<T>({T(0.5), std::numeric_limits<T>::max()}, T(-7)).relax(beyond);
    CHECK(beyond == clamped);
}

TEST_CASE_TEMPLATE("lloydRelax does not depend on the order of the image", T, float, double)
{
    // Depths in 1024ths keep every moment exact in double, whatever the order of its sum. What is left are the sums of
    // weights and values over the neighbourhoods, each term rounded at most once: n u relative, in double, then one
    // rounding to T.
    Random random(61);
    for (int i = 0; i < 20; ++i)
    {
        const int width = random.between(2, 40);
        const int height = random.between(2, 40);
        const Image<T> image =
            makeImage<T>(width, height, [&](int, int) { return T(random.between(0, 1024)) / T(1024); });
        const Image<T> mirrored = makeImage<T>(width, height, [&](int x, int y) { return image.at(width - 1 - x, y); });
        const Image<T> flipped = makeImage<T>(width, height, [&](int x, int y) { return image.at(x, height - 1 - y); });
        const Image<T> transposed = makeImage<T>(height, width, [&](int x, int y) { return image.at(y, x); });
        std::vector<T> truth = emptySplits<T>(5);
        const RelaxResult<T> result = image.relax(truth);
        for (const Image<T>* other : {&mirrored, &flipped, &transposed})
        {
            std::vector<T> splits = emptySplits<T>(5);
            CHECK(other->relax(splits).iterations == result.iterations);
            for (std::size_t k = 0; k < truth.size(); ++k)
            {
                const Exact tolerance = 2 * width * height * kRoundoff<double> + 2 * kRoundoff<T>;
                CHECK(std::abs(Exact(splits[k]) - Exact(truth[k])) <= tolerance);
            }
        }
    }
}

TEST_CASE_TEMPLATE("two splits an iteration and all reach the same peaks", T, float, double)
{
    for (const std::vector<T>& peaks : {std::vector<T>{T(0.3), T(0.6), T(0.9)}, {T(0.2), T(0.4), T(0.6), T(0.8)}})
    {
        std::vector<T> all = emptySplits<T>(static_cast<int>(peaks.size()) + 1);
        std::vector<T> pairs = all;
        RelaxOptions<T> inPairs;
        inPairs.splitsPerIteration = 2;
        CHECK(stripes(peaks).relax(all).status == RelaxStatus::Converged);
        CHECK(stripes(peaks).relax(pairs, inPairs).status == RelaxStatus::Converged);
        for (std::size_t i = 0; i < peaks.size(); ++i)
        {
            CHECK(isNear(all[i + 1], peaks[i]));
            CHECK(isNear(pairs[i + 1], peaks[i]));
        }
    }
}

// Weighted squared distance of the second occluders to their nearest split: what the relaxation lessens.
template <typename T>
Exact spreadAround(const Image<T>& image, const std::vector<T>& splits)
{
    Exact sum = 0;
    for (int y = 0; y + 1 < image.height; ++y)
    {
        for (int x = 0; x + 1 < image.width; ++x)
        {
            const Vec2<double> moments = neighbourhoodMoments(
                depthMoments(double(image.at(x, y))), depthMoments(double(image.at(x + 1, y))),
                depthMoments(double(image.at(x, y + 1))), depthMoments(double(image.at(x + 1, y + 1))));
            const auto value = static_cast<T>(secondOccluder(moments));
            const int nearest = nearestSplit(value, splits.data(), static_cast<int>(splits.size()) - 1);
            const Exact gap = Exact(value) - splits[static_cast<std::size_t>(nearest)];
            sum += occluderWeight(moments, 1.0e-6, 0.25) * gap * gap;
        }
    }
    return sum;
}

TEST_CASE_TEMPLATE("two splits an iteration lessen the spread of a busy image as all do", T, float, double)
{
    // Both stop in local optima, which need not be the same; neither may be far from the other.
    Random random(62);
    for (int i = 0; i < 10; ++i)
    {
        const Image<T> image = randomImage<T>(random, 48, 48);
        std::vector<T> all = emptySplits<T>(6);
        std::vector<T> pairs = emptySplits<T>(6);
        RelaxOptions<T> options;
        options.maxIterations = 1000;
        CHECK(image.relax(all, options).status == RelaxStatus::Converged);
        options.splitsPerIteration = 2;
        CHECK(image.relax(pairs, options).status == RelaxStatus::Converged);
        std::vector<T> uniform;
        for (int k = 0; k <= 6; ++k)
            uniform.push_back(T(k) / T(6));
        const Exact start = spreadAround(image, uniform);
        CHECK(spreadAround(image, all) < start);
        CHECK(spreadAround(image, pairs) < start);
        CHECK(spreadAround(image, pairs) < Exact(1.1) * spreadAround(image, all));
        CHECK(spreadAround(image, all) < Exact(1.1) * spreadAround(image, pairs));
    }
}

TEST_CASE_TEMPLATE("lloydRelax agrees with the steps that a renderer runs", T, float, double)
{
    // The same relaxation from the functions of placement.hpp, sample by sample and two splits a frame.
    const std::vector<T> peaks{T(0.25), T(0.5), T(0.875)};
    const Image<T> image = stripes(peaks);
    std::vector<T> splits{T(0), T(0.25), T(0.5), T(0.75), T(1)};
    splits.erase(splits.begin() + 2);
    splits.insert(splits.begin() + 2, T(0.6));
    for (int frame = 0; frame < 60; ++frame)
    {
        const glm::ivec2 pair = scheduledSplits(frame, 4);
        Vec4<T> sums(0);
        for (int y = 0; y + 1 < image.height; ++y)
        {
            for (int x = 0; x + 1 < image.width; ++x)
            {
                const Vec2<T> moments =
                    neighbourhoodMoments(depthMoments(image.at(x, y)), depthMoments(image.at(x + 1, y)),
                                         depthMoments(image.at(x, y + 1)), depthMoments(image.at(x + 1, y + 1)));
                const T value = secondOccluder(moments);
                sums += accumulateSplits(value, occluderWeight(moments, T(1.0e-6), T(0.25)),
                                         nearestSplit(value, splits.data(), 4), pair.x, pair.y);
            }
        }
        T& first = splits[static_cast<std::size_t>(pair.x)];
        T& second = splits[static_cast<std::size_t>(pair.y)];
        first = updateSplit(first, sums.x, sums.y);
        second = updateSplit(second, sums.z, sums.w);
        monotoneSplits(splits.data(), 4);
    }
    std::vector<T> relaxed = emptySplits<T>(4);
    CHECK(image.relax(relaxed));
    // Means of at most 91 equal terms in T: each sum rounds that often.
    for (std::size_t i = 0; i < splits.size(); ++i)
        CHECK(std::abs(Exact(splits[i]) - Exact(relaxed[i])) <= 2 * 91 * kRoundoff<T>);
}

TEST_CASE_TEMPLATE("lloydRelaxMoments of a depth image's moments is lloydRelax", T, float, double)
{
    Random random(63);
    const Image<T> image = makeImage<T>(24, 17, [&](int, int) { return T(random.between(0, 1024)) / T(1024); });
    std::vector<Vec2<T>> moments;
    for (const T depth : image.depths)
        moments.push_back(depthMoments(depth));
    std::vector<T> fromDepths = emptySplits<T>(5);
    std::vector<T> fromMoments = emptySplits<T>(5);
    const RelaxResult<T> one = image.relax(fromDepths);
    const RelaxResult<T> other = lloydRelaxMoments(moments.data(), 24, 17, fromMoments.data(), 5);
    CHECK(fromDepths == fromMoments);
    CHECK(one.status == other.status);
    CHECK(one.iterations == other.iterations);
    CHECK(one.movement == other.movement);
}

TEST_CASE_TEMPLATE("an occluder midway between two splits belongs to the lower one alone", T, float, double)
{
    RelaxOptions<T> options;
    options.keepSplits = true;
    options.maxIterations = 1;
    std::vector<T> splits{T(0), T(0.25), T(0.5), T(1)};
    stripes<T>({T(0.375), T(0.875)}).relax(splits, options);
    CHECK(isNear(splits[1], 0.375L));
    CHECK(isNear(splits[2], 0.875L));
}

TEST_CASE_TEMPLATE("all clusters are judged before any split moves", T, float, double)
{
    // 0.5625 is nearer to the second split until the first moves to 0.4375. The cap makes the weights equal.
    RelaxOptions<T> options;
    options.keepSplits = true;
    options.maxIterations = 1;
    options.maxVariance = T(0.01);
    std::vector<T> splits{T(0), T(0.25), T(0.75), T(1)};
    const RelaxResult<T> result = stripes<T>({T(0.4375), T(0.5625), T(0.875)}).relax(splits, options);
    CHECK(isNear(splits[1], 0.4375L));
    CHECK(isNear(splits[2], 0.71875L));
    CHECK(isNear(result.movement, 0.1875L));
}

TEST_CASE_TEMPLATE("in pairs it converges only after a whole round of quiet iterations", T, float, double)
{
    const Image<T> image = stripes<T>({T(0.2), T(0.4), T(0.6), T(0.8)});
    RelaxOptions<T> options;
    options.keepSplits = true;
    options.splitsPerIteration = 2;
    // The first pair is right, the second is not yet.
    std::vector<T> splits{T(0), T(0.2), T(0.4), T(0.65), T(0.8), T(1)};
    RelaxResult<T> result = image.relax(splits, options);
    CHECK(result.status == RelaxStatus::Converged);
    CHECK(isNear(splits[3], 0.6L));
    CHECK(result.iterations == 4);

    // Both pairs are quiet; the movement is the larger of the two.
    options.tolerance = T(0.1);
    splits = {T(0), T(0.25), T(0.4), T(0.6), T(0.8), T(1)};
    result = image.relax(splits, options);
    CHECK(result.status == RelaxStatus::Converged);
    CHECK(result.iterations == 2);
    CHECK(isNear(result.movement, 0.05L));
}

TEST_CASE_TEMPLATE("a sample of a large image has its peaks", T, float, double)
{
    // Every run of texels holds all of the peaks.
    const std::vector<T> peaks{T(0.3), T(0.6), T(0.9)};
    const Image<T> striped = makeImage<T>(
        700, 500, [&](int x, int) { return x % 4 < 2 ? T(0) : peaks[static_cast<std::size_t>(x / 4 % 3)]; });
    RelaxOptions<T> options;
    options.maxSamples = 4096;
    std::vector<T> splits = emptySplits<T>(4);
    CHECK(striped.relax(splits, options).status == RelaxStatus::Converged);
    for (std::size_t i = 0; i < peaks.size(); ++i)
        CHECK(isNear(splits[i + 1], peaks[i]));

    // It is a sample: all texels of a busy image give other splits.
    Random random(66);
    const Image<T> busy = randomImage<T>(random, 300, 200);
    std::vector<T> all = splits;
    CHECK(busy.relax(splits, options));
    CHECK(busy.relax(all));
    CHECK(splits != all);
    // As many samples as there are neighbourhoods are all of them.
    options.maxSamples = 299 * 199;
    CHECK(busy.relax(splits, options));
    CHECK(splits == all);
}

TEST_CASE_TEMPLATE("a kept start that is already right converges at once", T, float, double)
{
    const Image<T> image = stripes<T>({T(0.3), T(0.6), T(0.9)});
    std::vector<T> splits = emptySplits<T>(4);
    const RelaxResult<T> cold = image.relax(splits);
    RelaxOptions<T> options;
    options.keepSplits = true;
    const std::vector<T> before = splits;
    const RelaxResult<T> warm = image.relax(splits, options);
    CHECK(warm.status == RelaxStatus::Converged);
    CHECK(warm.iterations == 1);
    CHECK(warm.iterations < cold.iterations);
    CHECK(warm.movement == 0);
    CHECK(splits == before);
}

TEST_CASE_TEMPLATE("a kept start is where the relaxation starts", T, float, double)
{
    const Image<T> image = stripes<T>({T(0.3), T(0.6), T(0.9)});
    RelaxOptions<T> options;
    options.maxIterations = 0;
    options.keepSplits = true;
    const std::vector<T> start{T(0), T(0.1), T(0.1), T(0.95), T(1)};
    std::vector<T> splits = start;
    CHECK(image.relax(splits, options).status == RelaxStatus::IterationLimit);
    CHECK(splits == start);
    options.keepSplits = false;
    CHECK(image.relax(splits, options).status == RelaxStatus::IterationLimit);
    CHECK(splits == std::vector<T>{T(0), T(0.25), T(0.5), T(0.75), T(1)});
}

TEST_CASE_TEMPLATE("the iteration limit stops with splits that are valid", T, float, double)
{
    Random random(64);
    const Image<T> image = randomImage<T>(random, 32, 32);
    RelaxOptions<T> options;
    options.tolerance = T(0);
    options.maxIterations = 2;
    std::vector<T> splits = emptySplits<T>(8);
    const RelaxResult<T> result = image.relax(splits, options);
    CHECK(result.status == RelaxStatus::IterationLimit);
    CHECK(result);
    CHECK(result.iterations == 2);
    CHECK(result.movement > 0);
    CHECK(areValid(splits));
}

TEST_CASE_TEMPLATE("one layer needs no relaxation", T, float, double)
{
    std::vector<T> splits = emptySplits<T>(1);
    const RelaxResult<T> result = stripes<T>({T(0.5)}).relax(splits);
    CHECK(result.status == RelaxStatus::Converged);
    CHECK(result.iterations == 0);
    CHECK(splits == std::vector<T>{T(0), T(1)});
}

TEST_CASE_TEMPLATE("an image without a discontinuity leaves the starting splits", T, float, double)
{
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(16, 16), glm::ivec2(1, 9), glm::ivec2(9, 1)})
    {
        const Image<T> flat = makeImage<T>(size.x, size.y, [](int, int) { return T(0.3); });
        std::vector<T> splits = emptySplits<T>(4);
        const RelaxResult<T> result = flat.relax(splits);
        CHECK(result.status == RelaxStatus::NoDiscontinuity);
        CHECK(result);
        CHECK(result.iterations == 0);
        CHECK(result.movement == 0);
        CHECK(splits == std::vector<T>{T(0), T(0.25), T(0.5), T(0.75), T(1)});
        RelaxOptions<T> options;
        options.keepSplits = true;
        std::vector<T> kept{T(0), T(0.1), T(1)};
        CHECK(flat.relax(kept, options).status == RelaxStatus::NoDiscontinuity);
        CHECK(kept == std::vector<T>{T(0), T(0.1), T(1)});
    }
}

TEST_CASE_TEMPLATE("a single row and a single column are images too", T, float, double)
{
    const std::vector<T> pattern{T(0), T(0.3), T(0.3), T(0), T(0), T(0.8), T(0.8), T(0)};
    const auto depthAt = [&](int i)
    {
        return pattern[static_cast<std::size_t>(i)];
    };
    std::vector<T> row = emptySplits<T>(3);
    std::vector<T> column = emptySplits<T>(3);
    CHECK(makeImage<T>(8, 1, [&](int x, int) { return depthAt(x); }).relax(row).status == RelaxStatus::Converged);
    CHECK(makeImage<T>(1, 8, [&](int, int y) { return depthAt(y); }).relax(column).status == RelaxStatus::Converged);
    CHECK(row == column);
    CHECK(isNear(row[1], T(0.3)));
    CHECK(isNear(row[2], T(0.8)));
}

// An error leaves the splits as they were and converts to false.
template <typename T>
void checkError(const RelaxResult<T>& result, RelaxStatus status, const std::vector<T>& splits,
                const std::vector<T>& before)
{
    CHECK(result.status == status);
    CHECK_FALSE(result);
    CHECK(result.iterations == 0);
    CHECK(splits == before);
}

TEST_CASE_TEMPLATE("an image that is not there is an error, and nothing is written", T, float, double)
{
    const T depths[] = {T(0), T(1)};
    const Vec2<T> moments[] = {{T(0), T(0)}, {T(1), T(1)}};
    const T* noDepths = nullptr;
    const Vec2<T>* noMoments = nullptr;
    const std::vector<T> before = emptySplits<T>(2);
    std::vector<T> splits = before;
    checkError(lloydRelax(noDepths, 2, 1, splits.data(), 2), RelaxStatus::NoImage, splits, before);
    checkError(lloydRelaxMoments(noMoments, 2, 1, splits.data(), 2), RelaxStatus::NoImage, splits, before);
    for (const int size : {0, -1, std::numeric_limits<int>::min()})
    {
        checkError(lloydRelax(depths, size, 1, splits.data(), 2), RelaxStatus::NoImage, splits, before);
        checkError(lloydRelax(depths, 1, size, splits.data(), 2), RelaxStatus::NoImage, splits, before);
        checkError(lloydRelaxMoments(moments, size, 1, splits.data(), 2), RelaxStatus::NoImage, splits, before);
        checkError(lloydRelaxMoments(moments, 1, size, splits.data(), 2), RelaxStatus::NoImage, splits, before);
    }
}

TEST_CASE_TEMPLATE("no layers is an error, and nothing is written", T, float, double)
{
    const T depths[] = {T(0), T(1)};
    const std::vector<T> before = emptySplits<T>(2);
    std::vector<T> splits = before;
    T* none = nullptr;
    checkError(lloydRelax(depths, 2, 1, none, 2), RelaxStatus::NoLayers, splits, before);
    for (const int layers : {0, -1, std::numeric_limits<int>::min()})
        checkError(lloydRelax(depths, 2, 1, splits.data(), layers), RelaxStatus::NoLayers, splits, before);
}

TEST_CASE_TEMPLATE("a depth or moment that is not finite is an error, and nothing is written", T, float, double)
{
    using Limits = std::numeric_limits<T>;
    for (const T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()})
    {
        for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 2), glm::ivec2(1, 5), glm::ivec2(5, 1)})
        {
            for (int at = 0; at < size.x * size.y; ++at)
            {
                Image<T> image = makeImage<T>(size.x, size.y, [](int x, int y) { return T((x + y) % 2); });
                image.depths[static_cast<std::size_t>(at)] = bad;
                const std::vector<T> before = emptySplits<T>(3);
                std::vector<T> splits = before;
                checkError(image.relax(splits), RelaxStatus::DepthNotFinite, splits, before);
                for (int component : {0, 1})
                {
                    std::vector<Vec2<T>> moments(image.depths.size(), depthMoments(T(0.5)));
                    moments[static_cast<std::size_t>(at)][component] = bad;
                    checkError(lloydRelaxMoments(moments.data(), size.x, size.y, splits.data(), 3),
                               RelaxStatus::DepthNotFinite, splits, before);
                }
            }
        }
    }
}

TEST_CASE_TEMPLATE("moments of any finite size give valid splits", T, float, double)
{
    Random random(65);
    for (int i = 0; i < 200; ++i)
    {
        std::vector<Vec2<T>> moments;
        for (int k = 0; k < 36; ++k)
            moments.emplace_back(random.finitePattern<T>(), random.finitePattern<T>());
        RelaxOptions<T> options;
        options.maxVariance = i % 2 == 0 ? T(0.25) : std::numeric_limits<T>::max();
        std::vector<T> splits = emptySplits<T>(4);
        const RelaxResult<T> result = lloydRelaxMoments(moments.data(), 6, 6, splits.data(), 4, options);
        CHECK(result);
        CHECK(areValid(splits));
    }
}

TEST_CASE_TEMPLATE("a kept start that does not rise is an error, and nothing is written", T, float, double)
{
    const Image<T> image = stripes<T>({T(0.5)});
    RelaxOptions<T> options;
    options.keepSplits = true;
    const T nan = std::numeric_limits<T>::quiet_NaN();
    for (const std::vector<T>& before : {std::vector<T>{T(0), T(0.6), T(0.5), T(1)},
                                         {T(0.1), T(0.5), T(0.6), T(1)},
                                         {T(0), T(0.5), T(0.6), T(0.9)},
                                         {T(0), T(-0.5), T(0.6), T(1)},
                                         {T(0), T(0.5), T(1.5), T(1)}})
    {
        std::vector<T> splits = before;
        checkError(image.relax(splits, options), RelaxStatus::SplitsNotIncreasing, splits, before);
    }
    std::vector<T> splits{T(0), nan, T(0.6), T(1)};
    CHECK(image.relax(splits, options).status == RelaxStatus::SplitsNotIncreasing);
    CHECK(bitsOf(splits[1]) == bitsOf(nan));
    // Not kept, they are never read.
    CHECK(image.relax(splits).status == RelaxStatus::Converged);
}

TEST_CASE("every status is described in words of its own")
{
    const RelaxStatus all[] = {
        RelaxStatus::Converged, RelaxStatus::IterationLimit, RelaxStatus::NoDiscontinuity,    RelaxStatus::NoImage,
        RelaxStatus::NoLayers,  RelaxStatus::DepthNotFinite, RelaxStatus::SplitsNotIncreasing};
    std::vector<std::string> words;
    for (const RelaxStatus status : all)
        words.emplace_back(describe(status));
    std::sort(words.begin(), words.end());
    CHECK(std::adjacent_find(words.begin(), words.end()) == words.end());
    for (const std::string& text : words)
        CHECK(text.size() > 10);
    CHECK(std::string(describe(RelaxStatus::NoImage)).find("no image") != std::string::npos);
    CHECK(std::string(describe(RelaxStatus::NoLayers)).find("no layers") != std::string::npos);
    CHECK(std::string(describe(RelaxStatus::DepthNotFinite)).find("NaN") != std::string::npos);
    CHECK(std::string(describe(RelaxStatus::SplitsNotIncreasing)).find("rise") != std::string::npos);
}

TEST_CASE_TEMPLATE("all of a wide image is read, and nothing beyond it", T, float, double)
{
    // An edge far to the right, in a row that is more than one run of texels.
    for (const int edge : {3, 70, 150, 198})
    {
        const Image<T> image = makeImage<T>(200, 2, [edge](int x, int) { return x < edge ? T(0) : T(0.625); });
        std::vector<T> splits = emptySplits<T>(2);
        CHECK(image.relax(splits).status == RelaxStatus::Converged);
        CHECK(isNear(splits[1], 0.625L));
    }
    LVSM_NOT_WITH_FAST_MATH("NaN");
    for (const glm::ivec2 size : {glm::ivec2(200, 3), glm::ivec2(2, 2), glm::ivec2(64, 1), glm::ivec2(1, 7)})
    {
        Image<T> image = makeImage<T>(size.x, size.y, [](int x, int y) { return T((x + y) % 2); });
        image.depths.push_back(std::numeric_limits<T>::quiet_NaN());
        std::vector<T> splits = emptySplits<T>(2);
        CHECK(image.relax(splits));
    }
}

TEST_CASE_TEMPLATE("the first cluster reaches to depth 0 where teleportation judges it, too", T, float, double)
{
    // A peak weighs as its square. The first split moves to the mean of .2 and .6, .56, and the second to .63: now .6 is
    // the second's, and .2, nearer to 0 than to the first split, all that the first has.
    const Image<T> image = stripes<T>({T(0.2), T(0.6), T(0.63)});
    RelaxOptions<T> options;
    options.keepSplits = true;
    options.maxIterations = 1;
    std::vector<T> splits{0, T(0.5), T(0.75), 1};
    image.relax(splits, options);
    CHECK(splits[1] == doctest::Approx(0.56));
    CHECK(splits[2] == doctest::Approx(0.63));
}

TEST_CASE_TEMPLATE("nothing in front of the splits or behind them is read or written", T, float, double)
{
    Random random(47);
    const Image<T> image = randomImage<T>(random, 40, 30);
    for (int layers = 1; layers <= 8; ++layers)
    {
        std::vector<T> alone = emptySplits<T>(layers);
        image.relax(alone);
        std::vector<T> between(alone.size() + 2, T(9));
        lloydRelax(image.depths.data(), image.width, image.height, between.data() + 1, layers);
        CHECK(between.front() == T(9));
        CHECK(between.back() == T(9));
        CHECK(std::equal(alone.begin(), alone.end(), between.begin() + 1));
    }
}

TEST_CASE_TEMPLATE("occluders count at both ends of the depth range", T, float, double)
{
    RelaxOptions<T> options;
    options.minVariance = T(0);
    for (const T peak : {T(0x1p-11), T(1)})
    {
        std::vector<T> splits = emptySplits<T>(2);
        CHECK(stripes<T>({peak}).relax(splits, options).status == RelaxStatus::Converged);
        CHECK(isNear(splits[1], peak));
    }
}

TEST_CASE_TEMPLATE("an odd number of splits takes one more pair for a round", T, float, double)
{
    const Image<T> image = stripes<T>({T(0.25), T(0.5), T(0.875)});
    RelaxOptions<T> options;
    options.splitsPerIteration = 2;
    std::vector<T> splits = emptySplits<T>(4);
    CHECK(image.relax(splits, options).status == RelaxStatus::Converged);
    CHECK(isNear(splits[3], 0.875L));

    // The movement is the largest of the round, whichever pair has it.
    options.tolerance = T(0.2);
    splits = emptySplits<T>(4);
    const RelaxResult<T> result = image.relax(splits, options);
    CHECK(result.status == RelaxStatus::Converged);
    CHECK(isNear(result.movement, 0.125L));
}

TEST_CASE_TEMPLATE("a tolerance of 0 is met by splits that do not move at all", T, float, double)
{
    RelaxOptions<T> options;
    options.tolerance = T(0);
    std::vector<T> splits = emptySplits<T>(2);
    CHECK(stripes<T>({T(0.5)}).relax(splits, options).status == RelaxStatus::Converged);
}

} // namespace
} // namespace lvsm::unit
