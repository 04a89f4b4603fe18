// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config.
// Components of a mixture of planes: what a filter window sees of one surface, and how many of them become few.
//
// A component holds the moments of its taps, of first and second order in place and depth, which merge exactly. A window
// starts with a component a tap; insertComponent merges the two that are cheapest to merge whenever there are more than
// count. Windows grow as a tree: mixtureStep mixes the mixtures of three texels, 1/4, 1/2 and 1/4, along x and along y, a
// step apart that doubles; after n rounds that is a window of 2^(n + 1) - 1 texels, and mixtureDeviation is its
// deviation. The topic mixture codes the result and judges receivers by it.
#ifndef LVSM_COMPONENTS_GLSL
#define LVSM_COMPONENTS_GLSL

#include "config.glsl"

// Most components of a mixture.
const int LVSM_MAX_COMPONENTS = 4;

// Largest place of a component in texels, and largest spread.
const float LVSM_MOST_PLACE = 256.0;
const float LVSM_MOST_SPREAD = 65536.0;

/// The part of a filter window that one surface covers, as moments of its taps.
/// weight: its share of the window, in [0,1]. place: mean place of its taps from the texel's centre, in texels, in
/// [-256,256]. depth: their mean, in [0,1]. spread: covariance of place, xx, xy and yy. tilt: covariance of place and
/// depth. variance: of depth. A component of weight 0 is none.
struct lvsm_MixtureComponent
{
    float weight;
    vec2 place;
    float depth;
    vec3 spread;
    vec2 tilt;
    float variance;
};

/// What a filter window sees: up to four components, in any order.
struct lvsm_Mixture
{
    lvsm_MixtureComponent components[LVSM_MAX_COMPONENTS];
};

lvsm_MixtureComponent lvsm_noComponent()
{
    lvsm_MixtureComponent none;
    none.weight = 0.0;
    none.place = vec2(0.0);
    none.depth = 0.0;
    none.spread = vec3(0.0);
    none.tilt = vec2(0.0);
    none.variance = 0.0;
    return none;
}

// Every member in its documented range.
lvsm_MixtureComponent lvsm_validComponent(lvsm_MixtureComponent c)
{
    lvsm_MixtureComponent valid;
    valid.weight = clamp(c.weight, 0.0, 1.0);
    valid.place = clamp(c.place, vec2(-LVSM_MOST_PLACE), vec2(LVSM_MOST_PLACE));
    valid.depth = clamp(c.depth, 0.0, 1.0);
    valid.spread = clamp(c.spread, vec3(0.0, -LVSM_MOST_SPREAD, 0.0), vec3(LVSM_MOST_SPREAD));
    valid.tilt = clamp(c.tilt, vec2(-LVSM_MOST_PLACE), vec2(LVSM_MOST_PLACE));
    valid.variance = clamp(c.variance, 0.0, 1.0);
    return valid;
}

lvsm_MixtureComponent lvsm_merged(lvsm_MixtureComponent a, lvsm_MixtureComponent b)
{
    float sum = a.weight + b.weight;
    float inverse = 1.0 / max(sum, LVSM_TINY);
    float first = a.weight * inverse;
    float second = b.weight * inverse;
    vec2 p = b.place - a.place;
    float z = b.depth - a.depth;
    vec2 side = first * second * p;
    lvsm_MixtureComponent c;
    c.weight = sum;
    c.place = a.place + second * p;
    c.depth = a.depth + second * z;
    c.spread = first * a.spread + second * b.spread + vec3(side.x * p.x, side.x * p.y, side.y * p.y);
    c.tilt = first * a.tilt + second * b.tilt + side * z;
    c.variance = first * a.variance + second * b.variance + first * second * z * z;
    return c;
}

vec2 lvsm_slopeOf(lvsm_MixtureComponent c)
{
    float ridge = max(0.5 - 0.5 * c.weight, 0.000244140625);
    float xx = c.spread.x + ridge;
    float yy = c.spread.z + ridge;
    LVSM_PRECISE float determinant = max(xx * yy - c.spread.y * c.spread.y, ridge * ridge);
    LVSM_PRECISE vec2 solved = vec2(yy * c.tilt.x - c.spread.y * c.tilt.y, xx * c.tilt.y - c.spread.y * c.tilt.x);
    return clamp(solved / determinant, vec2(-1.0), vec2(1.0));
}

float lvsm_residualOf(lvsm_MixtureComponent c, vec2 g)
{
    LVSM_PRECISE float x = g.x * (g.x * c.spread.x + g.y * c.spread.y - 2.0 * c.tilt.x);
    LVSM_PRECISE float y = g.y * (g.x * c.spread.y + g.y * c.spread.z - 2.0 * c.tilt.y);
    LVSM_PRECISE float rest = c.variance + (x + y);
    return max(rest, 0.0);
}

