#include <lvsm/components.hpp>
#include <lvsm/passes_mixture.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

namespace
{

// Of a window along one axis, in texels of the map of mixtures.
std::vector<double> weightsOf(const lvsm::MixtureWindow& window)
{
    std::vector<double> weights{1.0};
    for (int i = 0; i < window.rounds; ++i)
    {
        const auto step = static_cast<std::size_t>(window.steps[i]);
        std::vector<double> wider(weights.size() + 2 * step);
        for (std::size_t at = 0; at < weights.size(); ++at)
        {
            const auto share = static_cast<double>(window.shares[i]);
            wider[at] += weights[at] * share;
            wider[at + step] += weights[at] * (1 - 2 * share);
            wider[at + 2 * step] += weights[at] * share;
        }
        weights = wider;
    }
    return weights;
}

// Depths, in whole numbers so that sums of them are exact; none off the map.
double depthAt(const lvsm::Rectangle& map, int x, int y)
{
    const bool isOn = x >= map.x && y >= map.y && x < map.x + map.width && y < map.y + map.height;
    return isOn ? 1 + (31 * x + 57 * y + x * y) % 89 : 0;
}

// What a texel of the codes has of the depths before any round.
double depthOfCode(const lvsm::Rectangle& map, int texels, int x, int y)
{
    double sum = 0;
    for (int i = 0; i < texels * texels; ++i)
        sum += depthAt(map, texels * x + i % texels, texels * y + i / texels);
    return sum / (texels * texels);
}

// A texture in which each texel is written once and read only afterwards.
class Texture
{
public:
    Texture(int width, int height) : m_width(width), m_values(static_cast<std::size_t>(width * height), kUnwritten) {}

    double& at(int x, int y)
    {
        REQUIRE(x >= 0);
        REQUIRE(x < m_width);
        return m_values.at(static_cast<std::size_t>(y * m_width + x));
    }

    void write(int x, int y, double value)
    {
        REQUIRE(at(x, y) == kUnwritten);
        at(x, y) = value;
        ++m_written;
    }

    double read(int x, int y)
    {
        REQUIRE(at(x, y) != kUnwritten);
        return at(x, y);
    }

    int written() const { return m_written; }

private:
    // No mean of depths.
    static constexpr double kUnwritten = 1.0e300;

    int m_width;
    int m_written = 0;
    std::vector<double> m_values;
};

using Pass = lvsm::Pass<lvsm::MixingBlock>;

// Three texels a step apart, the outer two with a share each.
struct Step
{
    int x;
    int y;
    double share;
};
using Steps = std::vector<Step>;

// By the last step, of what all before it give.
template <typename Read>
double mixed(const Read& read, const Steps& steps, std::size_t count, int x, int y)
{
    if (count == 0)
        return read(x, y);
    const auto [dx, dy, share] = steps[count - 1];
    return (1 - 2 * share) * mixed(read, steps, count - 1, x, y) +
           share * (mixed(read, steps, count - 1, x - dx, y - dy) + mixed(read, steps, count - 1, x + dx, y + dy));
}

// The texels that passes/mixture.comp writes, and the steps of its rounds.
struct Dispatch
{
    template <typename Write>
    static void run(const Pass& pass, const Write& write)
    {
        const int spacing = pass.block.spacing;
        for (int i = 0; i < pass.groups.x * pass.groups.y * pass.groups.z * 64; ++i)
        {
            const int group = i / 64, thread = i % 64;
            const int gx = group % pass.groups.x, gy = group / pass.groups.x % pass.groups.y;
            const int x = pass.block.region[0] + gx / spacing * 8 * spacing + gx % spacing + spacing * (thread % 8);
            const int y = pass.block.region[1] + gy / spacing * 8 * spacing + gy % spacing + spacing * (thread / 8);
            if (x < pass.block.region[2] && y < pass.block.region[3])
                write(x, y);
        }
    }

    static Steps steps(const lvsm::MixingBlock& block)
    {
        Steps steps;
        for (int i = 0; i < 2; ++i)
        {
            const int step = block.steps[i] * block.spacing;
            const auto share = static_cast<double>(block.shares[i]);
            if (step > 0)
                steps.insert(steps.end(), {{step, 0, share}, {0, step, share}});
        }
        return steps;
    }
};

// Those of passes/mixture.frag.
struct Draw
{
    template <typename Write>
    static void run(const Pass& pass, const Write& write)
    {
        for (int y = pass.region.y; y < pass.region.y + pass.region.height; ++y)
        {
            for (int x = pass.region.x; x < pass.region.x + pass.region.width; ++x)
                write(x + pass.block.origins[2], y + pass.block.origins[3]);
        }
    }

