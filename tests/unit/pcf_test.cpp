#include <lvsm/pcf.hpp>

#include <doctest/doctest.h>

#include <algorithm>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

// Percentage-closer filtering of a map by a box of some width around a position in texels.
template <typename T, typename DepthAt, typename ReceiverAt>
T boxFiltered(Vec2<T> position, T width, const DepthAt& depthAt, const ReceiverAt& receiverAt)
{
    const int reach = int(width / 2) + 2;
    Vec2<T> sum(0);
    for (int y = -reach; y <= reach; y += 2)
    {
        for (int x = -reach; x <= reach; x += 2)
        {
            Vec4<T> depths;
            Vec4<T> weights;
            Vec4<T> receivers;
            for (int i = 0; i < 4; ++i)
            {
                const Vec2<T> texel =
                    Vec2<T>(std::floor(position.x), std::floor(position.y)) + Vec2<T>(x + i % 2, y + i / 2);
                const Vec2<T> offset = texel - position;
                depths[i] = depthAt(texel);
                weights[i] = boxWeight(offset.x, width) * boxWeight(offset.y, width);
                receivers[i] = receiverAt(offset);
            }
            sum = pcfAdd(sum, depths, weights, receivers, T(0));
        }
    }
    return pcfVisibility(sum);
}

TEST_CASE_TEMPLATE("depthTest lights what is not behind the occluder", T, float, double)
{
    CHECK(depthTest(T(0.5), T(0.5), T(0)) == 1);
    CHECK(depthTest(T(0.5), std::nextafter(T(0.5), T(1)), T(0)) == 0);
    CHECK(depthTest(T(0.5), T(0.25), T(0)) == 1);
    CHECK(depthTest(T(0.5), T(0.75), T(0.25)) == 1);
    CHECK(depthTest(T(0.5), T(0.75), T(0.125)) == 0);
    CHECK(depthTest(T(0.5), T(0.5), T(-0.125)) == 0);
}

TEST_CASE_TEMPLATE("depthTest lights a receiver beyond the far end over an empty texel", T, float, double)
{
    CHECK(depthTest(T(1), T(7), T(0)) == 1);
    CHECK(depthTest(T(0.999), T(7), T(0)) == 0);
}

TEST_CASE_TEMPLATE("pcfBilinear tests first and then interpolates", T, float, double)
{
    const Vec4<T> depths(T(0.1), T(0.9), T(0.2), T(0.8));
    for (int i = 0; i <= 8; ++i)
    {
        const T x = T(i) / 8;
        CHECK(pcfBilinear(depths, Vec2<T>(x, T(0.375)), Vec4<T>(T(0.5)), T(0)) == x);
    }
    // Interpolating the depths first would light or shade all of it.
    CHECK(pcfBilinear(depths, Vec2<T>(T(0.5), 0), Vec4<T>(T(0.85)), T(0)) == T(0.5));
}

