// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, depth, moments, layers.
// Bracketed layers: the neighbours of a layer tell how much of the filter window lies in front of it and behind it.
//
// The layers are contiguous, without overlap: a depth behind the split between two layers warps to 1 in the one in
// front of it, and a depth in front of the split to 0 in the one behind. So the moments of the layer in front bound how
// much of the window is in front of this layer, those of the layer behind how much is behind it, and the moments of
// neighbours add up to those of their union. The share in front is dark, the share behind is lit, and only what is left
// needs a bound of its own.
//
// The visibility is an upper bound on the lit share of the window, as the bound that it is made of is, where the
// moments are exact, come from one window, and layers do not overlap. It is an estimate otherwise: for a layer that
// overlaps the one in front, samples in the overlap count as in front, and lit receivers there darken.
#ifndef LVSM_BRACKET_HPP
#define LVSM_BRACKET_HPP

#include "layers.hpp"

namespace lvsm
{

// Least variance floor of a neighbour in its warp, (1/64)^2: nearer to the split than about 1/64 of a layer nothing is
// surely beyond it. That covers the rounding of moments to unorm16, three half steps of the second moment about the
// split for each time they are rounded, which would otherwise make a share in front out of nothing.
template <typename T>
constexpr T kNeighbourMinVariance = T(0.000244140625);

/// Moments of the union of two neighbouring layers that do not overlap, from the moments of the two.
/// moments: of the layer in front, filtered. next: of the layer behind it. extent, nextExtent: lengths of the two, in
/// [0,1], clamped to it. Result: (M1, M2) of the layer that covers both, each in [0,1].
/// Degenerate: two empty layers give moments.
/// Source: the warp of the union is (extent phi + nextExtent phiNext) / (extent + nextExtent), and phiNext > 0 implies
/// phi = 1, so that E[phi phiNext] = E[phiNext].
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> mergeLayers(const glm::vec<2, T, Q>& moments, const glm::vec<2, T, Q>& next, T extent, T nextExtent)
{
    const T a = detail::clamp(extent, T(0), T(1));
    const T b = detail::clamp(nextExtent, T(0), T(1));
    const T sum = a + b;
    const T behind = sum < kTiny<T> ? T(0) : detail::minimum(T(1), b / sum);
    const T inFront = T(1) - behind;
    const T m1 = inFront * moments.x + behind * next.x;
    const T m2 = inFront * inFront * moments.y + behind * (behind * next.y + (T(2) * inFront) * next.x);
    return {detail::clamp(m1, T(0), T(1)), detail::clamp(m2, T(0), T(1))};
}

/// Layer moments in the basis that suits few bits: the mean and four times the mean of x (1 - x).
/// moments: (M1, M2) of a layer. Result: (M1, 4 (M1 - M2)), each in [0,1] and filtered as linearly as the moments.
/// A layer that is all in front or all behind is an exact code of any unorm format, and a texel without any surface
/// stores (1, 0).
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> compactMoments(const glm::vec<2, T, Q>& moments)
{
    const T m1 = detail::clamp(moments.x, T(0), T(1));
    const T m2 = detail::clamp(moments.y, T(0), T(1));
    return {m1, detail::clamp(T(4) * (m1 - m2), T(0), T(1))};
}

/// Layer moments out of the basis that suits few bits.
/// compact: as compactMoments made it, filtered, in [0,1], clamped to it. Result: (M1, M2), each in [0,1].
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> expandMoments(const glm::vec<2, T, Q>& compact)
{
    const T m1 = detail::clamp(compact.x, T(0), T(1));
    return {m1, detail::maximum(T(0), m1 - T(0.25) * detail::clamp(compact.y, T(0), T(1)))};
}

namespace detail
{

// Share of a window whose depth is above 0, at least, for depths in [0,1] with a floor of their variance:
// 1 - v / (v + m1^2). Multiplied in an order that makes any finite arguments safe.
template <typename T>
T shareAboveZero(T m1, T m2, T minVariance)
{
    const T second = maximum(m2, m1 * m1 + minVariance);
    return clamp(m1 * (m1 / clamp(second, kTiny<T>, kHuge<T>)), T(0), T(1));
}

// A mass that has the sums of moments (m1, m2), and of it the most that can be at t or farther: chebyshevUpperBound of
// its mean moments, times the mass, without dividing by the mass.
template <typename T>
T chebyshevMass(T mass, T m1, T m2, T t, T minVariance)
{
    const T v = maximum(mass * minVariance, rounded(mass * m2) - rounded(m1 * m1));
    const T d = mass * t - m1;
    const T tail = clamp(v / maximum(kTiny<T>, v + d * d), T(0), T(1));
    // Rounded, so that the lesser of this and another bound is never more than this.
    return d > T(0) ? rounded(mass * tail) : mass;
}

} // namespace detail

/// A layer's filter window in three parts: in front of the layer, behind it, and what is left.
/// front: moments of the layer in front of it, (1, 1) for the first layer. moments: of the layer.
/// behind: moments of the layer behind it, (0, 0) for the last layer. All filtered over one window.
/// minVariance: floor of the neighbours' variance in their warp, >= 0, less counts as 0.
/// Result: (share behind, share left, M1 left, M2 left), each in [0,1]. The share in front is 1 less the first two; the
/// moments left are sums: divided by the share left they are what any bound on the layer's warp takes.
/// The visibility is then at most share behind + share left * bound(moments left / share left).
/// Exact where the samples in front share one depth in the neighbour or lie in front of it, and those behind likewise.
/// Source: chebyshevUpperBound(front, 1) and chebyshevLowerBound(behind, 0), LVSM equation 3.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> bracketMoments(const glm::vec<2, T, Q>& front, const glm::vec<2, T, Q>& moments,
                                 const glm::vec<2, T, Q>& behind, T minVariance)
{
    const T floor = detail::clamp(minVariance, T(0), T(1));
    const T m1 = detail::clamp(moments.x, T(0), T(1));
    const T m2 = detail::clamp(moments.y, T(0), m1);
    const T a = T(1) - detail::clamp(front.x, T(0), T(1));
    const T second = detail::rounded(detail::clamp(front.y, T(0), T(1)) - T(1)) + T(2) * a;
    const T shareInFront = detail::minimum(T(1) - m1, detail::shareAboveZero(a, second, floor));
    const T shareBehind =
        detail::minimum(m2, detail::shareAboveZero(detail::clamp(behind.x, T(0), T(1)), behind.y, floor));
    return {shareBehind, detail::maximum(T(0), T(1) - shareInFront - shareBehind), m1 - shareBehind, m2 - shareBehind};
}