// What a component costs: its weight times the deviation from its plane.
float lvsm_costOf(lvsm_MixtureComponent c)
{
    return c.weight * sqrt(lvsm_residualOf(c, lvsm_slopeOf(c)) + 1.0e-8);
}

// Adds a valid component to so many valid ones, of which costs are costOf: where one is none, in its place. Loops end
// where a compiler sees it and return nowhere, so that they are unrolled and components stay in registers.
void lvsm_insertValid(inout lvsm_Mixture mixture, inout float costs[LVSM_MAX_COMPONENTS], int count,
                      lvsm_MixtureComponent added)
{
    if (!(added.weight > 0.0))
        return;
    // Pairs (m, n), where n = count stands for the new component.
    float addedCost = lvsm_costOf(added);
    float least = 2.0e30;
    float cost = addedCost;
    int first = 0;
    int second = count;
    for (int m = 0; m < LVSM_MAX_COMPONENTS; ++m)
    {
        for (int n = 1; n < LVSM_MAX_COMPONENTS; ++n)
        {
            if (n > m && n < count)
            {
                float both = lvsm_costOf(lvsm_merged(mixture.components[m], mixture.components[n]));
                float price = both - (costs[m] + costs[n]);
                if (price < least)
                {
                    least = price;
                    cost = both;
                    first = m;
                    second = n;
                }
            }
        }
        if (m < count)
        {
            float both = lvsm_costOf(lvsm_merged(mixture.components[m], added));
            bool isRoom = !(mixture.components[m].weight > 0.0);
            float price = isRoom ? -1.0e30 : both - (costs[m] + addedCost);
            if (price < least)
            {
                least = price;
                cost = isRoom ? addedCost : both;
                first = m;
                second = count;
            }
        }
    }
    lvsm_MixtureComponent chosen = mixture.components[0];
    lvsm_MixtureComponent partner = added;
    for (int k = 1; k < LVSM_MAX_COMPONENTS; ++k)
    {
        if (k == first)
            chosen = mixture.components[k];
        if (k == second && k < count)
        {
            partner = mixture.components[k];
            mixture.components[k] = added;
            costs[k] = addedCost;
        }
    }
    lvsm_MixtureComponent both = partner;
    if (chosen.weight > 0.0)
        both = lvsm_merged(chosen, partner);
    for (int f = 0; f < LVSM_MAX_COMPONENTS; ++f)
    {
        if (f == first && f < count)
        {
            mixture.components[f] = both;
            costs[f] = cost;
        }
    }
}

/// Standard deviation of the tree's window along each axis, in texels.
/// rounds: of the tree, each three texels along x and three along y, from 0 to 7, clamped to it: widths 1, 3, 7, 15,
/// 31 and so on. Result in [0, 52.26].
/// Source: a step of s texels with weights 1/4, 1/2, 1/4 adds the variance s^2 / 2; the steps are 1, 2, 4 and so on.
float lvsm_mixtureDeviation(int rounds)
{
    float variance = 0.0;
    float extent = 1.0;
    for (int i = 0; i < 7; ++i)
    {
        if (i < rounds)
            variance += 0.5 * extent;
        extent *= 4.0;
    }
    return variance > 0.0 ? sqrt(variance) : 0.0;
}

/// Component of one tap: a point.
/// depth: in [0,1], clamped to it. Result: all of the window, at the texel's centre.
lvsm_MixtureComponent lvsm_tapComponent(float depth)
{
    lvsm_MixtureComponent tap = lvsm_noComponent();
    tap.weight = 1.0;
    tap.depth = clamp(depth, 0.0, 1.0);
    return tap;
}

/// Component of one texel whose surface slopes: a square of one texel in the surface's plane.
/// depth: in the middle of the texel, in [0,1], clamped to it. gradient: change of depth per texel, each component
/// clamped to [-1,1]; 0 where the surface ends inside the texel. Result: all of the window, at the texel's centre.
/// Source: the moments of a plane over a square, whose variance along each side is 1/12.
lvsm_MixtureComponent lvsm_slopedComponent(float depth, vec2 gradient)
{
    float part = 1.0 / 12.0;
    vec2 g = clamp(gradient, vec2(-1.0), vec2(1.0));
    lvsm_MixtureComponent texel = lvsm_tapComponent(depth);
    texel.spread = vec3(part, 0.0, part);
    texel.tilt = part * g;
    texel.variance = part * (g.x * g.x + g.y * g.y);
    return texel;
}

