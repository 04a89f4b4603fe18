#include <lvsm/optimal.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

// The cells with the least within-cell spread, by trying all, and their splits.
struct Partition
{
    double cost = 1e300;
    std::vector<int> edges;
};

double centre(std::size_t bin, std::size_t bins)
{
    return (static_cast<double>(bin) + 0.5) / static_cast<double>(bins);
}

double mean(const std::vector<double>& weights, int first, int last)
{
    double weight = 0, sum = 0;
    for (int i = first; i < last; ++i)
    {
        weight += weights[std::size_t(i)];
        sum += weights[std::size_t(i)] * centre(std::size_t(i), weights.size());
    }
    return sum / weight;
}

double spread(const std::vector<double>& weights, int first, int last)
{
    const double middle = mean(weights, first, last);
    double sum = 0;
    for (int i = first; i < last; ++i)
    {
        const double distance = centre(std::size_t(i), weights.size()) - middle;
        sum += weights[std::size_t(i)] * distance * distance;
    }
    return sum;
}

void tryAll(const std::vector<double>& weights, int cells, int leastBins, std::vector<int>& edges, double cost,
            Partition& best)
{
    const int bins = static_cast<int>(weights.size());
    if (cells == 1)
    {
        if (bins - edges.back() < leastBins)
            return;
        cost += spread(weights, edges.back(), bins);
        if (cost < best.cost)
            best = {cost, edges};
        return;
    }
    const int first = edges.back();
    for (int last = first + leastBins; last < bins; ++last)
    {
        edges.push_back(last);
        tryAll(weights, cells - 1, leastBins, edges, cost + spread(weights, first, last), best);
        edges.pop_back();
    }
}

// The histogram that the placement works on: normalised, with its share of a uniform one.
std::vector<double> mixed(std::vector<double> weights, double uniformShare)
{
    double sum = 0;
    for (const double weight : weights)
        sum += weight;
    for (double& weight : weights)
        weight = (1 - uniformShare) * weight / sum + uniformShare / double(weights.size());
    return weights;
}

