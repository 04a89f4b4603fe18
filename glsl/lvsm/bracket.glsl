// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers.
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
#ifndef LVSM_BRACKET_GLSL
#define LVSM_BRACKET_GLSL

#include "layers.glsl"

// Least variance floor of a neighbour in its warp, (1/64)^2: nearer to the split than about 1/64 of a layer nothing is
// surely beyond it. That covers the rounding of moments to unorm16, three half steps of the second moment about the
// split for each time they are rounded, which would otherwise make a share in front out of nothing.
const float LVSM_NEIGHBOUR_MIN_VARIANCE = 0.000244140625;

/// Moments of the union of two neighbouring layers that do not overlap, from the moments of the two.
/// moments: of the layer in front, filtered. next: of the layer behind it. extent, nextExtent: lengths of the two, in
/// [0,1], clamped to it. Result: (M1, M2) of the layer that covers both, each in [0,1].
/// Degenerate: two empty layers give moments.
/// Source: the warp of the union is (extent phi + nextExtent phiNext) / (extent + nextExtent), and phiNext > 0 implies
/// phi = 1, so that E[phi phiNext] = E[phiNext].
vec2 lvsm_mergeLayers(vec2 moments, vec2 next, float extent, float nextExtent)
{
    float a = clamp(extent, 0.0, 1.0);
    float b = clamp(nextExtent, 0.0, 1.0);
    float sum = a + b;
    float behind = sum < LVSM_TINY ? 0.0 : min(b / sum, 1.0);
    float inFront = 1.0 - behind;
    float m1 = inFront * moments.x + behind * next.x;
    float m2 = inFront * inFront * moments.y + behind * (behind * next.y + (2.0 * inFront) * next.x);
    return clamp(vec2(m1, m2), 0.0, 1.0);
}

/// Layer moments in the basis that suits few bits: the mean and four times the mean of x (1 - x).
/// moments: (M1, M2) of a layer. Result: (M1, 4 (M1 - M2)), each in [0,1] and filtered as linearly as the moments.
/// A layer that is all in front or all behind is an exact code of any unorm format, and a texel without any surface
/// stores (1, 0).
vec2 lvsm_compactMoments(vec2 moments)
{
    vec2 valid = clamp(moments, 0.0, 1.0);
    return vec2(valid.x, clamp(4.0 * (valid.x - valid.y), 0.0, 1.0));
}

/// Layer moments out of the basis that suits few bits.
/// compact: as compactMoments made it, filtered, in [0,1], clamped to it. Result: (M1, M2), each in [0,1].
vec2 lvsm_expandMoments(vec2 compact)
{
    vec2 valid = clamp(compact, 0.0, 1.0);
    return vec2(valid.x, max(valid.x - 0.25 * valid.y, 0.0));
}

// Share of a window whose depth is above 0, at least, for depths in [0,1] with a floor of their variance:
// 1 - v / (v + m1^2). Multiplied in an order that makes any finite arguments safe.
float lvsm_shareAboveZero(float m1, float m2, float minVariance)
{
    float second = max(m2, m1 * m1 + minVariance);
    return clamp(m1 * (m1 / clamp(second, LVSM_TINY, LVSM_HUGE)), 0.0, 1.0);
}

// A mass that has the sums of moments (m1, m2), and of it the most that can be at t or farther: chebyshevUpperBound of
// its mean moments, times the mass, without dividing by the mass.
float lvsm_chebyshevMass(float mass, float m1, float m2, float t, float minVariance)
{
    LVSM_PRECISE float difference = mass * m2 - m1 * m1;
    float v = max(difference, mass * minVariance);
    float d = mass * t - m1;
    float tail = clamp(v / max(v + d * d, LVSM_TINY), 0.0, 1.0);
    return d > 0.0 ? mass * tail : mass;
}

/// A layer's filter window in three parts: in front of the layer, behind it, and what is left.
/// front: moments of the layer in front of it, (1, 1) for the first layer. moments: of the layer.
/// behind: moments of the layer behind it, (0, 0) for the last layer. All filtered over one window.
/// minVariance: floor of the neighbours' variance in their warp, >= 0, less counts as 0.
/// Result: (share behind, share left, M1 left, M2 left), each in [0,1]. The share in front is 1 less the first two; the
/// moments left are sums: divided by the share left they are what any bound on the layer's warp takes.
/// The visibility is then at most share behind + share left * bound(moments left / share left).
/// Exact where the samples in front share one depth in the neighbour or lie in front of it, and those behind likewise.
/// Source: chebyshevUpperBound(front, 1) and chebyshevLowerBound(behind, 0), LVSM equation 3.
vec4 lvsm_bracketMoments(vec2 front, vec2 moments, vec2 behind, float minVariance)
{
    float least = clamp(minVariance, 0.0, 1.0);
    float m1 = clamp(moments.x, 0.0, 1.0);
    float m2 = clamp(moments.y, 0.0, m1);
    float a = 1.0 - clamp(front.x, 0.0, 1.0);
    LVSM_PRECISE float second = clamp(front.y, 0.0, 1.0) - 1.0 + 2.0 * a;
    float shareInFront = min(lvsm_shareAboveZero(a, second, least), 1.0 - m1);
    float shareBehind = min(lvsm_shareAboveZero(clamp(behind.x, 0.0, 1.0), behind.y, least), m2);
    return vec4(shareBehind, max(1.0 - shareInFront - shareBehind, 0.0), m1 - shareBehind, m2 - shareBehind);
}