/// Visibility of a receiver from the moments of its layer and of the two neighbours.
/// front, moments, behind: as bracketMoments takes them. depth: the receiver's, in [0,1]. interval: begin and end of
/// the layer, which holds the receiver. minVariance: the global floor in depth squared, >= 0; the neighbours' warps are
/// taken to be as steep as the layer's, and their floor is at least 1/4096.
/// Result in [0,1]; an upper bound on the lit share of the window where layers do not overlap. Without a floor never
/// above layeredVisibility.
/// Source: bracketMoments, and chebyshevUpperBound for what is left in the layer.
template <typename T, glm::qualifier Q, glm::qualifier QI>
T bracketedVisibility(const glm::vec<2, T, Q>& front, const glm::vec<2, T, Q>& moments,
                      const glm::vec<2, T, Q>& behind, T depth, const glm::vec<2, T, QI>& interval, T minVariance)
{
    const T floor = layerMinVariance(minVariance, interval);
    const glm::vec<4, T, Q> left =
        bracketMoments(front, moments, behind, detail::maximum(kNeighbourMinVariance<T>, floor));
    const T share = detail::chebyshevMass(left.y, left.z, left.w, layerWarp(depth, interval), floor);
    return detail::clamp(left.x + share, T(0), T(1));
}

/// Visibility of a receiver from the moments of its layer and of the two neighbours, by the bound for depths in [0,1].
/// front, moments, behind: as bracketMoments takes them. depth: the receiver's, in [0,1]. interval: begin and end of
/// the layer, which holds the receiver. minVariance: the global floor in depth squared, >= 0; the neighbours' warps are
/// taken to be as steep as the layer's, and their floor is at least 1/4096.
/// Result in [0,1], never above bracketedVisibility; an upper bound on the lit share of the window where layers do not
/// overlap.
/// Source: bracketMoments, and boundedUpperBound for what is left in the layer.
template <typename T, glm::qualifier Q, glm::qualifier QI>
T bracketedBoundedVisibility(const glm::vec<2, T, Q>& front, const glm::vec<2, T, Q>& moments,
                             const glm::vec<2, T, Q>& behind, T depth, const glm::vec<2, T, QI>& interval,
                             T minVariance)
{
    const T floor = layerMinVariance(minVariance, interval);
    const glm::vec<4, T, Q> left =
        bracketMoments(front, moments, behind, detail::maximum(kNeighbourMinVariance<T>, floor));
    const T t = layerWarp(depth, interval);
    const T tail = detail::chebyshevMass(left.y, left.z, left.w, t, floor);
    const T inverse = T(1) / detail::maximum(kTiny<T>, t);
    const T second = left.z * t + detail::rounded(left.z - left.w);
    const T parabolas = (detail::minimum(left.z, second) + T(2.25) * floor * inverse) * inverse;
    const T share = t > T(0) ? detail::minimum(tail, parabolas) : left.y;
    return detail::clamp(left.x + share, T(0), T(1));
}

