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
// Two codes: two planes in 64 bits, four in 128. A plane is its depth at its coded place, in 10 bits, its slope, by sign
// and cube root, and its deviation, by the square root. All planes but the heaviest have their share, their place
// and the spread of their taps too; the heaviest takes what is left, since all shares add up to 1, all places to 0 and
// all spreads to the window's. A slope is read as the one nearest to the receiver's of those that its code stands for:
// so a surface is not its own shadow however coarse the code is.
#ifndef LVSM_MIXTURE_GLSL
#define LVSM_MIXTURE_GLSL

#include "components.glsl"

// Bias that suits the codes: two steps of a coded depth, of which its rounding takes a half. The rest is for surfaces
// that bend, a choice and no derivation.
const float LVSM_MIXTURE_BIAS = 0.00195503;

// The steepest slope that a code tells from steeper ones, in depth per texel.
const float LVSM_MOST_CODED_SLOPE = 0.0625;

// Levels of a coded place on each side of 0, which reach to two deviations of the filter.
const int LVSM_PLACE_LEVELS = 7;

// Deviation of a component's taps along an axis, in that of the filter: 0.3, 0.65 or 1.
const float LVSM_LEAST_EXTENT = 0.3;
const float LVSM_EXTENT_STEP = 0.35;

// Correlation of a component's places in x and in y where it has one.
const float LVSM_CODED_CORRELATION = 0.9;

/// One surface of a filter window as a receiver is compared with it.
/// weight: its share of the window, in [0,1]. place: of its taps' centroid from the texel's centre, in texels. depth: of
/// its plane at that place. slope, range: its change of depth per texel, and by how much more or less it may be. spread:
/// covariance of its taps' places, xx, xy and yy. deviation: of its taps from the plane, in depth. Weight 0 is none.
struct lvsm_MixturePlane
{
    float weight;
    vec2 place;
    float depth;
    vec2 slope;
    vec2 range;
    vec3 spread;
    float deviation;
};

/// The surfaces of a filter window: up to four planes.
struct lvsm_MixturePlanes
{
    lvsm_MixturePlane planes[LVSM_MAX_COMPONENTS];
};

// What a code's fields stand for. Slopes: levels on each side of 0. Deviations: levels above 0, and the largest.
struct lvsm_PlaneCode
{
    int slopeBits;
    int slopeLevels;
    int deviationBits;
    int deviationLevels;
    float mostDeviation;
};

lvsm_PlaneCode lvsm_planeCode2()
{
    lvsm_PlaneCode code;
    code.slopeBits = 5;
    code.slopeLevels = 15;
    code.deviationBits = 4;
    code.deviationLevels = 15;
    code.mostDeviation = 0.2;
    return code;
}

lvsm_PlaneCode lvsm_planeCode4()
{
    lvsm_PlaneCode code;
    code.slopeBits = 4;
    code.slopeLevels = 7;
    code.deviationBits = 2;
    code.deviationLevels = 3;
    code.mostDeviation = 0.05;
    return code;
}

float lvsm_filterDeviation(float deviation)
{
    return clamp(deviation, 0.25, 64.0);
}

// x in [0,1] as a whole number of levels.
uint lvsm_levelOf(float x, int levels)
{
    return uint(int(floor(clamp(x, 0.0, 1.0) * float(levels) + 0.5)));
}

uint lvsm_slopeLevel(float slope, int levels)
{
    float size = clamp(abs(slope) / LVSM_MOST_CODED_SLOPE, 1.0e-9, 1.0);
    uint level = lvsm_levelOf(exp(log(size) * (1.0 / 3.0)), levels);
    uint middle = uint(levels) + 1u;
    return slope < 0.0 ? middle - level : middle + level;
}

uint lvsm_placeLevel(float place, float reach)
{
    return lvsm_levelOf(0.5 + 0.5 * (place / reach), 2 * LVSM_PLACE_LEVELS) + 1u;
}

// The plane's own fields: depth at its coded place from bit 0, slopes from bit 10, deviation behind them.
uint lvsm_planeBits(lvsm_MixtureComponent c, vec2 place, lvsm_PlaneCode code)
{
    vec2 g = lvsm_slopeOf(c);
    uint x = lvsm_slopeLevel(g.x, code.slopeLevels);
    uint y = lvsm_slopeLevel(g.y, code.slopeLevels);
    float root = sqrt(sqrt(lvsm_residualOf(c, g)) * (1.0 / code.mostDeviation));
    uint depth = lvsm_levelOf(c.depth + (g.x * (place.x - c.place.x) + g.y * (place.y - c.place.y)), 1023);
    uint deviation = lvsm_levelOf(root, code.deviationLevels);
    return depth | (x << 10u) | (y << uint(10 + code.slopeBits)) | (deviation << uint(10 + 2 * code.slopeBits));
}

