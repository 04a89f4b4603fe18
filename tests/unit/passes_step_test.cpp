#include <lvsm/passes_step.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <vector>

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
    CHECK(all.sums.y == 0);
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

TEST_CASE("layers and a shader's room for them are from 1 to 64")
{
    const lvsm::Rectangle map{0, 0, 32, 32};
    constexpr int least = std::numeric_limits<int>::min();
    constexpr int most = std::numeric_limits<int>::max();
    for (const int room : {least, -3, 0, 1, 2, 63, 64, 65, 1000, most})
    {
        const int inRoom = room < 1 ? 1 : room > 64 ? 64 : room;
        // One more than there are layers, four to a texel.
        const int width = static_cast<int>(std::ceil((inRoom + 1) / 4.0));
        CHECK(lvsm::placeStateWidth(room) == width);
        for (const int layers : {least, -1, 0, 1, 2, 7, 63, 64, 65, most})
        {
            const int within = layers < 1 ? 1 : layers > inRoom ? inRoom : layers;
            CHECK(lvsm::placeStep(layers, room, map, 0).block.layerCount == within);
            CHECK(lvsm::placeStep(layers, room, map, 0).stateWidth == width);
            const auto size = static_cast<std::size_t>(8 * width);
            std::vector<float> state(size + 1, -9.0f);
            lvsm::startPlaceState(layers, room, state.data());
            for (std::size_t i = 0; i < size / 2; ++i)
            {
                // With -ffast-math a quotient is a product with the inverse, which rounds once more.
                const float split = std::fmin(static_cast<float>(i) / static_cast<float>(within), 1.0f);
                CHECK(std::abs(state[i] - split) <= std::numeric_limits<float>::epsilon());
                CHECK(state[size / 2 + i] == (i == 0 ? 1.0f - 2.0f * static_cast<float>(within) : 1.0f));
            }
            CHECK(state[size] == -9.0f);
        }
    }
}
