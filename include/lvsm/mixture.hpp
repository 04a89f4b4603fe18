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
// Two codes: two planes in 64 bits, four in 128. A plane is its depth at its coded place, in 10 bits, its slope, by sign
// and cube root, and its deviation, by the square root. All planes but the heaviest have their share, their place
// and the spread of their taps too; the heaviest takes what is left, since all shares add up to 1, all places to 0 and
// all spreads to the window's. A slope is read as the one nearest to the receiver's of those that its code stands for:
// so a surface is not its own shadow however coarse the code is.
#ifndef LVSM_MIXTURE_HPP
#define LVSM_MIXTURE_HPP

#include "components.hpp"

#include <cstdint>

namespace lvsm
{

// Bias that suits the codes: two steps of a coded depth, of which its rounding takes a half. The rest is for surfaces
// that bend, a choice and no derivation.
template <typename T>
constexpr T kMixtureBias = T(0.00195503);

// The steepest slope that a code tells from steeper ones, in depth per texel.
template <typename T>
constexpr T kMostCodedSlope = T(0.0625);

// Levels of a coded place on each side of 0, which reach to two deviations of the filter.
constexpr int kPlaceLevels = 7;

// Deviation of a component's taps along an axis, in that of the filter: 0.3, 0.65 or 1.
template <typename T>
constexpr T kLeastExtent = T(0.3);
template <typename T>
constexpr T kExtentStep = T(0.35);

// Correlation of a component's places in x and in y where it has one.
template <typename T>
constexpr T kCodedCorrelation = T(0.9);

/// One surface of a filter window as a receiver is compared with it.
/// weight: its share of the window, in [0,1]. place: of its taps' centroid from the texel's centre, in texels. depth: of
/// its plane at that place. slope, range: its change of depth per texel, and by how much more or less it may be. spread:
/// covariance of its taps' places, xx, xy and yy. deviation: of its taps from the plane, in depth. Weight 0 is none.
template <typename T>
struct MixturePlane
{
    T weight;
    glm::vec<2, T> place;
    T depth;
    glm::vec<2, T> slope;
    glm::vec<2, T> range;
    glm::vec<3, T> spread;
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

// What a code's fields stand for. Slopes: levels on each side of 0. Deviations: levels above 0, and the largest.
template <typename T>
struct PlaneCode
{
    int slopeBits;
    int deviationBits;
    T mostDeviation;

