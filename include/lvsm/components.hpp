// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config.
// Components of a mixture of planes: what a filter window sees of one surface, and how many of them become few.
//
// A component holds the moments of its taps, of first and second order in place and depth, which merge exactly. A window
// starts with a component a tap; insertComponent merges the two that are cheapest to merge whenever there are more than
// count. Windows grow as a tree: mixtureStep mixes the mixtures of three texels, 1/4, 1/2 and 1/4, along x and along y, a
// step apart that doubles; after n rounds that is a window of 2^(n + 1) - 1 texels, and mixtureDeviation is its
// deviation. The topic mixture codes the result and judges receivers by it.
#ifndef LVSM_COMPONENTS_HPP
#define LVSM_COMPONENTS_HPP

#include "config.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace lvsm
{

// Most components of a mixture.
constexpr int kMaxComponents = 4;

// Largest place of a component in texels, and largest spread.
template <typename T>
constexpr T kMostPlace = T(256.0);
template <typename T>
constexpr T kMostSpread = T(65536.0);

/// The part of a filter window that one surface covers, as moments of its taps.
/// weight: its share of the window, in [0,1]. place: mean place of its taps from the texel's centre, in texels, in
/// [-256,256]. depth: their mean, in [0,1]. spread: covariance of place, xx, xy and yy. tilt: covariance of place and
/// depth. variance: of depth. A component of weight 0 is none.
template <typename T>
struct MixtureComponent
{
    T weight;
    glm::vec<2, T> place;
    T depth;
    glm::vec<3, T> spread;
    glm::vec<2, T> tilt;
    T variance;
};

/// What a filter window sees: up to four components, in any order.
template <typename T>
struct Mixture
{
    MixtureComponent<T> components[kMaxComponents];
};

namespace detail
{

template <typename T, glm::qualifier Q>
glm::vec<2, T> clamped(const glm::vec<2, T, Q>& v, T most)
{
    return {clamp(v.x, -most, most), clamp(v.y, -most, most)};
}

// Every member in its documented range.
template <typename T>
MixtureComponent<T> validComponent(const MixtureComponent<T>& c)
{
    return {clamp(c.weight, T(0), T(1)),
            clamped(c.place, kMostPlace<T>),
            clamp(c.depth, T(0), T(1)),
            {clamp(c.spread.x, T(0), kMostSpread<T>), clamp(c.spread.y, -kMostSpread<T>, kMostSpread<T>),
             clamp(c.spread.z, T(0), kMostSpread<T>)},
            clamped(c.tilt, kMostPlace<T>),
            clamp(c.variance, T(0), T(1))};
}

template <typename T>
MixtureComponent<T> merged(const MixtureComponent<T>& a, const MixtureComponent<T>& b)
{
    const T sum = a.weight + b.weight;
    const T inverse = T(1) / maximum(kTiny<T>, sum);
    const T first = a.weight * inverse;
    const T second = b.weight * inverse;
    const T x = b.place.x - a.place.x;
    const T y = b.place.y - a.place.y;
    const T z = b.depth - a.depth;
    const T sideX = first * second * x;
    const T sideY = first * second * y;
    return {sum,
            {a.place.x + second * x, a.place.y + second * y},
            a.depth + second * z,
            {first * a.spread.x + second * b.spread.x + sideX * x, first * a.spread.y + second * b.spread.y + sideX * y,
             first * a.spread.z + second * b.spread.z + sideY * y},
            {first * a.tilt.x + second * b.tilt.x + sideX * z, first * a.tilt.y + second * b.tilt.y + sideY * z},
            first * a.variance + second * b.variance + first * second * z * z};
}

template <typename T>
glm::vec<2, T> slopeOf(const MixtureComponent<T>& c)
{
    const T ridge = maximum(T(0.000244140625), T(0.5) - T(0.5) * c.weight);
    const T xx = c.spread.x + ridge;
    const T yy = c.spread.z + ridge;
    const T determinant = maximum(ridge * ridge, rounded(xx * yy) - rounded(c.spread.y * c.spread.y));
    const T x = rounded(yy * c.tilt.x) - rounded(c.spread.y * c.tilt.y);
    const T y = rounded(xx * c.tilt.y) - rounded(c.spread.y * c.tilt.x);
    return {clamp(x / determinant, T(-1), T(1)), clamp(y / determinant, T(-1), T(1))};
}

template <typename T, glm::qualifier Q>
T residualOf(const MixtureComponent<T>& c, const glm::vec<2, T, Q>& g)
{
    const T x = g.x * rounded(rounded(g.x * c.spread.x + g.y * c.spread.y) - T(2) * c.tilt.x);
    const T y = g.y * rounded(rounded(g.x * c.spread.y + g.y * c.spread.z) - T(2) * c.tilt.y);
    return maximum(T(0), c.variance + rounded(rounded(x) + rounded(y)));
}

// What a component costs: its weight times the deviation from its plane.
template <typename T>
T costOf(const MixtureComponent<T>& c)
{
    using glm::sqrt;
    return c.weight * sqrt(residualOf(c, slopeOf(c)) + T(1.0e-8));
}

// Adds a valid component to so many valid ones, of which costs are costOf: where one is none, in its place.
template <typename T>
void insertValid(MixtureComponent<T>* components, T* costs, int count, const MixtureComponent<T>& added)
{
    if (!(added.weight > T(0)))
        return;
    const T addedCost = costOf(added);
    for (int i = 0; i < count; ++i)
    {
        if (components[i].weight > T(0))
            continue;
        components[i] = added;
        costs[i] = addedCost;
        return;
    }

    // Pairs (i, j), where j = count stands for the new component.
    T least = T(1.0e30);
    T cost = addedCost;
    int first = 0;
    int second = count;
    for (int i = 0; i < count; ++i)
    {
        for (int j = i + 1; j <= count; ++j)
        {
            const bool isNew = j == count;
            const T both = costOf(merged(components[i], isNew ? added : components[j]));
            const T price = both - (costs[i] + (isNew ? addedCost : costs[j]));
            if (price < least)
            {
                least = price;
                cost = both;
                first = i;
                second = j;
            }
        }
    }
    components[first] = merged(components[first], second == count ? added : components[second]);
    costs[first] = cost;
    if (second < count)
    {
        components[second] = added;
        costs[second] = addedCost;
    }
}

} // namespace detail

/// Standard deviation of the tree's window along each axis, in texels.
/// rounds: of the tree, each three texels along x and three along y, from 0 to 7, clamped to it: widths 1, 3, 7, 15,
/// 31 and so on. Result in [0, 52.26].
/// Source: a step of s texels with weights 1/4, 1/2, 1/4 adds the variance s^2 / 2; the steps are 1, 2, 4 and so on.
template <typename T = float>
T mixtureDeviation(int rounds)
{
    using glm::sqrt;
    T variance = T(0);
    T step = T(1);
    for (int i = 0; i < detail::clamp(rounds, 0, 7); ++i)
    {
        variance = variance + T(0.5) * step;
        step = T(4) * step;
    }
    return variance > T(0) ? sqrt(variance) : T(0);
}

/// Component of one tap: a point.
/// depth: in [0,1], clamped to it. Result: all of the window, at the texel's centre.
template <typename T>
MixtureComponent<T> tapComponent(T depth)
{
    return {T(1), {T(0), T(0)}, detail::clamp(depth, T(0), T(1)), {T(0), T(0), T(0)}, {T(0), T(0)}, T(0)};
}

/// Component of one texel whose surface slopes: a square of one texel in the surface's plane.
/// depth: in the middle of the texel, in [0,1], clamped to it. gradient: change of depth per texel, each component
/// clamped to [-1,1]; 0 where the surface ends inside the texel. Result: all of the window, at the texel's centre.
/// Source: the moments of a plane over a square, whose variance along each side is 1/12.
template <typename T, glm::qualifier Q>
MixtureComponent<T> slopedComponent(T depth, const glm::vec<2, T, Q>& gradient)
{
    const T part = T(1.0 / 12.0);
    const T x = detail::clamp(gradient.x, T(-1), T(1));
    const T y = detail::clamp(gradient.y, T(-1), T(1));
    return {T(1),           {T(0), T(0)},         detail::clamp(depth, T(0), T(1)),
            {part, T(0), part}, {part * x, part * y}, part * (x * x + y * y)};
}

/// Component seen from another texel's window.
/// component: any; its members are clamped to their ranges. offset: from the window's centre to the component's old one,
/// in texels, each component clamped to [-256,256]. share: of the old window in the new one, in [0,1], clamped to it.
/// Result: a component; its place is clamped to [-256,256].
/// Source: central moments do not depend on the centre that places are counted from.
template <typename T, glm::qualifier Q>
MixtureComponent<T> moveComponent(const MixtureComponent<T>& component, const glm::vec<2, T, Q>& offset, T share)
{
    MixtureComponent<T> moved = detail::validComponent(component);
    const glm::vec<2, T> step = detail::clamped(offset, kMostPlace<T>);
    moved.weight = moved.weight * detail::clamp(share, T(0), T(1));
    moved.place = detail::clamped(glm::vec<2, T>(moved.place.x + step.x, moved.place.y + step.y),
                                  kMostPlace<T>);
    return moved;
}

/// Two components as one: the moments of all their taps, exactly.
/// first, second: any; their members are clamped to their ranges. Result: a component whose weight is the sum, in [0,2],
/// spread in [-131072,131072], tilt in [-512,512] and variance in [0,2].
/// Degenerate: two of weight 0 give first with weight 0.
/// Source: pairwise central moments, Chan, Golub & LeVeque 1979.
template <typename T>
MixtureComponent<T> mergeComponents(const MixtureComponent<T>& first, const MixtureComponent<T>& second)
{
    const MixtureComponent<T> a = detail::validComponent(first);
    const MixtureComponent<T> b = detail::validComponent(second);
    if (a.weight + b.weight < kTiny<T>)
    {
        MixtureComponent<T> none = a;
        none.weight = T(0);
        return none;
    }
    return detail::merged(a, b);
}

/// Slope of the plane that fits a component best.
/// component: any; its members are clamped to their ranges. Result: change of depth per texel, each in [-1,1].
/// Degenerate: a lone tap has no slope: (0, 0).
/// Source: least squares with a ridge of (1 - weight) / 2 texels squared, which keeps few taps from wild slopes and
/// spares a full window; it is 2^-12 at least.
template <typename T>
glm::vec<2, T> componentSlope(const MixtureComponent<T>& component)
{
    return detail::slopeOf(detail::validComponent(component));
}

/// Mean squared distance, in depth, of a component's taps from a plane through its centroid.
/// component: any; its members are clamped to their ranges. slope: of the plane per texel, each component clamped to
/// [-1,1]. Result in depth squared, in [0, 263170].
/// Source: E[(z - g.p)^2] of central moments.
template <typename T, glm::qualifier Q>
T componentResidual(const MixtureComponent<T>& component, const glm::vec<2, T, Q>& slope)
{
    return detail::residualOf(detail::validComponent(component), detail::clamped(slope, T(1)));
}

/// What merging two components costs: by how much the weighed deviations from the planes grow.
/// first, second: any; their members are clamped to their ranges. Result in [-1,1], 0 or more for what taps made,
/// but for rounding and the ridge.
/// Source: W sqrt(R + e^2) of the merged less that of the two, R from componentResidual and e = 1e-4, under which
/// deviations do not count.
template <typename T>
T mergePrice(const MixtureComponent<T>& first, const MixtureComponent<T>& second)
{
    const MixtureComponent<T> a = detail::validComponent(first);
    const MixtureComponent<T> b = detail::validComponent(second);
    const T price = detail::costOf(detail::merged(a, b)) - (detail::costOf(a) + detail::costOf(b));
    return detail::clamp(price, T(-1), T(1));
}

/// Adds a component to a mixture; where there is no room for it, the two of all that cost least to merge are merged.
/// mixture: any, changed in place; members are clamped to their ranges. component: any; nothing happens where its weight
/// is 0. count: of components that the mixture may have, from 1 to 4, clamped to it; the others are not read.
/// The moments of the whole stay what they were. Of equal prices the first counts, in the order of the mixture with the
/// new component last.
/// Source: greedy agglomeration by mergePrice.
template <typename T>
void insertComponent(Mixture<T>& mixture, const MixtureComponent<T>& component, int count)
{
    const int last = detail::clamp(count, 1, kMaxComponents);
    const MixtureComponent<T> added = detail::validComponent(component);
    if (!(added.weight > T(0)))
        return;
    T costs[kMaxComponents] = {};
    for (int i = 0; i < last; ++i)
    {
        mixture.components[i] = detail::validComponent(mixture.components[i]);
        costs[i] = detail::costOf(mixture.components[i]);
    }
    detail::insertValid(mixture.components, costs, last, added);
}

/// A step of the tree: a texel's mixture of its own and of those of two others, one on each side.
/// middle, before, after: any; members are clamped to their ranges. offset: from the texel to the one after it, and back
/// to the one before it, in texels, each component clamped to [-256,256]. share: of the window that each of the outer two
/// gets, 1/4 in the tree, in [0,0.5], clamped to it. count: of components that each mixture may have, from 1 to 4,
/// clamped to it; the others are not read. Result: so many components, the others none.
/// The moments of the whole are those of all three. Source: insertComponent of the middle's components, then of those
/// before and after, with a component's plane fitted once.
template <typename T, glm::qualifier Q>
Mixture<T> mixtureStep(const Mixture<T>& middle, const Mixture<T>& before, const Mixture<T>& after,
                       const glm::vec<2, T, Q>& offset, T share, int count)
{
    const int last = detail::clamp(count, 1, kMaxComponents);
    const T outer = detail::clamp(share, T(0), T(0.5));
    const glm::vec<2, T> back(-offset.x, -offset.y);
    Mixture<T> mixed{};
    T costs[kMaxComponents] = {};
    for (int i = 0; i < last; ++i)
    {
        mixed.components[i] = moveComponent(middle.components[i], glm::vec<2, T>(T(0), T(0)), T(1) - T(2) * outer);
        costs[i] = detail::costOf(mixed.components[i]);
    }
    for (int i = 0; i < last; ++i)
        detail::insertValid(mixed.components, costs, last, moveComponent(before.components[i], back, outer));
    for (int i = 0; i < last; ++i)
        detail::insertValid(mixed.components, costs, last, moveComponent(after.components[i], offset, outer));
    return mixed;
}

/// Makes one of components that are one surface: those whose merging costs less than any code tells.
/// mixture: any, changed in place; members are clamped to their ranges. count: of components, from 1 to 4, clamped to it;
/// the others are not read. All are merged where that costs less than 1e-4, or else pairs, in the order of the mixture;
/// what is merged into another becomes none. Do so before coding: a surface that fills a window is then one plane, whose
/// slope is known best.
/// Source: mergePrice; a tenth of a step of a coded depth.
template <typename T>
void simplifyMixture(Mixture<T>& mixture, int count)
{
    const int last = detail::clamp(count, 1, kMaxComponents);
    MixtureComponent<T> whole = detail::validComponent(mixture.components[0]);
    T costs = detail::costOf(whole);
    mixture.components[0] = whole;
    for (int i = 1; i < kMaxComponents; ++i)
    {
        if (i >= last)
            continue;
        mixture.components[i] = detail::validComponent(mixture.components[i]);
        whole = detail::merged(whole, mixture.components[i]);
        costs = costs + detail::costOf(mixture.components[i]);
    }
    const bool isOne = detail::costOf(whole) - costs < T(1.0e-4);
    for (int i = 0; i < kMaxComponents; ++i)
    {
        for (int j = i + 1; j < kMaxComponents; ++j)
        {
            if (j >= last)
                continue;
            MixtureComponent<T>& a = mixture.components[i];
            MixtureComponent<T>& b = mixture.components[j];
            const MixtureComponent<T> both = detail::merged(a, b);
            const T price = detail::costOf(both) - (detail::costOf(a) + detail::costOf(b));
            if (a.weight > T(0) && b.weight > T(0) && (isOne || price < T(1.0e-4)))
            {
                a = both;
                b = MixtureComponent<T>{};
            }
        }
    }
}

/// Mixture of four taps of a texel: multisampled depths, or 2 x 2 texels of a map that is kept at half resolution.
/// depths: each in [0,1], clamped to it. x, y: places of the taps from the texel's centre, in texels, each component
/// clamped to [-256,256]. count: of components, as insertComponent takes it. Result: each tap weighs 1/4.
template <typename T, glm::qualifier Q>
Mixture<T> mixtureOfTaps(const glm::vec<4, T, Q>& depths, const glm::vec<4, T, Q>& x, const glm::vec<4, T, Q>& y,
                         int count)
{
    Mixture<T> mixture{};
    for (glm::length_t i = 0; i < 4; ++i)
        insertComponent(mixture, moveComponent(tapComponent(depths[i]), glm::vec<2, T>(x[i], y[i]), T(0.25)), count);
    return mixture;
}

} // namespace lvsm

#endif