// Extents along x and y, 0 to 2, in two bits each. Equal ones may have a correlation: above 0 the first is 3, below 0 the
// second.
uint lvsm_spreadBits(vec3 spread, float sigma)
{
    float inverse = 1.0 / sigma;
    float span = 2.0 * LVSM_EXTENT_STEP;
    uint x = lvsm_levelOf((sqrt(spread.x) * inverse - LVSM_LEAST_EXTENT) / span, 2);
    uint y = lvsm_levelOf((sqrt(spread.z) * inverse - LVSM_LEAST_EXTENT) / span, 2);
    float least = 0.25 * LVSM_CODED_CORRELATION * LVSM_CODED_CORRELATION;
    if (x == y && spread.y * spread.y > least * spread.x * spread.z)
        return spread.y > 0.0 ? 3u | (x << 2u) : x | (3u << 2u);
    return x | (y << 2u);
}

// What a coded share and a coded place stand for.
float lvsm_codedWeight(uint level, int index)
{
    return float(int(level)) * (1.0 / float(15 * (index + 1)));
}

vec2 lvsm_codedPlace(uint x, uint y, float sigma)
{
    vec2 level = vec2(float(int(x)), float(int(y)));
    return (level - float(LVSM_PLACE_LEVELS + 1)) * (2.0 * sigma * (1.0 / float(LVSM_PLACE_LEVELS)));
}

// The heaviest plane takes the share that the others leave, but a share that heaviest can be, and its place is such that
// all places add up to 0. others: their shares, and the sums of shares times places.
float lvsm_heaviestWeight(float others)
{
    return max(1.0 - others, 0.125);
}

vec2 lvsm_heaviestPlace(vec2 others, float weight, float sigma)
{
    float reach = 2.0 * sigma;
    return clamp(-others * (1.0 / weight), vec2(-reach), vec2(reach));
}