    static Steps steps(const lvsm::MixingBlock& block)
    {
        CHECK(block.spacing == 1);
        return {{block.steps[0], block.steps[1], static_cast<double>(block.shares[0])}};
    }
};

// Runs the passes as their shader would, each reading what the one before has written.
template <typename Shader>
Texture codesOf(const lvsm::MixturePasses& made, const lvsm::Rectangle& map, int texels)
{
    Texture source(0, 0);
    for (int i = 0; i < made.count; ++i)
    {
        const Pass& pass = made.passes[i];
        const auto& block = pass.block;
        const bool isLast = i + 1 == made.count;
        CHECK(block.map[0] == map.x);
        CHECK(block.map[1] == map.y);
        CHECK(block.map[2] == map.x + map.width);
        CHECK(block.map[3] == map.y + map.height);
        CHECK(block.texels == texels);
        const auto read = [&](int x, int y)
        {
            return i == 0 ? depthOfCode(map, texels, x, y) : source.read(x - block.origins[0], y - block.origins[1]);
        };
        const Steps steps = Shader::steps(block);
        Texture target(isLast ? 80 : made.between.width, isLast ? 80 : made.between.height);
        Shader::run(
            pass, [&](int x, int y)
            { target.write(x - block.origins[2], y - block.origins[3], mixed(read, steps, steps.size(), x, y)); });
        // A pass with groups is a pass over a region.
        CHECK(target.written() == pass.region.width * pass.region.height);
        source = target;
    }
    return source;
}

// tolerance: shares of 1/4 leave sums exact.
template <typename Shader>
void checkWindow(const lvsm::MixturePasses& made, const lvsm::MixtureWindow& window, const lvsm::Rectangle& map,
                 const lvsm::Rectangle& region, double tolerance = 0)
{
    const int texels = window.texels;
    const auto weights = weightsOf(window);
    const int width = static_cast<int>(weights.size());
    CAPTURE(width);
    CAPTURE(texels);
    Texture codes = codesOf<Shader>(made, map, texels);
    const int reach = width / 2;
    int count = 0;
    bool agree = true;
    for (int y = 0; y < 80; ++y)
    {
        for (int x = 0; x < 80; ++x)
        {
            // Whether one of the texel's depths is on the map and in the region.
            bool isAsked = false;
            for (int i = 0; i < texels * texels; ++i)
            {
                const int column = texels * x + i % texels, row = texels * y + i / texels;
                isAsked = isAsked || (depthAt(map, column, row) != 0 && depthAt(region, column, row) != 0);
            }
            if (!isAsked)
                continue;
            ++count;
            double sum = 0;
            for (int i = 0; i < width * width; ++i)
                sum += weights[static_cast<std::size_t>(i % width)] * weights[static_cast<std::size_t>(i / width)] *
                       depthOfCode(map, texels, x + i % width - reach, y + i / width - reach);
            agree = agree && std::abs(codes.read(x, y) - sum) <= tolerance;
        }
    }
    CHECK(agree);
    CHECK(codes.written() == count);
}

} // namespace

TEST_CASE("passes and draws of mixtures, run one after the other, sum up the window around each texel of a region")
{
    const lvsm::Rectangle map{10, 20, 60, 46};
    for (const lvsm::Rectangle& region :
         {lvsm::Rectangle{31, 21, 11, 5}, {59, 12, 40, 15}, {36, 45, 1, 1}, {4, 61, 9, 30}})
    {
        for (const int width : {1, 3, 5, 7, 9, 15, 17, 25})
        {
            for (const bool half : {false, true})
            {
                const auto window = lvsm::mixtureWindow(width, half);
                checkWindow<Dispatch>(lvsm::mixturePasses(width, half, map, region), window, map, region);
                checkWindow<Draw>(lvsm::mixtureDraws(width, half, map, region), window, map, region);
            }
        }
        for (const float deviation : {1.25f, 3.0f})
        {
            for (const bool half : {false, true})
            {
                // Of sums of at most 89, with some 400 roundings.
                const auto window = lvsm::gaussianMixtureWindow(deviation, half);
                checkWindow<Dispatch>(lvsm::mixturePassesOf(window, map, region), window, map, region, 1e-11);
                checkWindow<Draw>(lvsm::mixtureDrawsOf(window, map, region), window, map, region, 1e-11);
            }
        }
    }
}