TEST_CASE("optimalSplitsHistogram finds what trying all partitions finds")
{
    Random random(131);
    Tally tally;
    for (int i = 0; i < 3000; ++i)
    {
        std::vector<double> weights(static_cast<std::size_t>(random.between(4, 12)));
        for (double& weight : weights)
            weight = random.unit<double>() * random.unit<double>() + 1e-3;
        const int bins = static_cast<int>(weights.size());
        const int layers = random.between(1, 4);
        OptimalOptions<double> options;
        options.uniformShare = 0.25 * random.between(0, 3);
        const int leastBins = random.between(1, bins / layers);
        options.minLength = (leastBins + 0.5) / bins;

        Partition best;
        std::vector<int> edges{0};
        const std::vector<double> mix = mixed(weights, options.uniformShare);
        tryAll(mix, layers, leastBins, edges, 0, best);
        best.edges.push_back(bins);

        double splits[5];
        const auto result = optimalSplitsHistogram(weights.data(), bins, splits, layers, options);
        tally.claim(result.status == OptimalStatus::Optimal && splits[0] == 0 && splits[layers] == 1, i);
        for (std::size_t k = 1; k < std::size_t(layers); ++k)
        {
            const std::vector<int>& edge = best.edges;
            const double expected = 0.5 * (mean(mix, edge[k - 1], edge[k]) + mean(mix, edge[k], edge[k + 1]));
            tally.claim(std::abs(splits[k] - expected) < 1e-12, i, k, splits[k], expected);
        }
        // Where no cell is held apart by its least length, each bin is nearest to the mean of its own cell.
        if (leastBins == 1)
            tally.claim(std::abs(result.distortion - best.cost) < 1e-12, i, result.distortion, best.cost);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("two peaks are parted halfway", T, float, double)
{
    std::vector<T> weights(64, T(0));
    weights[8] = 3;
    weights[40] = 1;
    T splits[3];
    OptimalOptions<T> options;
    options.uniformShare = 0;
    CHECK(optimalSplitsHistogram(weights.data(), 64, splits, 2, options));
    CHECK(splits[1] == (T(8.5) + T(40.5)) / T(128));
}

TEST_CASE_TEMPLATE("a histogram without weight, and an image without edges, give uniform splits", T, float, double)
{
    const std::vector<T> weights(64, T(0));
    const std::vector<T> flat(32 * 32, T(0.3));
    for (const int layers : {1, 2, 4, 8, 16})
    {
        T splits[17], of[17];
        CHECK(optimalSplitsHistogram(weights.data(), 64, splits, layers));
        CHECK(optimalSplits(flat.data(), 32, 32, of, layers));
        for (int i = 0; i <= layers; ++i)
        {
            CHECK(std::abs(splits[i] - T(i) / T(layers)) < T(1e-6));
            CHECK(std::abs(of[i] - T(i) / T(layers)) < T(1e-6));
        }
    }
}

TEST_CASE("optimalSplits puts its splits between the depths that meet at edges")
{
    // Three planes in stripes, 0.2, 0.5 and 0.8; the two near ones touch both others.
    std::vector<float> image(64 * 64);
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = 0.2f + 0.3f * static_cast<float>(i / 8 % 3);
    float splits[4];
    OptimalOptions<float> options;
    options.uniformShare = 0;
    const auto result = optimalSplits(image.data(), 64, 64, splits, 3, options);
    CHECK(result);
    CHECK(splits[1] == doctest::Approx(0.35).epsilon(0.01));
    CHECK(splits[2] == doctest::Approx(0.65).epsilon(0.01));
    CHECK(result.distortion < 1e-6f);
}

TEST_CASE("a sample of a large image places the splits as the whole image does")
{
    // Waves over steps of 37 texels, so that edges fall on every place of a run.
    constexpr int kSize = 1024;
    std::vector<float> image(kSize * kSize);
    for (int y = 0; y < kSize; ++y)
    {
        for (int x = 0; x < kSize; ++x)
        {
            const float wave =
                0.2f * std::sin(0.02f * static_cast<float>(x)) * std::cos(0.013f * static_cast<float>(y));
            image[static_cast<std::size_t>(y * kSize + x)] = 0.5f + wave + ((x / 37 + y / 51) % 4 == 0 ? 0.2f : 0.0f);
        }
    }
    float splits[5];
    CHECK(optimalSplits(image.data(), kSize, kSize, splits, 4));
    const float sampled = splits[2];
    // Judged by all texels, they are kept.
    OptimalOptions<float> all;
    all.maxSamples = 0;
    all.leastGain = 0.01f;
    CHECK(optimalSplits(image.data(), kSize, kSize, splits, 4, all).status == OptimalStatus::Kept);
    // It was a sample: all texels give others.
    all.leastGain = 0;
    CHECK(optimalSplits(image.data(), kSize, kSize, splits, 4, all));
    CHECK(splits[2] != sampled);
}

TEST_CASE("a sample of a large image finds edges in any of its columns")
{
    constexpr int kSize = 1024;
    for (int column = 16; column < kSize; column += 64)
    {
        std::vector<float> image(kSize * kSize, 0.9f);
        for (int y = 0; y < kSize; ++y)
            image[static_cast<std::size_t>(y * kSize + column)] = 0.8f;
        float splits[3];
        CHECK(optimalSplits(image.data(), kSize, kSize, splits, 2));
        CHECK(splits[1] > 0.55f);
    }
}

TEST_CASE("splits rise, and no layer is shorter than half the least cell")
{
    Random random(132);
    Tally tally;
    for (int i = 0; i < 300; ++i)
    {
        std::vector<float> image(24 * 24);
        const float centre = random.unit<float>();
        for (float& depth : image)
            depth = centre + 0.01f * random.unit<float>();
        OptimalOptions<float> options;
        options.uniformShare = 0.001f;
        float splits[17];
        const int layers = random.between(1, 16);
        tally.claim(bool(optimalSplits(image.data(), 24, 24, splits, layers, options)), i);
        for (int k = 0; k < layers; ++k)
        {
            // A rounding of each split less than half of 1/64.
            tally.claim(splits[k + 1] - splits[k] >= 1.0f / 128 - 1.2e-7f, layers, k, splits[k], splits[k + 1]);
        }
        tally.claim(splits[0] == 0 && splits[layers] == 1, layers);
    }
    LVSM_CHECK_TALLY(tally);
}

// Of cells with next to no weight nothing but rounding is left to take a mean of.
TEST_CASE_TEMPLATE("splits rise where the share of a uniform histogram is next to nothing", T, float, double)
{
    Random random(133);
    Tally tally;
    for (int i = 0; i < 2000; ++i)
    {
        const int bins = random.between(1, 1024);
        std::vector<T> weights(static_cast<std::size_t>(bins), T(0));
        const T scale = std::ldexp(T(1), random.between(-140, 120));
        for (int k = random.between(0, 4); k > 0; --k)
            weights[static_cast<std::size_t>(random.between(0, bins - 1))] = random.unit<T>() * scale;
        OptimalOptions<T> options;
        options.uniformShare = std::ldexp(random.unit<T>(), -random.between(0, 60));
        const int leastBins = random.between(0, 32);
        options.minLength = (T(leastBins) + T(0.5)) / T(bins);
        T splits[17];
        const int layers = random.between(1, 16);
        const int cells = std::min(layers, bins);
        tally.claim(bool(optimalSplitsHistogram(weights.data(), bins, splits, layers, options)), i);
        const Exact least = Exact(std::clamp(leastBins, 1, bins / cells)) / bins / 2;
        for (int k = 0; k < cells; ++k)
            tally.claim(splits[k + 1] - splits[k] >= least - 2 * kRoundoff<T>, i, bins, layers, k, splits[k],
                        splits[k + 1]);
        tally.claim(splits[0] == 0 && splits[layers] == 1, i, bins, layers);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("weights of any finite size are weighed alike")
{
    const double shape[] = {3, 0, 0, 1, 0, 0, 0, 2};
    double expected[4];
    REQUIRE(optimalSplitsHistogram(shape, 8, expected, 3));
    for (const double scale : {0x1p-1070, 0x1p-1020, 0x1p1000, 0x1p1022})
    {
        // -ffast-math divides by the inverse, and neither may be subnormal.
        if (kFastMath && (scale < 0x1p-1020 || scale > 0x1p1000))
            continue;
        double weights[8], splits[4];
        for (int i = 0; i < 8; ++i)
            weights[i] = shape[i] * scale;
        CHECK(optimalSplitsHistogram(weights, 8, splits, 3));
        for (int k = 0; k <= 3; ++k)
            CHECK(splits[k] == expected[k]);
    }
}

TEST_CASE("by default three tenths of the weight are uniform, and a cell is a 64th long at least")
{
    // All weight in one of two bins: with a share u mixed in, 1 - u / 2 are in it and u / 2 are half the range away.
    const double one[] = {1, 0};
    double ends[2];
    CHECK(optimalSplitsHistogram(one, 2, ends, 1).distortion == doctest::Approx(0.85 * 0.15 / 4).epsilon(1e-12));

    // Two bins with weight at the very front, which would have a split between them. The cells are 0 to 1/64 and the
    // rest: their means are that of the two bins, and the middle of the rest.
    std::vector<double> weights(1024, 0.0);
    weights[0] = weights[1] = 1;
    OptimalOptions<double> options;
    options.uniformShare = 0;
    double splits[3];
    CHECK(optimalSplitsHistogram(weights.data(), 1024, splits, 2, options));
    CHECK(splits[1] == doctest::Approx(0.5 * (1.0 / 1024 + 0.5 * (1 + 1.0 / 64))).epsilon(1e-9));
}

// Four times the standard deviation of the depths at each texel, its right, its lower and its diagonal neighbour, where
// the last column and row repeat.
std::vector<double> weighed(const std::vector<double>& image, int width, int height)
{
    std::vector<double> weights(kMaxOptimalBins, 0.0);
    const auto at = [&](int x, int y)
    {
        return image[static_cast<std::size_t>(std::min(y, height - 1) * width + std::min(x, width - 1))];
    };
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            const double depths[] = {at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)};
            double middle = 0, squares = 0;
            for (const double depth : depths)
                middle += depth / 4;
            for (const double depth : depths)
                squares += (depth - middle) * (depth - middle) / 4;
            weights[std::min(std::size_t(depths[0] * 1024), std::size_t(1023))] += 4 * std::sqrt(squares);
        }
    }
    return weights;
}

TEST_CASE("an image's depths weigh as their neighbourhoods deviate, wherever in the image they are")
{
    Random random(134);
    Tally tally;
    for (int i = 0; i < 400; ++i)
    {
        const int width = random.between(1, 200);
        const int height = random.between(1, 6);
        std::vector<double> image(static_cast<std::size_t>(width * height));
        const double background = random.unit<double>();
        for (double& depth : image)
            depth = random.between(0, 7) == 0 ? random.unit<double>() : background;
        image[0] = i % 3 == 0 ? 1 : 0;
        OptimalOptions<double> options;
        options.maxSamples = 0;
        double splits[5], expected[5];
        const auto result = optimalSplits(image.data(), width, height, splits, 4, options);
        const auto truth =
            optimalSplitsHistogram(weighed(image, width, height).data(), kMaxOptimalBins, expected, 4, options);
        tally.claim(std::abs(result.distortion - truth.distortion) < 1e-12, i, width, height, result.distortion,
                    truth.distortion);
        for (int k = 0; k <= 4; ++k)
            tally.claim(std::abs(splits[k] - expected[k]) < 1e-9, i, width, height, k, splits[k], expected[k]);
    }
    LVSM_CHECK_TALLY(tally);
}

// The only edge of the image is between one run of texels that are read together and the next.
TEST_CASE("an edge at texel 64 places the splits as one anywhere else does")
{
    OptimalOptions<float> options;
    options.uniformShare = 0;
    float splits[2][3];
    for (const int edge : {40, 64})
    {
        std::vector<float> image(128, 0.1f);
        for (int x = edge; x < 128; ++x)
            image[static_cast<std::size_t>(x)] = 0.9f;
        CHECK(optimalSplits(image.data(), 128, 1, splits[edge / 64], 2, options));
    }
    CHECK(splits[0][1] == splits[1][1]);
    CHECK(splits[1][1] < 0.4f);
}

TEST_CASE("hysteresis keeps the previous splits unless the new ones gain enough")
{
    std::vector<double> weights(128);
    const auto peaks = [&](double first, double second)
    {
        for (std::size_t i = 0; i < weights.size(); ++i)
        {
            const double x = centre(i, weights.size());
            weights[i] = std::exp(-400 * (x - first) * (x - first)) + std::exp(-400 * (x - second) * (x - second));
        }
    };
    double splits[3];
    peaks(0.3, 0.7);
    REQUIRE(optimalSplitsHistogram(weights.data(), 128, splits, 2));
    const double before = splits[1];

    OptimalOptions<double> options;
    options.leastGain = 0.1;
    peaks(0.31, 0.71);
    const auto kept = optimalSplitsHistogram(weights.data(), 128, splits, 2, options);
    CHECK(kept.status == OptimalStatus::Kept);
    CHECK(bool(kept));
    CHECK(splits[1] == before);

    peaks(0.1, 0.5);
    double fresh[3];
    const auto optimum = optimalSplitsHistogram(weights.data(), 128, fresh, 2);
    const auto moved = optimalSplitsHistogram(weights.data(), 128, splits, 2, options);
    CHECK(moved.status == OptimalStatus::Optimal);
    CHECK(splits[1] == fresh[1]);
    CHECK(moved.distortion == optimum.distortion);

    // What is no placement is replaced, even if nothing at all would be gained.
    options.leastGain = 0.999999;
    for (const std::vector<double>& broken :
         {std::vector<double>{0, 2, 1}, {0, 0, 1}, {0, 1, 1}, {0.01, 0.3, 1}, {0, 0.3, 0.99}, {0, -1, 1}})
    {
        std::vector<double> replaced = broken;
        CHECK(optimalSplitsHistogram(weights.data(), 128, replaced.data(), 2, options).status ==
              OptimalStatus::Optimal);
        CHECK(replaced[1] == fresh[1]);
    }
    double equal[] = {0, 0.3, 0.3, 1};
    CHECK(optimalSplitsHistogram(weights.data(), 128, equal, 3, options).status == OptimalStatus::Optimal);
    CHECK(equal[1] < equal[2]);
}

TEST_CASE("what makes no sense is said, and the splits are left alone")
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    std::vector<float> image(16, 0.5f);
    float splits[17] = {-1};
    using Status = OptimalStatus;
    CHECK(optimalSplits<float>(nullptr, 4, 4, splits, 2).status == Status::NoImage);
    CHECK(optimalSplits(image.data(), 0, 4, splits, 2).status == Status::NoImage);
    CHECK(optimalSplits(image.data(), 4, 0, splits, 2).status == Status::NoImage);
    CHECK(optimalSplits(image.data(), 4, 0, splits, 2).distortion == 0);
    CHECK(optimalSplitsHistogram(image.data(), 0, splits, 2).status == Status::NoHistogram);
    CHECK(optimalSplitsHistogram<float>(image.data(), 16, nullptr, 2).status == Status::LayerCountOutOfRange);
    CHECK(optimalSplitsHistogram(image.data(), 16, splits, 0).status == Status::LayerCountOutOfRange);
    CHECK(optimalSplitsHistogram(image.data(), 16, splits, 17).status == Status::LayerCountOutOfRange);
    CHECK(optimalSplits<float>(image.data(), 4, 4, nullptr, 2).status == Status::LayerCountOutOfRange);
    CHECK(optimalSplits(image.data(), 4, 4, splits, 0).status == Status::LayerCountOutOfRange);
    CHECK(optimalSplits(image.data(), 4, 4, splits, 17).status == Status::LayerCountOutOfRange);
    CHECK(optimalSplitsHistogram<float>(nullptr, 4, splits, 2).status == Status::NoHistogram);
    CHECK(optimalSplitsHistogram(image.data(), 1025, splits, 2).status == Status::NoHistogram);
    for (const float bad : {nan, infinity, -infinity})
    {
        image[7] = bad;
        CHECK(optimalSplits(image.data(), 4, 4, splits, 2).status == Status::DepthNotFinite);
        CHECK(optimalSplitsHistogram(image.data(), 16, splits, 2).status == Status::WeightNotFinite);
    }
    image[7] = -1;
    CHECK(optimalSplitsHistogram(image.data(), 16, splits, 2).status == Status::WeightNotFinite);
    CHECK(splits[0] == -1);
    for (int status = 0; status <= int(Status::WeightNotFinite); ++status)
    {
        CHECK(std::string(describe(Status(status))) != "unknown status");
    }
}

