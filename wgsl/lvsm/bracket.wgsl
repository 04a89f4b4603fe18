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

// Least variance floor of a neighbour in its warp, (1/64)^2: nearer to the split than about 1/64 of a layer nothing is
// surely beyond it. That covers the rounding of moments to unorm16, three half steps of the second moment about the
// split for each time they are rounded, which would otherwise make a share in front out of nothing.
const LVSM_NEIGHBOUR_MIN_VARIANCE: f32 = 0.000244140625;

/// Moments of the union of two neighbouring layers that do not overlap, from the moments of the two.
/// moments: of the layer in front, filtered. next: of the layer behind it. extent, nextExtent: lengths of the two, in
/// [0,1], clamped to it. Result: (M1, M2) of the layer that covers both, each in [0,1].
/// Degenerate: two empty layers give moments.
/// Source: the warp of the union is (extent phi + nextExtent phiNext) / (extent + nextExtent), and phiNext > 0 implies
/// phi = 1, so that E[phi phiNext] = E[phiNext].
fn lvsm_mergeLayers(moments: vec2f, next: vec2f, extent: f32, nextExtent: f32) -> vec2f
{
    let a = clamp(extent, 0.0, 1.0);
    let b = clamp(nextExtent, 0.0, 1.0);
    let sum = a + b;
    let behind = select(min(b / sum, 1.0), 0.0, sum < LVSM_TINY);
    let inFront = 1.0 - behind;
    let m1 = inFront * moments.x + behind * next.x;
    let m2 = inFront * inFront * moments.y + behind * (behind * next.y + (2.0 * inFront) * next.x);
    return clamp(vec2f(m1, m2), vec2f(0.0), vec2f(1.0));
}

/// Layer moments in the basis that suits few bits: the mean and four times the mean of x (1 - x).
/// moments: (M1, M2) of a layer. Result: (M1, 4 (M1 - M2)), each in [0,1] and filtered as linearly as the moments.
/// A layer that is all in front or all behind is an exact code of any unorm format, and a texel without any surface
/// stores (1, 0).
fn lvsm_compactMoments(moments: vec2f) -> vec2f
{
    let valid = clamp(moments, vec2f(0.0), vec2f(1.0));
    return vec2f(valid.x, clamp(4.0 * (valid.x - valid.y), 0.0, 1.0));
}

/// Layer moments out of the basis that suits few bits.
/// compact: as compactMoments made it, filtered, in [0,1], clamped to it. Result: (M1, M2), each in [0,1].
fn lvsm_expandMoments(compact: vec2f) -> vec2f
{
    let valid = clamp(compact, vec2f(0.0), vec2f(1.0));
    return vec2f(valid.x, max(valid.x - 0.25 * valid.y, 0.0));
}

// Share of a window whose depth is above 0, at least, for depths in [0,1] with a floor of their variance:
// 1 - v / (v + m1^2). Multiplied in an order that makes any finite arguments safe.
fn lvsm_shareAboveZero(m1: f32, m2: f32, minVariance: f32) -> f32
{
    let second = max(m2, m1 * m1 + minVariance);
    return clamp(m1 * (m1 / clamp(second, LVSM_TINY, LVSM_HUGE)), 0.0, 1.0);
}

