#include <lvsm/passes_mip.hpp>

#include <doctest/doctest.h>

namespace
{

bool same(const std::int32_t (&ends)[4], int x, int y, int endX, int endY)
{
    return ends[0] == x && ends[1] == y && ends[2] == endX && ends[3] == endY;
}

} // namespace

TEST_CASE("a level has half the size of the one before, rounded down, and at least one texel")
{
    const lvsm::Rectangle level = lvsm::levelRectangle({16, 8, 21, 3}, 2);
    CHECK(level.x == 4);
    CHECK(level.y == 2);
    CHECK(level.width == 5);
    CHECK(level.height == 1);
    CHECK(lvsm::levelRectangle({16, 8, 21, 3}, -1).width == 21);
    CHECK(lvsm::levelRectangle({16, 8, 21, 3}, 99).width == 1);
    CHECK(lvsm::levelRectangle({1 << 30, 0, 1, 1}, 30).x == 1);
    CHECK(lvsm::levelRectangle({1 << 30, 0, 1, 1}, 99).x == 1);
}

TEST_CASE("levels end at one texel")
{
    CHECK(lvsm::levelCount({0, 0, 1, 1}) == 1);
    CHECK(lvsm::levelCount({0, 0, 2, 1}) == 2);
    CHECK(lvsm::levelCount({0, 0, 512, 512}) == 10);
    CHECK(lvsm::levelCount({0, 0, 513, 3}) == 10);
    CHECK(lvsm::levelCount({0, 0, 3, 513}) == 10);
    CHECK(lvsm::levelCount({0, 0, 0, 0}) == 1);
    CHECK(lvsm::levelCount({0, 0, 1 << 30, 3}) == 31);
}

TEST_CASE("a pass for a level reads the one before and covers its own")
{
    const auto pass = lvsm::mipPass({16, 8, 72, 40}, 2, 3, 4, 1);
    CHECK(same(pass.block.before, 8, 4, 8 + 36, 4 + 20));
    CHECK(same(pass.block.region, 4, 2, 4 + 18, 2 + 10));
    CHECK(pass.block.slice == 3);
    CHECK(pass.block.level == 1);
    CHECK(pass.region.width == 18);
    CHECK(pass.groups.x == 3);
    CHECK(pass.groups.y == 2);
    CHECK(pass.groups.z == 4);
}
