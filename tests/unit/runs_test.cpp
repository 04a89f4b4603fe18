// Sampling an image: as many texels as were asked for, whatever its shape.
#include <lvsm/runs.hpp>

#include <doctest/doctest.h>

#include <vector>

namespace lvsm::unit
{
namespace
{

struct Sample
{
    long long texels = 0;
    int texelsOfQuarter[2][2] = {};
    bool isInside = true;
    bool isDistinct = true;
};

Sample sample(int width, int height, int maxSamples)
{
    Sample result;
    std::vector<bool> seen(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    detail::forEachRun(
        width, height, maxSamples,
        [&](int begin, int y, int count)
        {
            result.isInside =
                result.isInside && begin >= 0 && count > 0 && begin + count <= width && y >= 0 && y < height;
            for (int x = begin; result.isInside && x < begin + count; ++x)
            {
                auto texel =
                    seen[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
                result.isDistinct = result.isDistinct && !texel;
                texel = true;
                ++result.texels;
                ++result.texelsOfQuarter[x < (width + 1) / 2 ? 0 : 1][y < (height + 1) / 2 ? 0 : 1];
            }
        });
    return result;
}

struct Shape
{
    int width;
    int height;
};

const Shape kShapes[] = {{1, 1 << 20}, {1 << 20, 1}, {2, 1 << 19}, {3, 349525},  {63, 16384},
                         {64, 16384},  {65, 16131},  {1024, 1024}, {1000, 1000}, {16384, 65}};

TEST_CASE("a sample has as many texels as were asked for, whatever the image's shape")
{
    for (const Shape shape : kShapes)
    {
        for (const int asked : {1024, 65536, 131072, 524288})
        {
            CAPTURE(shape.width);
            CAPTURE(shape.height);
            CAPTURE(asked);
            const Sample found = sample(shape.width, shape.height, asked);
            CHECK(found.isInside);
            CHECK(found.isDistinct);
            if (shape.width % 64 == 0 || shape.width < 64)
            {
                // All runs are of one length.
                CHECK(found.texels <= asked);
                CHECK(found.texels > asked - 64);
            }
            else
            {
                CHECK(found.texels > asked / 2);
                CHECK(found.texels < 2 * asked);
            }
            // No quarter of the image has less than half of its share.
            const int quarters = (shape.width > 1 ? 2 : 1) * (shape.height > 1 ? 2 : 1);
            for (int i = 0; i < (shape.width > 1 ? 2 : 1); ++i)
                for (int j = 0; j < (shape.height > 1 ? 2 : 1); ++j)
                    CHECK(found.texelsOfQuarter[i][j] > asked / (2 * quarters));
        }
    }
}

TEST_CASE("a sample of all texels or more is the whole image, in its order")
{
    for (const Shape shape : {Shape{1, 1}, {1, 100}, {100, 1}, {64, 3}, {65, 3}, {127, 5}})
    {
        for (const int asked : {0, -1, shape.width * shape.height, 1 << 30})
        {
            long long next = 0;
            detail::forEachRun(shape.width, shape.height, asked,
                               [&](int begin, int y, int count)
                               {
                                   CHECK(static_cast<long long>(y) * shape.width + begin == next);
                                   next += count;
                               });
            CHECK(next == static_cast<long long>(shape.width) * shape.height);
        }
    }
}

TEST_CASE("a sample is never empty")
{
    CHECK(sample(1000, 1000, 1).texels > 0);
    CHECK(sample(1, 1000, 1).texels == 1);
}

} // namespace
} // namespace lvsm::unit
