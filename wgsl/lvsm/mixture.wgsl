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

// Bias that suits the codes: two steps of a coded depth, of which its rounding takes a half. The rest is for surfaces
// that bend, a choice and no derivation.
const LVSM_MIXTURE_BIAS: f32 = 0.001953125;

// The steepest coded slope: change of depth over one deviation of the filter.
const LVSM_MOST_CODED_RISE: f32 = 0.088388348;

// Step of a coded place, in deviations of the filter: 16 levels reach to 2.25 on each side.
const LVSM_PLACE_STEP: f32 = 0.3;

// Least coded deviation from a plane: half a step of a coded depth, as far as its rounding can be off.
const LVSM_LEAST_DEVIATION: f32 = 0.00048828125;

// Units in which codes are read: the steepest coded slope is 2^62, a depth of 1 is 2^66 / sqrt(12), and a place of one
// deviation of the filter 1 / sqrt(6).
const LVSM_CODE_SLOPE: f32 = 4611686018427387904.0;
const LVSM_CODE_DEPTH: f32 = 21300465313256689664.0;
const LVSM_CODE_PLACE: f32 = 0.4082482905;

/// One surface of a filter window as a receiver is compared with it.
/// weight: its share of the window, in [0,1]. place: of its taps' centroid from the texel's centre, in texels. depth:
/// of its plane at that place. slope: its change of depth per texel. deviation: of its taps from the plane, in depth.
/// Weight 0 is none.
struct lvsm_MixturePlane
{
    weight: f32,
    place: vec2f,
    depth: f32,
    slope: vec2f,
    deviation: f32,
}

/// The surfaces of a filter window: up to four planes.
struct lvsm_MixturePlanes
{
    planes: array<lvsm_MixturePlane, LVSM_MAX_COMPONENTS>,
}

// A receiver as codes are read. Slopes count in units of 2^-62 of the steepest coded one, of which a field that fills
// the top of a word has the square root as it is; depth, less the bias, in those units that make half a spread 1.
// place: half of the offset, in deviations, and so that slope times place is a depth. rounding: square of what a coded
// slope may be off where it is the receiver's own.
struct lvsm_CodeReceiver
{
    depth: f32,
    slope: vec2f,
    place: vec2f,
    rounding: f32,
    bias: f32,
}

fn lvsm_filterDeviation(deviation: f32) -> f32
{
    return clamp(deviation, 0.25, 64.0);
}

// Sets a field of which value is in levels, the lowest of them least. Only bits below the field are set yet; they are
// read as a fraction of a level.
fn lvsm_withField(word: u32, at: i32, bits: i32, value: f32, least: f32) -> u32
{
    let below = f32(i32(word)) / f32(i32(1u << u32(at)));
    let level = clamp(value - below, least, least + f32(i32((1u << u32(bits)) - 1u)));
    return word | ((u32(i32(floor(level + 0.5))) & ((1u << u32(bits)) - 1u)) << u32(at));
}

// Slope in levels, by the signed square.
fn lvsm_slopeLevel(rise: f32) -> f32
{
    let size = 16.0 * sqrt(abs(rise) * (1.0 / LVSM_MOST_CODED_RISE));
    return select(size, -size, rise < 0.0);
}

// Slopes of a word in units of LVSM_CODE_SLOPE.
fn lvsm_codedSlope(word: u32) -> vec2f
{
    let x = f32(i32(word << 10u));
    let y = f32(i32(word << 15u));
    return vec2f(x * abs(x), y * abs(y));
}

fn lvsm_codedRise(word: u32) -> vec2f
{
    return lvsm_codedSlope(word) * (LVSM_MOST_CODED_RISE / LVSM_CODE_SLOPE);
}

// Place of a word from the heaviest plane's, in units of step.
fn lvsm_codedPlace(word: u32, unit: f32) -> vec2f
{
    return vec2f(f32(i32(word & 255u)) * (unit / 16.0) - 7.96875 * unit, f32(i32(word & 15u)) * unit - 7.5 * unit);
}

// Share of a word of that index, counted from 1: of 15 levels up to 1 / (index + 1).
fn lvsm_codedShare(word: u32, index: i32) -> f32
{
    return f32(i32(word & 3840u)) * (1.0 / f32(3840 * (index + 1)));
}

