#include <lvsm/passes_step.hpp>

#include <doctest/doctest.h>

TEST_CASE("a state holds four splits to a texel, and begins uniform with nothing known empty")
{
    CHECK(lvsm::placeStateWidth(8) == 3);
    CHECK(lvsm::placeStateWidth(4) == 2);
    CHECK(lvsm::placeStateWidth(3) == 1);
    CHECK(lvsm::placeStateWidth(1000) == 17);
    float state[24];
    lvsm::startPlaceState(4, 8, state);
    CHECK(state[0] == 0.0f);
    CHECK(state[1] == 0.25f);
    CHECK(state[4] == 1.0f);
    CHECK(state[11] == 1.0f);
    CHECK(state[12] == -7.0f);
    CHECK(state[13] == 1.0f);
    CHECK(state[23] == 1.0f);
}

TEST_CASE("all splits take a slice for two of them, two a frame take one")
{
    const lvsm::Rectangle map{5, 6, 70, 50};
    const auto all = lvsm::placeStep(8, 8, map, 3);
    CHECK(all.block.frame == -1);
    CHECK(all.slices == 4);
    CHECK(all.stateWidth == 3);
    CHECK(all.block.map[0] == 5);
    CHECK(all.block.map[3] == 56);
    CHECK(all.sums.x == 0);
    CHECK(all.sums.width == 70);
    CHECK(all.sums.height == 50);
    CHECK(lvsm::placeStep(3, 8, map, 0).slices == 1);
    CHECK(lvsm::placeStep(1, 8, map, 0).slices == 1);
    lvsm::RelaxOptions<float> options;
    options.splitsPerIteration = 2;
    options.minVariance = 0.125f;
    const auto pair = lvsm::placeStep(100, 8, map, 3, options, 6);
    CHECK(pair.block.layerCount == 8);
    CHECK(pair.block.frame == 3);
    CHECK(pair.block.level == 6);
    CHECK(pair.block.minVariance == 0.125f);
    CHECK(pair.block.maxVariance == 0.25f);
    CHECK(pair.slices == 1);
    CHECK(lvsm::placeStep(4, 8, map, -5, options).block.frame == 0);
}