    int slopeLevels() const { return (1 << (slopeBits - 1)) - 1; }
    int deviationLevels() const { return (1 << deviationBits) - 1; }
};

template <typename T>
constexpr PlaneCode<T> kPlaneCode2 = {5, 4, T(0.2)};
template <typename T>
constexpr PlaneCode<T> kPlaneCode4 = {4, 2, T(0.05)};

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

// x in [0,1] as a whole number of levels.
template <typename T>
std::uint32_t levelOf(T x, int levels)
{
    using glm::floor;
    const T scaled = floor(clamp(x, T(0), T(1)) * static_cast<T>(levels) + T(0.5));
    return static_cast<std::uint32_t>(static_cast<int>(scaled));
}

template <typename T>
std::uint32_t slopeLevel(T slope, int levels)
{
    using glm::abs;
    using glm::exp;
    using glm::log;
    const T size = clamp(abs(slope) / kMostCodedSlope<T>, T(1.0e-9), T(1));
    const std::uint32_t level = levelOf(exp(log(size) * T(1.0 / 3.0)), levels);
    const std::uint32_t middle = static_cast<std::uint32_t>(levels) + 1u;
    return slope < T(0) ? middle - level : middle + level;
}

template <typename T>
std::uint32_t placeLevel(T place, T reach)
{
    const std::uint32_t level = levelOf(T(0.5) + T(0.5) * (place / reach), 2 * kPlaceLevels);
    return level + 1u;
}

// The plane's own fields: depth at its coded place from bit 0, slopes from bit 10, deviation behind them.
template <typename T>
std::uint32_t planeBits(const MixtureComponent<T>& c, const glm::vec<2, T>& place, const PlaneCode<T>& code)
{
    using glm::sqrt;
    const glm::vec<2, T> g = slopeOf(c);
    const std::uint32_t x = slopeLevel(g.x, code.slopeLevels());
    const std::uint32_t y = slopeLevel(g.y, code.slopeLevels());
    const T root = sqrt(sqrt(residualOf(c, g)) * (T(1) / code.mostDeviation));
    return levelOf(c.depth + (g.x * (place.x - c.place.x) + g.y * (place.y - c.place.y)), 1023) | x << 10 | y << (10 + code.slopeBits) |
           levelOf(root, code.deviationLevels()) << (10 + 2 * code.slopeBits);
}

// Extents along x and y, 0 to 2, in two bits each. Equal ones may have a correlation: above 0 the first is 3, below 0 the
// second.
template <typename T>
std::uint32_t spreadBits(const glm::vec<3, T>& spread, T sigma)
{
    using glm::sqrt;
    const T inverse = T(1) / sigma;
    const T span = T(2) * kExtentStep<T>;
    const std::uint32_t x = levelOf((sqrt(spread.x) * inverse - kLeastExtent<T>) / span, 2);
    const std::uint32_t y = levelOf((sqrt(spread.z) * inverse - kLeastExtent<T>) / span, 2);
    const T least = T(0.25) * kCodedCorrelation<T> * kCodedCorrelation<T>;
    if (x == y && spread.y * spread.y > least * spread.x * spread.z)
        return spread.y > T(0) ? 3u | x << 2 : x | 3u << 2;
    return x | y << 2;
}

// What a coded share and a coded place stand for.
template <typename T>
T codedWeight(std::uint32_t level, int index)
{
    return real<T>(level) * (T(1) / static_cast<T>(15 * (index + 1)));
}

template <typename T>
glm::vec<2, T> codedPlace(std::uint32_t x, std::uint32_t y, T sigma)
{
    const T scale = T(2) * sigma * (T(1) / static_cast<T>(kPlaceLevels));
    return {(real<T>(x) - static_cast<T>(kPlaceLevels + 1)) * scale,
            (real<T>(y) - static_cast<T>(kPlaceLevels + 1)) * scale};
}

// The heaviest plane takes the share that the others leave, but a share that heaviest can be, and its place is such that
// all places add up to 0. others: their shares, and the sums of shares times places.
template <typename T>
T heaviestWeight(T others)
{
    return maximum(T(0.125), T(1) - others);
}

template <typename T>
glm::vec<2, T> heaviestPlace(const glm::vec<2, T>& others, T weight, T sigma)
{
    const T inverse = T(1) / weight;
    return clamped(glm::vec<2, T>(-others.x * inverse, -others.y * inverse), T(2) * sigma);
}

// Share of all but the heaviest; the one of that index, counted from 1, has at most 1 / (index + 1).
template <typename T>
std::uint32_t weightLevel(T weight, int index)
{
    const std::uint32_t level = levelOf(weight * static_cast<T>(index + 1), 15);
    return weight > T(0) && level == 0u ? 1u : level;
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
    return {c.weight, c.place, c.depth, g, {T(0), T(0)}, c.spread, sqrt(detail::residualOf(c, g))};
}

/// Two planes in 64 bits.
/// mixture: the first two components count; members are clamped to their ranges, and shares to a sum of 1. deviation: of
/// the filter along each axis in texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: in x from bit 0 the heavier plane in 24 bits, the other's share and spread in 4 each; in y the other plane and
/// its place, 4 bits an axis. A mixture without any component is coded as a surface at depth 1.
template <typename T>
glm::vec<2, std::uint32_t> encodeMixture2(const Mixture<T>& mixture, T deviation)
{
    const T sigma = detail::filterDeviation(deviation);
    const Mixture<T> m = detail::sorted(mixture, 2);
    const MixtureComponent<T>& c = m.components[1];
    const std::uint32_t share = detail::weightLevel(c.weight, 1);
    const std::uint32_t x = detail::placeLevel(c.place.x, T(2) * sigma);
    const std::uint32_t y = detail::placeLevel(c.place.y, T(2) * sigma);
    const T weight = detail::codedWeight<T>(share, 1);
    const glm::vec<2, T> place = detail::codedPlace(x, y, sigma);
    const glm::vec<2, T> others(weight * place.x, weight * place.y);
    const glm::vec<2, T> first = detail::heaviestPlace(others, detail::heaviestWeight(weight), sigma);
    return {detail::planeBits(m.components[0], first, detail::kPlaneCode2<T>) | share << 24 |
                detail::spreadBits(c.spread, sigma) << 28,
            detail::planeBits(c, place, detail::kPlaneCode2<T>) | x << 24 | y << 28};
}

/// Four planes in 128 bits.
/// mixture: members are clamped to their ranges, and shares to a sum of 1. deviation: of the filter along each axis in
/// texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: in each word from bit 0 a plane in 20 bits, the heaviest in x; in x then the spreads of the others, 4 bits
/// each; in the others the share and the place of their plane, 4 bits each.
/// A mixture without any component is coded as a surface at depth 1.
template <typename T>
glm::vec<4, std::uint32_t> encodeMixture4(const Mixture<T>& mixture, T deviation)
{
    const T sigma = detail::filterDeviation(deviation);
    const Mixture<T> m = detail::sorted(mixture, 4);
    glm::vec<4, std::uint32_t> code(0u, 0u, 0u, 0u);
    T shares = T(0);
    glm::vec<2, T> places(T(0), T(0));
    for (int i = 1; i < 4; ++i)
    {
        const MixtureComponent<T>& c = m.components[i];
        const std::uint32_t share = detail::weightLevel(c.weight, i);
        const std::uint32_t x = detail::placeLevel(c.place.x, T(2) * sigma);
        const std::uint32_t y = detail::placeLevel(c.place.y, T(2) * sigma);
        const T weight = detail::codedWeight<T>(share, i);
        const glm::vec<2, T> place = detail::codedPlace(x, y, sigma);
        shares = shares + weight;
        places = {places.x + weight * place.x, places.y + weight * place.y};
        code.x = code.x | detail::spreadBits(c.spread, sigma) << (16 + 4 * i);
        code[static_cast<glm::length_t>(i)] = detail::planeBits(c, place, detail::kPlaneCode4<T>) | share << 20 | x << 24 | y << 28;
    }
    const glm::vec<2, T> first = detail::heaviestPlace(places, detail::heaviestWeight(shares), sigma);
    code.x = code.x | detail::planeBits(m.components[0], first, detail::kPlaneCode4<T>);
    return code;
}

namespace detail
{

inline std::uint32_t field(std::uint32_t word, int begin, int bits)
{
    return word >> begin & ((1u << bits) - 1u);
}

// A plane's own fields; the rest is as of a plane that is all of the window.
template <typename T>
MixturePlane<T> planeOfBits(std::uint32_t bits, const PlaneCode<T>& code, T sigma)
{
    // u^3 for all u within half a level: in the middle u (u^2 + 3 h^2), to both sides h (3 u^2 + h^2).
    const int levels = code.slopeLevels();
    const T scale = T(1) / static_cast<T>(levels);
    const T half = T(0.5) * scale;
    const T x = (real<T>(field(bits, 10, code.slopeBits)) - static_cast<T>(levels + 1)) * scale;
    const T y = (real<T>(field(bits, 10 + code.slopeBits, code.slopeBits)) - static_cast<T>(levels + 1)) * scale;
    const T most = kMostCodedSlope<T>;
    const glm::vec<2, T> middle(most * (x * (x * x + T(3) * half * half)), most * (y * (y * y + T(3) * half * half)));
    const glm::vec<2, T> range(most * half * (T(3) * (x * x) + half * half), most * half * (T(3) * (y * y) + half * half));

    // Code 0 stands for deviations to half a level, evenly spread: their root mean square is 0.577 of that half's.
    const T step = T(1) / static_cast<T>(code.deviationLevels());
    const T level = real<T>(field(bits, 10 + 2 * code.slopeBits, code.deviationBits)) * step;
    const T size = maximum(level * level, T(0.14433757) * (step * step));
    const T variance = sigma * sigma;
    return {T(1),
            {T(0), T(0)},
            real<T>(field(bits, 0, 10)) * T(1.0 / 1023.0),
            middle,
            range,
            {variance, T(0), variance},
            code.mostDeviation * size};
}

template <typename T>
void placePlane(MixturePlane<T>& plane, std::uint32_t weight, int index, glm::vec<2, std::uint32_t> place,
                std::uint32_t spread, T sigma)
{
    plane.weight = codedWeight<T>(weight, index);
    plane.place = codedPlace(place.x, place.y, sigma);
    const std::uint32_t first = spread & 3u;
    const std::uint32_t second = spread >> 2;
    const T x = sigma * (kLeastExtent<T> + kExtentStep<T> * real<T>(first == 3u ? second : first));
    const T y = sigma * (kLeastExtent<T> + kExtentStep<T> * real<T>(second == 3u ? first : second));
    const T correlation = first == 3u ? kCodedCorrelation<T> : second == 3u ? -kCodedCorrelation<T> : T(0);
    plane.spread = {x * x, correlation * (x * y), y * y};
}

// The heaviest plane takes what the others leave of the window's moments.
template <typename T>
void completePlanes(MixturePlanes<T>& m, int count, T sigma)
{
    T shares = T(0);
    glm::vec<2, T> places(T(0), T(0));
    glm::vec<3, T> spread(sigma * sigma, T(0), sigma * sigma);
    for (int i = 1; i < count; ++i)
    {
        const MixturePlane<T>& p = m.planes[i];
        shares = shares + p.weight;
        places = {places.x + p.weight * p.place.x, places.y + p.weight * p.place.y};
        spread = {spread.x - p.weight * (p.spread.x + p.place.x * p.place.x),
                  spread.y - p.weight * (p.spread.y + p.place.x * p.place.y),
                  spread.z - p.weight * (p.spread.z + p.place.y * p.place.y)};
    }
    MixturePlane<T>& heaviest = m.planes[0];
    heaviest.weight = heaviestWeight(shares);
    heaviest.place = heaviestPlace(places, heaviest.weight, sigma);
    const T inverse = T(1) / heaviest.weight;
    const T least = rounded(T(0.05) * rounded(sigma * sigma));
    const T most = rounded(T(1.5) * rounded(sigma * sigma));
    const T xx = clamp(spread.x * inverse - heaviest.place.x * heaviest.place.x, least, most);
    const T yy = clamp(spread.z * inverse - heaviest.place.y * heaviest.place.y, least, most);
    const T correlated = minimum(xx, yy);
    heaviest.spread = {xx, clamp(spread.y * inverse - heaviest.place.x * heaviest.place.y, -correlated, correlated), yy};
}

} // namespace detail

/// The planes that a code of 64 bits holds.
/// code: any bits; what encodeMixture2 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heavier plane first, places within 2.3 deviations, the third and fourth none.
template <typename T>
MixturePlanes<T> decodeMixture2(const glm::vec<2, std::uint32_t>& code, T deviation)
{
    const T sigma = detail::filterDeviation(deviation);
    MixturePlanes<T> m{};
    m.planes[0] = detail::planeOfBits(code.x, detail::kPlaneCode2<T>, sigma);
    m.planes[1] = detail::planeOfBits(code.y, detail::kPlaneCode2<T>, sigma);
    detail::placePlane(m.planes[1], detail::field(code.x, 24, 4), 1,
                       {detail::field(code.y, 24, 4), detail::field(code.y, 28, 4)}, detail::field(code.x, 28, 4),
                       sigma);
    detail::completePlanes(m, 2, sigma);
    return m;
}

/// The planes that a code of 128 bits holds.
/// code: any bits; what encodeMixture4 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heaviest plane first, places within 2.3 deviations.
template <typename T>
MixturePlanes<T> decodeMixture4(const glm::vec<4, std::uint32_t>& code, T deviation)
{
    const T sigma = detail::filterDeviation(deviation);
    MixturePlanes<T> m{};
    m.planes[0] = detail::planeOfBits(code.x, detail::kPlaneCode4<T>, sigma);
    for (int i = 1; i < 4; ++i)
    {
        const std::uint32_t word = code[static_cast<glm::length_t>(i)];
        m.planes[i] = detail::planeOfBits(word, detail::kPlaneCode4<T>, sigma);
        detail::placePlane(m.planes[i], detail::field(word, 20, 4), i,
                           {detail::field(word, 24, 4), detail::field(word, 28, 4)},
                           detail::field(code.x, 16 + 4 * i, 4), sigma);
    }
    detail::completePlanes(m, 4, sigma);
    return m;
}

namespace detail
{

// The weight of a plane around a receiver at f, in squares of the filter's deviation.
template <typename T, glm::qualifier Q>
T weightOfPlane(const MixturePlane<T>& p, const glm::vec<2, T, Q>& f)
{
    using glm::exp;
    return p.weight * exp(clamp(f.x * p.place.x + f.y * p.place.y, T(-16), T(16)));
}

// Of a plane: the lit share of its taps, and how far behind the receiver's plane they are in the mean, in depth.
// f: the receiver's place; moved: the same in squares of the filter's deviation. g: the receiver's slope; compared: the
// same as far as the plane can tell.
template <typename T>
glm::vec<2, T> lightOfPlane(const MixturePlane<T>& p, const glm::vec<2, T>& f, const glm::vec<2, T>& moved, T depth,
                            const glm::vec<2, T>& g, const glm::vec<2, T>& compared, T bias)
{
    using glm::sqrt;
    const T offX = p.slope.x - compared.x;
    const T offY = p.slope.y - compared.y;
    const T x = offX - clamp(offX, -p.range.x, p.range.x);
    const T y = offY - clamp(offY, -p.range.y, p.range.y);
    const T across = x * p.spread.x + y * p.spread.y;
    const T along = x * p.spread.y + y * p.spread.z;
    const T own = rounded(depth + rounded(g.x * (p.place.x - f.x) + g.y * (p.place.y - f.y)));
    const T behind = rounded(p.depth - own) + rounded(across * moved.x + along * moved.y);
    const T variance = maximum(T(1.0e-10), rounded(across * x + along * y) + p.deviation * p.deviation);
    const T lit = T(0.5) + (behind + T(0.6) * p.deviation + bias) / sqrt(T(12) * variance);
    return {clamp(lit, T(0), T(1)), behind};
}

template <typename T, glm::qualifier Q>
glm::vec<2, T> inSquares(const glm::vec<2, T, Q>& f, T sigma)
{
    const T inverse = T(1) / (sigma * sigma);
    return {f.x * inverse, f.y * inverse};
}

} // namespace detail

/// Share of the window that a plane has around a receiver between texels.
/// plane: weight counts in [0,1] and place in [-256,256], clamped to them. offset: of the receiver from the texel's
/// centre, in texels, each component clamped to [-16,16]; half a texel for a map of full resolution. deviation: of the
/// filter, clamped to [0.25, 64]. Result in [0, 8.9e6], relative to the other planes of the texel.
/// Source: moving a Gaussian window by f tilts its weights by exp(f.p / deviation^2), taken at the centroid.
template <typename T, glm::qualifier Q>
T planeWeight(const MixturePlane<T>& plane, const glm::vec<2, T, Q>& offset, T deviation)
{
    MixturePlane<T> p = plane;
    p.weight = detail::clamp(plane.weight, T(0), T(1));
    p.place = detail::clamped(plane.place, kMostPlace<T>);
    return detail::weightOfPlane(p, detail::inSquares(detail::clamped(offset, T(16)), detail::filterDeviation(deviation)));
}

/// Lit share of a plane's taps, and how far they are behind the receiver.
/// plane: any; its members are clamped to [0,1], places to [-256,256], slopes and ranges to [-1,1], spreads to [-65536,65536].
/// offset: of the receiver from the texel's centre, in texels, each component clamped to [-16,16].
/// depth: the receiver's, in [0,1], clamped to it. gradient: its change per texel, each component clamped to [-1,1].
/// deviation: of the filter, clamped to [0.25, 64]. bias: in depth, clamped to [0,1].
/// Result: the share in [0,1], and the mean distance in depth, in [-1.4e8, 1.4e8].
/// Source: depth less the receiver's plane has the mean d and, by the difference of slopes and by the deviation, the
/// variance v; samples spread evenly around d are in front of 0 with the share 1/2 - d / sqrt(12 v).
template <typename T, glm::qualifier Q, glm::qualifier QG>
glm::vec<2, T> planeLight(const MixturePlane<T>& plane, const glm::vec<2, T, Q>& offset, T depth,
                          const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    const T most = kMostSpread<T>;
    const MixturePlane<T> p = {detail::clamp(plane.weight, T(0), T(1)),
                               detail::clamped(plane.place, kMostPlace<T>),
                               detail::clamp(plane.depth, T(0), T(1)),
                               detail::clamped(plane.slope, T(1)),
                               {detail::clamp(plane.range.x, T(0), T(1)), detail::clamp(plane.range.y, T(0), T(1))},
                               {detail::clamp(plane.spread.x, T(0), most), detail::clamp(plane.spread.y, -most, most),
                                detail::clamp(plane.spread.z, T(0), most)},
                               detail::clamp(plane.deviation, T(0), T(1))};
    const glm::vec<2, T> f = detail::clamped(offset, T(16));
    const glm::vec<2, T> g = detail::clamped(gradient, T(1));
    return detail::lightOfPlane(p, f, detail::inSquares(f, detail::filterDeviation(deviation)),
                                detail::clamp(depth, T(0), T(1)), g, g, detail::clamp(bias, T(0), T(1)));
}

namespace detail
{

// Sums over the planes of a code: weight, lit weight, weight in shadow, and that times the distance in front of the
// receiver. Slopes that the code does not tell apart are compared as one.
template <typename T, glm::qualifier Q, glm::qualifier QG>
glm::vec<4, T> sumsOfPlanes(const MixturePlanes<T>& m, int count, const glm::vec<2, T, Q>& offset, T depth,
                            const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    const glm::vec<2, T> f = clamped(offset, T(16));
    const glm::vec<2, T> moved = inSquares(f, filterDeviation(deviation));
    const glm::vec<2, T> g = clamped(gradient, T(1));
    const glm::vec<2, T> compared = clamped(gradient, kMostCodedSlope<T>);
    const T t = clamp(depth, T(0), T(1));
    const T allowed = clamp(bias, T(0), T(1));
    glm::vec<4, T> sums(T(0), T(0), T(0), T(0));
    for (int i = 0; i < count; ++i)
    {
        const T weight = weightOfPlane(m.planes[i], moved);
        const glm::vec<2, T> light = lightOfPlane(m.planes[i], f, moved, t, g, compared, allowed);
        const T dark = weight * (T(1) - light.x);
        sums = {sums.x + weight, sums.y + weight * light.x, sums.z + dark, sums.w + dark * maximum(T(0), -light.y)};
    }
    return sums;
}

template <typename T>
T visibilityOfSums(const glm::vec<4, T>& sums)
{
    return clamp(sums.y / maximum(T(1.0e-12), sums.x), T(0), T(1));
}

template <typename T>
T occluderOfSums(const glm::vec<4, T>& sums, T depth)
{
    const T t = clamp(depth, T(0), T(1));
    const T distance = sums.z < T(1.0e-12) ? T(0) : sums.w / maximum(T(1.0e-12), sums.z);
    return clamp(t - distance, T(0), T(1));
}

} // namespace detail

/// Visibility of a receiver from a code of 64 bits.
/// code: any bits, not filtered. offset: of the receiver from the code's place, in texels of the shadow map, each
/// component clamped to [-16,16]: at most half a texel for a nearest fetch from a map of full resolution, one of half
/// resolution. depth: the receiver's, in [0,1], clamped to it. gradient: its change per texel of the shadow map, each
/// component clamped to [-1,1]. deviation: of the filter, clamped to [0.25, 64]. bias: in depth, clamped to [0,1], see
/// kMixtureBias. Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T mixtureVisibility2(const glm::vec<2, std::uint32_t>& code, const glm::vec<2, T, Q>& offset, T depth,
                     const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    return detail::visibilityOfSums(
        detail::sumsOfPlanes(decodeMixture2(code, deviation), 2, offset, depth, gradient, deviation, bias));
}

/// Visibility of a receiver from a code of 128 bits.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T mixtureVisibility4(const glm::vec<4, std::uint32_t>& code, const glm::vec<2, T, Q>& offset, T depth,
                     const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    return detail::visibilityOfSums(
        detail::sumsOfPlanes(decodeMixture4(code, deviation), 4, offset, depth, gradient, deviation, bias));
}

/// Mean depth of what is in front of a receiver, from a code of 64 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T mixtureOccluder2(const glm::vec<2, std::uint32_t>& code, const glm::vec<2, T, Q>& offset, T depth,
                   const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    return detail::occluderOfSums(
        detail::sumsOfPlanes(decodeMixture2(code, deviation), 2, offset, depth, gradient, deviation, bias), depth);
}

/// Mean depth of what is in front of a receiver, from a code of 128 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
template <typename T, glm::qualifier Q, glm::qualifier QG>
T mixtureOccluder4(const glm::vec<4, std::uint32_t>& code, const glm::vec<2, T, Q>& offset, T depth,
                   const glm::vec<2, T, QG>& gradient, T deviation, T bias)
{
    return detail::occluderOfSums(
        detail::sumsOfPlanes(decodeMixture4(code, deviation), 4, offset, depth, gradient, deviation, bias), depth);
}

} // namespace lvsm

#endif
