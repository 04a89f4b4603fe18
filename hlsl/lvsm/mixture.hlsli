// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, components.
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
#ifndef LVSM_MIXTURE_HLSLI
#define LVSM_MIXTURE_HLSLI

#include "components.hlsli"

// Bias that suits the codes: two steps of a coded depth, of which its rounding takes a half. The rest is for surfaces
// that bend, a choice and no derivation.
static const float LVSM_MIXTURE_BIAS = 0.001953125;

// The steepest coded slope: change of depth over one deviation of the filter.
static const float LVSM_MOST_CODED_RISE = 0.088388348;

// Step of a coded place, in deviations of the filter: 16 levels reach to 2.25 on each side.
static const float LVSM_PLACE_STEP = 0.3;

// Least coded deviation from a plane: half a step of a coded depth, as far as its rounding can be off.
static const float LVSM_LEAST_DEVIATION = 0.00048828125;

// Units in which codes are read: the steepest coded slope is 2^62, a depth of 1 is 2^66 / sqrt(12), and a place of one
// deviation of the filter 1 / sqrt(6).
static const float LVSM_CODE_SLOPE = 4611686018427387904.0;
static const float LVSM_CODE_DEPTH = 21300465313256689664.0;
static const float LVSM_CODE_PLACE = 0.4082482905;

/// One surface of a filter window as a receiver is compared with it.
/// weight: its share of the window, in [0,1]. place: of its taps' centroid from the texel's centre, in texels. depth:
/// of its plane at that place. slope: its change of depth per texel. deviation: of its taps from the plane, in depth.
/// Weight 0 is none.
struct lvsm_MixturePlane
{
    float weight;
    float2 place;
    float depth;
    float2 slope;
    float deviation;
};

/// The surfaces of a filter window: up to four planes.
struct lvsm_MixturePlanes
{
    lvsm_MixturePlane planes[LVSM_MAX_COMPONENTS];
};

// A receiver as codes are read. Slopes count in units of 2^-62 of the steepest coded one, of which a field that fills
// the top of a word has the square root as it is; depth, less the bias, in those units that make half a spread 1.
// place: half of the offset, in deviations, and so that slope times place is a depth. rounding: square of what a coded
// slope may be off where it is the receiver's own.
struct lvsm_CodeReceiver
{
    float depth;
    float2 slope;
    float2 place;
    float rounding;
    float bias;
};

float lvsm_filterDeviation(float deviation)
{
    return clamp(deviation, 0.25, 64.0);
}

// Sets a field of which value is in levels, the lowest of them least. Only bits below the field are set yet; they are
// read as a fraction of a level.
uint lvsm_withField(uint word, int at, int bits, float value, float least)
{
    float below = float(int(word)) / float(int(1u << uint(at)));
    float level = clamp(value - below, least, least + float(int((1u << uint(bits)) - 1u)));
    return word | ((uint(int(floor(level + 0.5))) & ((1u << uint(bits)) - 1u)) << uint(at));
}

// Slope in levels, by the signed square.
float lvsm_slopeLevel(float rise)
{
    float size = 16.0 * sqrt(abs(rise) * (1.0 / LVSM_MOST_CODED_RISE));
    return rise < 0.0 ? -size : size;
}

// Slopes of a word in units of LVSM_CODE_SLOPE.
float2 lvsm_codedSlope(uint word)
{
    float x = float(int(word << 10u));
    float y = float(int(word << 15u));
    return float2(x * abs(x), y * abs(y));
}

float2 lvsm_codedRise(uint word)
{
    return lvsm_codedSlope(word) * (LVSM_MOST_CODED_RISE / LVSM_CODE_SLOPE);
}

// Place of a word from the heaviest plane's, in units of step.
float2 lvsm_codedPlace(uint word, float unit)
{
    return float2(float(int(word & 255u)) * (unit / 16.0) - 7.96875 * unit, float(int(word & 15u)) * unit - 7.5 * unit);
}

// Share of a word of that index, counted from 1: of 15 levels up to 1 / (index + 1).
float lvsm_codedShare(uint word, int index)
{
    return float(int(word & 3840u)) * (1.0 / float(3840 * (index + 1)));
}

// Deviation of the plane of that index from the first word, in units of LVSM_LEAST_DEVIATION times 2^-55: the bits of a
// float, three of its exponent and what there is of its mantissa.
float lvsm_codedDeviation(uint word, int index, int count)
{
    int bits = 12 / count;
    int at = 12 - bits * (index + 1);
    uint level = word & (((1u << uint(bits)) - 1u) << uint(at));
    return asfloat((level << uint(26 - at - bits)) + 0x5B000000u);
}

