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

TEST_CASE("the block of the fused pass has the offsets of std140 and of constant buffers")
{
    static_assert(offsetof(lvsm::FusedBlock, sliceCount) == 32);
    static_assert(offsetof(lvsm::FusedBlock, weights) == 48);
    static_assert(sizeof(lvsm::FusedBlock) == 48 + 36 * 4);
}