TEST_CASE("a region off the map, or of no texels, is no texel of any pass, wherever it begins")
{
    const lvsm::Rectangle map{10, 20, 60, 46};
    for (const lvsm::Rectangle& region :
         {lvsm::Rectangle{31, 21, 0, 5}, {31, 21, 5, 0}, {32, 22, 0, 0}, {71, 21, 9, 9}, {11, 67, 9, 9}, {0, 0, 9, 9}})
    {
        for (const bool half : {false, true})
        {
            for (const bool isDrawn : {false, true})
            {
                const auto made =
                    isDrawn ? lvsm::mixtureDraws(25, half, map, region) : lvsm::mixturePasses(25, half, map, region);
                for (int i = 0; i < made.count; ++i)
                {
                    CHECK(made.passes[i].region.width == 0);
                    CHECK(made.passes[i].region.height == 0);
                    CHECK(made.passes[i].groups.x * made.passes[i].groups.y == 0);
                }
            }
        }
    }
}

TEST_CASE("as many groups as cover a region with texels that are the spacing apart, and no more")
{
    const lvsm::Rectangle map{0, 0, 200, 200};
    for (int extent = 1; extent <= 90; ++extent)
    {
        for (const int width : {3, 7, 9, 15, 17, 25})
        {
            const auto made = lvsm::mixturePasses(width, false, map, {40, 50, extent, 91 - extent});
            for (int i = 0; i < made.count; ++i)
            {
                const Pass& pass = made.passes[i];
                const int spacing = pass.block.spacing;
                CHECK(pass.groups.x % spacing == 0);
                CHECK(pass.groups.y % spacing == 0);
                CHECK(pass.groups.z == 1);
                CHECK(8 * pass.groups.x >= pass.region.width);
                CHECK(8 * pass.groups.y >= pass.region.height);
                CHECK(8 * (pass.groups.x - spacing) < pass.region.width);
                CHECK(8 * (pass.groups.y - spacing) < pass.region.height);
            }
        }
    }
}

TEST_CASE(
    "mixtures between passes take what the first writes, in slices from 0 on, and nothing where there is one pass")
{
    const lvsm::Rectangle map{10, 20, 60, 46};
    const lvsm::Rectangle region{31, 21, 11, 5};
    for (int width = 1; width <= lvsm::kMaxMixtureWidth; width += 2)
    {
        for (const bool isDrawn : {false, true})
        {
            const auto made = isDrawn ? lvsm::mixtureDraws(width, false, map, region, 3)
                                      : lvsm::mixturePasses(width, false, map, region, 3);
            const lvsm::Rectangle& first = made.passes[0].region;
            CHECK(made.between.x == 0);
            CHECK(made.between.y == 0);
            CHECK(made.between.width == (made.count > 1 ? first.width : 0));
            CHECK(made.between.height == (made.count > 1 ? first.height : 0));
            // Depths are read where they are.
            CHECK(made.passes[0].block.origins[0] == 0);
            CHECK(made.passes[0].block.origins[1] == 0);
            CHECK(made.deviation == lvsm::mixtureWindow(width).deviation);
            // As much is made as the next pass reads, and no more: the reach of its one round.
            for (int i = 1; i < made.count; ++i)
            {
                const auto& block = made.passes[i].block;
                const auto& before = made.passes[i - 1].block;
                const int across = block.steps[0] * block.spacing;
                const int down = isDrawn ? block.steps[1] : across;
                CHECK(before.region[0] == block.region[0] - across);
                CHECK(before.region[1] == block.region[1] - down);
                CHECK(before.region[2] == block.region[2] + across);
                CHECK(before.region[3] == block.region[3] + down);
            }
            for (int i = 0; i < made.count; ++i)
            {
                CHECK(made.passes[i].block.slice == (i + 1 == made.count ? 3 : 0));
                CHECK(made.passes[i].block.deviation == made.deviation);
            }
        }
    }
}

