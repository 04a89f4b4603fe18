#include <lvsm/moments4.hpp>
#include <lvsm/trigonometric.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <complex>

#include "distributions.hpp"
#include "ranges.hpp"

namespace lvsm::unit
{
namespace
{

using Complex = std::complex<Exact>;

constexpr Exact kPi = 3.14159265358979323846L;
constexpr double kOneRounding = 0.5 / 65535;

Exact angleOf(Exact depth)
{
    return (depth - 0.5L) * 4 * kPi / 3;
}

Vec4<double> momentsOf(const DepthWindow& window)
{
    return window.mean([](double depth) { return trigonometricMoments(depth); });
}

// The bound the plain way: the kernel polynomial by solving the Toeplitz system with Cramer's rule, its zeros by the
// quadratic formula, the weights from the moments. An atom is in front of t where its angle says so.
Exact plainBound(const Vec4<double>& stored, Exact depth, Exact bias)
{
    const Complex c1 = (1 - bias) * Complex(1.5L * stored.x - 0.5L, 2 * Exact(stored.y) - 1);
    const Complex c2 = (1 - bias) * Complex(2 * Exact(stored.z) - 1, 2 * Exact(stored.w) - 1);
    const Complex m[3][3] = {{1, std::conj(c1), std::conj(c2)}, {c1, 1, std::conj(c1)}, {c2, c1, 1}};
    const Complex t = std::polar(1.0L, angleOf(depth));
    const Complex right[3] = {1, t, t * t};
    const auto determinant = [](const Complex(&a)[3][3])
    {
        return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    };
    Complex u[3];
    for (int column = 0; column < 3; ++column)
    {
        Complex replaced[3][3];
        for (int i = 0; i < 3; ++i)
        {
            for (int j = 0; j < 3; ++j)
                replaced[i][j] = j == column ? right[i] : m[i][j];
        }
        u[column] = determinant(replaced) / determinant(m);
    }
    // sum of u_k conj(z)^k is 0: in z, conj(u0) z^2 + ... after conjugation.
    const Complex a = std::conj(u[2]), b = std::conj(u[1]), c = std::conj(u[0]);
    const Complex root = std::sqrt(b * b - 4.0L * a * c);
    const Complex atoms[3] = {t, (-b + root) / (2.0L * a), (-b - root) / (2.0L * a)};
    Exact lit = 0;
    for (int i = 0; i < 3; ++i)
    {
        const Complex x = atoms[i], y = atoms[(i + 1) % 3], z = atoms[(i + 2) % 3];
        const Complex weight = (c2 - c1 * (y + z) + y * z) / ((x - y) * (x - z));
        const Exact angle = std::arg(x);
        const bool isInFront = angle < angleOf(depth) && angle > std::atan2(-0.848L, -0.53L);
        lit += i == 0 || !isInFront ? weight.real() : 0;
    }
    return lit;
}

} // namespace

TEST_CASE_TEMPLATE("trigonometricMoments are those of a point on the arc", T, float, double)
{
    Tally tally;
    for (int i = 0; i <= 4096; ++i)
    {
        const Vec4<T> stored = trigonometricMoments(T(i) / T(4096));
        const Exact angle = angleOf(Exact(i) / 4096);
        const Exact wanted[] = {(std::cos(angle) + 0.5L) / 1.5L, 0.5L + 0.5L * std::sin(angle),
                                0.5L + 0.5L * std::cos(2 * angle), 0.5L + 0.5L * std::sin(2 * angle)};
        for (int k = 0; k < 4; ++k)
        {
            // The polynomials' 2e-8, at most four times; a dozen roundings of numbers up to 2.
            tally.claim(std::abs(Exact(stored[k]) - wanted[k]) <= 8e-8L + 12 * kRoundoff<T>, i, k, stored[k]);
            tally.claim(stored[k] >= 0 && stored[k] <= 1, i, k, stored[k]);
        }
    }
    LVSM_CHECK_TALLY(tally);
    for (int k = 0; k < 4; ++k)
    {
        // What is constant may be contracted otherwise.
        CHECK(std::abs(trigonometricMoments(T(7))[k] - trigonometricMoments(T(1))[k]) <= 12 * kRoundoff<T>);
        CHECK(std::abs(trigonometricMoments(T(-7))[k] - trigonometricMoments(T(0))[k]) <= 12 * kRoundoff<T>);
    }
}

TEST_CASE("trigonometricVisibility is what the Toeplitz system gives")
{
    Random random(151);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const DepthWindow window(random);
        const Vec4<double> moments = momentsOf(window);
        const double t = random.unit<double>();
        const double bound = trigonometricVisibility(moments, t, 0.05);
        const Exact plain = plainBound(moments, t, 0.05L);
        // The point t is off by 8e-8, and the kernel's inverse norms are at most some 1 / 0.05^2.
        tally.claim(std::abs(Exact(bound) - plain) < 1e-4L, t, bound, plain);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("trigonometricVisibility is a bound to 1e-4 of windows up to 3/4 deep, to 0.01 of others")
{
    Random random(152);
    Tally any, shallow;
    const double bias = 1e-6;
    for (int i = 0; i < drawsOf(1000000); ++i)
    {
        DepthWindow window(random);
        const double t = window.receiver(random);
        const double bound = trigonometricVisibility(momentsOf(window), t, bias);
        any.claim(bound >= window.tail(t) - 0.01, t, window.tail(t), bound);
        const double low = 0.25 * random.unit<double>();
        for (double& depth : window.depths)
            depth = low + 0.75 * depth;
        const double moved = low + 0.75 * t;
        const double inner = trigonometricVisibility(momentsOf(window), moved, bias);
        shallow.claim(inner >= window.tail(moved) - 1e-4, moved, window.tail(moved), inner);
    }
    LVSM_CHECK_TALLY(any);
    LVSM_CHECK_TALLY(shallow);
}

TEST_CASE("trigonometricVisibility is exact for two occluders and a receiver")
{
    Random random(153);
    Tally tally;
    for (int i = 0; i < drawsOf(20000); ++i)
    {
        const double first = 0.05 + 0.25 * random.unit<double>();
        const double second = first + 0.1 + 0.2 * random.unit<double>();
        const double receiver = second + 0.1 + 0.2 * random.unit<double>();
        const double a = 0.1 + 0.3 * random.unit<double>();
        const double b = 0.1 + 0.3 * random.unit<double>();
        const Vec4<double> moments = a * trigonometricMoments(first) + b * trigonometricMoments(second) +
                                     (1 - a - b) * trigonometricMoments(receiver);
        const double bound = trigonometricVisibility(moments, receiver, 1e-9);
        tally.claim(std::abs(bound - (1 - a - b)) < 1e-3, first, second, receiver, a, b, bound);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE("recommendedTrigonometricBias is the least that makes up for rounding")
{
    const Exact error = 0.001L;
    const Exact bias = recommendedTrigonometricBias(static_cast<double>(error));
    // Is bias I + T free of negative eigenvalues, for T Hermitian with 0 on its diagonal?
    const auto isValid = [](Exact share, const Complex& c1, const Complex& c2)
    {
        const Exact two = share * share - std::norm(c1);
        const Exact three = share * share * share - share * (2 * std::norm(c1) + std::norm(c2)) +
                            2 * std::real(c1 * c1 * std::conj(c2));
        return share >= 0 && two >= 0 && three >= 0;
    };
    bool always = true, isNeeded = false;
    for (int corner = 0; corner < 16; ++corner)
    {
        const auto at = [&](int i)
        {
            return (corner >> i & 1) != 0 ? error : -error;
        };
        const Complex c1(1.5L * at(0), 2 * at(1)), c2(2 * at(2), 2 * at(3));
        always = always && isValid(bias, c1, c2);
        isNeeded = isNeeded || !isValid(0.9999L * bias, c1, c2);
    }
    CHECK(always);
    CHECK(isNeeded);
    CHECK(recommendedTrigonometricBias(-1.0) == 0);
    CHECK(recommendedTrigonometricBias(5.0) == 1);
}

TEST_CASE_TEMPLATE("what exceeds its range is taken to its end in trigonometric moments", T, float, double)
{
    const Range<T> unit{0, 1};
    checkEnds<T, 6>({unit, unit, unit, unit, unit, unit},
                    [](const auto& a) { return trigonometricVisibility(Vec4<T>(a[0], a[1], a[2], a[3]), a[4], a[5]); });
}

// The thousandth that the default biases of four moments are asked to keep, too.
TEST_CASE("16 bits keep flat lit surfaces lit and the bound a bound")
{
    const double bias = recommendedTrigonometricBias(kOneRounding);
    Tally flat, windows;
    for (int i = 0; i <= 262144; ++i)
    {
        const double depth = i / 262144.0;
        const Vec4<double> stored = unorm16(trigonometricMoments(depth));
        flat.claim(trigonometricVisibility(stored, depth, bias) >= 0.999, depth);
        flat.claim(trigonometricVisibility(Vec4<float>(stored), float(depth), float(bias)) >= 0.999f, depth);
    }
    Random random(154);
    for (int i = 0; i < drawsOf(300000); ++i)
    {
        DepthWindow window(random);
        const double t = 0.75 * window.receiver(random);
        for (double& depth : window.depths)
            depth *= 0.75;
        const float bound =
            trigonometricVisibility(Vec4<float>(unorm16(momentsOf(window))), static_cast<float>(t), float(bias));
        // The receiver's own depth is rounded to float as well.
        windows.claim(double(bound) >= std::min(window.tail(t), window.tail(double(float(t)))) - 0.001, t, bound);
    }
    LVSM_CHECK_TALLY(flat);
    LVSM_CHECK_TALLY(windows);
}

TEST_CASE("in 16 bits they err less than four moments do")
{
    Random random(155);
    const double bias = recommendedTrigonometricBias(kOneRounding);
    double arc = 0, powers = 0;
    for (int i = 0; i < drawsOf(300000); ++i)
    {
        DepthWindow window(random);
        // What a filter window holds: surfaces of a tenth or so of the scene.
        for (double& depth : window.depths)
            depth = 0.4 + 0.2 * depth;
        const double t = 0.4 + 0.2 * window.receiver(random);
        const double truth = window.tail(t);
        const Vec4<double> moments = window.mean([](double depth) { return depthMoments4(depth); });
        const double other =
            momentVisibility4(decodeMoments4(unorm16(encodeMoments4(moments))), t, kMoment4BiasUnorm16<double>) - truth;
        const double own = trigonometricVisibility(unorm16(momentsOf(window)), t, bias) - truth;
        arc += own * own;
        powers += other * other;
    }
    CHECK(arc < powers);
}

} // namespace lvsm::unit
