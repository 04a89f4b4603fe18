#include <lvsm/moments4.hpp>

#include <doctest/doctest.h>

#include <algorithm>

#include "distributions.hpp"
#include "ranges.hpp"

namespace lvsm::unit
{
namespace
{

struct Window : DepthWindow
{
    using DepthWindow::DepthWindow;

    Vec4<double> moments(const Vec2<double>& interval) const
    {
        return mean([&](double depth) { return layerMoments4(depth, interval); });
    }
};

// The bound the plain way: the kernel polynomial by solving the 3 x 3 Hankel system, its roots, and the weights of the
// three atoms from the first moments. In long double, for moments well inside the valid ones.
Exact plainHamburger(const Vec4<double>& b, Exact t)
{
    const Exact h[3][3] = {{1, b.x, b.y}, {b.x, b.y, b.z}, {b.y, b.z, b.w}};
    const auto minor = [&](int r0, int r1, int c0, int c1)
    {
        return h[r0][c0] * h[r1][c1] - h[r0][c1] * h[r1][c0];
    };
    // Adjugate of a symmetric matrix times (1, t, t^2): the kernel polynomial but for a factor.
    const Exact a[3][3] = {{minor(1, 2, 1, 2), -minor(0, 2, 1, 2), minor(0, 1, 1, 2)},
                           {-minor(0, 2, 1, 2), minor(0, 2, 0, 2), -minor(0, 1, 0, 2)},
                           {minor(0, 1, 1, 2), -minor(0, 1, 0, 2), minor(0, 1, 0, 1)}};
    Exact c[3];
    for (int i = 0; i < 3; ++i)
        c[i] = a[i][0] + a[i][1] * t + a[i][2] * t * t;
    const Exact middle = -c[1] / (2 * c[2]);
    const Exact root = std::sqrt(middle * middle - c[0] / c[2]);
    const Exact atoms[] = {t, middle - root, middle + root};
    Exact lit = 0;
    for (int i = 0; i < 3; ++i)
    {
        const Exact y = atoms[(i + 1) % 3], z = atoms[(i + 2) % 3], x = atoms[i];
        const Exact weight = (Exact(b.y) - Exact(b.x) * (y + z) + y * z) / ((x - y) * (x - z));
        lit += i == 0 || x >= t ? weight : 0;
    }
    return lit;
}

TEST_CASE_TEMPLATE("depthMoments4 are the powers of the signed depth", T, float, double)
{
    CHECK(depthMoments4(T(1)) == Vec4<T>(1, 1, 1, 1));
    CHECK(depthMoments4(T(0)) == Vec4<T>(-1, 1, -1, 1));
    CHECK(depthMoments4(T(0.75)) == Vec4<T>(T(0.5), T(0.25), T(0.125), T(0.0625)));
    CHECK(layerMoments4(T(0.5), Vec2<T>(T(0.25), T(0.5))) == Vec4<T>(1, 1, 1, 1));
    CHECK(layerMoments4(T(0.375), Vec2<T>(T(0.25), T(0.5))) == Vec4<T>(0, 0, 0, 0));
}

TEST_CASE_TEMPLATE("the basis for 16 bits comes back and fills the unit interval", T, float, double)
{
    Vec4<T> least(1), most(0);
    Tally tally;
    for (int i = 0; i <= 4096; ++i)
    {
        const Vec4<T> moments = depthMoments4(T(i) / T(4096));
        const Vec4<T> encoded = encodeMoments4(moments);
        const Vec4<T> decoded = decodeMoments4(encoded);
        for (int k = 0; k < 4; ++k)
        {
            least[k] = std::min(least[k], encoded[k]);
            most[k] = std::max(most[k], encoded[k]);
            // Ten roundings of numbers up to 4, and constants of nine digits.
            tally.claim(std::abs(Exact(decoded[k]) - Exact(moments[k])) <= 40 * kRoundoff<T> + 4e-9L, i, k);
        }
    }
    LVSM_CHECK_TALLY(tally);
    for (int k = 0; k < 4; ++k)
    {
        CHECK(least[k] <= T(0.001));
        CHECK(most[k] >= T(0.999));
    }
    const Vec4<T> clear = encodeMoments4(depthMoments4(T(1)));
    CHECK(clear.x == T(0));
    CHECK(clear.y == T(0));
    CHECK(std::abs(Exact(clear.z) - 0.981125225L) < 2e-7L);
    CHECK(clear.w == T(1));
}

// The biased distribution holds (1 - bias) of the window, so that the bound can fall below the truth by the bias.
// Rounding moves the moments by 2^-50, against 0.1 bias for the least norm of the polynomials.
TEST_CASE("hamburgerUpperBound bounds every distribution but for the bias")
{
    Random random(141);
    Tally tally;
    const double bias = 1e-6;
    for (int i = 0; i < drawsOf(1000000); ++i)
    {
        const Window window(random);
        const double t = window.receiver(random);
        const double bound = momentVisibility4(window.moments({0.0, 1.0}), t, bias);
        tally.claim(bound >= window.tail(t) - bias - 1e-7, t, window.tail(t), bound);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("hamburgerUpperBound is what the Hankel system gives")
{
    Random random(142);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Window window(random);
        const double bias = 0.05;
        Vec4<double> b = window.moments({0.0, 1.0});
        const double t = 2 * random.unit<double>() - 1;
        const double bound = hamburgerUpperBound(b, t, bias);
        b = (1 - bias) * b + bias * Vec4<double>(0, 0.63, 0, 0.63);
        const Exact plain = plainHamburger(b, t);
        // The plain way loses what its roots lose where one is far away.
        tally.claim(std::abs(Exact(bound) - plain) < 1e-8L, b.x, b.y, b.z, b.w, t, bound, plain);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("hamburgerUpperBound is exact for two occluders and a receiver")
{
    Random random(143);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const double first = 0.05 + 0.25 * random.unit<double>();
        const double second = first + 0.1 + 0.2 * random.unit<double>();
        const double receiver = second + 0.1 + 0.2 * random.unit<double>();
        const double a = 0.1 + 0.3 * random.unit<double>();
        const double b = 0.1 + 0.3 * random.unit<double>();
        const Vec4<double> moments =
            a * depthMoments4(first) + b * depthMoments4(second) + (1 - a - b) * depthMoments4(receiver);
        const double bound = momentVisibility4(moments, receiver, 1e-9);
        // Depths a fifth apart in [-1,1]: the kernel's inverse norms are at most some 1e5, times the bias.
        tally.claim(std::abs(bound - (1 - a - b)) < 1e-3, first, second, receiver, a, b, bound);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("four moments are never worse than two")
{
    Random random(144);
    Tally tally;
    for (int i = 0; i < drawsOf(200000); ++i)
    {
        const Window window(random);
        const double t = 2 * window.receiver(random) - 1;
        const Vec4<double> b = window.moments({0.0, 1.0});
        // Both of the biased moments.
        const Vec2<double> two((1 - 1e-6) * b.x, (1 - 1e-6) * b.y + 0.63e-6);
        const double bound = hamburgerUpperBound(b, t, 1e-6);
        tally.claim(bound <= chebyshevUpperBound(two, t, 0.0) + 1e-7, t, bound);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("hamburgerUpperBound falls with depth")
{
    Random random(145);
    Tally tally;
    for (int i = 0; i < drawsOf(5000); ++i)
    {
        const Vec4<double> moments = Window(random).moments({0.0, 1.0});
        double before = 1;
        for (int k = 0; k <= 64; ++k)
        {
            const double bound = hamburgerUpperBound(moments, k / 32.0 - 1, 1e-5);
            tally.claim(bound <= before + 1e-9, k, bound, before);
            before = bound;
        }
    }
    LVSM_CHECK_TALLY(tally);
}

// Is the Hankel matrix of moments with b0 = 1 - or of any such numbers - free of negative eigenvalues?
bool isValid(Exact b0, const Vec4<Exact>& b)
{
    const Exact two = b0 * b.y - b.x * b.x;
    const Exact three = b0 * (b.y * b.w - b.z * b.z) - b.x * (b.x * b.w - b.z * b.y) + b.y * (b.x * b.z - b.y * b.y);
    return b0 >= 0 && two >= 0 && three >= 0;
}

TEST_CASE("recommendedMoment4Bias is the least that makes up for rounding")
{
    const Exact error = 0.5L / 65535;
    const Exact bias = recommendedMoment4Bias(static_cast<double>(error));
    bool always = true, isNeeded = false;
    for (int corner = 0; corner < 16; ++corner)
    {
        Vec4<Exact> encoded;
        for (int i = 0; i < 4; ++i)
            encoded[i] = (corner >> i & 1) != 0 ? error : -error;
        // Without its offset and clamps the decoding is linear.
        const Exact root = std::sqrt(3.0L);
        const Vec4<Exact> moments(root * encoded.z - encoded.x / 3, encoded.w + encoded.y / 8,
                                  0.75L * (root * encoded.z - encoded.x), encoded.w - encoded.y / 8);
        const Vec4<Exact> target(0, 0.63L, 0, 0.63L);
        always = always && isValid(bias, moments + bias * target);
        isNeeded = isNeeded || !isValid(0.999L * bias, moments + 0.999L * bias * target);
    }
    CHECK(always);
    CHECK(isNeeded);
    CHECK(recommendedMoment4Bias(-1.0) == 0);
    CHECK(recommendedMoment4Bias(5.0) == 1);
}

TEST_CASE("the norms of the polynomials are at least what the bias brings")
{
    Random random(148);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec4<double> moments = Window(random).moments({0.0, 1.0});
        const double bias = 0.01;
        const Vec4<double> b = (1 - bias) * moments + bias * Vec4<double>(0, 0.63, 0, 0.63);
        const double v = b.y - b.x * b.x;
        const double e = b.z - b.x * b.y;
        tally.claim(v >= 0.63 * bias - 1e-12, v);
        tally.claim(b.w - b.y * b.y - e * e / v >= 0.2331 * bias - 1e-12, v, e);
    }
    LVSM_CHECK_TALLY(tally);
}

// A thousandth is the darkening that the default biases are asked to keep flat lit surfaces from.
TEST_CASE("the default biases keep flat lit surfaces lit")
{
    Tally tally;
    for (int i = 0; i <= 262144; ++i)
    {
        const double depth = i / 262144.0;
        const Vec4<double> stored = decodeMoments4(unorm16(encodeMoments4(depthMoments4(depth))));
        tally.claim(momentVisibility4(stored, depth, kMoment4BiasUnorm16<double>) >= 0.999, depth);
        const float z = static_cast<float>(depth);
        tally.claim(momentVisibility4(depthMoments4(z), z, kMoment4BiasFp32<float>) >= 0.999f, depth);
    }
    LVSM_CHECK_TALLY(tally);
}

// With less bias than rounding needs the norms that come out are wrong, but never less than what the bias brings.
TEST_CASE("flat lit surfaces stay lit for biases below the default")
{
    Tally tally;
    for (const float bias : {5.0e-8f, 1.0e-7f, 2.0e-7f})
    {
        for (int i = 0; i <= 65536; ++i)
        {
            const float depth = static_cast<float>(i) / 65536.0f;
            tally.claim(momentVisibility4(depthMoments4(depth), depth, bias) >= 0.999f, depth, bias);
            const Vec4<double> stored = decodeMoments4(unorm16(encodeMoments4(depthMoments4(double(depth)))));
            tally.claim(momentVisibility4(stored, double(depth), 100.0 * double(bias)) >= 0.999, depth, 100 * bias);
        }
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("without any bias one depth and two are judged as they are", T, float, double)
{
    // One depth: lit in front of it and at it, dark behind it.
    const Vec4<T> flat = depthMoments4(T(0.75));
    for (int i = 0; i <= 64; ++i)
        CHECK(momentVisibility4(flat, T(i) / 64, T(0)) == doctest::Approx(i <= 48 ? 1 : 0).epsilon(1e-6));
    // Two: the share of the farther is lit at its depth.
    const Vec4<T> two = T(0.25) * depthMoments4(T(0)) + T(0.75) * depthMoments4(T(0.5));
    CHECK(momentVisibility4(two, T(0.5), T(0)) == doctest::Approx(0.75));
}

TEST_CASE_TEMPLATE("what exceeds its range is taken to its end in four moments", T, float, double)
{
    const Range<T> odd{-1, 1}, even{0, 1};
    const auto momentsAt = [](const auto& a, std::size_t i)
    {
        return Vec4<T>(a[i], a[i + 1], a[i + 2], a[i + 3]);
    };
    checkEnds<T, 4>({odd, even, odd, even}, [&](const auto& a) { return encodeMoments4(momentsAt(a, 0)); });
    checkEnds<T, 6>({odd, even, odd, even, odd, even},
                    [&](const auto& a) { return hamburgerUpperBound(momentsAt(a, 0), a[4], a[5]); });
    const Vec2<T> interval(T(0.25), T(0.75));
    const Vec4<T> front = T(0.25) * depthMoments4(T(0.5)) + T(0.75) * depthMoments4(T(1));
    const Vec4<T> behind = T(0.25) * depthMoments4(T(0.5)) + T(0.75) * depthMoments4(T(0));
    checkEnds<T, 6>({odd, even, odd, even, Range<T>{T(0.25), T(0.75)}, even}, [&](const auto& a)
                    { return bracketedVisibility4(front, momentsAt(a, 0), behind, a[4], interval, a[5]); });
}

// JCGT section 2 has the two constants; here they are what so many roundings of half a step need.
TEST_CASE("the published biases are what rounding asks for")
{
    // As ratios: without scale(0) doctest's Approx takes all small numbers for the same.
    CHECK(kMoment4BiasUnorm16<double> / recommendedMoment4Bias(1.6 * 0.5 / 65535) == doctest::Approx(1).epsilon(0.02));
    CHECK(kMoment4BiasFp32<double> / recommendedMoment4Bias(2.385 * 0.9 * 0x1p-25) == doctest::Approx(1).epsilon(0.05));
}

struct Layered
{
    Vec4<double> front, moments, behind;
    Vec2<double> interval;

    Layered(const Window& window, double depth, const double* splits, int layerCount)
    {
        const int layer = layerIndex(depth, splits, layerCount);
        interval = {splits[layer], splits[layer + 1]};
        front = layer > 0 ? window.moments({splits[layer - 1], splits[layer]}) : Vec4<double>(1);
        moments = window.moments(interval);
        const bool isLast = layer + 1 == layerCount;
        behind = isLast ? Vec4<double>(-1, 1, -1, 1) : window.moments({splits[layer + 1], splits[layer + 2]});
    }

    void store()
    {
        for (Vec4<double>* m : {&front, &moments, &behind})
            *m = decodeMoments4(unorm16(encodeMoments4(*m)));
    }

    double visibility(double depth, double bias) const
    {
        return bracketedVisibility4(front, moments, behind, depth, interval, bias);
    }
};

// The share in front is judged no larger than it is, since the bias is taken off it; the share that is left loses the
// bias as in the single layer, divided by the share and multiplied by it again.
TEST_CASE("bracketed four moments bound every distribution but for the bias")
{
    Random random(146);
    Tally tally;
    const double bias = 1e-6;
    double bracketed = 0, single = 0;
    for (int i = 0; i < drawsOf(1000000); ++i)
    {
        const Window window(random);
        const double t = window.receiver(random);
        double splits[4] = {0, 0.1 + 0.35 * random.unit<double>(), 0.55 + 0.35 * random.unit<double>(), 1};
        const Layered layers(window, t, splits, 3);
        const double visibility = layers.visibility(t, bias);
        const double truth = window.tail(t);
        tally.claim(visibility >= truth - 3 * bias - 1e-6, t, truth, visibility);
        bracketed += (visibility - truth) * (visibility - truth);
        const double layered = layeredVisibility4(layers.moments, t, layers.interval, bias) - truth;
        single += layered * layered;
    }
    LVSM_CHECK_TALLY(tally);
    CHECK(bracketed < 0.5 * single);
}

// Again to the thousandth that the default bias is asked to keep.
TEST_CASE("bracketed four moments stay bounds in 16 bits")
{
    Random random(147);
    Tally tally;
    const double bias = kMoment4BiasUnorm16<double>;
    for (int i = 0; i < drawsOf(300000); ++i)
    {
        const Window window(random);
        const double t = window.receiver(random);
        const double splits[] = {0, 0.25, 0.5, 0.75, 1};
        Layered layers(window, t, splits, 4);
        layers.store();
        tally.claim(layers.visibility(t, bias) >= window.tail(t) - 0.001, t, window.tail(t),
                    layers.visibility(t, bias));
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("with nothing in front of a layer and behind it only its own moments count", T, float, double)
{
    const Vec2<T> interval(T(0.25), T(0.5));
    const T bias = T(1.0e-3);
    // The last have no window, as rounding makes them: less than no share of them is behind.
    for (const Vec4<T>& own : {T(0.5) * (depthMoments4(T(0.25)) + depthMoments4(T(0.5))), Vec4<T>(T(-0.9), 0, 0, 0)})
    {
        const T bracketed = bracketedVisibility4(Vec4<T>(1), own, Vec4<T>(-1, 1, -1, 1), T(0.35), interval, bias);
        CHECK(bracketed == doctest::Approx(layeredVisibility4(own, T(0.35), interval, bias)).epsilon(0.01).scale(0));
    }
}

TEST_CASE_TEMPLATE("bracketed four moments know a layer that is all in front or all behind", T, float, double)
{
    const Vec4<T> lit = depthMoments4(T(1));
    const Vec4<T> dark = depthMoments4(T(0));
    const Vec2<T> interval(T(0.25), T(0.5));
    const T bias = kMoment4BiasUnorm16<T>;
    CHECK(bracketedVisibility4(lit, lit, lit, T(0.3), interval, bias) == doctest::Approx(1).epsilon(1e-3));
    CHECK(bracketedVisibility4(dark, dark, dark, T(0.3), interval, bias) == doctest::Approx(0).epsilon(1e-3));
    const Vec4<T> half = T(0.5) * (lit + dark);
    CHECK(bracketedVisibility4(half, half, half, T(0.3), interval, bias) == doctest::Approx(0.5).epsilon(1e-3));
}

// Neighbours from another window, or overlapping, can claim more than the layer's own moments leave room for.
TEST_CASE_TEMPLATE("bracketed four moments take no more at an end than the layer's own mean allows", T, float, double)
{
    const Vec4<T> atOne = depthMoments4(T(1));
    const Vec4<T> atZero = depthMoments4(T(0));
    const Vec2<T> interval(T(0.25), T(0.5));
    const T bias = kMoment4BiasUnorm16<T>;
    // All in front, says the one in front; all behind, says the layer.
    CHECK(bracketedVisibility4(atZero, atOne, atZero, T(0.4), interval, bias) == doctest::Approx(1).epsilon(1e-3));
    // All behind, says the one behind; all in front, says the layer.
    CHECK(bracketedVisibility4(atOne, atZero, atOne, T(0.4), interval, bias) == doctest::Approx(0).epsilon(1e-3));
    // Half of the window may be at an end, and the other half is at the layer's middle: in front of the receiver.
    const Vec4<T> half = T(0.5) * (atOne + depthMoments4(T(0.5)));
    // With its middle at 1/2 the layer holds (1/2)^2 / 2 + 1/2 of squares, which is what may be behind at most.
    CHECK(bracketedVisibility4(atOne, half, atOne, T(0.4), interval, bias) == doctest::Approx(0.625).epsilon(1e-3));
    const Vec4<T> other = T(0.5) * (atZero + depthMoments4(T(0.5)));
    // Three quarters may be in front by its mean; a quarter is left, and lies beyond the receiver's place.
    CHECK(bracketedVisibility4(atZero, other, atZero, T(0.26), interval, bias) == doctest::Approx(0.25).epsilon(1e-3));
}

} // namespace
} // namespace lvsm::unit
