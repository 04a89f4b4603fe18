#include "domains.hpp"

#include <lvsm/exponential.hpp>
#include <lvsm/layers.hpp>
#include <lvsm/moments4.hpp>
#include <lvsm/placement.hpp>
#include <lvsm/trigonometric.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <map>

namespace parity
{
namespace
{

const double kSubnormal = 1.0e-40;
const double kTiny = static_cast<double>(FLT_MIN);
const double kBelowOne = 1.0 - std::ldexp(1.0, -24);

Slot depth()
{
    return {{0.0, 1.0, 0.5, kSubnormal, kTiny, 2.0 * kTiny, 1.0e-7, kBelowOne, -0.5, 1.5}, 0.0, 1.0};
}

Slot share()
{
    return {{0.0, 1.0, 0.5, 1.0e-7, kBelowOne}, 0.0, 1.0};
}

Slot difference()
{
    return {{0.0, kSubnormal, -kSubnormal, 1.0e-7, -1.0e-7, 1.0e-3}, -1.0, 1.0};
}

Slot smallVariance()
{
    return {{0.0, kSubnormal, kTiny, 1.0e-7, 1.0e-5, 0.25}, 1.0e-9, 0.1, Scale::Logarithmic};
}

Slot integers(std::vector<double> edges, double lo, double hi)
{
    return {std::move(edges), lo, hi, Scale::Integer};
}

// Of components of a mixture: a place and an extent in texels, a correlation, a slope, a deviation from a plane.
Slot place()
{
    return {{0.0, 1.0, -2.0, kSubnormal, 300.0}, -3.0, 3.0};
}

Slot extent()
{
    return {{0.0, 0.5, 1.58, 3.24}, 0.0, 2.0};
}

Slot correlation()
{
    return {{0.0, 1.0, -1.0}, -1.0, 1.0};
}

Slot slope()
{
    return {{0.0, 1.0e-3, -1.0e-2, 2.0, kSubnormal}, -0.02, 0.02};
}

Slot residual()
{
    return {{0.0, 1.0e-3, 0.1}, 1.0e-5, 0.1, Scale::Logarithmic};
}

Slot filterWidth()
{
    return {{0.70710678, 1.58113883, 3.24037035, 0.0, -1.0, 1.0e30}, 0.5, 7.0};
}

Slot bits()
{
    return integers({0.0, -1.0, 1.0, -2147483648.0, 2147483647.0}, -2147483648.0, 2147483647.0);
}

// The first moment stays, the second becomes that of a distribution with a share of the largest variance.
void momentsFromShare(double* moments)
{
    const float m1 = static_cast<float>(moments[0]);
    const float largest = std::max(m1 - m1 * m1, 0.0f);
    moments[1] = static_cast<double>(m1 * m1 + static_cast<float>(moments[1]) * largest);
}

// Moments of the two warps of two depths, mixed as a filter mixes them.
void exponentialMomentsOfTwo(double* words)
{
    const auto warp = [words](double depth, int which)
    {
        const double c = std::clamp(words[1 + which], 0.0, 43.3216);
        return which == 0 ? std::exp(c * (2.0 * depth - 1.0)) : -std::exp(-c * (2.0 * depth - 1.0));
    };
    const double front = words[4];
    const double back = words[5];
    const double alpha = words[6];
    for (int which = 0; which < 2; ++which)
    {
        const double a = warp(front, which);
        const double b = warp(back, which);
        words[4 + 2 * which] = alpha * a + (1.0 - alpha) * b;
        words[5 + 2 * which] = alpha * a * a + (1.0 - alpha) * b * b;
    }
}

// A window of three depths, each with its share.
struct Window
{
    double depths[3];
    double shares[3];

