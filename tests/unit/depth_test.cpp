#include <lvsm/depth.hpp>

#include <doctest/doctest.h>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/mat4x4.hpp>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

// The depth of a point on the axis of a glm projection, by the matrix itself.
double projectedDepth(const glm::dmat4& projection, double distance)
{
    const glm::dvec4 clip = projection * glm::dvec4(0, 0, -distance, 1);
    return clip.z / clip.w;
}

constexpr double kPlanes[][2] = {{0.1, 10}, {0.1, 1000}, {1, 2}, {0.5, 77}, {0.01, 10000}};

TEST_CASE_TEMPLATE("linstep is 0 up to lo, 1 from hi on and linear between", T, float, double)
{
    for (const Vec2<T> range : {Vec2<T>(0, 1), Vec2<T>(T(0.25), T(0.75)), Vec2<T>(-4, 12)})
    {
        CHECK(linstep(range.x, range.x, range.y) == 0);
        CHECK(linstep(range.x - 1, range.x, range.y) == 0);
        CHECK(linstep(range.y, range.x, range.y) == 1);
        CHECK(linstep(range.y + 1, range.x, range.y) == 1);
        for (int i = 0; i <= 64; ++i)
        {
            const T share = T(i) / T(64);
            CHECK(linstep(range.x + share * (range.y - range.x), range.x, range.y) == share);
        }
    }
}

TEST_CASE_TEMPLATE("linstep of an empty or inverted range is a step at hi", T, float, double)
{
    const T subnormal = kTiny<T> / 2;
    for (const Vec2<T> range : {Vec2<T>(T(0.5), T(0.5)), Vec2<T>(T(0.75), T(0.5)), Vec2<T>(-subnormal, 0)})
    {
        CHECK(linstep(range.y, range.x, range.y) == 1);
        CHECK(linstep(T(2), range.x, range.y) == 1);
        CHECK(linstep(justBelow(range.y), range.x, range.y) == 0);
        CHECK(linstep(T(-2), range.x, range.y) == 0);
    }
}

TEST_CASE_TEMPLATE("linstep of a range longer than 2^126 ends there", T, float, double)
{
    CHECK(linstep(T(0x1p125), T(0), T(0x1p127)) == T(0.5));
    CHECK(linstep(T(0x1p126), T(0), T(0x1p127)) == 1);
}