TEST_CASE_TEMPLATE("pcfAdd with box weights gives the lit area of a box of any width", T, float, double)
{
    Random random(5);
    Tally tally;
    for (int i = 0; i < 2000; ++i)
    {
        const T width = T(0.5) + T(7) * random.unit<T>();
        const Vec2<T> position(random.unit<T>(), random.unit<T>());
        const int edge = random.between(-4, 4);
        const auto depthAt = [edge](Vec2<T> texel)
        {
            return texel.x < T(edge) ? T(0.25) : T(1);
        };
        const auto receiverAt = [](Vec2<T>)
        {
            return T(0.5);
        };
        const Exact right = Exact(position.x) + Exact(width) / 2;
        const Exact lit = std::clamp((right - (Exact(edge) - Exact(0.5))) / Exact(width), Exact(0), Exact(1));
        const Exact visibility = boxFiltered(position, width, depthAt, receiverAt);
        // Weights of texels up to 6 away are four roundings of numbers up to 8 apart from exact, over the width, for up to
        // 9 x 9 texels; the sums add as many roundings as there are texels to numbers up to 1.
        const Exact error = kRoundoff<T> * (2 * 9 * 4 * 8 / Exact(width) + 2 * 169);
        tally.claim(std::abs(visibility - lit) <= error, width, position.x, edge, visibility, lit);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("pcfAdd with Gaussian weights gives the weight of what is lit", T, float, double)
{
    for (int size : {3, 5, 7, 9})
    {
        for (int litColumns = 0; litColumns <= size; ++litColumns)
        {
            Vec2<T> sum(0);
            Exact lit = 0;
            for (int y = 0; y < size; ++y)
            {
                for (int x = 0; x < size; x += 4)
                {
                    Vec4<T> depths(0);
                    Vec4<T> weights(0);
                    for (int i = 0; i < 4; ++i)
                    {
                        depths[i] = x + i < litColumns ? T(0.5) : T(0.25);
                        weights[i] = gaussianWeight(x + i, size, T(1.5)) * gaussianWeight(y, size, T(1.5));
                    }
                    sum = pcfAdd(sum, depths, weights, Vec4<T>(T(0.5)), T(0));
                }
            }
            for (int x = 0; x < litColumns; ++x)
                lit += gaussianWeight(x, size, T(1.5));
            // The weights of a size add up to 1 within (size + 6) roundings; 81 of them are multiplied and summed.
            CHECK(std::abs(Exact(pcfVisibility(sum)) - lit) <= kRoundoff<T> * (3 * 81 + 4 * (size + 6)));
        }
    }
}

TEST_CASE_TEMPLATE("a receiver's own plane does not shadow it when each texel is compared with it", T, float, double)
{
    // Dyadic slopes and positions: the plane is exact at every texel.
    const Vec2<T> slope(T(0.0625), T(-0.03125));
    const Vec2<T> position(T(0.25), T(0.75));
    const T depth = T(0.5);
    const auto plane = [=](Vec2<T> offset)
    {
        return depth + slope.x * offset.x + slope.y * offset.y;
    };
    const auto depthAt = [=](Vec2<T> texel)
    {
        return plane(texel - position);
    };
    CHECK(boxFiltered(position, T(4.5), depthAt, plane) == 1);
    CHECK(boxFiltered(position, T(4.5), depthAt, [=](Vec2<T>) { return depth; }) < T(0.75));
}

TEST_CASE_TEMPLATE("pcfVisibility of no texels is lit", T, float, double)
{
    CHECK(pcfVisibility(Vec2<T>(0, 0)) == 1);
    CHECK(pcfVisibility(Vec2<T>(-1, -1)) == 1);
}

TEST_CASE_TEMPLATE("weights beyond 2^122 and sums beyond 2^125 count as these", T, float, double)
{
    const Vec4<T> none(0), lit(1), shadow(0), receivers(T(0.5));
    const Vec4<T> heavy(T(0x1p125), 0, 0, 0);
    CHECK(pcfAdd(Vec2<T>(0), lit, heavy, receivers, T(0)) == Vec2<T>(T(0x1p122), T(0x1p122)));
    CHECK(pcfAdd(Vec2<T>(0), shadow, heavy, receivers, T(0)) == Vec2<T>(0, T(0x1p122)));
    CHECK(pcfAdd(Vec2<T>(T(0x1p126)), lit, none, receivers, T(0)) == Vec2<T>(T(0x1p125)));
}

TEST_CASE_TEMPLATE("percentage-closer filtering stays in range for any arguments", T, float, double)
{
    Tally tally;
    const std::vector<T> values = specialValues<T>();
    Random random(6);
    const auto any = [&]
    {
        return values[std::size_t(random.between(0, int(values.size()) - 1))];
    };
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec4<T> depths(any(), any(), any(), any());
        const Vec4<T> receivers(any(), any(), any(), any());
        const T bilinear = pcfBilinear(depths, Vec2<T>(any(), any()), receivers, any());
        tally.claim(bilinear >= 0 && bilinear <= 1, bilinear);
        const Vec2<T> sum =
            pcfAdd(Vec2<T>(any(), any()), depths, Vec4<T>(any(), any(), any(), any()), receivers, any());
        tally.claim(sum.x >= 0 && sum.x <= kHuge<T> && sum.y >= 0 && sum.y <= kHuge<T>, sum.x, sum.y);
        const T visibility = pcfVisibility(Vec2<T>(any(), any()));
        tally.claim(visibility >= 0 && visibility <= 1, visibility);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("a receiver and its bias beyond their ranges count as the ends of them", T, float, double)
{
    CHECK(depthTest(T(-0.5), T(-3), T(0)) == T(0));
    CHECK(depthTest(T(1), T(7), T(0)) == T(1));
    CHECK(depthTest(T(-0.75), T(0.5), T(1)) == T(0));
    CHECK(depthTest(T(-0.5), T(0.5), T(1)) == T(1));
    CHECK(depthTest(T(-0.75), T(0.5), T(7)) == T(0));
    CHECK(depthTest(T(1.25), T(0.5), T(-1)) == T(0));
    CHECK(depthTest(T(1.5), T(0.5), T(-1)) == T(1));
    CHECK(depthTest(T(1.5), T(0.5), T(-7)) == T(1));
}

} // namespace
} // namespace lvsm::unit