// Level of a deviation, the nearest of those that lvsm_codedDeviation reads.
uint lvsm_deviationLevel(float deviation, int count)
{
    uint most = (1u << uint(12 / count)) - 1u;
    uint shift = count == 2 ? 20u : 23u;
    float size = clamp(deviation * (1.0 / LVSM_LEAST_DEVIATION), 1.0, 256.0);
    return min((asuint(size) - 0x3F800000u + (1u << (shift - 1u))) >> shift, most);
}

// A word of the bits below its slopes: slopes and depth of a component's plane. p: where the plane is told, and apart:
// how far that is from the heaviest one's, in deviations.
uint lvsm_planeWord(uint low, lvsm_MixtureComponent c, float2 p, float2 apart, float sigma)
{
    float2 g = lvsm_slopeOf(c);
    float2 rise = clamp(g * sigma, -LVSM_MOST_CODED_RISE, LVSM_MOST_CODED_RISE);
    uint word = lvsm_withField(low, 12, 5, lvsm_slopeLevel(rise.y), -16.0);
    word = lvsm_withField(word, 17, 5, lvsm_slopeLevel(rise.x), -16.0);
    float2 coded = lvsm_codedRise(word);
    float there = c.depth + (g.x * (p.x * sigma - c.place.x) + g.y * (p.y * sigma - c.place.y));
    return lvsm_withField(word, 22, 10, 1024.0 * (there - (coded.x * apart.x + coded.y * apart.y)), 0.0);
}

void lvsm_sortPair(inout lvsm_Mixture m, int i, int j)
{
    if (m.components[i].weight < m.components[j].weight)
    {
        lvsm_MixtureComponent lighter = m.components[i];
        m.components[i] = m.components[j];
        m.components[j] = lighter;
    }
}

// Heaviest first, with shares that add up to 1; a surface at depth 1 where there is none.
lvsm_Mixture lvsm_sorted(lvsm_Mixture mixture, int count)
{
    lvsm_Mixture m;
    float sum = 0.0;
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
    {
        m.components[i] = lvsm_noComponent();
        if (i < count)
            m.components[i] = lvsm_validComponent(mixture.components[i]);
        sum += m.components[i].weight;
    }
    if (sum < 1.0e-6)
    {
        for (int j = 1; j < LVSM_MAX_COMPONENTS; ++j)
            m.components[j] = lvsm_noComponent();
        m.components[0] = lvsm_tapComponent(1.0);
        return m;
    }
    lvsm_sortPair(m, 0, 1);
    if (count > 2)
    {
        lvsm_sortPair(m, 2, 3);
        lvsm_sortPair(m, 0, 2);
        lvsm_sortPair(m, 1, 3);
        lvsm_sortPair(m, 1, 2);
    }
    float inverse = 1.0 / sum;
    for (int k = 0; k < LVSM_MAX_COMPONENTS; ++k)
        m.components[k].weight *= inverse;
    return m;
}

// A word's bits below its slopes: share, at least one level of what is there at all, and place from the heaviest
// plane's.
uint lvsm_shareAndPlace(lvsm_MixtureComponent c, int index, float2 heaviest, float sigma)
{
    if (!(c.weight > 0.0))
        return 0u;
    float unit = 1.0 / (sigma * LVSM_PLACE_STEP);
    uint word = lvsm_withField(0u, 0, 4, (c.place.y - heaviest.y) * unit + 7.5, 0.0);
    word = lvsm_withField(word, 4, 4, (c.place.x - heaviest.x) * unit + 7.96875, 0.0);
    float level = clamp(c.weight * float(15 * (index + 1)), 1.0, 15.0);
    return word | (uint(int(floor(level + 0.5))) << 8u);
}

// Words of so many planes.
uint4 lvsm_encodePlanes(lvsm_Mixture mixture, int count, float deviation)
{
    float sigma = lvsm_filterDeviation(deviation);
    lvsm_Mixture m = lvsm_sorted(mixture, count);
    uint4 code = uint4(0u, 0u, 0u, 0u);
    float2 first = float2(0.0, 0.0);
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
    {
        if (i >= count)
            continue;
        lvsm_MixtureComponent c = m.components[i];
        int at = 12 - (12 / count) * (i + 1);
        code.x |= lvsm_deviationLevel(sqrt(lvsm_residualOf(c, lvsm_slopeOf(c))), count) << uint(at);
        if (i > 0)
        {
            code[i] = lvsm_shareAndPlace(c, i, m.components[0].place, sigma);
            first -= lvsm_codedShare(code[i], i) * lvsm_codedPlace(code[i], LVSM_PLACE_STEP);
        }
    }
    for (int k = 0; k < LVSM_MAX_COMPONENTS; ++k)
    {
        if (k >= count)
            continue;
        float2 apart = k == 0 ? float2(0.0, 0.0) : lvsm_codedPlace(code[k], LVSM_PLACE_STEP);
        code[k] = lvsm_planeWord(code[k], m.components[k], first + apart, apart, sigma);
    }
    return code;
}