// Deviation of the plane of that index from the first word, in units of LVSM_LEAST_DEVIATION times 2^-55: the bits of a
// float, three of its exponent and what there is of its mantissa.
fn lvsm_codedDeviation(word: u32, index: i32, count: i32) -> f32
{
    let bits = 12 / count;
    let at = 12 - bits * (index + 1);
    let level = word & (((1u << u32(bits)) - 1u) << u32(at));
    return bitcast<f32>((level << u32(26 - at - bits)) + 0x5B000000u);
}

// Level of a deviation, the nearest of those that lvsm_codedDeviation reads.
fn lvsm_deviationLevel(deviation: f32, count: i32) -> u32
{
    let most = (1u << u32(12 / count)) - 1u;
    let shift = select(23u, 20u, count == 2);
    let size = clamp(deviation * (1.0 / LVSM_LEAST_DEVIATION), 1.0, 256.0);
    return min((bitcast<u32>(size) - 0x3F800000u + (1u << (shift - 1u))) >> shift, most);
}

// A word of the bits below its slopes: slopes and depth of a component's plane. p: where the plane is told, and apart:
// how far that is from the heaviest one's, in deviations.
fn lvsm_planeWord(low: u32, c: lvsm_MixtureComponent, p: vec2f, apart: vec2f, sigma: f32) -> u32
{
    let g = lvsm_slopeOf(c);
    let rise = clamp(g * sigma, vec2f(-LVSM_MOST_CODED_RISE), vec2f(LVSM_MOST_CODED_RISE));
    var word = lvsm_withField(low, 12, 5, lvsm_slopeLevel(rise.y), -16.0);
    word = lvsm_withField(word, 17, 5, lvsm_slopeLevel(rise.x), -16.0);
    let coded = lvsm_codedRise(word);
    let there = c.depth + (g.x * (p.x * sigma - c.place.x) + g.y * (p.y * sigma - c.place.y));
    return lvsm_withField(word, 22, 10, 1024.0 * (there - (coded.x * apart.x + coded.y * apart.y)), 0.0);
}

fn lvsm_sortPair(m: ptr<function, lvsm_Mixture>, i: i32, j: i32)
{
    if ((*m).components[i].weight < (*m).components[j].weight)
    {
        let lighter = (*m).components[i];
        (*m).components[i] = (*m).components[j];
        (*m).components[j] = lighter;
    }
}

// Heaviest first, with shares that add up to 1; a surface at depth 1 where there is none.
fn lvsm_sorted(mixture: lvsm_Mixture, count: i32) -> lvsm_Mixture
{
    var m: lvsm_Mixture;
    var sum = 0.0;
    for (var i = 0; i < LVSM_MAX_COMPONENTS; i++)
    {
        m.components[i] = lvsm_noComponent();
        if (i < count)
        {
            m.components[i] = lvsm_validComponent(mixture.components[i]);
        }
        sum += m.components[i].weight;
    }
    if (sum < 1.0e-6)
    {
        for (var j = 1; j < LVSM_MAX_COMPONENTS; j++)
        {
            m.components[j] = lvsm_noComponent();
        }
        m.components[0] = lvsm_tapComponent(1.0);
        return m;
    }
    lvsm_sortPair(&m, 0, 1);
    if (count > 2)
    {
        lvsm_sortPair(&m, 2, 3);
        lvsm_sortPair(&m, 0, 2);
        lvsm_sortPair(&m, 1, 3);
        lvsm_sortPair(&m, 1, 2);
    }
    let inverse = 1.0 / sum;
    for (var k = 0; k < LVSM_MAX_COMPONENTS; k++)
    {
        m.components[k].weight *= inverse;
    }
    return m;
}

// A word's bits below its slopes: share, at least one level of what is there at all, and place from the heaviest
// plane's.
fn lvsm_shareAndPlace(c: lvsm_MixtureComponent, index: i32, heaviest: vec2f, sigma: f32) -> u32
{
    if (!(c.weight > 0.0))
    {
        return 0u;
    }
    let unit = 1.0 / (sigma * LVSM_PLACE_STEP);
    var word = lvsm_withField(0u, 0, 4, (c.place.y - heaviest.y) * unit + 7.5, 0.0);
    word = lvsm_withField(word, 4, 4, (c.place.x - heaviest.x) * unit + 7.96875, 0.0);
    let level = clamp(c.weight * f32(15 * (index + 1)), 1.0, 15.0);
    return word | (u32(i32(floor(level + 0.5))) << 8u);
}