TEST_CASE("more layers than bins leave the rest empty")
{
    const double weights[] = {1, 2};
    double splits[5];
    CHECK(optimalSplitsHistogram(weights, 2, splits, 4));
    CHECK(splits[1] == 0.5);
    CHECK(splits[2] == 1);
    CHECK(splits[4] == 1);
}

TEST_CASE("nothing beyond an image or a histogram is read")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    double splits[3];
    for (const auto& [width, height] : {std::pair(200, 3), std::pair(64, 1), std::pair(1, 7)})
    {
        std::vector<double> image(static_cast<std::size_t>(width * height), 0.25);
        image.push_back(nan);
        CHECK(optimalSplits(image.data(), width, height, splits, 2));
    }
    std::vector<double> weights(1024, 1.0);
    weights.push_back(nan);
    CHECK(optimalSplitsHistogram(weights.data(), 1024, splits, 2));
    CHECK(optimalSplitsHistogram(weights.data() + 1000, 24, splits, 2));
}

TEST_CASE("depths outside [0,1] count as its ends, wherever in a run they are")
{
    Random random(133);
    for (int i = 0; i < 20; ++i)
    {
        std::vector<double> wild, tame;
        for (int texel = 0; texel < 130 * 4; ++texel)
        {
            wild.push_back(3 * random.unit<double>() - 1);
            tame.push_back(std::clamp(wild.back(), 0.0, 1.0));
        }
        double first[5], second[5];
        CHECK(optimalSplits(wild.data(), 130, 4, first, 4).distortion ==
              optimalSplits(tame.data(), 130, 4, second, 4).distortion);
        CHECK(std::equal(first, first + 5, second));
    }
}

