#include <lvsm/passes_place.hpp>

#include <doctest/doctest.h>

#include <cstddef>

TEST_CASE("relaxPass takes the host's options and covers the map with groups of 32 x 32 texels")
{
    lvsm::RelaxOptions<float> options;
    options.keepSplits = true;
    options.minVariance = 0.01f;
    const lvsm::PlacePass pass = lvsm::relaxPass(4, {5, 9, 65, 64}, options);
    CHECK(pass.groups.x == 3);
    CHECK(pass.groups.y == 2);
    CHECK(pass.block.map[0] == 5);
    CHECK(pass.block.map[3] == 73);
    CHECK(pass.block.layerCount == 4);
    CHECK(pass.block.optimal == 0);
    CHECK(pass.block.keepSplits == 1);
    CHECK(pass.block.maxIterations == lvsm::RelaxOptions<float>().maxIterations);
    CHECK(pass.block.minVariance == 0.01f);
    CHECK(pass.block.maxVariance == 0.25f);
    // Sums of 64 bits for two numbers of each bin, and a word of each bin and layer.
    CHECK(pass.histogramBytes == 1024 * (16 + 4 * 4));
}

TEST_CASE("optimalPass counts the least length in bins, and leaves room for all layers")
{
    const lvsm::Rectangle map{0, 0, 32, 1};
    CHECK(lvsm::optimalPass(4, map).block.optimal == 1);
    CHECK(lvsm::optimalPass(4, map).block.leastBins == 16);
    lvsm::OptimalOptions<float> options;
    options.minLength = 1.0f;
    options.leastGain = 0.125f;
    CHECK(lvsm::optimalPass(8, map, options).block.leastBins == 128);
    CHECK(lvsm::optimalPass(8, map, options).block.leastGain == 0.125f);
    options.minLength = 0.0f;
    CHECK(lvsm::optimalPass(8, map, options).block.leastBins == 1);
    CHECK(lvsm::optimalPass(0, map).block.layerCount == 1);
}

TEST_CASE("the block of the placement has the offsets of std140 and of constant buffers")
{
    static_assert(offsetof(lvsm::PlaceBlock, layerCount) == 16);
    static_assert(offsetof(lvsm::PlaceBlock, tolerance) == 32);
    static_assert(offsetof(lvsm::PlaceBlock, leastBins) == 52);
    static_assert(sizeof(lvsm::PlaceBlock) == 64);
}