/// Plane of a component, uncoded.
/// component: any; its members are clamped to their ranges. Result: a plane whose slope is known exactly.
/// Source: componentSlope, componentResidual.
lvsm_MixturePlane lvsm_componentPlane(lvsm_MixtureComponent component)
{
    lvsm_MixtureComponent c = lvsm_validComponent(component);
    float2 g = lvsm_slopeOf(c);
    lvsm_MixturePlane plane;
    plane.weight = c.weight;
    plane.place = c.place;
    plane.depth = c.depth;
    plane.slope = g;
    plane.deviation = sqrt(lvsm_residualOf(c, g));
    return plane;
}

/// Two planes in 64 bits.
/// mixture: the first two components count; members are clamped to their ranges, and shares to a sum of 1. deviation:
/// of the filter along each axis in texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: the heavier plane in x, the other in y. A mixture without any component is coded as a surface at depth 1.
uint2 lvsm_encodeMixture2(lvsm_Mixture mixture, float deviation)
{
    return lvsm_encodePlanes(mixture, 2, deviation).xy;
}

/// Four planes in 128 bits.
/// mixture: members are clamped to their ranges, and shares to a sum of 1. deviation: of the filter along each axis in
/// texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: the heaviest plane in x, the others by weight in y, z and w. A mixture without any component is coded as a
/// surface at depth 1.
uint4 lvsm_encodeMixture4(lvsm_Mixture mixture, float deviation)
{
    return lvsm_encodePlanes(mixture, 4, deviation);
}

lvsm_MixturePlane lvsm_noPlane()
{
    lvsm_MixturePlane none;
    none.weight = 0.0;
    none.place = float2(0.0, 0.0);
    none.depth = 0.0;
    none.slope = float2(0.0, 0.0);
    none.deviation = 0.0;
    return none;
}

lvsm_MixturePlanes lvsm_decodePlanes(uint4 code, int count, float deviation)
{
    float sigma = lvsm_filterDeviation(deviation);
    lvsm_MixturePlanes m;
    float shares = 0.0;
    float2 first = float2(0.0, 0.0);
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
    {
        m.planes[i] = lvsm_noPlane();
        if (i >= count)
            continue;
        float2 rise = lvsm_codedRise(code[i]);
        float2 apart = i == 0 ? float2(0.0, 0.0) : lvsm_codedPlace(code[i], LVSM_PLACE_STEP);
        float share = i == 0 ? 0.0 : lvsm_codedShare(code[i], i);
        m.planes[i].weight = share;
        m.planes[i].place = apart * sigma;
        float depth = float(code[i]) * (1.0 / 4294967296.0) + (rise.x * apart.x + rise.y * apart.y);
        m.planes[i].depth = clamp(depth, 0.0, 1.0);
        m.planes[i].slope = rise * (1.0 / sigma);
        m.planes[i].deviation = lvsm_codedDeviation(code.x, i, count) * (LVSM_LEAST_DEVIATION / 36028797018963968.0);
        shares += share;
        first -= share * m.planes[i].place;
    }
    m.planes[0].weight = max(1.0 - shares, 0.0);
    for (int k = 0; k < LVSM_MAX_COMPONENTS; ++k)
    {
        if (k < count)
            m.planes[k].place += first;
    }
    return m;
}

/// The planes that a code of 64 bits holds.
/// code: any bits; what encodeMixture2 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heavier plane first, places within 3.6 deviations, the third and fourth none.
lvsm_MixturePlanes lvsm_decodeMixture2(uint2 code, float deviation)
{
    return lvsm_decodePlanes(uint4(code, 0u, 0u), 2, deviation);
}

/// The planes that a code of 128 bits holds.
/// code: any bits; what encodeMixture4 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heaviest plane first, places within 5 deviations.
lvsm_MixturePlanes lvsm_decodeMixture4(uint4 code, float deviation)
{
    return lvsm_decodePlanes(code, 4, deviation);
}