// Share of all but the heaviest; the one of that index, counted from 1, has at most 1 / (index + 1).
uint lvsm_weightLevel(float weight, int index)
{
    uint level = lvsm_levelOf(weight * float(index + 1), 15);
    return weight > 0.0 && level == 0u ? 1u : level;
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

/// Plane of a component, uncoded.
/// component: any; its members are clamped to their ranges. Result: a plane whose slope is known exactly.
/// Source: componentSlope, componentResidual.
lvsm_MixturePlane lvsm_componentPlane(lvsm_MixtureComponent component)
{
    lvsm_MixtureComponent c = lvsm_validComponent(component);
    vec2 g = lvsm_slopeOf(c);
    lvsm_MixturePlane plane;
    plane.weight = c.weight;
    plane.place = c.place;
    plane.depth = c.depth;
    plane.slope = g;
    plane.range = vec2(0.0);
    plane.spread = c.spread;
    plane.deviation = sqrt(lvsm_residualOf(c, g));
    return plane;
}

/// Two planes in 64 bits.
/// mixture: the first two components count; members are clamped to their ranges, and shares to a sum of 1. deviation: of
/// the filter along each axis in texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: in x from bit 0 the heavier plane in 24 bits, the other's share and spread in 4 each; in y the other plane and
/// its place, 4 bits an axis. A mixture without any component is coded as a surface at depth 1.
uvec2 lvsm_encodeMixture2(lvsm_Mixture mixture, float deviation)
{
    float sigma = lvsm_filterDeviation(deviation);
    lvsm_Mixture m = lvsm_sorted(mixture, 2);
    lvsm_PlaneCode code = lvsm_planeCode2();
    lvsm_MixtureComponent c = m.components[1];
    uint share = lvsm_weightLevel(c.weight, 1);
    uint x = lvsm_placeLevel(c.place.x, 2.0 * sigma);
    uint y = lvsm_placeLevel(c.place.y, 2.0 * sigma);
    float weight = lvsm_codedWeight(share, 1);
    vec2 place = lvsm_codedPlace(x, y, sigma);
    vec2 first = lvsm_heaviestPlace(weight * place, lvsm_heaviestWeight(weight), sigma);
    uint heaviest = lvsm_planeBits(m.components[0], first, code) | (share << 24u);
    uint lighter = lvsm_planeBits(c, place, code) | (x << 24u) | (y << 28u);
    return uvec2(heaviest | (lvsm_spreadBits(c.spread, sigma) << 28u), lighter);
}

/// Four planes in 128 bits.
/// mixture: members are clamped to their ranges, and shares to a sum of 1. deviation: of the filter along each axis in
/// texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: in each word from bit 0 a plane in 20 bits, the heaviest in x; in x then the spreads of the others, 4 bits
/// each; in the others the share and the place of their plane, 4 bits each.
/// A mixture without any component is coded as a surface at depth 1.
uvec4 lvsm_encodeMixture4(lvsm_Mixture mixture, float deviation)
{
    float sigma = lvsm_filterDeviation(deviation);
    lvsm_Mixture m = lvsm_sorted(mixture, 4);
    lvsm_PlaneCode planeCode = lvsm_planeCode4();
    uvec4 code = uvec4(0u);
    float shares = 0.0;
    vec2 places = vec2(0.0);
    for (int k = 1; k < LVSM_MAX_COMPONENTS; ++k)
    {
        lvsm_MixtureComponent c = m.components[k];
        uint share = lvsm_weightLevel(c.weight, k);
        uint x = lvsm_placeLevel(c.place.x, 2.0 * sigma);
        uint y = lvsm_placeLevel(c.place.y, 2.0 * sigma);
        float weight = lvsm_codedWeight(share, k);
        vec2 place = lvsm_codedPlace(x, y, sigma);
        shares += weight;
        places += weight * place;
        code.x |= lvsm_spreadBits(c.spread, sigma) << uint(16 + 4 * k);
        code[k] = lvsm_planeBits(c, place, planeCode) | (share << 20u) | (x << 24u) | (y << 28u);
    }
    vec2 first = lvsm_heaviestPlace(places, lvsm_heaviestWeight(shares), sigma);
    code.x |= lvsm_planeBits(m.components[0], first, planeCode);
    return code;
}

uint lvsm_field(uint word, int begin, int bits)
{
    return (word >> uint(begin)) & ((1u << uint(bits)) - 1u);
}

// A plane's own fields; the rest is as of a plane that is all of the window.
lvsm_MixturePlane lvsm_planeOfBits(uint bits, lvsm_PlaneCode code, float sigma)
{
    // u^3 for all u within half a level: in the middle u (u^2 + 3 h^2), to both sides h (3 u^2 + h^2).
    int levelX = int(lvsm_field(bits, 10, code.slopeBits)) - (code.slopeLevels + 1);
    int levelY = int(lvsm_field(bits, 10 + code.slopeBits, code.slopeBits)) - (code.slopeLevels + 1);
    float scale = 1.0 / float(code.slopeLevels);
    float side = 0.5 * scale;
    vec2 level = vec2(float(levelX), float(levelY)) * scale;
    vec2 square = level * level;

    // Code 0 stands for deviations to half a level, evenly spread: their root mean square is 0.577 of that half's.
    float unit = 1.0 / float(code.deviationLevels);
    float size = float(int(lvsm_field(bits, 10 + 2 * code.slopeBits, code.deviationBits))) * unit;
    lvsm_MixturePlane plane;
    plane.weight = 1.0;
    plane.place = vec2(0.0);
    plane.depth = float(int(lvsm_field(bits, 0, 10))) * (1.0 / 1023.0);
    plane.slope = LVSM_MOST_CODED_SLOPE * (level * (square + 3.0 * side * side));
    plane.range = LVSM_MOST_CODED_SLOPE * side * (3.0 * square + side * side);
    plane.spread = vec3(sigma * sigma, 0.0, sigma * sigma);
    plane.deviation = code.mostDeviation * max(size * size, 0.14433757 * (unit * unit));
    return plane;
}

// Share, place and spread of the plane of that index, counted from 1, from the levels of its code.
void lvsm_placePlane(inout lvsm_MixturePlane plane, uint weight, int index, uint x, uint y, uint spread, float sigma)
{
    plane.weight = lvsm_codedWeight(weight, index);
    plane.place = lvsm_codedPlace(x, y, sigma);
    uint first = spread & 3u;
    uint second = spread >> 2u;
    float levelX = float(int(first == 3u ? second : first));
    float levelY = float(int(second == 3u ? first : second));
    vec2 extent = sigma * (LVSM_LEAST_EXTENT + LVSM_EXTENT_STEP * vec2(levelX, levelY));
    float correlation = first == 3u ? LVSM_CODED_CORRELATION : second == 3u ? -LVSM_CODED_CORRELATION : 0.0;
    plane.spread = vec3(extent.x * extent.x, correlation * (extent.x * extent.y), extent.y * extent.y);
}

// The heaviest plane takes what the others leave of the window's moments.
void lvsm_completePlanes(inout lvsm_MixturePlanes m, int count, float sigma)
{
    float shares = 0.0;
    vec2 places = vec2(0.0);
    vec3 spread = vec3(sigma * sigma, 0.0, sigma * sigma);
    for (int i = 1; i < LVSM_MAX_COMPONENTS; ++i)
    {
        if (i < count)
        {
            vec2 at = m.planes[i].place;
            float part = m.planes[i].weight;
            shares += part;
            places += part * at;
            spread -= part * (m.planes[i].spread + vec3(at.x * at.x, at.x * at.y, at.y * at.y));
        }
    }
    float weight = lvsm_heaviestWeight(shares);
    vec2 p = lvsm_heaviestPlace(places, weight, sigma);
    float inverse = 1.0 / weight;
    vec3 left = spread * inverse - vec3(p.x * p.x, p.x * p.y, p.y * p.y);
    LVSM_PRECISE float least = 0.05 * (sigma * sigma);
    LVSM_PRECISE float most = 1.5 * (sigma * sigma);
    vec2 along = clamp(left.xz, vec2(least), vec2(most));
    float correlated = min(along.x, along.y);
    m.planes[0].weight = weight;
    m.planes[0].place = p;
    m.planes[0].spread = vec3(along.x, clamp(left.y, -correlated, correlated), along.y);
}

lvsm_MixturePlane lvsm_noPlane()
{
    lvsm_MixturePlane none;
    none.weight = 0.0;
    none.place = vec2(0.0);
    none.depth = 0.0;
    none.slope = vec2(0.0);
    none.range = vec2(0.0);
    none.spread = vec3(0.0);
    none.deviation = 0.0;
    return none;
}

/// The planes that a code of 64 bits holds.
/// code: any bits; what encodeMixture2 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heavier plane first, places within 2.3 deviations, the third and fourth none.
lvsm_MixturePlanes lvsm_decodeMixture2(uvec2 code, float deviation)
{
    float sigma = lvsm_filterDeviation(deviation);
    lvsm_MixturePlane lighter = lvsm_planeOfBits(code.y, lvsm_planeCode2(), sigma);
    lvsm_placePlane(lighter, lvsm_field(code.x, 24, 4), 1, lvsm_field(code.y, 24, 4), code.y >> 28u, code.x >> 28u, sigma);
    lvsm_MixturePlanes m;
    m.planes[0] = lvsm_planeOfBits(code.x, lvsm_planeCode2(), sigma);
    m.planes[1] = lighter;
    m.planes[2] = lvsm_noPlane();
    m.planes[3] = lvsm_noPlane();
    lvsm_completePlanes(m, 2, sigma);
    return m;
}

// Plane of that index, counted from 1, of a code of 128 bits.
lvsm_MixturePlane lvsm_lighterPlane(uint bits, int index, uint spread, float sigma)
{
    lvsm_MixturePlane plane = lvsm_planeOfBits(bits, lvsm_planeCode4(), sigma);
    lvsm_placePlane(plane, lvsm_field(bits, 20, 4), index, lvsm_field(bits, 24, 4), bits >> 28u, spread, sigma);
    return plane;
}

/// The planes that a code of 128 bits holds.
/// code: any bits; what encodeMixture4 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heaviest plane first, places within 2.3 deviations.
lvsm_MixturePlanes lvsm_decodeMixture4(uvec4 code, float deviation)
{
    float sigma = lvsm_filterDeviation(deviation);
    lvsm_MixturePlanes m;
    m.planes[0] = lvsm_planeOfBits(code.x, lvsm_planeCode4(), sigma);
    m.planes[1] = lvsm_lighterPlane(code.y, 1, (code.x >> 20u) & 15u, sigma);
    m.planes[2] = lvsm_lighterPlane(code.z, 2, (code.x >> 24u) & 15u, sigma);
    m.planes[3] = lvsm_lighterPlane(code.w, 3, code.x >> 28u, sigma);
    lvsm_completePlanes(m, 4, sigma);
    return m;
}

// The weight of a plane around a receiver at f, in squares of the filter's deviation.
float lvsm_weightOfPlane(lvsm_MixturePlane p, vec2 f)
{
    return p.weight * exp(clamp(f.x * p.place.x + f.y * p.place.y, -16.0, 16.0));
}

// Of a plane: the lit share of its taps, and how far behind the receiver's plane they are in the mean, in depth.
// f: the receiver's place; moved: the same in squares of the filter's deviation. g: the receiver's slope; compared: the
// same as far as the plane can tell.
vec2 lvsm_lightOfPlane(lvsm_MixturePlane p, vec2 f, vec2 moved, float depth, vec2 g, vec2 compared, float bias)
{
    vec2 off = p.slope - compared;
    vec2 d = off - clamp(off, -p.range, p.range);
    vec2 across = vec2(d.x * p.spread.x + d.y * p.spread.y, d.x * p.spread.y + d.y * p.spread.z);
    LVSM_PRECISE float own = depth + (g.x * (p.place.x - f.x) + g.y * (p.place.y - f.y));
    LVSM_PRECISE float behind = (p.depth - own) + (across.x * moved.x + across.y * moved.y);
    float variance = across.x * d.x + across.y * d.y + p.deviation * p.deviation;
    float lit = 0.5 + (behind + 0.6 * p.deviation + bias) * inversesqrt(12.0 * max(variance, 1.0e-10));
    return vec2(clamp(lit, 0.0, 1.0), behind);
}

vec2 lvsm_inSquares(vec2 f, float sigma)
{
    return f * (1.0 / (sigma * sigma));
}

/// Share of the window that a plane has around a receiver between texels.
/// plane: weight counts in [0,1] and place in [-256,256], clamped to them. offset: of the receiver from the texel's
/// centre, in texels, each component clamped to [-16,16]; half a texel for a map of full resolution. deviation: of the
/// filter, clamped to [0.25, 64]. Result in [0, 8.9e6], relative to the other planes of the texel.
/// Source: moving a Gaussian window by f tilts its weights by exp(f.p / deviation^2), taken at the centroid.
float lvsm_planeWeight(lvsm_MixturePlane plane, vec2 offset, float deviation)
{
    lvsm_MixturePlane p = plane;
    p.weight = clamp(plane.weight, 0.0, 1.0);
    p.place = clamp(plane.place, vec2(-LVSM_MOST_PLACE), vec2(LVSM_MOST_PLACE));
    vec2 f = clamp(offset, vec2(-16.0), vec2(16.0));
    return lvsm_weightOfPlane(p, lvsm_inSquares(f, lvsm_filterDeviation(deviation)));
}

/// Lit share of a plane's taps, and how far they are behind the receiver.
/// plane: any; its members are clamped to [0,1], places to [-256,256], slopes and ranges to [-1,1], spreads to [-65536,65536].
/// offset: of the receiver from the texel's centre, in texels, each component clamped to [-16,16].
/// depth: the receiver's, in [0,1], clamped to it. gradient: its change per texel, each component clamped to [-1,1].
/// deviation: of the filter, clamped to [0.25, 64]. bias: in depth, clamped to [0,1].
/// Result: the share in [0,1], and the mean distance in depth, in [-1.4e8, 1.4e8].
/// Source: depth less the receiver's plane has the mean d and, by the difference of slopes and by the deviation, the
/// variance v; samples spread evenly around d are in front of 0 with the share 1/2 - d / sqrt(12 v).
vec2 lvsm_planeLight(lvsm_MixturePlane plane, vec2 offset, float depth, vec2 gradient, float deviation, float bias)
{
    lvsm_MixturePlane p;
    p.weight = clamp(plane.weight, 0.0, 1.0);
    p.place = clamp(plane.place, vec2(-LVSM_MOST_PLACE), vec2(LVSM_MOST_PLACE));
    p.depth = clamp(plane.depth, 0.0, 1.0);
    p.slope = clamp(plane.slope, vec2(-1.0), vec2(1.0));
    p.range = clamp(plane.range, vec2(0.0), vec2(1.0));
    p.spread = clamp(plane.spread, vec3(0.0, -LVSM_MOST_SPREAD, 0.0), vec3(LVSM_MOST_SPREAD));
    p.deviation = clamp(plane.deviation, 0.0, 1.0);
    vec2 f = clamp(offset, vec2(-16.0), vec2(16.0));
    vec2 g = clamp(gradient, vec2(-1.0), vec2(1.0));
    return lvsm_lightOfPlane(p, f, lvsm_inSquares(f, lvsm_filterDeviation(deviation)), clamp(depth, 0.0, 1.0), g, g,
                             clamp(bias, 0.0, 1.0));
}

// Sums over the planes of a code: weight, lit weight, weight in shadow, and that times the distance in front of the
// receiver. Slopes that the code does not tell apart are compared as one.
vec4 lvsm_sumsOfPlanes(lvsm_MixturePlanes m, int count, vec2 offset, float depth, vec2 gradient, float deviation,
                       float bias)
{
    vec2 f = clamp(offset, vec2(-16.0), vec2(16.0));
    vec2 moved = lvsm_inSquares(f, lvsm_filterDeviation(deviation));
    vec2 g = clamp(gradient, vec2(-1.0), vec2(1.0));
    vec2 compared = clamp(gradient, vec2(-LVSM_MOST_CODED_SLOPE), vec2(LVSM_MOST_CODED_SLOPE));
    float t = clamp(depth, 0.0, 1.0);
    float allowed = clamp(bias, 0.0, 1.0);
    vec4 sums = vec4(0.0);
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
    {
        if (i < count)
        {
            float weight = lvsm_weightOfPlane(m.planes[i], moved);
            vec2 light = lvsm_lightOfPlane(m.planes[i], f, moved, t, g, compared, allowed);
            float dark = weight * (1.0 - light.x);
            sums += vec4(weight, weight * light.x, dark, dark * max(-light.y, 0.0));
        }
    }
    return sums;
}

float lvsm_visibilityOfSums(vec4 sums)
{
    return clamp(sums.y / max(sums.x, 1.0e-12), 0.0, 1.0);
}

float lvsm_occluderOfSums(vec4 sums, float depth)
{
    float away = sums.z < 1.0e-12 ? 0.0 : sums.w / max(sums.z, 1.0e-12);
    return clamp(clamp(depth, 0.0, 1.0) - away, 0.0, 1.0);
}

/// Visibility of a receiver from a code of 64 bits.
/// code: any bits, not filtered. offset: of the receiver from the code's place, in texels of the shadow map, each
/// component clamped to [-16,16]: at most half a texel for a nearest fetch from a map of full resolution, one of half
/// resolution. depth: the receiver's, in [0,1], clamped to it. gradient: its change per texel of the shadow map, each
/// component clamped to [-1,1]. deviation: of the filter, clamped to [0.25, 64]. bias: in depth, clamped to [0,1], see
/// LVSM_MIXTURE_BIAS. Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
float lvsm_mixtureVisibility2(uvec2 code, vec2 offset, float depth, vec2 gradient, float deviation, float bias)
{
    lvsm_MixturePlanes planes = lvsm_decodeMixture2(code, deviation);
    return lvsm_visibilityOfSums(lvsm_sumsOfPlanes(planes, 2, offset, depth, gradient, deviation, bias));
}

/// Visibility of a receiver from a code of 128 bits.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
float lvsm_mixtureVisibility4(uvec4 code, vec2 offset, float depth, vec2 gradient, float deviation, float bias)
{
    lvsm_MixturePlanes planes = lvsm_decodeMixture4(code, deviation);
    return lvsm_visibilityOfSums(lvsm_sumsOfPlanes(planes, 4, offset, depth, gradient, deviation, bias));
}

/// Mean depth of what is in front of a receiver, from a code of 64 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
float lvsm_mixtureOccluder2(uvec2 code, vec2 offset, float depth, vec2 gradient, float deviation, float bias)
{
    lvsm_MixturePlanes planes = lvsm_decodeMixture2(code, deviation);
    return lvsm_occluderOfSums(lvsm_sumsOfPlanes(planes, 2, offset, depth, gradient, deviation, bias), depth);
}

/// Mean depth of what is in front of a receiver, from a code of 128 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
float lvsm_mixtureOccluder4(uvec4 code, vec2 offset, float depth, vec2 gradient, float deviation, float bias)
{
    lvsm_MixturePlanes planes = lvsm_decodeMixture4(code, deviation);
    return lvsm_occluderOfSums(lvsm_sumsOfPlanes(planes, 4, offset, depth, gradient, deviation, bias), depth);
}

#endif