// Words of so many planes.
fn lvsm_encodePlanes(mixture: lvsm_Mixture, count: i32, deviation: f32) -> vec4u
{
    let sigma = lvsm_filterDeviation(deviation);
    let m = lvsm_sorted(mixture, count);
    var code = vec4u(0u);
    var first = vec2f(0.0);
    for (var i = 0; i < LVSM_MAX_COMPONENTS; i++)
    {
        if (i >= count)
        {
            continue;
        }
        let c = m.components[i];
        let at = 12 - (12 / count) * (i + 1);
        code.x |= lvsm_deviationLevel(sqrt(lvsm_residualOf(c, lvsm_slopeOf(c))), count) << u32(at);
        if (i > 0)
        {
            code[i] = lvsm_shareAndPlace(c, i, m.components[0].place, sigma);
            first -= lvsm_codedShare(code[i], i) * lvsm_codedPlace(code[i], LVSM_PLACE_STEP);
        }
    }
    for (var k = 0; k < LVSM_MAX_COMPONENTS; k++)
    {
        if (k >= count)
        {
            continue;
        }
        let apart = select(lvsm_codedPlace(code[k], LVSM_PLACE_STEP), vec2f(0.0), k == 0);
        code[k] = lvsm_planeWord(code[k], m.components[k], first + apart, apart, sigma);
    }
    return code;
}