TEST_CASE("weights as large as numbers are, beside ones as small, place the splits as their ratios do")
{
    // -ffast-math takes the inverse of the largest numbers, which is subnormal, for 0.
    const double most = kFastMath ? 0x1p1000 : std::numeric_limits<double>::max();
    const double least = std::numeric_limits<double>::min();
    const auto placed = [](const std::vector<double>& weights)
    {
        OptimalOptions<double> options;
        options.uniformShare = 0;
        std::vector<double> splits(3);
        CHECK(optimalSplitsHistogram(weights.data(), static_cast<int>(weights.size()), splits.data(), 2, options));
        return splits;
    };
    CHECK(placed({most, 0, 0, 0, 0, 0, 0, least}) == placed({1, 0, 0, 0, 0, 0, 0, 0}));
    CHECK(placed({least, most, 0, 0, most, 0, least, least}) == placed({0, 1, 0, 0, 1, 0, 0, 0}));
    CHECK(placed({most, least, least, least, least, least, least, least}) == placed({1, 0, 0, 0, 0, 0, 0, 0}));
}

TEST_CASE("no weight at all is the same weight everywhere, by its distortion too, and empty layers cost nothing")
{
    const std::vector<double> none(64, 0.0), one(64, 1.0);
    double first[5], second[5];
    const double uniform = optimalSplitsHistogram(none.data(), 64, first, 4).distortion;
    CHECK(uniform == doctest::Approx(optimalSplitsHistogram(one.data(), 64, second, 4).distortion));
    // Four layers of 16 bins each, at the bins' centres: (16^2 - 1) / 12 of a bin's square.
    CHECK(uniform == doctest::Approx((256.0 - 1) / 12 / (64.0 * 64.0)));

    std::vector<double> two(64, 0.0);
    two[10] = two[50] = 1;
    OptimalOptions<double> options;
    options.uniformShare = 0;
    CHECK(optimalSplitsHistogram(two.data(), 64, first, 4, options).distortion < 1e-12);
}

