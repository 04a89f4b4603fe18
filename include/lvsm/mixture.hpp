// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, components.
// Mixtures of planes: a texel stores the few surfaces that its filter window sees, each with its share of the window,
// its place in it and its plane, and a receiver is compared plane with plane.
//
// The map is coded: filtered first (topic components), packed once, read by one fetch and moved between texels by its
// own maths. Nothing may average the codes: no hardware filter, no mip maps of codes, no blending. Neither is the
// estimate a bound. Shift the receiver by half a texel of its slope first, shiftReceiver(depth, gradient, 0.5): the map
// knows a surface at the centres of its texels only.
//
// Two codes: two planes in 64 bits, four in 128, a word each, the heaviest first. Places and slopes count in deviations
// of the filter. From bit 22 a word has the plane's depth in 10 bits, at the heaviest plane's place; from bit 17 and
// bit 12 its slope along x and y by the signed square, in 5 each. Below, the first word has the deviations of all
// planes from their taps, the heaviest's on top, logarithmic: in 6 bits each of two, in 3 of four. The others have
// their share from bit 8, and their place from the heaviest's from bits 4 and 0, in 4 bits each. What the heaviest has
// of share and place follows, since shares add up to 1 and places to 0. A field is read with all that lies below it in
// its word, as a number with a fraction, and is chosen for that: so nothing has to be cut off.
#ifndef LVSM_MIXTURE_HPP
#define LVSM_MIXTURE_HPP

#include "components.hpp"

#include <cstdint>