/// Plane of a component, uncoded.
/// component: any; its members are clamped to their ranges. Result: a plane whose slope is known exactly.
/// Source: componentSlope, componentResidual.
fn lvsm_componentPlane(component: lvsm_MixtureComponent) -> lvsm_MixturePlane
{
    let c = lvsm_validComponent(component);
    let g = lvsm_slopeOf(c);
    var plane: lvsm_MixturePlane;
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
fn lvsm_encodeMixture2(mixture: lvsm_Mixture, deviation: f32) -> vec2u
{
    return lvsm_encodePlanes(mixture, 2, deviation).xy;
}

/// Four planes in 128 bits.
/// mixture: members are clamped to their ranges, and shares to a sum of 1. deviation: of the filter along each axis in
/// texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: the heaviest plane in x, the others by weight in y, z and w. A mixture without any component is coded as a
/// surface at depth 1.
fn lvsm_encodeMixture4(mixture: lvsm_Mixture, deviation: f32) -> vec4u
{
    return lvsm_encodePlanes(mixture, 4, deviation);
}

fn lvsm_noPlane() -> lvsm_MixturePlane
{
    var none: lvsm_MixturePlane;
    none.weight = 0.0;
    none.place = vec2f(0.0);
    none.depth = 0.0;
    none.slope = vec2f(0.0);
    none.deviation = 0.0;
    return none;
}

fn lvsm_decodePlanes(code: vec4u, count: i32, deviation: f32) -> lvsm_MixturePlanes
{
    let sigma = lvsm_filterDeviation(deviation);
    var m: lvsm_MixturePlanes;
    var shares = 0.0;
    var first = vec2f(0.0);
    for (var i = 0; i < LVSM_MAX_COMPONENTS; i++)
    {
        m.planes[i] = lvsm_noPlane();
        if (i >= count)
        {
            continue;
        }
        let rise = lvsm_codedRise(code[i]);
        let apart = select(lvsm_codedPlace(code[i], LVSM_PLACE_STEP), vec2f(0.0), i == 0);
        let share = select(lvsm_codedShare(code[i], i), 0.0, i == 0);
        m.planes[i].weight = share;
        m.planes[i].place = apart * sigma;
        let depth = f32(code[i]) * (1.0 / 4294967296.0) + (rise.x * apart.x + rise.y * apart.y);
        m.planes[i].depth = clamp(depth, 0.0, 1.0);
        m.planes[i].slope = rise * (1.0 / sigma);
        m.planes[i].deviation = lvsm_codedDeviation(code.x, i, count) * (LVSM_LEAST_DEVIATION / 36028797018963968.0);
        shares += share;
        first -= share * m.planes[i].place;
    }
    m.planes[0].weight = max(1.0 - shares, 0.0);
    for (var k = 0; k < LVSM_MAX_COMPONENTS; k++)
    {
        if (k < count)
        {
            m.planes[k].place += first;
        }
    }
    return m;
}

/// The planes that a code of 64 bits holds.
/// code: any bits; what encodeMixture2 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heavier plane first, places within 3.6 deviations, the third and fourth none.
fn lvsm_decodeMixture2(code: vec2u, deviation: f32) -> lvsm_MixturePlanes
{
    return lvsm_decodePlanes(vec4u(code, 0u, 0u), 2, deviation);
}

/// The planes that a code of 128 bits holds.
/// code: any bits; what encodeMixture4 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heaviest plane first, places within 5 deviations.
fn lvsm_decodeMixture4(code: vec4u, deviation: f32) -> lvsm_MixturePlanes
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
fn lvsm_planeWeight(plane: lvsm_MixturePlane, offset: vec2f, deviation: f32) -> f32
{
    let sigma = lvsm_filterDeviation(deviation);
    let p = clamp(plane.place, vec2f(-LVSM_MOST_PLACE), vec2f(LVSM_MOST_PLACE));
    let f = clamp(offset, vec2f(-16.0), vec2f(16.0));
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
fn lvsm_planeLight(plane: lvsm_MixturePlane, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32,
                   bias: f32) -> vec2f
{
    let sigma = lvsm_filterDeviation(deviation);
    let p = clamp(plane.place, vec2f(-LVSM_MOST_PLACE), vec2f(LVSM_MOST_PLACE));
    let f = clamp(offset, vec2f(-16.0), vec2f(16.0));
    let g = clamp(gradient, vec2f(-1.0), vec2f(1.0));
    let d = clamp(plane.slope, vec2f(-1.0), vec2f(1.0)) - g;
    let r = clamp(plane.deviation, 0.0, 1.0);
    let own = clamp(depth, 0.0, 1.0) + (g.x * (p.x - f.x) + g.y * (p.y - f.y));
    let behind = (clamp(plane.depth, 0.0, 1.0) - own) + 0.5 * (d.x * f.x + d.y * f.y);
    let variance = 0.5 * (sigma * sigma) * (d.x * d.x + d.y * d.y) + r * r;
    let lit = 0.5 + (behind + 0.6 * r + clamp(bias, 0.0, 1.0)) * inverseSqrt(12.0 * max(variance, 1.0e-10));
    return vec2f(clamp(lit, 0.0, 1.0), behind);
}

// planeLight of a word, the distance in units of LVSM_CODE_DEPTH. apart: the plane's place from the heaviest one's and
// half of the offset; deviation: in the units of lvsm_codedDeviation.
fn lvsm_lightOfWord(word: u32, deviation: f32, apart: vec2f, r: lvsm_CodeReceiver) -> vec2f
{
    let d = lvsm_codedSlope(word) - r.slope;
    let variance = max(d.x * d.x + d.y * d.y - r.rounding, 0.0) + deviation * deviation;
    let behind = f32(word) * (LVSM_CODE_DEPTH / 4294967296.0) - r.depth + (d.x * apart.x + d.y * apart.y);
    return vec2f(clamp(0.5 + (behind + 0.17320508 * deviation) * inverseSqrt(variance), 0.0, 1.0), behind);
}

fn lvsm_codeReceiver(offset: vec2f, depth: f32, gradient: vec2f, sigma: f32, bias: f32) -> lvsm_CodeReceiver
{
    var r: lvsm_CodeReceiver;
    let f = clamp(offset, vec2f(-16.0), vec2f(16.0)) * (LVSM_CODE_PLACE / sigma);
    let g = gradient * (sigma * (LVSM_CODE_SLOPE / LVSM_MOST_CODED_RISE));
    r.slope = clamp(g, vec2f(-LVSM_CODE_SLOPE), vec2f(LVSM_CODE_SLOPE));
    r.place = 0.5 * f;
    r.bias = clamp(bias, 0.0, 1.0) * LVSM_CODE_DEPTH;
    r.depth = clamp(depth, 0.0, 1.0) * LVSM_CODE_DEPTH - r.bias - (r.slope.x * f.x + r.slope.y * f.y);
    // A slope u^2 is off by half a level of u at most, (2 u + 1/32) / 32, the square of which is less than
    // (8 u^2 + 2 / 32^2) / 32^2.
    r.rounding = (abs(r.slope.x) + abs(r.slope.y)) * 36028797018963968.0 + 81129638414606681695789005144064.0;
    return r;
}

// Sums over the planes of a code: lit weight, weight in shadow, and that times the distance in front of the receiver.
fn lvsm_sumsOfCode(code: vec4u, count: i32, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32,
                   bias: f32) -> vec3f
{
    var r = lvsm_codeReceiver(offset, depth, gradient, lvsm_filterDeviation(deviation), bias);
    let turned = r.slope.x * r.place.x + r.slope.y * r.place.y;
    let moved = 12.0 * (r.place.x * r.place.x + r.place.y * r.place.y);
    var shares: array<f32, LVSM_MAX_COMPONENTS>;
    var tilts: array<f32, LVSM_MAX_COMPONENTS>;
    var apart: array<vec2f, LVSM_MAX_COMPONENTS>;
    var tilt = 1.0;
    for (var i = 1; i < LVSM_MAX_COMPONENTS; i++)
    {
        if (i >= count)
        {
            continue;
        }
        apart[i] = lvsm_codedPlace(code[i], LVSM_PLACE_STEP * LVSM_CODE_PLACE) + r.place;
        shares[i] = lvsm_codedShare(code[i], i);
        tilts[i] = 12.0 * (r.place.x * apart[i].x + r.place.y * apart[i].y) - moved;
        tilt -= shares[i] * tilts[i];
        r.depth -= shares[i] * (r.slope.x * apart[i].x + r.slope.y * apart[i].y - turned);
    }
    let first = lvsm_lightOfWord(code.x, lvsm_codedDeviation(code.x, 0, count), r.place, r);
    var lit = first.x;
    var left = 1.0;
    var dark = vec2f(0.0);
    for (var k = 1; k < LVSM_MAX_COMPONENTS; k++)
    {
        if (k >= count)
        {
            continue;
        }
        let light = lvsm_lightOfWord(code[k], lvsm_codedDeviation(code.x, k, count), apart[k], r);
        let weight = shares[k] * (tilt + tilts[k]);
        lit += weight * (light.x - first.x);
        left -= weight;
        let unlit = max(weight, 0.0) * (1.0 - light.x);
        dark += vec2f(unlit, unlit * max(r.bias - light.y, 0.0));
    }
    let unlit = max(left, 0.0) * (1.0 - first.x);
    dark += vec2f(unlit, unlit * max(r.bias - first.y, 0.0));
    return vec3f(clamp(lit, 0.0, 1.0), dark.x, dark.y * (1.0 / LVSM_CODE_DEPTH));
}

fn lvsm_occluderOfSums(sums: vec3f, depth: f32) -> f32
{
    let away = select(sums.z / max(sums.y, 1.0e-12), 0.0, sums.y < 1.0e-12);
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
fn lvsm_mixtureVisibility2(code: vec2u, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32, bias: f32) -> f32
{
    return lvsm_sumsOfCode(vec4u(code, 0u, 0u), 2, offset, depth, gradient, deviation, bias).x;
}

/// Visibility of a receiver from a code of 128 bits.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
fn lvsm_mixtureVisibility4(code: vec4u, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32, bias: f32) -> f32
{
    return lvsm_sumsOfCode(code, 4, offset, depth, gradient, deviation, bias).x;
}

/// Mean depth of what is in front of a receiver, from a code of 64 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
fn lvsm_mixtureOccluder2(code: vec2u, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32, bias: f32) -> f32
{
    let sums = lvsm_sumsOfCode(vec4u(code, 0u, 0u), 2, offset, depth, gradient, deviation, bias);
    return lvsm_occluderOfSums(sums, depth);
}

/// Mean depth of what is in front of a receiver, from a code of 128 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
fn lvsm_mixtureOccluder4(code: vec4u, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32, bias: f32) -> f32
{
    return lvsm_occluderOfSums(lvsm_sumsOfCode(code, 4, offset, depth, gradient, deviation, bias), depth);
}
