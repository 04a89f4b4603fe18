#include <lvsm/depth.hpp>
#include <lvsm/passes_depth.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <initializer_list>
#include <limits>

namespace
{

// What the passes make of a projected depth, in double.
double distanceOf(const lvsm::DepthBlock& block, double z)
{
    const double between =
        (1 - z) * static_cast<double>(block.distances[0]) + z * static_cast<double>(block.distances[1]);
    return block.isPerspective != 0 ? 1 / between : between;
}

} // namespace

TEST_CASE("orthographicDepths and perspectiveDepths give the distances of the projected depth")
{
    for (const double z : {0.0, 0.25, 0.875, 1.0})
    {
        CHECK(distanceOf(lvsm::orthographicDepths(2, 10, false, 0, 1), z) == doctest::Approx(2 + 8 * z));
        CHECK(distanceOf(lvsm::orthographicDepths(2, 10, true, 0, 1), z) == doctest::Approx(10 - 8 * z));
        CHECK(distanceOf(lvsm::perspectiveDepths(2, 10, false, 2, 10), z) ==
              doctest::Approx(2 + 8 * lvsm::linearDepth(z, 2.0, 10.0)));
        CHECK(distanceOf(lvsm::perspectiveDepths(2, 10, true, 2, 10), z) ==
              doctest::Approx(2 + 8 * lvsm::linearDepthReversed(z, 2.0, 10.0)));
    }
    const lvsm::DepthBlock range = lvsm::orthographicDepths(2, 10, false, 3, 7);
    CHECK(range.range[0] == 3.0f);
    CHECK(range.range[1] == 7.0f);
    CHECK(range.isPerspective == 0);
    CHECK(lvsm::perspectiveDepths(2, 10, false, 3, 7).isPerspective == 1);
    const float infinity = std::numeric_limits<float>::infinity();
    CHECK(distanceOf(lvsm::perspectiveDepths(2, infinity, true, 2, 10), 0.25) == doctest::Approx(8));
}

TEST_CASE("pointDepths has tangents that reach the edges of the map")
{
    const lvsm::DepthBlock block = lvsm::pointDepths(1, 10, false, 1, 10, {1.0f, 0.5f}, {64, 32, 32, 16});
    CHECK(64 * block.tangents[0] + block.tangents[2] == doctest::Approx(-1));
    CHECK(96 * block.tangents[0] + block.tangents[2] == doctest::Approx(1));
    CHECK(32 * block.tangents[1] + block.tangents[3] == doctest::Approx(-0.5));
    CHECK(48 * block.tangents[1] + block.tangents[3] == doctest::Approx(0.5));
    // A map of no texels counts as one of one.
    const lvsm::DepthBlock none = lvsm::pointDepths(1, 10, false, 1, 10, {1.0f, 0.5f}, {0, 0, 0, -5});
    CHECK(none.tangents[0] == 2.0f);
    CHECK(none.tangents[1] == 1.0f);
}

TEST_CASE("the block of a depth buffer has the offsets of std140 and of constant buffers")
{
    static_assert(offsetof(lvsm::DepthBlock, distances) == 16);
    static_assert(offsetof(lvsm::DepthBlock, range) == 24);
    static_assert(offsetof(lvsm::DepthBlock, isPerspective) == 32);
    static_assert(sizeof(lvsm::DepthBlock) == 48);
}