namespace lvsm
{

// Bias that suits the codes: two steps of a coded depth, of which its rounding takes a half. The rest is for surfaces
// that bend, a choice and no derivation.
template <typename T>
constexpr T kMixtureBias = T(0.001953125);

// The steepest coded slope: change of depth over one deviation of the filter.
template <typename T>
constexpr T kMostCodedRise = T(0.08838834764831844);

// Step of a coded place, in deviations of the filter: 16 levels reach to 2.25 on each side.
template <typename T>
constexpr T kPlaceStep = T(0.3);

// Least coded deviation from a plane: half a step of a coded depth, as far as its rounding can be off.
template <typename T>
constexpr T kLeastDeviation = T(0.00048828125);

// Units in which codes are read: the steepest coded slope is 2^62, a depth of 1 is 2^66 / sqrt(12), and a place of one
// deviation of the filter 1 / sqrt(6).
template <typename T>
constexpr T kCodeSlope = T(4611686018427387904.0);
template <typename T>
constexpr T kCodeDepth = T(21300465313256689664.0);
template <typename T>
constexpr T kCodePlace = T(0.40824829046386302);

/// One surface of a filter window as a receiver is compared with it.
/// weight: its share of the window, in [0,1]. place: of its taps' centroid from the texel's centre, in texels. depth:
/// of its plane at that place. slope: its change of depth per texel. deviation: of its taps from the plane, in depth.
/// Weight 0 is none.
template <typename T>
struct MixturePlane
{
    T weight;
    glm::vec<2, T> place;
    T depth;
    glm::vec<2, T> slope;
    T deviation;
};

/// The surfaces of a filter window: up to four planes.
template <typename T>
struct MixturePlanes
{
    MixturePlane<T> planes[kMaxComponents];
};

namespace detail
{

// A receiver as codes are read. Slopes count in units of 2^-62 of the steepest coded one, of which a field that fills
// the top of a word has the square root as it is; depth, less the bias, in those units that make half a spread 1.
// place: half of the offset, in deviations, and so that slope times place is a depth. rounding: square of what a coded
// slope may be off where it is the receiver's own.
template <typename T>
struct CodeReceiver
{
    T depth;
    glm::vec<2, T> slope;
    glm::vec<2, T> place;
    T rounding;
    T bias;
};

template <typename T>
T filterDeviation(T deviation)
{
    return clamp(deviation, T(0.25), T(64));
}

template <typename T>
T real(std::uint32_t level)
{
    return static_cast<T>(static_cast<int>(level));
}

template <typename T>
std::uint32_t nearestLevel(T x)
{
    using glm::floor;
    return static_cast<std::uint32_t>(static_cast<int>(floor(x + T(0.5))));
}

// Sets a field of which value is in levels, the lowest of them least. Only bits below the field are set yet; they are
// read as a fraction of a level.
template <typename T>
std::uint32_t withField(std::uint32_t word, int at, int bits, T value, T least)
{
    const T below = real<T>(word) / static_cast<T>(1 << at);
    const T level = clamp(value - below, least, least + static_cast<T>((1 << bits) - 1));
    return word | (nearestLevel(level) & ((1u << bits) - 1u)) << at;
}

// Slope in levels, by the signed square.
template <typename T>
T slopeLevel(T rise)
{
    using glm::abs;
    using glm::sqrt;
    const T size = T(16) * sqrt(abs(rise) * (T(1) / kMostCodedRise<T>));
    return rise < T(0) ? -size : size;
}

// Slopes of a word in units of kCodeSlope.
template <typename T>
glm::vec<2, T> codedSlope(std::uint32_t word)
{
    using glm::abs;
    const T x = static_cast<T>(static_cast<double>(static_cast<std::int32_t>(word << 10)));
    const T y = static_cast<T>(static_cast<double>(static_cast<std::int32_t>(word << 15)));
    return {x * abs(x), y * abs(y)};
}

template <typename T>
glm::vec<2, T> codedRise(std::uint32_t word)
{
    const T unit = kMostCodedRise<T> / kCodeSlope<T>;
    const glm::vec<2, T> slope = codedSlope<T>(word);
    return {slope.x * unit, slope.y * unit};
}

// Place of a word from the heaviest plane's, in units of step.
template <typename T>
glm::vec<2, T> codedPlace(std::uint32_t word, T unit)
{
    return {real<T>(word & 255u) * (unit / T(16)) - T(7.96875) * unit, real<T>(word & 15u) * unit - T(7.5) * unit};
}

// Share of a word of that index, counted from 1: of 15 levels up to 1 / (index + 1).
template <typename T>
T codedShare(std::uint32_t word, int index)
{
    return real<T>(word & 3840u) * (T(1) / static_cast<T>(3840 * (index + 1)));
}

// Deviation of the plane of that index from the first word, in units of kLeastDeviation times 2^-55: in shaders the
// bits of a float, three of its exponent and what there is of its mantissa.
template <typename T>
T codedDeviation(std::uint32_t word, int index, int count)
{
    const int bits = 12 / count;
    const std::uint32_t level = word >> (12 - bits * (index + 1)) & ((1u << bits) - 1u);
    const std::uint32_t parts = count == 2 ? 8u : 1u;
    const T size = real<T>((parts + level % parts) << (level / parts));
    return size * (T(36028797018963968.0) / static_cast<T>(static_cast<int>(parts)));
}

// Level of a deviation, the nearest of those that codedDeviation reads.
template <typename T>
std::uint32_t deviationLevel(T deviation, int count)
{
    const int parts = count == 2 ? 8 : 1;
    const T size = clamp(deviation * (T(1) / kLeastDeviation<T>), T(1), T(256));
    T start = T(1);
    int octave = 0;
    while (octave < 7 && size >= start * (T(2) - T(0.5) / static_cast<T>(parts)))
    {
        start = T(2) * start;
        ++octave;
    }
    const T part = clamp((size - start) * static_cast<T>(parts) / start, T(0), static_cast<T>(parts - 1));
    return static_cast<std::uint32_t>(octave * parts) + nearestLevel(part);
}

// A word of the bits below its slopes: slopes and depth of a component's plane. p: where the plane is told, and apart:
// how far that is from the heaviest one's, in deviations.
template <typename T>
std::uint32_t planeWord(std::uint32_t low, const MixtureComponent<T>& c, const glm::vec<2, T>& p,
                        const glm::vec<2, T>& apart, T sigma)
{
    const glm::vec<2, T> g = slopeOf(c);
    const glm::vec<2, T> rise = clamped(glm::vec<2, T>(g.x * sigma, g.y * sigma), kMostCodedRise<T>);
    std::uint32_t word = withField(low, 12, 5, slopeLevel(rise.y), T(-16));
    word = withField(word, 17, 5, slopeLevel(rise.x), T(-16));
    const glm::vec<2, T> coded = codedRise<T>(word);
    const T there = c.depth + (g.x * (p.x * sigma - c.place.x) + g.y * (p.y * sigma - c.place.y));
    return withField(word, 22, 10, T(1024) * (there - (coded.x * apart.x + coded.y * apart.y)), T(0));
}

template <typename T>
void sortPair(Mixture<T>& m, int i, int j)
{
    if (m.components[i].weight < m.components[j].weight)
    {
        const MixtureComponent<T> lighter = m.components[i];
        m.components[i] = m.components[j];
        m.components[j] = lighter;
    }
}

// Heaviest first, with shares that add up to 1; a surface at depth 1 where there is none.
template <typename T>
Mixture<T> sorted(const Mixture<T>& mixture, int count)
{
    Mixture<T> m{};
    T sum = T(0);
    for (int i = 0; i < count; ++i)
    {
        m.components[i] = validComponent(mixture.components[i]);
        sum = sum + m.components[i].weight;
    }
    if (sum < T(1.0e-6))
    {
        m = Mixture<T>{};
        m.components[0] = tapComponent(T(1));
        return m;
    }
    sortPair(m, 0, 1);
    sortPair(m, 2, 3);
    sortPair(m, 0, 2);
    sortPair(m, 1, 3);
    sortPair(m, 1, 2);
    const T inverse = T(1) / sum;
    for (int i = 0; i < count; ++i)
        m.components[i].weight = m.components[i].weight * inverse;
    return m;
}

// A word's bits below its slopes: share, at least one level of what is there at all, and place from the heaviest
// plane's.
template <typename T>
std::uint32_t shareAndPlace(const MixtureComponent<T>& c, int index, const glm::vec<2, T>& heaviest, T sigma)
{
    if (!(c.weight > T(0)))
        return 0u;
    const T unit = T(1) / (sigma * kPlaceStep<T>);
    std::uint32_t word = withField(0u, 0, 4, (c.place.y - heaviest.y) * unit + T(7.5), T(0));
    word = withField(word, 4, 4, (c.place.x - heaviest.x) * unit + T(7.96875), T(0));
    const T level = clamp(c.weight * static_cast<T>(15 * (index + 1)), T(1), T(15));
    return word | nearestLevel(level) << 8;
}

// Words of so many planes.
template <typename T>
glm::vec<4, std::uint32_t> encodePlanes(const Mixture<T>& mixture, int count, T deviation)
{
    using glm::sqrt;
    const T sigma = filterDeviation(deviation);
    const Mixture<T> m = sorted(mixture, count);
    std::uint32_t code[kMaxComponents] = {};
    glm::vec<2, T> first(T(0), T(0));
    for (int i = 0; i < count; ++i)
    {
        const MixtureComponent<T>& c = m.components[i];
        const T residual = sqrt(residualOf(c, slopeOf(c)));
        code[0] = code[0] | deviationLevel(residual, count) << (12 - 12 / count * (i + 1));
        if (i == 0)
            continue;
        code[i] = shareAndPlace(c, i, m.components[0].place, sigma);
        const T share = codedShare<T>(code[i], i);
        const glm::vec<2, T> apart = codedPlace(code[i], kPlaceStep<T>);
        first = {first.x - share * apart.x, first.y - share * apart.y};
    }
    for (int i = 0; i < count; ++i)
    {
        const glm::vec<2, T> apart = i == 0 ? glm::vec<2, T>(T(0), T(0)) : codedPlace(code[i], kPlaceStep<T>);
        const glm::vec<2, T> place(first.x + apart.x, first.y + apart.y);
        code[i] = planeWord(code[i], m.components[i], place, apart, sigma);
    }
    return {code[0], code[1], code[2], code[3]};
}

} // namespace detail

/// Plane of a component, uncoded.
/// component: any; its members are clamped to their ranges. Result: a plane whose slope is known exactly.
/// Source: componentSlope, componentResidual.
template <typename T>
MixturePlane<T> componentPlane(const MixtureComponent<T>& component)
{
    using glm::sqrt;
    const MixtureComponent<T> c = detail::validComponent(component);
    const glm::vec<2, T> g = detail::slopeOf(c);
    return {c.weight, c.place, c.depth, g, sqrt(detail::residualOf(c, g))};
}

/// Two planes in 64 bits.
/// mixture: the first two components count; members are clamped to their ranges, and shares to a sum of 1. deviation:
/// of the filter along each axis in texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: the heavier plane in x, the other in y. A mixture without any component is coded as a surface at depth 1.
template <typename T>
glm::vec<2, std::uint32_t> encodeMixture2(const Mixture<T>& mixture, T deviation)
{
    const glm::vec<4, std::uint32_t> code = detail::encodePlanes(mixture, 2, deviation);
    return {code.x, code.y};
}

/// Four planes in 128 bits.
/// mixture: members are clamped to their ranges, and shares to a sum of 1. deviation: of the filter along each axis in
/// texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: the heaviest plane in x, the others by weight in y, z and w. A mixture without any component is coded as a
/// surface at depth 1.
template <typename T>
glm::vec<4, std::uint32_t> encodeMixture4(const Mixture<T>& mixture, T deviation)
{
    return detail::encodePlanes(mixture, 4, deviation);
}

namespace detail
{

template <typename T>
MixturePlanes<T> decodePlanes(const glm::vec<4, std::uint32_t>& code, int count, T deviation)
{
    const T sigma = filterDeviation(deviation);
    const T inverse = T(1) / sigma;
    MixturePlanes<T> m{};
    T shares = T(0);
    glm::vec<2, T> first(T(0), T(0));
    for (int i = 0; i < count; ++i)
    {
        const std::uint32_t word = code[static_cast<glm::length_t>(i)];
        const glm::vec<2, T> rise = codedRise<T>(word);
        const glm::vec<2, T> apart = i == 0 ? glm::vec<2, T>(T(0), T(0)) : codedPlace(word, kPlaceStep<T>);
        const T depth = static_cast<T>(static_cast<double>(word)) * T(1.0 / 4294967296.0);
        const T share = i == 0 ? T(0) : codedShare<T>(word, i);
        m.planes[i] = {share,
                       {apart.x * sigma, apart.y * sigma},
                       clamp(depth + (rise.x * apart.x + rise.y * apart.y), T(0), T(1)),
                       {rise.x * inverse, rise.y * inverse},
                       codedDeviation<T>(code.x, i, count) * (kLeastDeviation<T> / T(36028797018963968.0))};
        shares = shares + share;
        first = {first.x - share * m.planes[i].place.x, first.y - share * m.planes[i].place.y};
    }
    m.planes[0].weight = maximum(T(1) - shares, T(0));
    for (int i = 0; i < count; ++i)
        m.planes[i].place = {m.planes[i].place.x + first.x, m.planes[i].place.y + first.y};
    return m;
}

} // namespace detail

/// The planes that a code of 64 bits holds.
/// code: any bits; what encodeMixture2 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heavier plane first, places within 3.6 deviations, the third and fourth none.
template <typename T>
MixturePlanes<T> decodeMixture2(const glm::vec<2, std::uint32_t>& code, T deviation)
{
    return detail::decodePlanes(glm::vec<4, std::uint32_t>(code.x, code.y, 0u, 0u), 2, deviation);
}

/// The planes that a code of 128 bits holds.
/// code: any bits; what encodeMixture4 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heaviest plane first, places within 5 deviations.
template <typename T>
MixturePlanes<T> decodeMixture4(const glm::vec<4, std::uint32_t>& code, T deviation)
{
    return detail::decodePlanes(code, 4, deviation);
}

/// Share of the window that a plane has around a receiver between texels.
/// plane: weight counts in [0,1] and place in [-256,256], clamped to them. offset: of the receiver from the texel's
/// centre, in texels, each component clamped to [-16,16]; half a texel for a map of full resolution. deviation: of the
/// filter, clamped to [0.25, 64]. Result in [-131071, 131073], below 0 where the window has left the plane. All shares
/// of a window stay 1 in sum.
/// Source: moving a Gaussian window by f tilts its weights by exp(f.p / deviation^2), here 1 + f.p / deviation^2, taken
/// at the centroid.
template <typename T, glm::qualifier Q>
T planeWeight(const MixturePlane<T>& plane, const glm::vec<2, T, Q>& offset, T deviation)
{
    const T sigma = detail::filterDeviation(deviation);
    const glm::vec<2, T> p = detail::clamped(plane.place, kMostPlace<T>);
    const glm::vec<2, T> f = detail::clamped(offset, T(16));
    return detail::clamp(plane.weight, T(0), T(1)) * (T(1) + (f.x * p.x + f.y * p.y) * (T(1) / (sigma * sigma)));
}

/// Lit share of a plane's taps, and how far they are behind the receiver.
/// plane: any; its members are clamped to [0,1], places to [-256,256], slopes to [-1,1].
/// offset: of the receiver from the texel's centre, in texels, each component clamped to [-16,16].
/// depth: the receiver's, in [0,1], clamped to it. gradient: its change per texel, each component clamped to [-1,1].
/// deviation: of the filter, clamped to [0.25, 64]. bias: in depth, clamped to [0,1].
/// Result: the share in [0,1], and the mean distance in depth, in [-600, 600].
/// Source: half of the filter's variance along each axis is taken as that of the plane's taps, without direction.
/// Moving the window moves their centroid by as much of the way. Depth less the receiver's plane then has the mean d
/// and, by the difference of slopes and by the deviation, the variance v; samples spread evenly around d are in front
/// of 0 with the share 1/2 - d / sqrt(12 v).
template <typename T, glm::qualifier Q, glm::qualifier QG>
glm::vec<2, T> planeLight(const MixturePlane<T>& plane, const glm::vec<2, T, Q>& offset, T depth,
                          const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    using glm::sqrt;
    const T sigma = detail::filterDeviation(deviation);
    const glm::vec<2, T> p = detail::clamped(plane.place, kMostPlace<T>);
    const glm::vec<2, T> f = detail::clamped(offset, T(16));
    const glm::vec<2, T> g = detail::clamped(gradient, T(1));
    const T x = detail::clamp(plane.slope.x, T(-1), T(1)) - g.x;
    const T y = detail::clamp(plane.slope.y, T(-1), T(1)) - g.y;
    const T r = detail::clamp(plane.deviation, T(0), T(1));
    const T own = detail::rounded(detail::clamp(depth, T(0), T(1)) +
                                  detail::rounded(g.x * (p.x - f.x) + g.y * (p.y - f.y)));
    const T behind = detail::rounded(detail::clamp(plane.depth, T(0), T(1)) - own) +
                     detail::rounded(T(0.5) * (x * f.x + y * f.y));
    const T variance = detail::maximum(T(1.0e-10), T(0.5) * (sigma * sigma) * (x * x + y * y) + r * r);
    const T lit = T(0.5) + (behind + T(0.6) * r + detail::clamp(bias, T(0), T(1))) / sqrt(T(12) * variance);
    return {detail::clamp(lit, T(0), T(1)), behind};
}

namespace detail
{

// planeLight of a word, the distance in units of kCodeDepth. apart: the plane's place from the heaviest one's and half
// of the offset; deviation: in the units of codedDeviation.
template <typename T>
glm::vec<2, T> lightOfWord(std::uint32_t word, T deviation, const glm::vec<2, T>& apart, const CodeReceiver<T>& r)
{
    using glm::sqrt;
    const glm::vec<2, T> coded = codedSlope<T>(word);
    const T x = coded.x - r.slope.x;
    const T y = coded.y - r.slope.y;
    const T variance = maximum(x * x + y * y - r.rounding, T(0)) + deviation * deviation;
    const T depth = static_cast<T>(static_cast<double>(word)) * (kCodeDepth<T> * T(1.0 / 4294967296.0));
    const T behind = depth - r.depth + (x * apart.x + y * apart.y);
    return {clamp(T(0.5) + (behind + T(0.17320508075688773) * deviation) / sqrt(variance), T(0), T(1)), behind};
}

template <typename T, glm::qualifier Q, glm::qualifier QG>
CodeReceiver<T> codeReceiver(const glm::vec<2, T, Q>& offset, T depth, const glm::vec<2, T, QG>& gradient, T sigma,
                             T bias)
{
    using glm::abs;
    const T steep = sigma * (kCodeSlope<T> / kMostCodedRise<T>);
    const T perTexel = kCodePlace<T> / sigma;
    const glm::vec<2, T> f = clamped(offset, T(16));
    CodeReceiver<T> r;
    r.slope = clamped(glm::vec<2, T>(gradient.x * steep, gradient.y * steep), kCodeSlope<T>);
    r.place = glm::vec<2, T>(T(0.5) * (f.x * perTexel), T(0.5) * (f.y * perTexel));
    r.bias = clamp(bias, T(0), T(1)) * kCodeDepth<T>;
    r.depth = clamp(depth, T(0), T(1)) * kCodeDepth<T> - r.bias -
              (r.slope.x * (f.x * perTexel) + r.slope.y * (f.y * perTexel));
    // A slope u^2 is off by half a level of u at most, (2 u + 1/32) / 32, the square of which is less than
    // (8 u^2 + 2 / 32^2) / 32^2.
    r.rounding =
        (abs(r.slope.x) + abs(r.slope.y)) * T(36028797018963968.0) + T(81129638414606681695789005144064.0);
    return r;
}

// Sums over the planes of a code: lit weight, weight in shadow, and that times the distance in front of the receiver.
template <typename T, glm::qualifier Q, glm::qualifier QG>
glm::vec<3, T> sumsOfCode(const glm::vec<4, std::uint32_t>& code, int count, const glm::vec<2, T, Q>& offset, T depth,
                          const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    CodeReceiver<T> r = codeReceiver(offset, depth, gradient, filterDeviation(deviation), bias);
    const T turned = r.slope.x * r.place.x + r.slope.y * r.place.y;
    const T moved = T(12) * (r.place.x * r.place.x + r.place.y * r.place.y);
    T shares[kMaxComponents];
    T tilts[kMaxComponents];
    glm::vec<2, T> apart[kMaxComponents];
    T tilt = T(1);
    for (int i = 1; i < count; ++i)
    {
        const std::uint32_t word = code[static_cast<glm::length_t>(i)];
        const glm::vec<2, T> place = codedPlace(word, kPlaceStep<T> * kCodePlace<T>);
        apart[i] = {place.x + r.place.x, place.y + r.place.y};
        shares[i] = codedShare<T>(word, i);
        tilts[i] = T(12) * (r.place.x * apart[i].x + r.place.y * apart[i].y) - moved;
        tilt = tilt - shares[i] * tilts[i];
        r.depth = r.depth - shares[i] * (r.slope.x * apart[i].x + r.slope.y * apart[i].y - turned);
    }
    const glm::vec<2, T> first = lightOfWord(code.x, codedDeviation<T>(code.x, 0, count), r.place, r);
    T lit = first.x;
    T left = T(1);
    glm::vec<2, T> dark(T(0), T(0));
    const auto darken = [&dark, &r](T weight, const glm::vec<2, T>& light)
    {
        const T unlit = maximum(weight, T(0)) * (T(1) - light.x);
        dark = {dark.x + unlit, dark.y + unlit * maximum(r.bias - light.y, T(0))};
    };
    for (int i = 1; i < count; ++i)
    {
        const glm::vec<2, T> light =
            lightOfWord(code[static_cast<glm::length_t>(i)], codedDeviation<T>(code.x, i, count), apart[i], r);
        const T weight = shares[i] * (tilt + tilts[i]);
        lit = lit + weight * (light.x - first.x);
        left = left - weight;
        darken(weight, light);
    }
    darken(left, first);
    return {clamp(lit, T(0), T(1)), dark.x, dark.y * (T(1) / kCodeDepth<T>)};
}

template <typename T>
T occluderOfSums(const glm::vec<3, T>& sums, T depth)
{
    const T away = sums.y < T(1.0e-12) ? T(0) : sums.z / maximum(sums.y, T(1.0e-12));
    return clamp(clamp(depth, T(0), T(1)) - away, T(0), T(1));
}

} // namespace detail

/// Visibility of a receiver from a code of 64 bits.
/// code: any bits, not filtered. offset: of the receiver from the code's place, in texels of the shadow map, each
/// component clamped to [-16,16]: at most half a texel for a nearest fetch from a map of full resolution, one of half
/// resolution. depth: the receiver's, in [0,1], clamped to it. gradient: its change per texel of the shadow map;
/// steeper than kMostCodedRise over a deviation of the filter counts as that. deviation: of the filter, clamped to
/// [0.25, 64]. bias: in depth, clamped to [0,1], see kMixtureBias. Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight; a difference of slopes counts as far as it exceeds what a
/// slope's rounding can be off.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T mixtureVisibility2(const glm::vec<2, std::uint32_t>& code, const glm::vec<2, T, Q>& offset, T depth,
                     const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    const glm::vec<4, std::uint32_t> words(code.x, code.y, 0u, 0u);
    return detail::sumsOfCode(words, 2, offset, depth, gradient, deviation, bias).x;
}

/// Visibility of a receiver from a code of 128 bits.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T mixtureVisibility4(const glm::vec<4, std::uint32_t>& code, const glm::vec<2, T, Q>& offset, T depth,
                     const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    return detail::sumsOfCode(code, 4, offset, depth, gradient, deviation, bias).x;
}

/// Mean depth of what is in front of a receiver, from a code of 64 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T mixtureOccluder2(const glm::vec<2, std::uint32_t>& code, const glm::vec<2, T, Q>& offset, T depth,
                   const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    const glm::vec<4, std::uint32_t> words(code.x, code.y, 0u, 0u);
    return detail::occluderOfSums(detail::sumsOfCode(words, 2, offset, depth, gradient, deviation, bias), depth);
}

/// Mean depth of what is in front of a receiver, from a code of 128 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T mixtureOccluder4(const glm::vec<4, std::uint32_t>& code, const glm::vec<2, T, Q>& offset, T depth,
                   const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    return detail::occluderOfSums(detail::sumsOfCode(code, 4, offset, depth, gradient, deviation, bias), depth);
}

} // namespace lvsm

#endif