// A mass that has the sums of moments (m1, m2), and of it the most that can be at t or farther: chebyshevUpperBound of
// its mean moments, times the mass, without dividing by the mass.
fn lvsm_chebyshevMass(mass: f32, m1: f32, m2: f32, t: f32, minVariance: f32) -> f32
{
    let difference = mass * m2 - m1 * m1;
    let v = max(difference, mass * minVariance);
    let d = mass * t - m1;
    let tail = clamp(v / max(v + d * d, LVSM_TINY), 0.0, 1.0);
    return select(mass, mass * tail, d > 0.0);
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
fn lvsm_bracketMoments(front: vec2f, moments: vec2f, behind: vec2f, minVariance: f32) -> vec4f
{
    let least = clamp(minVariance, 0.0, 1.0);
    let m1 = clamp(moments.x, 0.0, 1.0);
    let m2 = clamp(moments.y, 0.0, m1);
    let a = 1.0 - clamp(front.x, 0.0, 1.0);
    let second = clamp(front.y, 0.0, 1.0) - 1.0 + 2.0 * a;
    let shareInFront = min(lvsm_shareAboveZero(a, second, least), 1.0 - m1);
    let shareBehind = min(lvsm_shareAboveZero(clamp(behind.x, 0.0, 1.0), behind.y, least), m2);
    return vec4f(shareBehind, max(1.0 - shareInFront - shareBehind, 0.0), m1 - shareBehind, m2 - shareBehind);
}

/// Visibility of a receiver from the moments of its layer and of the two neighbours.
/// front, moments, behind: as bracketMoments takes them. depth: the receiver's, in [0,1]. interval: begin and end of
/// the layer, which holds the receiver. minVariance: the global floor in depth squared, >= 0; the neighbours' warps are
/// taken to be as steep as the layer's, and their floor is at least 1/4096.
/// Result in [0,1]; an upper bound on the lit share of the window where layers do not overlap. Without a floor never
/// above layeredVisibility.
/// Source: bracketMoments, and chebyshevUpperBound for what is left in the layer.
fn lvsm_bracketedVisibility(front: vec2f, moments: vec2f, behind: vec2f, depth: f32, interval: vec2f,
                            minVariance: f32) -> f32
{
    let least = lvsm_layerMinVariance(minVariance, interval);
    let left = lvsm_bracketMoments(front, moments, behind, max(least, LVSM_NEIGHBOUR_MIN_VARIANCE));
    let share = lvsm_chebyshevMass(left.y, left.z, left.w, lvsm_layerWarp(depth, interval), least);
    return clamp(left.x + share, 0.0, 1.0);
}

/// Visibility of a receiver from the moments of its layer and of the two neighbours, by the bound for depths in [0,1].
/// front, moments, behind: as bracketMoments takes them. depth: the receiver's, in [0,1]. interval: begin and end of
/// the layer, which holds the receiver. minVariance: the global floor in depth squared, >= 0; the neighbours' warps are
/// taken to be as steep as the layer's, and their floor is at least 1/4096.
/// Result in [0,1], never above bracketedVisibility; an upper bound on the lit share of the window where layers do not
/// overlap.
/// Source: bracketMoments, and boundedUpperBound for what is left in the layer.
fn lvsm_bracketedBoundedVisibility(front: vec2f, moments: vec2f, behind: vec2f, depth: f32, interval: vec2f,
                                   minVariance: f32) -> f32
{
    let least = lvsm_layerMinVariance(minVariance, interval);
    let left = lvsm_bracketMoments(front, moments, behind, max(least, LVSM_NEIGHBOUR_MIN_VARIANCE));
    let t = lvsm_layerWarp(depth, interval);
    let tail = lvsm_chebyshevMass(left.y, left.z, left.w, t, least);
    let inverse = 1.0 / max(t, LVSM_TINY);
    let parabolas = (min(left.z, left.z * t + (left.z - left.w)) + 2.25 * least * inverse) * inverse;
    let share = select(left.y, min(tail, parabolas), t > 0.0);
    return clamp(left.x + share, 0.0, 1.0);
}

/// Visibility of a receiver from the one texel that holds both of two layers: bracketedVisibility with few operations.
/// texel: as packLayers made it, filtered. depth: the receiver's, in [0,1]; one beyond 1 is no lighter than one at 1.
/// split: between the two layers, in [0,1], clamped to it. minVariance: the global floor in depth squared, from 0 to a
/// quarter of the squared length of the receiver's layer, the largest variance there is; more is not clamped to it.
/// Result in [0,1]; an upper bound on the lit share of the window where the layers do not overlap.
/// Source: bracketedVisibility for the layer that holds the receiver, both sides multiplied by the layer's length.
fn lvsm_bracketedVisibility2(texel: vec4f, depth: f32, split: f32, minVariance: f32) -> f32
{
    // Depths are counted from the split, in units of depth, and negative in front of it: then what holds for the layer
    // behind the split holds for the one in front, and one division gives the share in the other layer.
    let middle = clamp(split, 0.0, 1.0);
    let isBehind = depth >= middle;
    let front1 = clamp(1.0 - texel.x, 0.0, 1.0);
    let front2 = clamp(texel.y - 1.0 + 2.0 * front1, 0.0, 1.0);
    let own1 = select(front1, texel.z, isBehind);
    let own2 = select(front2, texel.w, isBehind);
    let other1 = select(texel.z, front1, isBehind);
    let other2 = select(texel.w, front2, isBehind);
    let reach = select(-middle, 1.0 - middle, isBehind);
    let squared = reach * reach;

    let away1 = clamp(other1 * abs(reach), 0.0, 1.0);
    let away2 = clamp(other2 * squared, 0.0, 1.0);
    let least = max(minVariance, LVSM_NEIGHBOUR_MIN_VARIANCE * squared);
    let share = away1 * (away1 / max(max(away2, away1 * away1 + least), LVSM_TINY));
    let away = clamp(share, 0.0, 1.0);
    let lit = select(away, 0.0, isBehind);
    let left = 1.0 - away;

    // V and d of chebyshevUpperBound times left and left^2, so that nothing is divided by left.
    let mean = reach * own1;
    let v = max(max(left * (squared * own2) - mean * mean, left * minVariance), LVSM_TINY);
    let d = left * (depth - middle) - mean;
    let tail = v / (v + d * d);
    return clamp(lit + left * select(1.0, tail, d > 0.0), 0.0, 1.0);
}

/// Visibility of a receiver from the union of two neighbouring layers: what to blend to near the split between them.
/// moments: of the layer in front, filtered. next: of the layer behind it. depth: the receiver's, in [0,1].
/// begin, split, end: of the two layers, which do not overlap. minVariance: the global floor in depth squared, >= 0.
/// Result in [0,1], an upper bound on the lit share of the window; both layers see the same one, so that
/// blendTransition(visibility, mergedVisibility, 2 transitionWeight) is continuous across the split.
/// Source: mergeLayers and layeredVisibility.
fn lvsm_mergedVisibility(moments: vec2f, next: vec2f, depth: f32, begin: f32, split: f32, end: f32,
                         minVariance: f32) -> f32
{
    let merged = lvsm_mergeLayers(moments, next, split - begin, end - split);
    return lvsm_layeredVisibility(merged, depth, vec2f(begin, end), minVariance);
}