/// Share of the window that a plane has around a receiver between texels.
/// plane: weight counts in [0,1] and place in [-256,256], clamped to them. offset: of the receiver from the texel's
/// centre, in texels, each component clamped to [-16,16]; half a texel for a map of full resolution. deviation: of the
/// filter, clamped to [0.25, 64]. Result in [-131071, 131073], below 0 where the window has left the plane. All shares
/// of a window stay 1 in sum.
/// Source: moving a Gaussian window by f tilts its weights by exp(f.p / deviation^2), here 1 + f.p / deviation^2, taken
/// at the centroid.
float lvsm_planeWeight(lvsm_MixturePlane plane, float2 offset, float deviation)
{
    float sigma = lvsm_filterDeviation(deviation);
    float2 p = clamp(plane.place, float2(-LVSM_MOST_PLACE, -LVSM_MOST_PLACE), float2(LVSM_MOST_PLACE, LVSM_MOST_PLACE));
    float2 f = clamp(offset, float2(-16.0, -16.0), float2(16.0, 16.0));
    return clamp(plane.weight, 0.0, 1.0) * (1.0 + (f.x * p.x + f.y * p.y) * (1.0 / (sigma * sigma)));
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
float2 lvsm_planeLight(lvsm_MixturePlane plane, float2 offset, float depth, float2 gradient, float deviation,
                       float bias)
{
    float sigma = lvsm_filterDeviation(deviation);
    float2 p = clamp(plane.place, float2(-LVSM_MOST_PLACE, -LVSM_MOST_PLACE), float2(LVSM_MOST_PLACE, LVSM_MOST_PLACE));
    float2 f = clamp(offset, float2(-16.0, -16.0), float2(16.0, 16.0));
    float2 g = clamp(gradient, float2(-1.0, -1.0), float2(1.0, 1.0));
    float2 d = clamp(plane.slope, float2(-1.0, -1.0), float2(1.0, 1.0)) - g;
    float r = clamp(plane.deviation, 0.0, 1.0);
    LVSM_PRECISE float own = clamp(depth, 0.0, 1.0) + (g.x * (p.x - f.x) + g.y * (p.y - f.y));
    LVSM_PRECISE float behind = (clamp(plane.depth, 0.0, 1.0) - own) + 0.5 * (d.x * f.x + d.y * f.y);
    float variance = 0.5 * (sigma * sigma) * (d.x * d.x + d.y * d.y) + r * r;
    float lit = 0.5 + (behind + 0.6 * r + clamp(bias, 0.0, 1.0)) * rsqrt(12.0 * max(variance, 1.0e-10));
    return float2(clamp(lit, 0.0, 1.0), behind);
}

// planeLight of a word, the distance in units of LVSM_CODE_DEPTH. apart: the plane's place from the heaviest one's and
// half of the offset; deviation: in the units of lvsm_codedDeviation.
float2 lvsm_lightOfWord(uint word, float deviation, float2 apart, lvsm_CodeReceiver r)
{
    float2 d = lvsm_codedSlope(word) - r.slope;
    float variance = max(d.x * d.x + d.y * d.y - r.rounding, 0.0) + deviation * deviation;
    float behind = float(word) * (LVSM_CODE_DEPTH / 4294967296.0) - r.depth + (d.x * apart.x + d.y * apart.y);
    return float2(clamp(0.5 + (behind + 0.17320508 * deviation) * rsqrt(variance), 0.0, 1.0), behind);
}

lvsm_CodeReceiver lvsm_codeReceiver(float2 offset, float depth, float2 gradient, float sigma, float bias)
{
    lvsm_CodeReceiver r;
    float2 f = clamp(offset, float2(-16.0, -16.0), float2(16.0, 16.0)) * (LVSM_CODE_PLACE / sigma);
    float2 g = gradient * (sigma * (LVSM_CODE_SLOPE / LVSM_MOST_CODED_RISE));
    r.slope = clamp(g, float2(-LVSM_CODE_SLOPE, -LVSM_CODE_SLOPE), float2(LVSM_CODE_SLOPE, LVSM_CODE_SLOPE));
    r.place = 0.5 * f;
    r.bias = clamp(bias, 0.0, 1.0) * LVSM_CODE_DEPTH;
    r.depth = clamp(depth, 0.0, 1.0) * LVSM_CODE_DEPTH - r.bias - (r.slope.x * f.x + r.slope.y * f.y);
    // A slope u^2 is off by half a level of u at most, (2 u + 1/32) / 32, the square of which is less than
    // (8 u^2 + 2 / 32^2) / 32^2.
    r.rounding = (abs(r.slope.x) + abs(r.slope.y)) * 36028797018963968.0 + 81129638414606681695789005144064.0;
    return r;
}

// Sums over the planes of a code: lit weight, weight in shadow, and that times the distance in front of the receiver.
float3 lvsm_sumsOfCode(uint4 code, int count, float2 offset, float depth, float2 gradient, float deviation, float bias)
{
    lvsm_CodeReceiver r = lvsm_codeReceiver(offset, depth, gradient, lvsm_filterDeviation(deviation), bias);
    float turned = r.slope.x * r.place.x + r.slope.y * r.place.y;
    float moved = 12.0 * (r.place.x * r.place.x + r.place.y * r.place.y);
    float shares[LVSM_MAX_COMPONENTS];
    float tilts[LVSM_MAX_COMPONENTS];
    float2 apart[LVSM_MAX_COMPONENTS];
    float tilt = 1.0;
    for (int i = 1; i < LVSM_MAX_COMPONENTS; ++i)
    {
        if (i >= count)
            continue;
        apart[i] = lvsm_codedPlace(code[i], LVSM_PLACE_STEP * LVSM_CODE_PLACE) + r.place;
        shares[i] = lvsm_codedShare(code[i], i);
        tilts[i] = 12.0 * (r.place.x * apart[i].x + r.place.y * apart[i].y) - moved;
        tilt -= shares[i] * tilts[i];
        r.depth -= shares[i] * (r.slope.x * apart[i].x + r.slope.y * apart[i].y - turned);
    }
    float2 first = lvsm_lightOfWord(code.x, lvsm_codedDeviation(code.x, 0, count), r.place, r);
    float lit = first.x;
    float left = 1.0;
    float2 dark = float2(0.0, 0.0);
    for (int k = 1; k < LVSM_MAX_COMPONENTS; ++k)
    {
        if (k >= count)
            continue;
        float2 light = lvsm_lightOfWord(code[k], lvsm_codedDeviation(code.x, k, count), apart[k], r);
        float weight = shares[k] * (tilt + tilts[k]);
        lit += weight * (light.x - first.x);
        left -= weight;
        float unlit = max(weight, 0.0) * (1.0 - light.x);
        dark += float2(unlit, unlit * max(r.bias - light.y, 0.0));
    }
    float unlit = max(left, 0.0) * (1.0 - first.x);
    dark += float2(unlit, unlit * max(r.bias - first.y, 0.0));
    return float3(clamp(lit, 0.0, 1.0), dark.x, dark.y * (1.0 / LVSM_CODE_DEPTH));
}

float lvsm_occluderOfSums(float3 sums, float depth)
{
    float away = sums.y < 1.0e-12 ? 0.0 : sums.z / max(sums.y, 1.0e-12);
    return clamp(clamp(depth, 0.0, 1.0) - away, 0.0, 1.0);
}

/// Visibility of a receiver from a code of 64 bits.
/// code: any bits, not filtered. offset: of the receiver from the code's place, in texels of the shadow map, each
/// component clamped to [-16,16]: at most half a texel for a nearest fetch from a map of full resolution, one of half
/// resolution. depth: the receiver's, in [0,1], clamped to it. gradient: its change per texel of the shadow map;
/// steeper than LVSM_MOST_CODED_RISE over a deviation of the filter counts as that. deviation: of the filter, clamped
/// to [0.25, 64]. bias: in depth, clamped to [0,1], see LVSM_MIXTURE_BIAS. Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight; a difference of slopes counts as far as it exceeds what a
/// slope's rounding can be off.
float lvsm_mixtureVisibility2(uint2 code, float2 offset, float depth, float2 gradient, float deviation, float bias)
{
    return lvsm_sumsOfCode(uint4(code, 0u, 0u), 2, offset, depth, gradient, deviation, bias).x;
}

/// Visibility of a receiver from a code of 128 bits.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
float lvsm_mixtureVisibility4(uint4 code, float2 offset, float depth, float2 gradient, float deviation, float bias)
{
    return lvsm_sumsOfCode(code, 4, offset, depth, gradient, deviation, bias).x;
}

/// Mean depth of what is in front of a receiver, from a code of 64 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
float lvsm_mixtureOccluder2(uint2 code, float2 offset, float depth, float2 gradient, float deviation, float bias)
{
    float3 sums = lvsm_sumsOfCode(uint4(code, 0u, 0u), 2, offset, depth, gradient, deviation, bias);
    return lvsm_occluderOfSums(sums, depth);
}

/// Mean depth of what is in front of a receiver, from a code of 128 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
float lvsm_mixtureOccluder4(uint4 code, float2 offset, float depth, float2 gradient, float deviation, float bias)
{
    return lvsm_occluderOfSums(lvsm_sumsOfCode(code, 4, offset, depth, gradient, deviation, bias), depth);
}

#endif