/// Component seen from another texel's window.
/// component: any; its members are clamped to their ranges. offset: from the window's centre to the component's old one,
/// in texels, each component clamped to [-256,256]. share: of the old window in the new one, in [0,1], clamped to it.
/// Result: a component; its place is clamped to [-256,256].
/// Source: central moments do not depend on the centre that places are counted from.
lvsm_MixtureComponent lvsm_moveComponent(lvsm_MixtureComponent component, vec2 offset, float share)
{
    lvsm_MixtureComponent moved = lvsm_validComponent(component);
    vec2 most = vec2(LVSM_MOST_PLACE);
    moved.weight = moved.weight * clamp(share, 0.0, 1.0);
    moved.place = clamp(moved.place + clamp(offset, -most, most), -most, most);
    return moved;
}

/// Two components as one: the moments of all their taps, exactly.
/// first, second: any; their members are clamped to their ranges. Result: a component whose weight is the sum, in [0,2],
/// spread in [-131072,131072], tilt in [-512,512] and variance in [0,2].
/// Degenerate: two of weight 0 give first with weight 0.
/// Source: pairwise central moments, Chan, Golub & LeVeque 1979.
lvsm_MixtureComponent lvsm_mergeComponents(lvsm_MixtureComponent first, lvsm_MixtureComponent second)
{
    lvsm_MixtureComponent a = lvsm_validComponent(first);
    lvsm_MixtureComponent b = lvsm_validComponent(second);
    if (a.weight + b.weight < LVSM_TINY)
    {
        a.weight = 0.0;
        return a;
    }
    return lvsm_merged(a, b);
}

/// Slope of the plane that fits a component best.
/// component: any; its members are clamped to their ranges. Result: change of depth per texel, each in [-1,1].
/// Degenerate: a lone tap has no slope: (0, 0).
/// Source: least squares with a ridge of (1 - weight) / 2 texels squared, which keeps few taps from wild slopes and
/// spares a full window; it is 2^-12 at least.
vec2 lvsm_componentSlope(lvsm_MixtureComponent component)
{
    return lvsm_slopeOf(lvsm_validComponent(component));
}

/// Mean squared distance, in depth, of a component's taps from a plane through its centroid.
/// component: any; its members are clamped to their ranges. slope: of the plane per texel, each component clamped to
/// [-1,1]. Result in depth squared, in [0, 263170].
/// Source: E[(z - g.p)^2] of central moments.
float lvsm_componentResidual(lvsm_MixtureComponent component, vec2 slope)
{
    return lvsm_residualOf(lvsm_validComponent(component), clamp(slope, vec2(-1.0), vec2(1.0)));
}

/// What merging two components costs: by how much the weighed deviations from the planes grow.
/// first, second: any; their members are clamped to their ranges. Result in [-1,1], 0 or more for what taps made,
/// but for rounding and the ridge.
/// Source: W sqrt(R + e^2) of the merged less that of the two, R from componentResidual and e = 1e-4, under which
/// deviations do not count.
float lvsm_mergePrice(lvsm_MixtureComponent first, lvsm_MixtureComponent second)
{
    lvsm_MixtureComponent a = lvsm_validComponent(first);
    lvsm_MixtureComponent b = lvsm_validComponent(second);
    float price = lvsm_costOf(lvsm_merged(a, b)) - (lvsm_costOf(a) + lvsm_costOf(b));
    return clamp(price, -1.0, 1.0);
}

/// Adds a component to a mixture; where there is no room for it, the two of all that cost least to merge are merged.
/// mixture: any, changed in place; members are clamped to their ranges. component: any; nothing happens where its weight
/// is 0. count: of components that the mixture may have, from 1 to 4, clamped to it; the others are not read.
/// The moments of the whole stay what they were. Of equal prices the first counts, in the order of the mixture with the
/// new component last.
/// Source: greedy agglomeration by mergePrice.
void lvsm_insertComponent(inout lvsm_Mixture mixture, lvsm_MixtureComponent component, int count)
{
    int last = clamp(count, 1, LVSM_MAX_COMPONENTS);
    lvsm_MixtureComponent added = lvsm_validComponent(component);
    if (!(added.weight > 0.0))
        return;
    float costs[LVSM_MAX_COMPONENTS];
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
    {
        costs[i] = 0.0;
        if (i < last)
        {
            mixture.components[i] = lvsm_validComponent(mixture.components[i]);
            costs[i] = lvsm_costOf(mixture.components[i]);
        }
    }
    lvsm_insertValid(mixture, costs, last, added);
}