    // Means of warped powers 1 to count; warped depths lie in [-1,1] where isSigned, else in [0,1].
    void moments(double begin, double end, bool isSigned, int count, double* out) const
    {
        std::fill(out, out + count, 0.0);
        for (int i = 0; i < 3; ++i)
        {
            const double warped = lvsm::linstep(depths[i], begin, end);
            double power = shares[i];
            for (int k = 0; k < count; ++k)
                out[k] += power *= isSigned ? 2.0 * warped - 1.0 : warped;
        }
    }
};

// Words 1 and 2 become an interval, 4 to 6 are depths of a window and 7 and 8 weigh them.
Window windowAround(double* words)
{
    words[2] += words[1];
    const double first = words[7];
    const double second = (1.0 - first) * words[8];
    return {{words[4], words[5], words[6]}, {first, second, 1.0 - first - second}};
}

// Words 4 to 9 become the moments in front of the interval, in it and behind it.
Window momentsAround(double* words)
{
    const Window window = windowAround(words);
    window.moments(0.0, words[1], false, 2, words + 4);
    window.moments(words[1], words[2], false, 2, words + 6);
    window.moments(words[2], 1.0, false, 2, words + 8);
    return window;
}

void bracketedMoments(double* words)
{
    const Window window = momentsAround(words);
    words[10] = words[1];
    words[11] = words[2] - words[1];
    window.moments(0.0, words[1], false, 2, words + 12);
    window.moments(words[1], 1.0, false, 2, words + 14);
    words[16] = 0.0;
    words[17] = 1.0;
}

void bracketedMoments4(double* words)
{
    const Window window = windowAround(words);
    window.moments(0.0, words[1], true, 4, words + 4);
    window.moments(words[1], words[2], true, 4, words + 8);
    window.moments(words[2], 1.0, true, 4, words + 12);
    window.moments(0.0, 1.0, true, 4, words + 16);
    const glm::dvec4 encoded = lvsm::encodeMoments4(glm::dvec4(words[16], words[17], words[18], words[19]));
    for (int i = 0; i < 4; ++i)
        words[20 + i] = encoded[i];
}

// Words 0 to 2 are depths and 3 and 6 weigh them; words 0 to 3 become their trigonometric moments.
void trigonometricMoments(double* words)
{
    const double shares[] = {words[3], (1.0 - words[3]) * words[6], (1.0 - words[3]) * (1.0 - words[6])};
    glm::dvec4 moments(0.0);
    for (int i = 0; i < 3; ++i)
        moments += shares[i] * lvsm::trigonometricMoments(words[i]);
    for (int i = 0; i < 4; ++i)
        words[i] = moments[i];
}

// Extents along both axes and a correlation, slopes and a deviation become spread, tilt and variance of a component.
void momentsOfPlane(double* words)
{
    const double xx = words[0] * words[0];
    const double xy = words[0] * words[1] * words[2];
    const double yy = words[2] * words[2];
    const double x = words[3];
    const double y = words[4];
    words[0] = xx;
    words[1] = xy;
    words[2] = yy;
    words[3] = xx * x + xy * y;
    words[4] = xy * x + yy * y;
    words[5] = words[5] * words[5] + x * words[3] + y * words[4];
}

void sortSplits(double* words)
{
    std::sort(words + 1, words + 8);
    const int count = std::clamp(static_cast<int>(words[19]), 1, 8);
    words[0] = 0.0;
    words[count] = 1.0;
}

// clang-format off
const std::map<std::string, Domain>& allDomains()
{
    static const std::map<std::string, Domain> all = {
        {"depths", {{depth()}, nullptr}},
        {"ramp",
         {{depth(), depth(), {{0.0, kSubnormal, kTiny, 1.0e-7, 0.1, 1.0, -0.25}, 0.0, 1.0}},
          [](double* words) { words[2] += words[1]; }}},
        {"lightDistance",
         {{{{0.0, 1.0, -3.0}, -10.0, 10.0}, {{0.0, 1.0}, -10.0, 10.0}, {{0.0, 5.0}, -10.0, 10.0},
           {{0.0, 1.0}, -10.0, 10.0}, {{0.0, 1.0}, -10.0, 10.0}, {{0.0, 5.0}, -10.0, 10.0},
           {{0.0, 0.1}, 0.0, 5.0}, {{0.0, 0.1, 20.0}, 1.0, 50.0},
           {{0.0, 1.0, -1.0}, -1.0, 1.0}, {{0.0, 1.0}, -1.0, 1.0}, {{0.0, 1.0}, -1.0, 1.0}},
          [](double* words) {
              const double length = std::sqrt(words[8] * words[8] + words[9] * words[9] + words[10] * words[10]);
              for (int i = 8; i < 11 && length > 0.0; ++i)
                  words[i] /= length;
          }}},
        {"projection",
         {{depth(), {{0.0, 0.1, 1.0, -1.0, kTiny}, 1.0e-3, 1.0e3, Scale::Logarithmic},
           {{0.0, 0.1, 1.0, 1.0e6}, 1.0e-1, 1.0e5, Scale::Logarithmic}},
          nullptr}},
        {"slopedDepth",
         {{depth(), {{0.0, kSubnormal, 0.5, -1.0e-4}, -0.1, 0.1}, {{0.0, 2.0, 1.0e-4}, -0.1, 0.1}}, nullptr}},
        // 0, 1 moments; 2 a receiver near the mean or anywhere; 3, 4 variance limits.
        {"momentsAndReceiver",
         {{depth(), share(), difference(), smallVariance(), {{0.0, 0.25, -1.0}, 1.0e-6, 0.25, Scale::Logarithmic}},
          [](double* words) {
              momentsFromShare(words);
              words[2] += words[0];
          }}},
        {"visibilities",
         {{{{0.0, 1.0, 0.5, kBelowOne}, 0.0, 1.0}, {{0.0, 1.0, 0.2, -1.0, 2.0}, 0.0, 1.0},
           {{0.0, 0.5, -0.5, 1.0, 2.0, kSubnormal}, -0.5, 0.5}},
          nullptr}},
        {"roundings",
         {{{{0.0, 1.0, kSubnormal, 7.62951094e-6}, 1.0e-8, 1.0e-2, Scale::Logarithmic},
           {{0.0, 1.0, -1.0, 2.0, 0.01}, 1.0e-4, 0.5, Scale::Logarithmic}},
          nullptr}},
        // 0 depth; 1, 2 interval; 3 overlap or width; 4 minVariance; 5, 6 moments of the layer.
        {"layer",
         {{depth(), depth(), {{0.0, kSubnormal, kTiny, 1.0e-3, 1.0, -0.25}, 0.0, 0.5},
           {{0.0, 0.01, 1.0, -0.1, kSubnormal}, 0.0, 0.1}, smallVariance(), depth(), share()},
          [](double* words) {
              words[2] += words[1];
              momentsFromShare(words + 5);
          }}},
        // 0 depth; 1 index; 2 layers. Depths on the split of that index, and next to it, are among the first.
        {"uniformLayers",
         {{{{0.0, 1.0, -1.0, 2.0, -2.0}, -3.0, 3.0},
           integers({0.0, 1.0, 2.0, 3.0, 7.0, 64.0, -1.0}, 0.0, 70.0),
           integers({1.0, 2.0, 3.0, 4.0, 7.0, 49.0, 64.0, 65536.0, 0.0, -5.0}, 1.0, 64.0)},
          [](double* words) {
              const float split = lvsm::uniformSplit(static_cast<int>(words[1]), static_cast<int>(words[2]));
              const float towards = words[0] < 0.0 ? -1.0f : 2.0f;
              const float besides = std::nextafter(split, towards);
              words[0] = std::abs(words[0]) < 1.0 ? static_cast<double>(split)
                         : std::abs(words[0]) < 2.0 ? static_cast<double>(besides)
                                                    : std::abs(words[0]) - 2.0;
          }}},
        // 0 to 8 splits; 9 to 17 weights; 18 a depth; 19 layers.
        {"placedSplits",
         {{{{0.0}, 0.0, 1.0}, {{0.0, 0.5}, 0.0, 1.0}, {{0.5, kSubnormal}, 0.0, 1.0}, {{0.5, 0.25}, 0.0, 1.0},
           {{0.5}, 0.0, 1.0}, {{0.5, 1.0}, 0.0, 1.0}, {{0.75}, 0.0, 1.0}, {{1.0, 0.0}, 0.0, 1.0}, {{1.0}, 1.0, 1.0},
           {{0.0}, 0.0, 1.0}, {{0.0, 1.0}, 0.0, 1.0}, {{0.0, 2.0}, 0.0, 1.0}, {{0.0, 1.0, -1.0}, 0.0, 1.0},
           {{0.0, 1.0}, 0.0, 1.0}, {{0.0, 1.0}, 0.0, 1.0}, {{0.0, 3.0}, 0.0, 1.0}, {{0.0, 1.0}, 0.0, 1.0},
           {{0.0}, 0.0, 1.0}, depth(), integers({1.0, 2.0, 3.0, 8.0, 0.0, -1.0}, 1.0, 8.0)},
          sortSplits}},
        {"packedLayers",
         {{depth(), share(), depth(), share(), integers({0.0, 1.0, 2.0, 7.0, -1.0, -2.0}, 0.0, 8.0)}, nullptr}},
        // 0 depth; 1, 2 exponents; 3 minVariance; 4 to 7 moments, from two depths and their shares.
        {"exponentialDepth",
         {{depth(), {{0.0, 5.54, 42.0, 43.3216, 50.0, -1.0}, 0.0, 42.0}, {{0.0, 5.54, 10.0, 43.3216, 1.0e9}, 0.0, 20.0},
           smallVariance(), {{0.0, 1.0, 0.5}, 0.0, 1.0}, {{0.0, 1.0, 0.5}, 0.0, 1.0}, share(), {{0.0}, 0.0, 1.0}},
          exponentialMomentsOfTwo}},
        {"formats",
         {{{{65504.0, static_cast<double>(FLT_MAX), 1.0, 0.0, -5.0, 2.0}, 1.0, 1.0e38, Scale::Logarithmic},
           {{1.0, 0.0, 9.0, 81.0, -1.0, 1.0e38}, 1.0, 1.0e3, Scale::Logarithmic}},
          nullptr}},
        {"texels",
         {{integers({0.0, 1.0, 1023.0, -1.0, 5000.0}, 0.0, 4096.0), integers({0.0, 1.0, 1023.0, -1.0}, 0.0, 4096.0),
           integers({1.0, 2.0, 1024.0, 0.0, -3.0}, 1.0, 4096.0), integers({1.0, 2.0, 1024.0, 0.0}, 1.0, 4096.0)},
          nullptr}},
        {"neighbourhood",
         {{depth(), share(), depth(), share(), depth(), share(), depth(), share()},
          [](double* words) {
              for (int i = 0; i < 8; i += 2)
                  momentsFromShare(words + i);
          }}},
        // 0 value or split; 1 weight or weighted sum; 2 to 4 splits; 5 sum of weights.
        {"contributions",
         {{depth(), {{0.0, 0.25, kSubnormal}, 0.0, 0.25}, integers({0.0, 1.0, 7.0}, 1.0, 7.0),
           integers({1.0, 2.0}, 1.0, 7.0), integers({1.0, 7.0}, 1.0, 7.0),
           {{0.0, kSubnormal, kTiny, 1.0, -1.0}, 0.1, 1.0}},
          nullptr}},
        {"frames",
         {{integers({0.0, 1.0, -1.0, 2147483647.0}, 0.0, 100000.0),
           integers({1.0, 2.0, 3.0, 8.0, 0.0, -7.0, 70000.0}, 1.0, 16.0)},
          nullptr}},
        // 0 index; 1 size; 2 sigma; 3 dimensions.
        {"kernels",
         {{integers({0.0, 1.0, 4.0, 32.0, -1.0}, 0.0, 64.0),
           integers({1.0, 2.0, 3.0, 9.0, 65.0, 0.0, -7.0, 70000.0}, 1.0, 65.0),
           {{0.0, 0.3, 1.5, kSubnormal, -1.0, 1.0e30}, 0.1, 20.0, Scale::Logarithmic},
           integers({1.0, 2.0, 3.0, 0.0, 9.0}, 1.0, 3.0)},
          nullptr}},
        {"boxes",
         {{{{0.0, 0.5, -0.5, 1.0, -1.25, kSubnormal, 1.0e30}, -8.0, 8.0},
           {{1.0, 2.5, 3.0, 0.0, 0.5, -1.0, 1.0e30}, 0.25, 15.0}},
          nullptr}},
        {"weightPairs",
         {{{{0.0, 1.0, kSubnormal, kTiny, -1.0, 1.0e38}, 0.0, 1.0}, {{0.0, 1.0, 0.25, kSubnormal, kTiny}, 0.0, 1.0}},
          nullptr}},
        {"corners", {{depth(), depth(), depth(), depth(), depth(), depth()}, nullptr}},
        // 0 to 3 depths in the map; 4, 5 fraction, or lit and whole weight; 6 to 9 receivers near them or anywhere;
        // 10 bias; 11 to 14 weights.
        {"comparisons",
         {{depth(), depth(), depth(), depth(), share(), {{0.0, 1.0, 0.5, kSubnormal, 1.0e38}, 0.0, 2.0},
           difference(), difference(), difference(), difference(), {{0.0, kSubnormal, 1.0e-7, 1.0e-3}, 0.0, 0.1},
           share(), share(), share(), share()},
          [](double* words) {
              for (int i = 0; i < 4; ++i)
                  words[6 + i] += words[i];
          }}},
        // 0 depth; 1 exponent; 2 threshold or offset; 3 to 6 terms of depths; 7, 8 fraction; 9 greatest depth.
        {"occluderTerms",
         {{depth(), {{0.0, 11.0, 80.0, 87.3365, 90.0, -1.0}, 0.0, 87.0}, {{0.0, 0.02, 0.001, -1.0}, 0.0, 0.1},
           depth(), depth(), depth(), depth(), share(), share(), depth()},
          [](double* words) {
              for (int i = 3; i < 7; ++i)
                  words[i] = std::exp(std::clamp(words[1], 0.0, 87.3365) * std::clamp(words[i], 0.0, 1.0));
          }}},
        // 0 depth or filtered value; 1 exponent; 2 receiver; 3 weight; 4, 5 greatest depth and sum so far.
        {"logFilter",
         {{depth(), {{1.0, 80.0, 0.0, -1.0, 1.0e4, 1.0e30}, 1.0, 500.0}, depth(), share(), depth(),
           {{0.0, 1.0, kSubnormal, kTiny, 1.0e38, -1.0}, 0.0, 1.0}},
          nullptr}},
        // 0 depth; 1 first term; 2 order; 3 strength; 4 offset; 5 to 8 sines; 9 to 12 cosines; 13 scale; 14 sum.
        {"fourierTerms",
         {{depth(), integers({1.0, 5.0, 13.0, 0.0, 256.0, 300.0}, 1.0, 16.0),
           integers({2.0, 4.0, 16.0, 7.0, 1.0, 256.0, -3.0, 1000.0}, 2.0, 32.0),
           {{0.0, 1.0, kSubnormal, -1.0, 1.0e30}, 0.0, 4.0}, {{0.0, 0.03125, 1.0, -1.0}, 0.0, 0.25},
           {{0.0, 1.0, -1.0, 2.0}, -1.0, 1.0}, {{0.0, 1.0, -1.0}, -1.0, 1.0}, {{0.0, 1.0, -1.0}, -1.0, 1.0},
           {{0.0, 1.0, -1.0}, -1.0, 1.0}, {{0.0, 1.0, -1.0}, -1.0, 1.0}, {{0.0, 1.0, -1.0}, -1.0, 1.0},
           {{0.0, 1.0, -1.0}, -1.0, 1.0}, {{0.0, 1.0, -1.0}, -1.0, 1.0}, {{1.0, 2.0, 0.0, -1.0, 1.0e30}, 0.5, 2.0},
           {{0.0, 0.5, -0.5, 1.0, -2.0}, -1.0, 1.0}},
          nullptr}},
        // 0 depth; 1, 2 interval; 3 minVariance; 4 to 9 moments of the layers in front, of it, behind; 10, 11 lengths;
        // 12 to 15 two layers that meet at word 1; 16, 17 their outer ends.
        {"bracketed",
         {{depth(), depth(), {{0.0, kTiny, 1.0e-3, 1.0, -0.25}, 0.0, 0.5}, smallVariance(), depth(), depth(), depth(),
           share(), share(), share(), share(), share(), share(), share(), share(), share(), share(), share()},
          bracketedMoments}},
        // 0 depth; 1, 2 interval; 3 minVariance; 4 to 9 moments of the layers in front, of it, behind; 10 to 12
        // covariances with the plane; 13 its variance; 14 amount; 15 to 18 neighbours; 19, 20 gradient; 21 deviation.
        {"planes",
         {{depth(), depth(), {{0.0, kTiny, 1.0e-3, 1.0, -0.25}, 0.0, 0.5}, smallVariance(), depth(), depth(), depth(),
           share(), share(), share(), {{0.0, kSubnormal, 1.0, -2.0}, -0.01, 0.01}, {{0.0, 1.0e-4}, -0.01, 0.01},
           {{0.0, -1.0e-4}, -0.01, 0.01}, smallVariance(), {{0.0, 0.15, 1.0, -1.0}, 0.0, 0.5}, share(), share(),
           share(), share(), {{0.0, 1.0e-3, 2.0}, -0.02, 0.02}, {{0.0, -1.0e-3}, -0.02, 0.02},
           {{0.0, 1.22, -1.0, 1.0e30}, 0.0, 4.0}},
          [](double* words) { momentsAround(words); }}},
        // 0 depth; 1, 2 interval; 3 bias; 4 to 15 moments of the layers in front, of it, behind; 16 to 19 of one layer
        // from 0 to 1; 20 to 23 those encoded.
        {"fourMoments",
         {{depth(), depth(), {{0.0, kTiny, 1.0e-3, 1.0, -0.25}, 0.0, 0.5},
           {{3.0e-7, 6.0e-5, 0.0, 1.0, kSubnormal}, 1.0e-7, 1.0e-2, Scale::Logarithmic}, depth(), depth(), depth(),
           share(), share(), share(), share(), share(), share(), share(), share(), share(), share(), share(), share(),
           share(), share(), share(), share(), share()},
          bracketedMoments4}},
        // 0 to 3 the code; 4 depth; 5 depth error; 6, 7 packed words.
        {"quantisedMoments",
         {{share(), share(), share(), share(), depth(), {{0.0, 7.62951094e-6, 4.88758553e-4, -1.0}, 0.0, 1.0e-3},
           integers({0.0, 65535.0, 32768.0, -1.0}, 0.0, 65535.0), integers({0.0, 65535.0, 64.0, -1.0}, 0.0, 65535.0)},
          nullptr}},
        // 0 to 3 moments of three depths; 4 depth; 5 bias; 6 a share.
        {"arcMoments",
         {{depth(), depth(), depth(), share(), depth(), {{3.92e-5, 0.0, 1.0, kSubnormal}, 1.0e-5, 1.0e-2, Scale::Logarithmic},
           share()},
          trigonometricMoments}},
        // 0 to 5 screen derivatives of texel and depth; 6 depth; 7, 8 gradient; 9, 10 offset; 11 shift; 12 deviation;
        // 13 minVariance.
        {"receivers",
         {{{{0.0, 1.0, -1.0, 1.2e-30}, -4.0, 4.0}, {{0.0, 1.0}, -4.0, 4.0}, {{0.0, 1.0e-3, 1.0e18}, -0.01, 0.01},
           {{0.0, 1.0}, -4.0, 4.0}, {{0.0, 1.0, -1.0, 1.0e-8}, -4.0, 4.0}, {{0.0, -1.0e-3, -1.0e18}, -0.01, 0.01},
           depth(),
           {{0.0, 1.0e-3, 2.0}, -0.02, 0.02}, {{0.0, -1.0e-3}, -0.02, 0.02}, {{0.0, 1.0, 1.0e30}, -4.0, 4.0},
           {{0.0, -3.0}, -4.0, 4.0}, {{0.0, 0.3, 3.0, -1.0}, 0.0, 4.0}, {{0.0, 1.22, -1.0, 1.0e30}, 0.0, 4.0},
           smallVariance()},
          nullptr}},
        {"rounds", {{integers({0.0, 1.0, 2.0, 3.0, 7.0, 8.0, -1.0, 70000.0}, 0.0, 8.0)}, nullptr}},
        // 0 to 9 and 10 to 19 components: weight, place, depth, and momentsOfPlane; 20, 21 offset, a tap's weight and x,
        // or a deviation; 22 share or y; 23 depth.
        {"components",
         {{share(), place(), place(), depth(), extent(), correlation(), extent(), slope(), slope(), residual(),
           share(), place(), place(), depth(), extent(), correlation(), extent(), slope(), slope(), residual(),
           {{0.0, 1.0, 300.0, -1.0}, -1.0, 4.0}, {{0.0, 1.0, 1.58, -300.0}, -1.0, 4.0}, share(), depth()},
          [](double* words) {
              momentsOfPlane(words + 4);
              momentsOfPlane(words + 14);
          }}},
        {"fourTaps",
         {{depth(), depth(), depth(), depth(), place(), place(), place(), place(), place(), place(), place(), place()},
          nullptr}},
        // 0 to 15 weight, place and depth of four components; 16 to 21 momentsOfPlane; 22 deviation of the filter.
        {"fourComponents",
         {{share(), place(), place(), depth(), share(), place(), place(), depth(), share(), place(), place(), depth(),
           share(), place(), place(), depth(), extent(), correlation(), extent(), slope(), slope(), residual(),
           filterWidth()},
          [](double* words) { momentsOfPlane(words + 16); }}},
        // 0 to 3 code; 4, 5 offset; 6 a receiver near the heaviest plane or anywhere; 7 bias; 8 deviation of the filter;
        // 9, 10 gradient.
        {"codes",
         {{bits(), bits(), bits(), bits(), {{0.0, 0.5, -1.0, 30.0}, -1.0, 1.0}, {{0.0, -0.5, 1.0}, -1.0, 1.0},
           difference(), {{0.0, 0.001953125, 2.0, -1.0}, 0.0, 0.01}, filterWidth(), slope(), slope()},
          [](double* words) {
              const auto code = static_cast<std::uint32_t>(static_cast<std::int32_t>(words[0]));
              words[6] += static_cast<double>(code) / 4294967296.0;
          }}},
        // 0 to 6 plane; 7, 8 offset; 9 deviation of the filter; 10 a receiver near the plane or anywhere; 11, 12 gradient;
        // 13 bias.
        {"planesOfMixtures",
         {{share(), place(), place(), depth(), slope(), slope(),
           {{0.0, 1.0, kSubnormal, -1.0}, 1.0e-5, 0.1, Scale::Logarithmic},
           {{0.0, 0.5, -1.0, 30.0}, -1.0, 1.0}, {{0.0, -0.5, 1.0}, -1.0, 1.0}, filterWidth(), difference(), slope(),
           slope(), {{0.0, 0.001953125, 2.0, -1.0}, 0.0, 0.01}},
          [](double* words) { words[10] += words[3]; }}},
    };
    return all;
}
// clang-format on

} // namespace

const Domain* findDomain(const std::string& name)
{
    const auto found = allDomains().find(name);
    return found == allDomains().end() ? nullptr : &found->second;
}

} // namespace parity