TEST_CASE_TEMPLATE("linstep never falls and never leaves its ends open", T, float, double)
{
    Random random(1);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const T lo = random.unit<T>();
        const T hi = random.unit<T>();
        const T x = random.unit<T>();
        const T next = std::nextafter(x, T(2));
        tally.claim(linstep(next, lo, hi) >= linstep(x, lo, hi), x, lo, hi);
        tally.claim(linstep(hi, lo, hi) == T(1), lo, hi);
        tally.claim(hi <= lo || linstep(lo, lo, hi) == T(0), lo, hi);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("pointLightDepth is the normalised Euclidean distance", T, float, double)
{
    // Pythagorean quadruples: the distance is an integer and every step is exact.
    const int quadruples[][4] = {{3, 4, 0, 5}, {2, 3, 6, 7}, {1, 4, 8, 9}, {2, 6, 9, 11}, {8, 9, 12, 17}, {0, 0, 0, 0}};
    const Vec3<T> light(T(10), T(-20), T(0.5));
    for (const auto& q : quadruples)
    {
        for (int sign : {-1, 1})
        {
            const Vec3<T> position = light + T(sign) * Vec3<T>(T(q[0]), T(q[1]), T(q[2]));
            CHECK(pointLightDepth(position, light, T(0), T(32)) == T(q[3]) / T(32));
            CHECK(pointLightDepth(position, light, T(1), T(17)) == std::max(T(q[3] - 1) / T(16), T(0)));
        }
    }
}

TEST_CASE_TEMPLATE("planeLightDepth is the normalised distance to the light plane", T, float, double)
{
    const Vec3<T> light(1, 2, 3);
    const Vec3<T> down(0, -1, 0);
    CHECK(planeLightDepth(Vec3<T>(77, -6, -5), light, down, T(0), T(16)) == T(0.5));
    CHECK(planeLightDepth(Vec3<T>(77, -6, -5), light, down, T(4), T(12)) == T(0.5));
    // Behind the plane is nearer than near.
    CHECK(planeLightDepth(Vec3<T>(0, 3, 0), light, down, T(0), T(16)) == 0);
    CHECK(planeLightDepth(Vec3<T>(0, 3, 0), light, down, T(-2), T(0)) == T(0.5));
    // Any point of the plane stands for it.
    CHECK(planeLightDepth(Vec3<T>(77, -6, -5), Vec3<T>(-900, 2, 41), down, T(0), T(16)) == T(0.5));
    // An oblique direction, with three products and two sums rounded once each.
    const Vec3<T> oblique(T(2) / T(7), T(-3) / T(7), T(6) / T(7));
    const T depth = planeLightDepth(light + T(14) * oblique, light, oblique, T(0), T(28));
    CHECK(std::abs(Exact(depth) - Exact(0.5)) <= 16 * kRoundoff<T>);
}

TEST_CASE_TEMPLATE("planeLightDepth scales by the length of its direction", T, float, double)
{
    CHECK(planeLightDepth(Vec3<T>(0, 0, 4), Vec3<T>(0), Vec3<T>(0, 0, 2), T(0), T(16)) == T(0.5));
}

TEST_CASE_TEMPLATE("planeLightDepth counts components beyond 1e18 as 1e18", T, float, double)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const T sign : {T(-1), T(1)})
        {
            Vec3<T> one(0), far(0);
            one[axis] = sign;
            far[axis] = sign * T(3.0e18);
            CHECK(planeLightDepth(far, Vec3<T>(0), one, T(0), T(4.0e18)) == T(0.25));
            CHECK(planeLightDepth(one, Vec3<T>(0), far, T(0), T(4.0e18)) == T(0.25));
        }
    }
}

TEST_CASE_TEMPLATE("light depths are a step at the far distance where near is not in front of it", T, float, double)
{
    const Vec3<T> light(0);
    for (const T near : {T(5), T(9)})
    {
        CHECK(pointLightDepth(Vec3<T>(0, 3, 4), light, near, T(5)) == 1);
        CHECK(pointLightDepth(Vec3<T>(0, 3, T(3.9)), light, near, T(5)) == 0);
        CHECK(planeLightDepth(Vec3<T>(0, 0, 5), light, Vec3<T>(0, 0, 1), near, T(5)) == 1);
        CHECK(planeLightDepth(Vec3<T>(0, 0, T(4.9)), light, Vec3<T>(0, 0, 1), near, T(5)) == 0);
    }
}