TEST_CASE("a window of mixtures has as many texels as asked, falls from the middle outwards, and tells its deviation")
{
    for (int width = 1; width <= lvsm::kMaxMixtureWidth; width += 2)
    {
        CAPTURE(width);
        const auto weights = weightsOf(lvsm::mixtureWindow(width));
        REQUIRE(weights.size() == static_cast<std::size_t>(width));
        const std::size_t middle = weights.size() / 2;
        double variance = 0;
        for (std::size_t i = 0; i < weights.size(); ++i)
        {
            const double away = static_cast<double>(i) - static_cast<double>(middle);
            variance += weights[i] * away * away;
            CHECK(weights[i] > 0);
            CHECK(weights[i] == weights[weights.size() - 1 - i]);
            if (i > 0 && i <= middle)
                CHECK(weights[i] >= weights[i - 1]);
        }
        CHECK(lvsm::mixtureWindow(width).deviation == doctest::Approx(std::sqrt(variance)));
        // Twice as wide, and two texels of the depths to one of the codes.
        CHECK(lvsm::mixtureWindow(width, true).deviation == doctest::Approx(std::sqrt(4 * variance + 0.25)));
    }
}

TEST_CASE(
    "a window of a deviation has that variance, falls from the middle outwards, and takes as few rounds as can have it")
{
    for (int i = 0; i <= 70; ++i)
    {
        for (const bool half : {false, true})
        {
            const double wanted = 0.1 * i;
            CAPTURE(wanted);
            CAPTURE(half);
            const auto window = lvsm::gaussianMixtureWindow(static_cast<float>(wanted), half);
            const auto weights = weightsOf(window);
            const std::size_t middle = weights.size() / 2;
            double variance = 0;
            for (std::size_t at = 0; at < weights.size(); ++at)
            {
                const double away = static_cast<double>(at) - static_cast<double>(middle);
                variance += weights[at] * away * away;
                CHECK(weights[at] > 0);
                if (at > 0 && at <= middle)
                    CHECK(weights[at] >= weights[at - 1]);
            }
            CHECK(window.texels == (half ? 2 : 1));
            const double inDepths = half ? 4 * variance + 0.25 : variance;
            CHECK(static_cast<double>(window.deviation) == doctest::Approx(std::sqrt(inDepths)));
            // No round, or three whole ones.
            const double least = half ? 0.25 : 0, most = half ? 42.25 : 10.5;
            CHECK(std::abs(inDepths - std::min(std::max(wanted * wanted, least), most)) < 1.0 / 256);
            const double before = 0.5 * (std::pow(4.0, window.rounds - 1) - 1) / 3;
            CHECK((window.rounds == 0 || variance > before));
        }
    }
}

TEST_CASE("binomial filters of 3 and 11 taps are a round and two, whatever the rounding of their deviation")
{
    for (const int taps : {3, 11})
    {
        const auto window = lvsm::gaussianMixtureWindow(std::sqrt(static_cast<float>(taps - 1)) / 2);
        CHECK(window.rounds == (taps == 3 ? 1 : 2));
        for (int i = 0; i < window.rounds; ++i)
        {
            CHECK(window.steps[i] == 1 << i);
            CHECK(window.shares[i] == doctest::Approx(0.25));
        }
    }
    const float endless = std::numeric_limits<float>::max();
    CHECK(lvsm::gaussianMixtureWindow(endless, true).deviation == doctest::Approx(6.5));
    CHECK(lvsm::gaussianMixtureWindow(-endless, true).rounds == 0);
    CHECK(lvsm::gaussianMixtureWindow(0.0f).deviation == 0.0f);
}

TEST_CASE("windows that double are those of mixtureDeviation, and widths out of range are clamped")
{
    for (int rounds = 1; rounds <= 3; ++rounds)
    {
        const auto window = lvsm::mixtureWindow((2 << rounds) - 1);
        CHECK(window.rounds == rounds);
        CHECK(window.deviation == doctest::Approx(lvsm::mixtureDeviation(rounds)));
        for (int i = 0; i < rounds; ++i)
            CHECK(window.steps[i] == 1 << i);
    }
    CHECK(lvsm::mixtureWindow(8).deviation == lvsm::mixtureWindow(7).deviation);
    for (const int less : {1, 0, -3, std::numeric_limits<int>::min()})
        CHECK(lvsm::mixtureWindow(less).rounds == 0);
    for (const int more : {26, 27, 99, std::numeric_limits<int>::max()})
        CHECK(weightsOf(lvsm::mixtureWindow(more)).size() == 25);
}

