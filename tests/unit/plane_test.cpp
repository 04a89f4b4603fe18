// Receivers judged relative to their plane.
#include <lvsm/plane.hpp>

#include <doctest/doctest.h>

#include <initializer_list>

namespace
{

// A window of samples along one axis: offset in texels, depth, weight. Moments of the layer [0,1].
template <typename T>
struct Window
{
    T m1 = T(0);
    T m2 = T(0);
    T covariance = T(0);

    void add(T offset, T slope, T depth, T weight)
    {
        m1 += weight * depth;
        m2 += weight * depth * depth;
        covariance += weight * slope * offset * depth;
    }

    T visibility(T t, T slope, T minVariance, T amount) const
    {
        const T variance = lvsm::planeVariance(glm::vec<2, T>(slope, T(0)), T(1));
        return lvsm::planeBracketedVisibility(glm::vec<2, T>(T(1)), glm::vec<2, T>(m1, m2), glm::vec<2, T>(T(0)),
                                              glm::vec<3, T>(T(0), covariance, T(0)), t, glm::vec<2, T>(T(0), T(1)),
                                              variance, minVariance, amount);
    }
};

// Two offsets of equal weight have the deviation 1.
template <typename T>
Window<T> plates(T t, T slope, T occluder, T share)
{
    Window<T> window;
    for (const T offset : {T(-1), T(1)})
    {
        window.add(offset, slope, t + slope * offset, T(0.5) * (T(1) - share));
        window.add(offset, slope, occluder + slope * offset, T(0.5) * share);
    }
    return window;
}

} // namespace

TEST_CASE_TEMPLATE("a lit plane is fully lit, whatever its slope", T, float, double)
{
    for (const T slope : {T(0), T(0.001), T(0.01), T(0.05)})
        CHECK(plates(T(0.5), slope, T(0.2), T(0)).visibility(T(0.5), slope, T(1e-6), T(0.15)) ==
              doctest::Approx(1.0).epsilon(1e-5));
}

TEST_CASE_TEMPLATE("a parallel occluder over a slanted plane darkens by its share", T, float, double)
{
    // Relative to the plane the window holds two depths, which the bound meets, but for the floor: a tenth of the
    // plane's variance adds at most floor / (floor + share distance^2) to it.
    for (const T share : {T(0.25), T(0.5), T(0.75)})
    {
        for (const T slope : {T(0), T(0.002), T(0.01)})
        {
            const T floor = T(0.1) * slope * slope + T(1e-6);
            const T visibility = plates(T(0.6), slope, T(0.3), share).visibility(T(0.6), slope, T(1e-6), T(0));
            CHECK(visibility >= T(1) - share - T(1e-5));
            CHECK(visibility <= T(1) - share + T(3) * floor / (share * T(0.09)) + T(1e-5));
        }
    }
}

TEST_CASE_TEMPLATE("without slope it is bracketedBoundedVisibility", T, float, double)
{
    using vec2 = glm::vec<2, T>;
    for (int i = 0; i < 200; ++i)
    {
        const T a = static_cast<T>((7 * i) % 19) / T(19);
        const T b = static_cast<T>((5 * i) % 23) / T(23);
        const vec2 front(T(1) - T(0.5) * a, T(1) - T(0.6) * a);
        const vec2 moments(b, b * b + T(0.5) * (b - b * b));
        const vec2 behind(T(0.5) * b * a, T(0.4) * b * a);
        const T depth = T(0.25) + T(0.25) * static_cast<T>(i % 7) / T(7);
        const vec2 interval(T(0.25), T(0.5));
        const T plain = lvsm::bracketedBoundedVisibility(front, moments, behind, depth, interval, T(1e-5));
        const T plane = lvsm::planeBracketedVisibility(front, moments, behind, glm::vec<3, T>(T(0)), depth, interval,
                                                       T(0), T(1e-5), T(0));
        // What is left can be next to nothing, which the one divides by and the other does not.
        CHECK(plane == doctest::Approx(plain).epsilon(1e-4));
    }
}

TEST_CASE_TEMPLATE("planeCovariance is exact for a plane under any filter of that deviation", T, float, double)
{
    using vec4 = glm::vec<4, T>;
    const glm::vec<2, T> gradient(T(0.01), T(-0.02));
    const vec4 neighbours(T(0.5) + gradient.x, T(0.5) - gradient.x, T(0.5) + gradient.y, T(0.5) - gradient.y);
    CHECK(lvsm::planeCovariance(neighbours, gradient, T(1.5)) ==
          doctest::Approx(static_cast<double>(lvsm::planeVariance(gradient, T(1.5)))).epsilon(1e-5));
}