/// Visibility of a receiver from the one texel that holds both of two layers: bracketedVisibility with few operations.
/// texel: as packLayers made it, filtered. depth: the receiver's, in [0,1]; one beyond 1 is no lighter than one at 1.
/// split: between the two layers, in [0,1], clamped to it. minVariance: the global floor in depth squared, from 0 to a
/// quarter of the squared length of the receiver's layer, the largest variance there is; more is not clamped to it.
/// Result in [0,1]; an upper bound on the lit share of the window where the layers do not overlap.
/// Source: bracketedVisibility for the layer that holds the receiver, both sides multiplied by the layer's length.
template <typename T, glm::qualifier Q>
T bracketedVisibility2(const glm::vec<4, T, Q>& texel, T depth, T split, T minVariance)
{
    // Depths are counted from the split, in units of depth, and negative in front of it: then what holds for the layer
    // behind the split holds for the one in front, and one division gives the share in the other layer.
    const T middle = detail::clamp(split, T(0), T(1));
    const bool isBehind = depth >= middle;
    const T front1 = detail::clamp(T(1) - texel.x, T(0), T(1));
    const T front2 = detail::clamp(texel.y - T(1) + T(2) * front1, T(0), T(1));
    const T own1 = isBehind ? texel.z : front1;
    const T own2 = isBehind ? texel.w : front2;
    const T other1 = isBehind ? front1 : texel.z;
    const T other2 = isBehind ? front2 : texel.w;
    const T reach = isBehind ? T(1) - middle : -middle;
    const T squared = reach * reach;

    const T away1 = detail::clamp(other1 * (reach < T(0) ? -reach : reach), T(0), T(1));
    const T away2 = detail::clamp(other2 * squared, T(0), T(1));
    const T floor = detail::maximum(kNeighbourMinVariance<T> * squared, minVariance);
    const T share = away1 * (away1 / detail::maximum(kTiny<T>, detail::maximum(away2, away1 * away1 + floor)));
    const T away = detail::clamp(share, T(0), T(1));
    const T lit = isBehind ? T(0) : away;
    const T left = T(1) - away;

    // V and d of chebyshevUpperBound times left and left^2, so that nothing is divided by left.
    const T mean = reach * own1;
    const T v = detail::maximum(kTiny<T>, detail::maximum(left * minVariance, left * (squared * own2) - mean * mean));
    const T d = left * (depth - middle) - mean;
    const T tail = v / (v + d * d);
    return detail::clamp(lit + left * (d > T(0) ? tail : T(1)), T(0), T(1));
}

/// Visibility of a receiver from the union of two neighbouring layers: what to blend to near the split between them.
/// moments: of the layer in front, filtered. next: of the layer behind it. depth: the receiver's, in [0,1].
/// begin, split, end: of the two layers, which do not overlap. minVariance: the global floor in depth squared, >= 0.
/// Result in [0,1], an upper bound on the lit share of the window; both layers see the same one, so that
/// blendTransition(visibility, mergedVisibility, 2 transitionWeight) is continuous across the split.
/// Source: mergeLayers and layeredVisibility.
template <typename T, glm::qualifier Q>
T mergedVisibility(const glm::vec<2, T, Q>& moments, const glm::vec<2, T, Q>& next, T depth, T begin, T split, T end,
                   T minVariance)
{
    return layeredVisibility(mergeLayers(moments, next, split - begin, end - split), depth,
                             glm::vec<2, T, Q>(begin, end), minVariance);
}

} // namespace lvsm

#endif
