#include <lvsm/passes_fused.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <initializer_list>

TEST_CASE("fusedPasses gives each tap its weight, whether the kernel's fetches are paired or not")
{
    const float splits[] = {0.0f, 0.5f, 1.0f};
    const lvsm::Rectangle map{0, 0, 100, 50};
    for (const bool paired : {true, false})
    {
        const auto passes =
            lvsm::fusedPasses(lvsm::binomialKernel(9, paired), splits, 2, 0.01f, map, map, glm::vec4(1));
        CHECK(passes.fused.reach == 4);
        CHECK(passes.fused.sliceCount == 1);
        for (int i = 0; i <= 4; ++i)
            CHECK(passes.fused.weights[i] == doctest::Approx(lvsm::binomialWeight<float>(4 + i, 9)).epsilon(1e-5));
        CHECK(passes.fused.weights[5] == 0.0f);
    }
}

TEST_CASE("the fused pass makes the rows that the second direction reads, in groups of 64 x 4 texels")
{
    const lvsm::Rectangle map{64, 64, 64, 64};
    const auto passes =
        lvsm::fusedPasses(lvsm::binomialKernel(9), nullptr, 0, 0.0f, map, {80, 90, 5, 6}, glm::vec4(1, 2, 3, 4), 2);
    CHECK(passes.store.block.region[1] == 86);
    CHECK(passes.store.block.region[3] == 100);
    CHECK(passes.store.block.firstSlice == 2);
    CHECK(passes.store.groups.x == 1);
    CHECK(passes.store.groups.y == 4);
    CHECK(passes.down.region.y == 90);
    CHECK(passes.fused.map[2] == 128);
    CHECK(passes.fused.border[3] == 4.0f);
}

TEST_CASE("the fused pass makes all slices of a map in as many groups as cover it")
{
    float splits[66] = {};
    const lvsm::BlurKernel kernel = lvsm::binomialKernel(65);
    const int slicesOf[][2] = {{-3, 1}, {0, 1}, {1, 1}, {2, 1}, {3, 2}, {4, 2}, {63, 32}, {64, 32}, {65, 32}};
    for (const auto& [layers, slices] : slicesOf)
    {
        const auto passes = lvsm::fusedPasses(kernel, splits, layers, 0.0f, {0, 0, 9, 9}, {0, 0, 9, 9}, glm::vec4(1));
        CHECK(passes.fused.sliceCount == slices);
        CHECK(passes.down.groups.z == slices);
        CHECK(passes.store.groups.z == 1);
        CHECK(passes.fused.reach == 32);
    }
    for (int extent = 1; extent <= 130; ++extent)
    {
        const lvsm::Rectangle map{0, 0, extent, 131 - extent};
        const auto passes = lvsm::fusedPasses(kernel, nullptr, 0, 0.0f, map, map, glm::vec4(1, 2, 3, 4));
        CHECK(passes.store.groups.x == (extent <= 64 ? 1 : extent <= 128 ? 2 : 3));
        CHECK(passes.store.groups.y * 4 >= 131 - extent);
        CHECK(passes.store.groups.y * 4 < 131 - extent + 4);
        for (int c = 0; c < 4; ++c)
            CHECK(passes.fused.border[c] == static_cast<float>(c + 1));
    }
    // One tap is all of its kernel.
    const lvsm::Rectangle map{0, 0, 8, 8};
    CHECK(lvsm::fusedPasses(lvsm::binomialKernel(1), nullptr, 0, 0.0f, map, map, glm::vec4(1)).fused.weights[0] ==
          1.0f);
}

TEST_CASE("the block of the fused pass has the offsets of std140 and of constant buffers")
{
    static_assert(offsetof(lvsm::FusedBlock, sliceCount) == 32);
    static_assert(offsetof(lvsm::FusedBlock, weights) == 48);
    static_assert(sizeof(lvsm::FusedBlock) == 48 + 36 * 4);
}