TEST_CASE_TEMPLATE("linearDepth inverts glm's perspective projection", T, float, double)
{
    Tally tally;
    for (const auto& [near, far] : kPlanes)
    {
        const glm::dmat4 zeroToOne = glm::perspectiveRH_ZO(1.0, 1.5, near, far);
        const glm::dmat4 minusOneToOne = glm::perspectiveRH_NO(1.0, 1.5, near, far);
        for (int i = 0; i <= 1000; ++i)
        {
            const double truth = i / 1000.0;
            const double distance = near + truth * (far - near);
            const double depths[] = {projectedDepth(zeroToOne, distance),
                                     projectedDepth(minusOneToOne, distance) / 2 + 0.5};
            for (const double z : depths)
            {
                // Slope of the inverse times the error of z in T, of the planes in T (two more) and of glm in double.
                const double sum = z * near + (1 - z) * far;
                const Exact slope = near * far / (sum * sum);
                const Exact tolerance = slope * (3 * kRoundoff<T> + 16 * kRoundoff<double>)+8 * kRoundoff<T>;
                const T depth = linearDepth(static_cast<T>(z), static_cast<T>(near), static_cast<T>(far));
                tally.claim(std::abs(Exact(depth) - truth) <= tolerance, near, far, truth, depth);
            }
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("linearDepthReversed inverts glm's projection with the planes exchanged", T, float, double)
{
    Tally tally;
    for (const auto& [near, far] : kPlanes)
    {
        const glm::dmat4 reversed = glm::perspectiveRH_ZO(1.0, 1.5, far, near);
        for (int i = 0; i <= 1000; ++i)
        {
            const double truth = i / 1000.0;
            const double distance = near + truth * (far - near);
            const double z = projectedDepth(reversed, distance);
            // z is rounded relative to itself, and near the far plane it is small: only glm's own error, absolute in
            // double, meets the slope there.
            const double sum = (1 - z) * near + z * far;
            const Exact slope = near * far / (sum * sum);
            const Exact tolerance = slope * 16 * kRoundoff<double> + 8 * kRoundoff<T>;
            const T depth = linearDepthReversed(static_cast<T>(z), static_cast<T>(near), static_cast<T>(far));
            tally.claim(std::abs(Exact(depth) - truth) <= tolerance, near, far, truth, depth);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("linear depths meet the planes exactly and clamp beyond them", T, float, double)
{
    for (const auto& [near, far] : kPlanes)
    {
        for (const T beyond : {T(0), T(0.5)})
        {
            CHECK(linearDepth(-beyond, T(near), T(far)) == 0);
            CHECK(linearDepth(1 + beyond, T(near), T(far)) == 1);
            CHECK(linearDepthReversed(1 + beyond, T(near), T(far)) == 0);
            CHECK(linearDepthReversed(-beyond, T(near), T(far)) == 1);
        }
    }
}

TEST_CASE_TEMPLATE("linear depths count planes that are not positive as 0", T, float, double)
{
    const T z = T(0.25);
    CHECK(linearDepth(z, T(0), T(0)) == z);
    CHECK(linearDepth(z, T(-1), T(-2)) == z);
    CHECK(linearDepthReversed(z, T(0), T(0)) == 1 - z);
    CHECK(linearDepthReversed(z, T(-1), T(-2)) == 1 - z);
    CHECK(linearDepth(z, T(-1), T(2)) == linearDepth(z, T(0), T(2)));
    CHECK(linearDepthReversed(z, T(1), T(-2)) == linearDepthReversed(z, T(1), T(0)));
    // Nor do they take anything from the other plane's part.
    CHECK(linearDepth(z, T(-100), T(2)) == 0);
    CHECK(linearDepth(z, T(2), T(-100)) == 1);
    CHECK(linearDepthReversed(z, T(-100), T(2)) == 0);
    CHECK(linearDepthReversed(z, T(2), T(-100)) == 1);
}

TEST_CASE_TEMPLATE("linear depths count planes beyond 2^126 as there", T, float, double)
{
    const T most = std::numeric_limits<T>::max();
    CHECK(linearDepth(T(0.5), most, T(0x1p126)) == T(0.5));
    CHECK(linearDepth(T(0.5), T(0x1p126), most) == T(0.5));
    CHECK(linearDepthReversed(T(0.5), most, T(0x1p126)) == T(0.5));
    CHECK(linearDepthReversed(T(0.5), T(0x1p126), most) == T(0.5));
}

TEST_CASE_TEMPLATE("signedDepth maps 0 1/2 1 to -1 0 1 and clamps", T, float, double)
{
    CHECK(signedDepth(T(0)) == -1);
    CHECK(signedDepth(T(0.5)) == 0);
    CHECK(signedDepth(T(0.75)) == T(0.5));
    CHECK(signedDepth(T(1)) == 1);
    CHECK(signedDepth(T(-3)) == -1);
    CHECK(signedDepth(T(3)) == 1);
}

} // namespace
} // namespace lvsm::unit