/// A step of the tree: a texel's mixture of its own and of those of two others, one on each side.
/// middle, before, after: any; members are clamped to their ranges. offset: from the texel to the one after it, and back
/// to the one before it, in texels, each component clamped to [-256,256]. share: of the window that each of the outer two
/// gets, 1/4 in the tree, in [0,0.5], clamped to it. count: of components that each mixture may have, from 1 to 4,
/// clamped to it; the others are not read. Result: so many components, the others none.
/// The moments of the whole are those of all three. Source: insertComponent of the middle's components, then of those
/// before and after, with a component's plane fitted once.
lvsm_Mixture lvsm_mixtureStep(lvsm_Mixture middle, lvsm_Mixture before, lvsm_Mixture after, vec2 offset, float share,
                              int count)
{
    int last = clamp(count, 1, LVSM_MAX_COMPONENTS);
    float outer = clamp(share, 0.0, 0.5);
    lvsm_Mixture mixed;
    float costs[LVSM_MAX_COMPONENTS];
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
    {
        mixed.components[i] = lvsm_noComponent();
        if (i < last)
            mixed.components[i] = lvsm_moveComponent(middle.components[i], vec2(0.0), 1.0 - 2.0 * outer);
        costs[i] = lvsm_costOf(mixed.components[i]);
    }
    for (int b = 0; b < LVSM_MAX_COMPONENTS; ++b)
    {
        if (b < last)
            lvsm_insertValid(mixed, costs, last, lvsm_moveComponent(before.components[b], -offset, outer));
    }
    for (int a = 0; a < LVSM_MAX_COMPONENTS; ++a)
    {
        if (a < last)
            lvsm_insertValid(mixed, costs, last, lvsm_moveComponent(after.components[a], offset, outer));
    }
    return mixed;
}

/// Makes one of components that are one surface: those whose merging costs less than any code tells.
/// mixture: any, changed in place; members are clamped to their ranges. count: of components, from 1 to 4, clamped to it;
/// the others are not read. All are merged where that costs less than 1e-4, or else pairs, in the order of the mixture;
/// what is merged into another becomes none. Do so before coding: a surface that fills a window is then one plane, whose
/// slope is known best.
/// Source: mergePrice; a tenth of a step of a coded depth.
void lvsm_simplifyMixture(inout lvsm_Mixture mixture, int count)
{
    int last = clamp(count, 1, LVSM_MAX_COMPONENTS);
    lvsm_MixtureComponent whole = lvsm_validComponent(mixture.components[0]);
    float costs = lvsm_costOf(whole);
    mixture.components[0] = whole;
    for (int k = 1; k < LVSM_MAX_COMPONENTS; ++k)
    {
        if (k < last)
        {
            mixture.components[k] = lvsm_validComponent(mixture.components[k]);
            whole = lvsm_merged(whole, mixture.components[k]);
            costs += lvsm_costOf(mixture.components[k]);
        }
    }
    bool isOne = lvsm_costOf(whole) - costs < 1.0e-4;
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
    {
        for (int j = 1; j < LVSM_MAX_COMPONENTS; ++j)
        {
            if (j > i && j < last)
            {
                lvsm_MixtureComponent a = mixture.components[i];
                lvsm_MixtureComponent b = mixture.components[j];
                lvsm_MixtureComponent both = lvsm_merged(a, b);
                float price = lvsm_costOf(both) - (lvsm_costOf(a) + lvsm_costOf(b));
                if (a.weight > 0.0 && b.weight > 0.0 && (isOne || price < 1.0e-4))
                {
                    mixture.components[i] = both;
                    mixture.components[j] = lvsm_noComponent();
                }
            }
        }
    }
}

/// Mixture of four taps of a texel: multisampled depths, or 2 x 2 texels of a map that is kept at half resolution.
/// depths: each in [0,1], clamped to it. x, y: places of the taps from the texel's centre, in texels, each component
/// clamped to [-256,256]. count: of components, as insertComponent takes it. Result: each tap weighs 1/4.
lvsm_Mixture lvsm_mixtureOfTaps(vec4 depths, vec4 x, vec4 y, int count)
{
    lvsm_Mixture mixture;
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
        mixture.components[i] = lvsm_noComponent();
    lvsm_insertComponent(mixture, lvsm_moveComponent(lvsm_tapComponent(depths.x), vec2(x.x, y.x), 0.25), count);
    lvsm_insertComponent(mixture, lvsm_moveComponent(lvsm_tapComponent(depths.y), vec2(x.y, y.y), 0.25), count);
    lvsm_insertComponent(mixture, lvsm_moveComponent(lvsm_tapComponent(depths.z), vec2(x.z, y.z), 0.25), count);
    lvsm_insertComponent(mixture, lvsm_moveComponent(lvsm_tapComponent(depths.w), vec2(x.w, y.w), 0.25), count);
    return mixture;
}

#endif