TEST_CASE("options outside their ranges count as the ends of these")
{
    Random random(134);
    std::vector<double> weights;
    for (int i = 0; i < 128; ++i)
        weights.push_back(random.unit<double>());
    const auto placed = [&](double share)
    {
        OptimalOptions<double> options;
        options.uniformShare = share;
        double splits[5];
        return optimalSplitsHistogram(weights.data(), 128, splits, 4, options).distortion;
    };
    CHECK(placed(-3) == placed(0));
    CHECK(placed(3) == placed(1));
    CHECK(placed(0) != placed(1));
}

TEST_CASE("the largest weight is the largest, in whichever bin it is")
{
    for (const int bin : {0, 3, 7})
    {
        double one[8] = {};
        double beside[8] = {};
        one[bin] = beside[bin] = 1.0e300;
        beside[(bin + 1) % 8] = 1.0e-300;
        double expected[4], splits[4];
        const auto alone = optimalSplitsHistogram(one, 8, expected, 3);
        const auto both = optimalSplitsHistogram(beside, 8, splits, 3);
        CHECK(alone.distortion > 0.0);
        CHECK(both.distortion == alone.distortion);
        for (int k = 0; k <= 3; ++k)
            CHECK(splits[k] == expected[k]);
    }
}

TEST_CASE("a previous split in the first half of the first bin parts nothing off")
{
    const double weights[] = {1, 0, 0, 0, 0, 0, 0, 1};
    OptimalOptions<double> options;
    options.leastGain = 1.0 - 1.0e-9;
    // What one layer costs: .7 of the weight 7/16 from the middle, and .3 of it uniform.
    const double mixed = 0.7 * 49 / 256 + 0.3 * 63 / 12 / 64;
    double splits[] = {0, 0.4 / 8, 1};
    const auto kept = optimalSplitsHistogram(weights, 8, splits, 2, options);
    CHECK(kept.status == OptimalStatus::Kept);
    CHECK(kept.distortion == doctest::Approx(mixed));
}

TEST_CASE("splits that cannot be bettered are kept, with their own distortion")
{
    OptimalOptions<double> options;
    options.uniformShare = 0;
    options.leastGain = 0.1;
    std::vector<double> two(64, 0.0);
    two[10] = two[50] = 1;
    double splits[] = {0, 0.5, 1};
    const auto perfect = optimalSplitsHistogram(two.data(), 64, splits, 2, options);
    CHECK(perfect.status == OptimalStatus::Kept);
    CHECK(perfect.distortion < 1e-12);

    // Of a uniform histogram: two halves are the optimum, 2^-2 / 12; parted at 9/16 they are a little worse.
    const std::vector<double> one(64, 1.0);
    splits[1] = 0.5625;
    const auto kept = optimalSplitsHistogram(one.data(), 64, splits, 2, options);
    CHECK(kept.status == OptimalStatus::Kept);
    const double longer = 36, shorter = 28;
    const auto spread = [](double bins)
    {
        return bins * (bins * bins - 1) / 12;
    };
    CHECK(kept.distortion == doctest::Approx((spread(longer) + spread(shorter)) / 64 / (64 * 64)));
}

} // namespace
} // namespace lvsm::unit