/// Visibility of a receiver from the moments of its layer and of the two neighbours.
/// front, moments, behind: as bracketMoments takes them. depth: the receiver's, in [0,1]. interval: begin and end of
/// the layer, which holds the receiver. minVariance: the global floor in depth squared, >= 0; the neighbours' warps are
/// taken to be as steep as the layer's, and their floor is at least 1/4096.
/// Result in [0,1]; an upper bound on the lit share of the window where layers do not overlap. Without a floor never
/// above layeredVisibility.
/// Source: bracketMoments, and chebyshevUpperBound for what is left in the layer.
float lvsm_bracketedVisibility(vec2 front, vec2 moments, vec2 behind, float depth, vec2 interval, float minVariance)
{
    float least = lvsm_layerMinVariance(minVariance, interval);
    vec4 left = lvsm_bracketMoments(front, moments, behind, max(least, LVSM_NEIGHBOUR_MIN_VARIANCE));
    float share = lvsm_chebyshevMass(left.y, left.z, left.w, lvsm_layerWarp(depth, interval), least);
    return clamp(left.x + share, 0.0, 1.0);
}

/// Visibility of a receiver from the moments of its layer and of the two neighbours, by the bound for depths in [0,1].
/// front, moments, behind: as bracketMoments takes them. depth: the receiver's, in [0,1]. interval: begin and end of
/// the layer, which holds the receiver. minVariance: the global floor in depth squared, >= 0; the neighbours' warps are
/// taken to be as steep as the layer's, and their floor is at least 1/4096.
/// Result in [0,1], never above bracketedVisibility; an upper bound on the lit share of the window where layers do not
/// overlap.
/// Source: bracketMoments, and boundedUpperBound for what is left in the layer.
float lvsm_bracketedBoundedVisibility(vec2 front, vec2 moments, vec2 behind, float depth, vec2 interval,
                                      float minVariance)
{
    float least = lvsm_layerMinVariance(minVariance, interval);
    vec4 left = lvsm_bracketMoments(front, moments, behind, max(least, LVSM_NEIGHBOUR_MIN_VARIANCE));
    float t = lvsm_layerWarp(depth, interval);
    float tail = lvsm_chebyshevMass(left.y, left.z, left.w, t, least);
    float inverse = 1.0 / max(t, LVSM_TINY);
    float parabolas = (min(left.z, left.z * t + (left.z - left.w)) + 2.25 * least * inverse) * inverse;
    float share = t > 0.0 ? min(tail, parabolas) : left.y;
    return clamp(left.x + share, 0.0, 1.0);
}

/// Visibility of a receiver from the one texel that holds both of two layers: bracketedVisibility with few operations.
/// texel: as packLayers made it, filtered. depth: the receiver's, in [0,1]; one beyond 1 is no lighter than one at 1.
/// split: between the two layers, in [0,1], clamped to it. minVariance: the global floor in depth squared, from 0 to a
/// quarter of the squared length of the receiver's layer, the largest variance there is; more is not clamped to it.
/// Result in [0,1]; an upper bound on the lit share of the window where the layers do not overlap.
/// Source: bracketedVisibility for the layer that holds the receiver, both sides multiplied by the layer's length.
float lvsm_bracketedVisibility2(vec4 texel, float depth, float split, float minVariance)
{
    // Depths are counted from the split, in units of depth, and negative in front of it: then what holds for the layer
    // behind the split holds for the one in front, and one division gives the share in the other layer.
    float middle = clamp(split, 0.0, 1.0);
    bool isBehind = depth >= middle;
    float front1 = clamp(1.0 - texel.x, 0.0, 1.0);
    float front2 = clamp(texel.y - 1.0 + 2.0 * front1, 0.0, 1.0);
    float own1 = isBehind ? texel.z : front1;
    float own2 = isBehind ? texel.w : front2;
    float other1 = isBehind ? front1 : texel.z;
    float other2 = isBehind ? front2 : texel.w;
    float reach = isBehind ? 1.0 - middle : -middle;
    float squared = reach * reach;

    float away1 = clamp(other1 * abs(reach), 0.0, 1.0);
    float away2 = clamp(other2 * squared, 0.0, 1.0);
    float least = max(minVariance, LVSM_NEIGHBOUR_MIN_VARIANCE * squared);
    float share = away1 * (away1 / max(max(away2, away1 * away1 + least), LVSM_TINY));
    float away = clamp(share, 0.0, 1.0);
    float lit = isBehind ? 0.0 : away;
    float left = 1.0 - away;

    // V and d of chebyshevUpperBound times left and left^2, so that nothing is divided by left.
    float mean = reach * own1;
    float v = max(max(left * (squared * own2) - mean * mean, left * minVariance), LVSM_TINY);
    float d = left * (depth - middle) - mean;
    float tail = v / (v + d * d);
    return clamp(lit + left * (d > 0.0 ? tail : 1.0), 0.0, 1.0);
}

/// Visibility of a receiver from the union of two neighbouring layers: what to blend to near the split between them.
/// moments: of the layer in front, filtered. next: of the layer behind it. depth: the receiver's, in [0,1].
/// begin, split, end: of the two layers, which do not overlap. minVariance: the global floor in depth squared, >= 0.
/// Result in [0,1], an upper bound on the lit share of the window; both layers see the same one, so that
/// blendTransition(visibility, mergedVisibility, 2 transitionWeight) is continuous across the split.
/// Source: mergeLayers and layeredVisibility.
float lvsm_mergedVisibility(vec2 moments, vec2 next, float depth, float begin, float split, float end,
                            float minVariance)
{
    vec2 merged = lvsm_mergeLayers(moments, next, split - begin, end - split);
    return lvsm_layeredVisibility(merged, depth, vec2(begin, end), minVariance);
}

#endif
