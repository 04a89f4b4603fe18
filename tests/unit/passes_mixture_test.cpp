#include <lvsm/components.hpp>
#include <lvsm/passes_mixture.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
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
            wider[at] += weights[at] / 4;
            wider[at + step] += weights[at] / 2;
            wider[at + 2 * step] += weights[at] / 4;
        }
        weights = wider;
    }
    return weights;
}

} // namespace

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
    CHECK(lvsm::mixtureWindow(-3).rounds == 0);
    CHECK(lvsm::mixtureWindow(99).deviation == lvsm::mixtureWindow(25).deviation);
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
    CHECK(sizeof(lvsm::MixingBlock) % 16 == 0);
}
