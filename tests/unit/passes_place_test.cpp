#include <lvsm/passes_place.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <initializer_list>

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

TEST_CASE("a placement takes up to 64 layers and covers maps of any size")
{
    for (const int most : {64, 65, 1000})
        CHECK(lvsm::relaxPass(most, {0, 0, 32, 32}).block.layerCount == 64);
    for (int extent = 1; extent <= 96; ++extent)
    {
        const lvsm::PlacePass pass = lvsm::relaxPass(2, {3, 4, extent, 97 - extent});
        CHECK(pass.groups.x == (extent <= 32 ? 1 : extent <= 64 ? 2 : 3));
        CHECK(pass.groups.y == (extent >= 65 ? 1 : extent >= 33 ? 2 : 3));
        CHECK(pass.groups.z == 1);
    }
    lvsm::RelaxOptions<float> options;
    options.tolerance = 0.125f;
    CHECK(lvsm::relaxPass(2, {0, 0, 32, 32}, options).block.tolerance == 0.125f);
    CHECK(lvsm::relaxPass(2, {0, 0, 32, 32}, options).block.keepSplits == 0);
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
    options.minLength = 0.999f;
    CHECK(lvsm::optimalPass(1, map, options).block.leastBins == 1022);
    CHECK(lvsm::optimalPass(5, map, options).block.leastBins == 204);
    options.minLength = 1.0e30f;
    CHECK(lvsm::optimalPass(8, map, options).block.leastBins == 128);
    options.uniformShare = 0.125f;
    CHECK(lvsm::optimalPass(8, map, options).block.uniformShare == 0.125f);
}

TEST_CASE("the block of the placement has the offsets of std140 and of constant buffers")
{
    static_assert(offsetof(lvsm::PlaceBlock, layerCount) == 16);
    static_assert(offsetof(lvsm::PlaceBlock, tolerance) == 32);
    static_assert(offsetof(lvsm::PlaceBlock, leastBins) == 52);
    static_assert(sizeof(lvsm::PlaceBlock) == 64);
}