TEST_CASE("a dispatch of mixtures fits in the shared memory that Vulkan promises")
{
    for (int width = 1; width <= lvsm::kMaxMixtureWidth; width += 2)
    {
        const lvsm::Rectangle map{0, 0, 64, 64};
        const auto made = lvsm::mixturePasses(width, false, map, map);
        CHECK(made.count == (width <= 7 ? 1 : width <= 15 ? 2 : 3));
        for (int i = 0; i < made.count; ++i)
            CHECK(made.passes[i].block.steps[0] + made.passes[i].block.steps[1] <= lvsm::kMaxMixtureHalo);
    }
    CHECK(lvsm::kMixtureTile == lvsm::kPassGroupSize + 2 * lvsm::kMaxMixtureHalo);
    CHECK(lvsm::kMixtureTile * lvsm::kMixtureTile * lvsm::kMaxComponents * 16 <= 16384);
}

TEST_CASE("passes of mixtures write what the next one reads, and the codes of a rectangle where it lies")
{
    const auto made = lvsm::mixturePasses(25, true, {10, 20, 100, 80}, {31, 21, 11, 4}, 3);
    REQUIRE(made.count == 3);
    const auto& last = made.passes[2];
    CHECK(last.region.x == 15);
    CHECK(last.region.y == 10);
    CHECK(last.region.width == 6);
    CHECK(last.region.height == 3);
    CHECK(last.block.slice == 3);
    CHECK(last.block.origins[2] == 0);
    CHECK(last.block.texels == 2);
    CHECK(last.block.deviation == made.deviation);
    for (int i = 1; i < made.count; ++i)
    {
        const auto& before = made.passes[i - 1];
        const auto& after = made.passes[i];
        const int reach = after.block.steps[0] * after.block.spacing;
        CHECK(before.block.region[0] == after.block.region[0] - reach);
        CHECK(before.block.region[3] == after.block.region[3] + reach);
        CHECK(before.block.origins[2] == after.block.origins[0]);
        CHECK(before.region.x >= 0);
        CHECK(before.region.x + before.region.width <= made.between.width);
        CHECK(before.region.y + before.region.height <= made.between.height);
        // Groups of 8 x 8 texels that are the spacing apart.
        CHECK(after.groups.x * 8 >= after.region.width);
        CHECK(after.groups.x % after.block.spacing == 0);
    }
}

TEST_CASE("draws of mixtures go along x and along y by turns, and write what the next one reads")
{
    const lvsm::Rectangle map{0, 0, 64, 64};
    const auto made = lvsm::mixtureDraws(9, false, map, {20, 30, 8, 4}, 2);
    REQUIRE(made.count == 6);
    for (int i = 0; i < made.count; ++i)
    {
        const auto& pass = made.passes[i];
        CHECK(pass.block.steps[1 - i % 2] == 0);
        CHECK(pass.block.steps[i % 2] == lvsm::mixtureWindow(9).steps[i / 2]);
        if (i == 0)
            continue;
        const auto& before = made.passes[i - 1];
        CHECK(before.block.region[0] == pass.block.region[0] - pass.block.steps[0]);
        CHECK(before.block.region[1] == pass.block.region[1] - pass.block.steps[1]);
        CHECK(before.region.y + before.region.height <= made.between.height);
    }
    CHECK(made.passes[5].region.x == 20);
    CHECK(made.passes[5].block.slice == 2);
    CHECK(lvsm::mixtureDraws(1, false, map, map).count == 1);
}

TEST_CASE("the block of the mixture passes has the offsets of std140 and of constant buffers")
{
    CHECK(offsetof(lvsm::MixingBlock, region) == 16);
    CHECK(offsetof(lvsm::MixingBlock, origins) == 32);
    CHECK(offsetof(lvsm::MixingBlock, steps) == 48);
    CHECK(offsetof(lvsm::MixingBlock, spacing) == 56);
    CHECK(offsetof(lvsm::MixingBlock, deviation) == 64);
    CHECK(offsetof(lvsm::MixingBlock, shares) == 72);
    CHECK(sizeof(lvsm::MixingBlock) % 16 == 0);
}
