#include <lvsm/passes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

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

// How far off a tap's weight may be: a fetch lies up to 32 texels out, in steps of 2^-19, between the tap and a neighbour.
template <typename Weight>
double roundedBy(int i, const Weight& weight)
{
    return 0x1p-19 * (weight(i - 1) + weight(i) + weight(i + 1));
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
                CHECK(std::abs(weightOf(binomial, tap) - lvsm::binomialWeight<double>(i, size)) <=
                      roundedBy(i, [size](int k) { return lvsm::binomialWeight<double>(k, size); }));
                CHECK(std::abs(weightOf(gaussian, tap) - lvsm::gaussianWeight(i, size, 2.5)) <=
                      roundedBy(i, [size](int k) { return lvsm::gaussianWeight(k, size, 2.5); }));
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
    for (int c = 0; c < 4; ++c)
        CHECK(passes.down.block.border[c] == static_cast<float>(c + 1));
}

TEST_CASE("the blocks of a blur hold the kernel's taps")
{
    for (const int size : {1, 2, 9, 65})
    {
        const lvsm::BlurKernel kernel = lvsm::gaussianKernel(size, 3.0f, false);
        const auto passes = lvsm::blurPasses(kernel, {0, 0, 8, 8}, {0, 0, 8, 8}, glm::vec4(1));
        for (const lvsm::BlurBlock& block : {passes.across.block, passes.down.block})
        {
            REQUIRE(block.fetchCount == size);
            for (int i = 0; i < size; ++i)
            {
                CHECK(block.taps[i][0] == kernel.taps[i][0]);
                CHECK(block.taps[i][1] == kernel.taps[i][1]);
            }
        }
    }
}

TEST_CASE("as many groups as cover a region")
{
    for (int extent = 0; extent <= 33; ++extent)
    {
        const auto pass = lvsm::storePass(nullptr, 0, 0.0f, {3, 4, extent, 33 - extent});
        CHECK(pass.groups.x == static_cast<int>(std::ceil(extent / 8.0)));
        CHECK(pass.groups.y == static_cast<int>(std::ceil((33 - extent) / 8.0)));
        CHECK(pass.groups.z == 1);
    }
}

TEST_CASE("a kernel has from 1 to 65 taps")
{
    for (const bool paired : {true, false})
    {
        for (const int less : {0, -7})
        {
            CHECK(lvsm::binomialKernel(less, paired).size == 1);
            CHECK(lvsm::gaussianKernel(less, 1.0f, paired).size == 1);
            CHECK(lvsm::binomialKernel(less, paired).taps[0][1] == 1.0f);
        }
        for (const int more : {66, 1000})
        {
            CHECK(lvsm::binomialKernel(more, paired).size == 65);
            CHECK(lvsm::gaussianKernel(more, 1.0f, paired).size == 65);
        }
        for (const float width : {65.0f, 66.0f, 1000.0f})
            CHECK(weightOf(lvsm::boxKernel(width, paired), 32) == doctest::Approx(1.0 / 65));
    }
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
    const auto corner = lvsm::blurPasses(lvsm::binomialKernel(9), map, {126, 60, 8, 8}, glm::vec4(1));
    CHECK(same(corner.down.region, {126, 64, 2, 4}));
    const auto beside = lvsm::blurPasses(lvsm::binomialKernel(9), map, {0, 0, 8, 8}, glm::vec4(1));
    CHECK(same(beside.down.region, {64, 64, 0, 0}));
    CHECK(beside.down.groups.x == 0);
    CHECK(beside.down.groups.y == 0);
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
    CHECK(pass.block.overlap == 0.01f);
    CHECK(lvsm::storePass(splits, 2, 0.0f, {0, 0, 8, 8}).groups.z == 1);
    CHECK(lvsm::storePass(splits, 1, 0.0f, {0, 0, 8, 8}).block.splits[0] == 0.0f);
}

TEST_CASE("a map of no layers takes one slice, and one of more than 64 has 64")
{
    std::vector<float> splits;
    for (int i = 0; i <= 65; ++i)
        splits.push_back(static_cast<float>(i) / 65.0f);
    for (const int none : {0, -3})
    {
        const auto pass = lvsm::storePass(nullptr, none, 0.0f, {0, 0, 8, 8});
        CHECK(pass.groups.z == 1);
        CHECK(pass.block.layerCount == 0);
        for (const float split : pass.block.splits)
            CHECK(split == 1.0f);
    }
    for (const int most : {64, 65, 1000})
    {
        const auto pass = lvsm::storePass(splits.data(), most, 0.0f, {0, 0, 8, 8});
        CHECK(pass.groups.z == 32);
        CHECK(pass.block.layerCount == 64);
        CHECK(pass.block.splits[64] == splits[64]);
        for (int i = 65; i < 68; ++i)
            CHECK(pass.block.splits[i] == 1.0f);
    }
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
