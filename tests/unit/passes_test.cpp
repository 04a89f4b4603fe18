#include <lvsm/passes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace
{

// What a kernel's fetches give each tap, by its offset in texels, when every fetch blends the two taps around it.
double weightOf(const lvsm::BlurKernel& kernel, double tap)
{
    double weight = 0;
    for (int i = 0; i < kernel.fetchCount; ++i)
    {
        const double distance = std::abs(static_cast<double>(kernel.taps[i][0]) - tap);
        weight += std::max(1.0 - distance, 0.0) * static_cast<double>(kernel.taps[i][1]);
    }
    return weight;
}

bool same(const lvsm::Rectangle& a, const lvsm::Rectangle& b)
{
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

} // namespace

TEST_CASE("the fetches of a kernel give each tap its weight")
{
    for (const bool paired : {true, false})
    {
        for (int size = 1; size <= lvsm::kMaxFilterSize; ++size)
        {
            const lvsm::BlurKernel binomial = lvsm::binomialKernel(size, paired);
            const lvsm::BlurKernel gaussian = lvsm::gaussianKernel(size, 2.5f, paired);
            CHECK(binomial.size == size);
            CHECK(binomial.fetchCount == (paired ? (size + 1) / 2 : size));
            for (int i = 0; i < size; ++i)
            {
                const double tap = i - 0.5 * (size - 1);
                CHECK(weightOf(binomial, tap) == doctest::Approx(lvsm::binomialWeight<double>(i, size)).epsilon(1e-5));
                CHECK(weightOf(gaussian, tap) == doctest::Approx(lvsm::gaussianWeight(i, size, 2.5)).epsilon(1e-5));
            }
        }
    }
}

TEST_CASE("kernels that are not paired read texels at their centres")
{
    const lvsm::BlurKernel kernel = lvsm::gaussianKernel(65, 9.0f, false);
    for (int i = 0; i < kernel.fetchCount; ++i)
        CHECK(kernel.taps[i][0] == static_cast<float>(i - 32));
}

TEST_CASE("a box takes the taps that it covers")
{
    CHECK(lvsm::boxKernel(0.0f).size == 1);
    CHECK(lvsm::boxKernel(1.0f).size == 1);
    CHECK(lvsm::boxKernel(1.5f).size == 3);
    CHECK(lvsm::boxKernel(3.0f).size == 3);
    CHECK(lvsm::boxKernel(1000.0f).size == 65);
    for (const double width : {1.25, 4.0, 7.5})
    {
        const lvsm::BlurKernel kernel = lvsm::boxKernel(static_cast<float>(width));
        for (int i = -6; i <= 6; ++i)
            CHECK(weightOf(kernel, i) == doctest::Approx(lvsm::boxWeight<double>(i, width)).epsilon(1e-6));
    }
}

TEST_CASE("a blur of a whole map runs twice over it")
{
    const lvsm::Rectangle map{0, 0, 100, 50};
    const auto passes = lvsm::blurPasses(lvsm::binomialKernel(9), map, map, {1, 2, 3, 4}, 2, 3);
    CHECK(same(passes.across.region, map));
    CHECK(same(passes.down.region, map));
    CHECK(passes.down.groups.x == 13);
    CHECK(passes.down.groups.y == 7);
    CHECK(passes.down.groups.z == 3);
    CHECK(passes.across.block.direction[0] == 1.0f);
    CHECK(passes.across.block.direction[1] == 0.0f);
    CHECK(passes.down.block.direction[0] == 0.0f);
    CHECK(passes.down.block.direction[1] == 1.0f);
    CHECK(passes.down.block.slice == 2);
    CHECK(passes.down.block.fetchCount == 5);
    CHECK(passes.down.block.border[3] == 4.0f);
}

TEST_CASE("a region's first direction makes the rows that the second reads, and none off the map")
{
    const lvsm::Rectangle map{64, 64, 64, 64};
    const auto inside = lvsm::blurPasses(lvsm::binomialKernel(9), map, {80, 90, 5, 6}, glm::vec4(1));
    CHECK(same(inside.across.region, {80, 86, 5, 14}));
    CHECK(same(inside.down.region, {80, 90, 5, 6}));
    CHECK(inside.across.block.region[1] == 86);
    CHECK(inside.across.block.region[3] == 100);
    CHECK(inside.across.block.map[0] == 64);
    CHECK(inside.across.block.map[2] == 128);
    const auto edge = lvsm::blurPasses(lvsm::binomialKernel(9), map, {60, 126, 8, 8}, glm::vec4(1));
    CHECK(same(edge.across.region, {64, 122, 4, 6}));
    CHECK(same(edge.down.region, {64, 126, 4, 2}));
    const auto beside = lvsm::blurPasses(lvsm::binomialKernel(9), map, {0, 0, 8, 8}, glm::vec4(1));
    CHECK(beside.down.groups.x * beside.down.groups.y == 0);
}

TEST_CASE("the pass that stores layers takes a slice for two of them")
{
    const float splits[] = {0.0f, 0.25f, 0.5f, 1.0f};
    const auto pass = lvsm::storePass(splits, 3, 0.01f, {0, 0, 17, 8}, 4);
    CHECK(pass.groups.x == 3);
    CHECK(pass.groups.y == 1);
    CHECK(pass.groups.z == 2);
    CHECK(pass.block.layerCount == 3);
    CHECK(pass.block.firstSlice == 4);
    CHECK(pass.block.splits[2] == 0.5f);
    CHECK(pass.block.splits[4] == 1.0f);
    CHECK(lvsm::storePass(nullptr, 0, 0.0f, {0, 0, 8, 8}).groups.z == 1);
}

TEST_CASE("blocks have the offsets of std140 and of constant buffers")
{
    static_assert(offsetof(lvsm::BlurBlock, map) == 16);
    static_assert(offsetof(lvsm::BlurBlock, region) == 32);
    static_assert(offsetof(lvsm::BlurBlock, direction) == 48);
    static_assert(offsetof(lvsm::BlurBlock, slice) == 56);
    static_assert(offsetof(lvsm::BlurBlock, taps) == 64);
    static_assert(sizeof(lvsm::BlurBlock) == 64 + 33 * 16);
    static_assert(offsetof(lvsm::StoreBlock, layerCount) == 16);
    static_assert(offsetof(lvsm::StoreBlock, splits) == 32);
    static_assert(sizeof(lvsm::StoreBlock) % 16 == 0);
}
