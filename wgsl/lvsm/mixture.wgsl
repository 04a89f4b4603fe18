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

// Bias that suits the codes: two steps of a coded depth, of which its rounding takes a half. The rest is for surfaces
// that bend, a choice and no derivation.
const LVSM_MIXTURE_BIAS: f32 = 0.00195503;

// The steepest slope that a code tells from steeper ones, in depth per texel.
const LVSM_MOST_CODED_SLOPE: f32 = 0.0625;

// Levels of a coded place on each side of 0, which reach to two deviations of the filter.
const LVSM_PLACE_LEVELS: i32 = 7;

// Deviation of a component's taps along an axis, in that of the filter: 0.3, 0.65 or 1.
const LVSM_LEAST_EXTENT: f32 = 0.3;
const LVSM_EXTENT_STEP: f32 = 0.35;

// Correlation of a component's places in x and in y where it has one.
const LVSM_CODED_CORRELATION: f32 = 0.9;

/// One surface of a filter window as a receiver is compared with it.
/// weight: its share of the window, in [0,1]. place: of its taps' centroid from the texel's centre, in texels. depth: of
/// its plane at that place. slope, range: its change of depth per texel, and by how much more or less it may be. spread:
/// covariance of its taps' places, xx, xy and yy. deviation: of its taps from the plane, in depth. Weight 0 is none.
struct lvsm_MixturePlane
{
    weight: f32,
    place: vec2f,
    depth: f32,
    slope: vec2f,
    range: vec2f,
    spread: vec3f,
    deviation: f32,
}

/// The surfaces of a filter window: up to four planes.
struct lvsm_MixturePlanes
{
    planes: array<lvsm_MixturePlane, LVSM_MAX_COMPONENTS>,
}

// What a code's fields stand for. Slopes: levels on each side of 0. Deviations: levels above 0, and the largest.
struct lvsm_PlaneCode
{
    slopeBits: i32,
    slopeLevels: i32,
    deviationBits: i32,
    deviationLevels: i32,
    mostDeviation: f32,
}

fn lvsm_planeCode2() -> lvsm_PlaneCode
{
    var code: lvsm_PlaneCode;
    code.slopeBits = 5;
    code.slopeLevels = 15;
    code.deviationBits = 4;
    code.deviationLevels = 15;
    code.mostDeviation = 0.2;
    return code;
}

fn lvsm_planeCode4() -> lvsm_PlaneCode
{
    var code: lvsm_PlaneCode;
    code.slopeBits = 4;
    code.slopeLevels = 7;
    code.deviationBits = 2;
    code.deviationLevels = 3;
    code.mostDeviation = 0.05;
    return code;
}

fn lvsm_filterDeviation(deviation: f32) -> f32
{
    return clamp(deviation, 0.25, 64.0);
}

// x in [0,1] as a whole number of levels.
fn lvsm_levelOf(x: f32, levels: i32) -> u32
{
    return u32(i32(floor(clamp(x, 0.0, 1.0) * f32(levels) + 0.5)));
}

fn lvsm_slopeLevel(slope: f32, levels: i32) -> u32
{
    let size = clamp(abs(slope) / LVSM_MOST_CODED_SLOPE, 1.0e-9, 1.0);
    let level = lvsm_levelOf(exp(log(size) * (1.0 / 3.0)), levels);
    let middle = u32(levels) + 1u;
    return select(middle + level, middle - level, slope < 0.0);
}

fn lvsm_placeLevel(place: f32, reach: f32) -> u32
{
    return lvsm_levelOf(0.5 + 0.5 * (place / reach), 2 * LVSM_PLACE_LEVELS) + 1u;
}

// The plane's own fields: depth at its coded place from bit 0, slopes from bit 10, deviation behind them.
fn lvsm_planeBits(c: lvsm_MixtureComponent, place: vec2f, code: lvsm_PlaneCode) -> u32
{
    let g = lvsm_slopeOf(c);
    let x = lvsm_slopeLevel(g.x, code.slopeLevels);
    let y = lvsm_slopeLevel(g.y, code.slopeLevels);
    let root = sqrt(sqrt(lvsm_residualOf(c, g)) * (1.0 / code.mostDeviation));
    let depth = lvsm_levelOf(c.depth + (g.x * (place.x - c.place.x) + g.y * (place.y - c.place.y)), 1023);
    let deviation = lvsm_levelOf(root, code.deviationLevels);
    return depth | (x << 10u) | (y << u32(10 + code.slopeBits)) | (deviation << u32(10 + 2 * code.slopeBits));
}

// Extents along x and y, 0 to 2, in two bits each. Equal ones may have a correlation: above 0 the first is 3, below 0 the
// second.
fn lvsm_spreadBits(spread: vec3f, sigma: f32) -> u32
{
    let inverse = 1.0 / sigma;
    let span = 2.0 * LVSM_EXTENT_STEP;
    let x = lvsm_levelOf((sqrt(spread.x) * inverse - LVSM_LEAST_EXTENT) / span, 2);
    let y = lvsm_levelOf((sqrt(spread.z) * inverse - LVSM_LEAST_EXTENT) / span, 2);
    let least = 0.25 * LVSM_CODED_CORRELATION * LVSM_CODED_CORRELATION;
    if (x == y && spread.y * spread.y > least * spread.x * spread.z)
    {
        return select(x | (3u << 2u), 3u | (x << 2u), spread.y > 0.0);
    }
    return x | (y << 2u);
}

// What a coded share and a coded place stand for.
fn lvsm_codedWeight(level: u32, index: i32) -> f32
{
    return f32(i32(level)) * (1.0 / f32(15 * (index + 1)));
}

fn lvsm_codedPlace(x: u32, y: u32, sigma: f32) -> vec2f
{
    let level = vec2f(f32(i32(x)), f32(i32(y)));
    return (level - f32(LVSM_PLACE_LEVELS + 1)) * (2.0 * sigma * (1.0 / f32(LVSM_PLACE_LEVELS)));
}

// The heaviest plane takes the share that the others leave, but a share that heaviest can be, and its place is such that
// all places add up to 0. others: their shares, and the sums of shares times places.
fn lvsm_heaviestWeight(others: f32) -> f32
{
    return max(1.0 - others, 0.125);
}

fn lvsm_heaviestPlace(others: vec2f, weight: f32, sigma: f32) -> vec2f
{
    let reach = 2.0 * sigma;
    return clamp(-others * (1.0 / weight), vec2f(-reach), vec2f(reach));
}

// Share of all but the heaviest; the one of that index, counted from 1, has at most 1 / (index + 1).
fn lvsm_weightLevel(weight: f32, index: i32) -> u32
{
    let level = lvsm_levelOf(weight * f32(index + 1), 15);
    return select(level, 1u, weight > 0.0 && level == 0u);
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
    plane.range = vec2f(0.0);
    plane.spread = c.spread;
    plane.deviation = sqrt(lvsm_residualOf(c, g));
    return plane;
}

/// Two planes in 64 bits.
/// mixture: the first two components count; members are clamped to their ranges, and shares to a sum of 1. deviation: of
/// the filter along each axis in texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: in x from bit 0 the heavier plane in 24 bits, the other's share and spread in 4 each; in y the other plane and
/// its place, 4 bits an axis. A mixture without any component is coded as a surface at depth 1.
fn lvsm_encodeMixture2(mixture: lvsm_Mixture, deviation: f32) -> vec2u
{
    let sigma = lvsm_filterDeviation(deviation);
    let m = lvsm_sorted(mixture, 2);
    let code = lvsm_planeCode2();
    let c = m.components[1];
    let share = lvsm_weightLevel(c.weight, 1);
    let x = lvsm_placeLevel(c.place.x, 2.0 * sigma);
    let y = lvsm_placeLevel(c.place.y, 2.0 * sigma);
    let weight = lvsm_codedWeight(share, 1);
    let place = lvsm_codedPlace(x, y, sigma);
    let first = lvsm_heaviestPlace(weight * place, lvsm_heaviestWeight(weight), sigma);
    let heaviest = lvsm_planeBits(m.components[0], first, code) | (share << 24u);
    let lighter = lvsm_planeBits(c, place, code) | (x << 24u) | (y << 28u);
    return vec2u(heaviest | (lvsm_spreadBits(c.spread, sigma) << 28u), lighter);
}

/// Four planes in 128 bits.
/// mixture: members are clamped to their ranges, and shares to a sum of 1. deviation: of the filter along each axis in
/// texels, in [0.25, 64], clamped to it, as mixtureDeviation gives it.
/// Result: in each word from bit 0 a plane in 20 bits, the heaviest in x; in x then the spreads of the others, 4 bits
/// each; in the others the share and the place of their plane, 4 bits each.
/// A mixture without any component is coded as a surface at depth 1.
fn lvsm_encodeMixture4(mixture: lvsm_Mixture, deviation: f32) -> vec4u
{
    let sigma = lvsm_filterDeviation(deviation);
    let m = lvsm_sorted(mixture, 4);
    let planeCode = lvsm_planeCode4();
    var code = vec4u(0u);
    var shares = 0.0;
    var places = vec2f(0.0);
    for (var k = 1; k < LVSM_MAX_COMPONENTS; k++)
    {
        let c = m.components[k];
        let share = lvsm_weightLevel(c.weight, k);
        let x = lvsm_placeLevel(c.place.x, 2.0 * sigma);
        let y = lvsm_placeLevel(c.place.y, 2.0 * sigma);
        let weight = lvsm_codedWeight(share, k);
        let place = lvsm_codedPlace(x, y, sigma);
        shares += weight;
        places += weight * place;
        code.x |= lvsm_spreadBits(c.spread, sigma) << u32(16 + 4 * k);
        code[k] = lvsm_planeBits(c, place, planeCode) | (share << 20u) | (x << 24u) | (y << 28u);
    }
    let first = lvsm_heaviestPlace(places, lvsm_heaviestWeight(shares), sigma);
    code.x |= lvsm_planeBits(m.components[0], first, planeCode);
    return code;
}

fn lvsm_field(word: u32, begin: i32, bits: i32) -> u32
{
    return (word >> u32(begin)) & ((1u << u32(bits)) - 1u);
}

// A plane's own fields; the rest is as of a plane that is all of the window.
fn lvsm_planeOfBits(bits: u32, code: lvsm_PlaneCode, sigma: f32) -> lvsm_MixturePlane
{
    // u^3 for all u within half a level: in the middle u (u^2 + 3 h^2), to both sides h (3 u^2 + h^2).
    let levelX = i32(lvsm_field(bits, 10, code.slopeBits)) - (code.slopeLevels + 1);
    let levelY = i32(lvsm_field(bits, 10 + code.slopeBits, code.slopeBits)) - (code.slopeLevels + 1);
    let scale = 1.0 / f32(code.slopeLevels);
    let side = 0.5 * scale;
    let level = vec2f(f32(levelX), f32(levelY)) * scale;
    let square = level * level;

    // Code 0 stands for deviations to half a level, evenly spread: their root mean square is 0.577 of that half's.
    let unit = 1.0 / f32(code.deviationLevels);
    let size = f32(i32(lvsm_field(bits, 10 + 2 * code.slopeBits, code.deviationBits))) * unit;
    var plane: lvsm_MixturePlane;
    plane.weight = 1.0;
    plane.place = vec2f(0.0);
    plane.depth = f32(i32(lvsm_field(bits, 0, 10))) * (1.0 / 1023.0);
    plane.slope = LVSM_MOST_CODED_SLOPE * (level * (square + 3.0 * side * side));
    plane.range = LVSM_MOST_CODED_SLOPE * side * (3.0 * square + side * side);
    plane.spread = vec3f(sigma * sigma, 0.0, sigma * sigma);
    plane.deviation = code.mostDeviation * max(size * size, 0.14433757 * (unit * unit));
    return plane;
}

// Share, place and spread of the plane of that index, counted from 1, from the levels of its code.
fn lvsm_placePlane(plane: ptr<function, lvsm_MixturePlane>, weight: u32, index: i32, x: u32, y: u32, spread: u32,
                   sigma: f32)
{
    (*plane).weight = lvsm_codedWeight(weight, index);
    (*plane).place = lvsm_codedPlace(x, y, sigma);
    let first = spread & 3u;
    let second = spread >> 2u;
    let levelX = f32(i32(select(first, second, first == 3u)));
    let levelY = f32(i32(select(second, first, second == 3u)));
    let extent = sigma * (LVSM_LEAST_EXTENT + LVSM_EXTENT_STEP * vec2f(levelX, levelY));
    let correlation = select(select(0.0, -LVSM_CODED_CORRELATION, second == 3u), LVSM_CODED_CORRELATION, first == 3u);
    (*plane).spread = vec3f(extent.x * extent.x, correlation * (extent.x * extent.y), extent.y * extent.y);
}

// The heaviest plane takes what the others leave of the window's moments.
fn lvsm_completePlanes(m: ptr<function, lvsm_MixturePlanes>, count: i32, sigma: f32)
{
    var shares = 0.0;
    var places = vec2f(0.0);
    var spread = vec3f(sigma * sigma, 0.0, sigma * sigma);
    for (var i = 1; i < LVSM_MAX_COMPONENTS; i++)
    {
        if (i < count)
        {
            let at = (*m).planes[i].place;
            let part = (*m).planes[i].weight;
            shares += part;
            places += part * at;
            spread -= part * ((*m).planes[i].spread + vec3f(at.x * at.x, at.x * at.y, at.y * at.y));
        }
    }
    let weight = lvsm_heaviestWeight(shares);
    let p = lvsm_heaviestPlace(places, weight, sigma);
    let inverse = 1.0 / weight;
    let left = spread * inverse - vec3f(p.x * p.x, p.x * p.y, p.y * p.y);
    let least = 0.05 * (sigma * sigma);
    let most = 1.5 * (sigma * sigma);
    let along = clamp(left.xz, vec2f(least), vec2f(most));
    let correlated = min(along.x, along.y);
    (*m).planes[0].weight = weight;
    (*m).planes[0].place = p;
    (*m).planes[0].spread = vec3f(along.x, clamp(left.y, -correlated, correlated), along.y);
}

fn lvsm_noPlane() -> lvsm_MixturePlane
{
    var none: lvsm_MixturePlane;
    none.weight = 0.0;
    none.place = vec2f(0.0);
    none.depth = 0.0;
    none.slope = vec2f(0.0);
    none.range = vec2f(0.0);
    none.spread = vec3f(0.0);
    none.deviation = 0.0;
    return none;
}

/// The planes that a code of 64 bits holds.
/// code: any bits; what encodeMixture2 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heavier plane first, places within 2.3 deviations, the third and fourth none.
fn lvsm_decodeMixture2(code: vec2u, deviation: f32) -> lvsm_MixturePlanes
{
    let sigma = lvsm_filterDeviation(deviation);
    var lighter = lvsm_planeOfBits(code.y, lvsm_planeCode2(), sigma);
    lvsm_placePlane(&lighter, lvsm_field(code.x, 24, 4), 1, lvsm_field(code.y, 24, 4), code.y >> 28u, code.x >> 28u,
                    sigma);
    var m: lvsm_MixturePlanes;
    m.planes[0] = lvsm_planeOfBits(code.x, lvsm_planeCode2(), sigma);
    m.planes[1] = lighter;
    m.planes[2] = lvsm_noPlane();
    m.planes[3] = lvsm_noPlane();
    lvsm_completePlanes(&m, 2, sigma);
    return m;
}

// Plane of that index, counted from 1, of a code of 128 bits.
fn lvsm_lighterPlane(bits: u32, index: i32, spread: u32, sigma: f32) -> lvsm_MixturePlane
{
    var plane = lvsm_planeOfBits(bits, lvsm_planeCode4(), sigma);
    lvsm_placePlane(&plane, lvsm_field(bits, 20, 4), index, lvsm_field(bits, 24, 4), bits >> 28u, spread, sigma);
    return plane;
}

/// The planes that a code of 128 bits holds.
/// code: any bits; what encodeMixture4 does not write means something too. deviation: of the filter, as it was coded
/// with. Result: the heaviest plane first, places within 2.3 deviations.
fn lvsm_decodeMixture4(code: vec4u, deviation: f32) -> lvsm_MixturePlanes
{
    let sigma = lvsm_filterDeviation(deviation);
    var m: lvsm_MixturePlanes;
    m.planes[0] = lvsm_planeOfBits(code.x, lvsm_planeCode4(), sigma);
    m.planes[1] = lvsm_lighterPlane(code.y, 1, (code.x >> 20u) & 15u, sigma);
    m.planes[2] = lvsm_lighterPlane(code.z, 2, (code.x >> 24u) & 15u, sigma);
    m.planes[3] = lvsm_lighterPlane(code.w, 3, code.x >> 28u, sigma);
    lvsm_completePlanes(&m, 4, sigma);
    return m;
}

// The weight of a plane around a receiver at f, in squares of the filter's deviation.
fn lvsm_weightOfPlane(p: lvsm_MixturePlane, f: vec2f) -> f32
{
    return p.weight * exp(clamp(f.x * p.place.x + f.y * p.place.y, -16.0, 16.0));
}

// Of a plane: the lit share of its taps, and how far behind the receiver's plane they are in the mean, in depth.
// f: the receiver's place; moved: the same in squares of the filter's deviation. g: the receiver's slope; compared: the
// same as far as the plane can tell.
fn lvsm_lightOfPlane(p: lvsm_MixturePlane, f: vec2f, moved: vec2f, depth: f32, g: vec2f, compared: vec2f,
                     bias: f32) -> vec2f
{
    let off = p.slope - compared;
    let d = off - clamp(off, -p.range, p.range);
    let across = vec2f(d.x * p.spread.x + d.y * p.spread.y, d.x * p.spread.y + d.y * p.spread.z);
    let own = depth + (g.x * (p.place.x - f.x) + g.y * (p.place.y - f.y));
    let behind = (p.depth - own) + (across.x * moved.x + across.y * moved.y);
    let variance = across.x * d.x + across.y * d.y + p.deviation * p.deviation;
    let lit = 0.5 + (behind + 0.6 * p.deviation + bias) * inverseSqrt(12.0 * max(variance, 1.0e-10));
    return vec2f(clamp(lit, 0.0, 1.0), behind);
}

fn lvsm_inSquares(f: vec2f, sigma: f32) -> vec2f
{
    return f * (1.0 / (sigma * sigma));
}

/// Share of the window that a plane has around a receiver between texels.
/// plane: weight counts in [0,1] and place in [-256,256], clamped to them. offset: of the receiver from the texel's
/// centre, in texels, each component clamped to [-16,16]; half a texel for a map of full resolution. deviation: of the
/// filter, clamped to [0.25, 64]. Result in [0, 8.9e6], relative to the other planes of the texel.
/// Source: moving a Gaussian window by f tilts its weights by exp(f.p / deviation^2), taken at the centroid.
fn lvsm_planeWeight(plane: lvsm_MixturePlane, offset: vec2f, deviation: f32) -> f32
{
    var p = plane;
    p.weight = clamp(plane.weight, 0.0, 1.0);
    p.place = clamp(plane.place, vec2f(-LVSM_MOST_PLACE), vec2f(LVSM_MOST_PLACE));
    let f = clamp(offset, vec2f(-16.0), vec2f(16.0));
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
fn lvsm_planeLight(plane: lvsm_MixturePlane, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32,
                   bias: f32) -> vec2f
{
    var p: lvsm_MixturePlane;
    p.weight = clamp(plane.weight, 0.0, 1.0);
    p.place = clamp(plane.place, vec2f(-LVSM_MOST_PLACE), vec2f(LVSM_MOST_PLACE));
    p.depth = clamp(plane.depth, 0.0, 1.0);
    p.slope = clamp(plane.slope, vec2f(-1.0), vec2f(1.0));
    p.range = clamp(plane.range, vec2f(0.0), vec2f(1.0));
    p.spread = clamp(plane.spread, vec3f(0.0, -LVSM_MOST_SPREAD, 0.0), vec3f(LVSM_MOST_SPREAD));
    p.deviation = clamp(plane.deviation, 0.0, 1.0);
    let f = clamp(offset, vec2f(-16.0), vec2f(16.0));
    let g = clamp(gradient, vec2f(-1.0), vec2f(1.0));
    return lvsm_lightOfPlane(p, f, lvsm_inSquares(f, lvsm_filterDeviation(deviation)), clamp(depth, 0.0, 1.0), g, g,
                             clamp(bias, 0.0, 1.0));
}

// Sums over the planes of a code: weight, lit weight, weight in shadow, and that times the distance in front of the
// receiver. Slopes that the code does not tell apart are compared as one.
fn lvsm_sumsOfPlanes(m: lvsm_MixturePlanes, count: i32, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32,
                     bias: f32) -> vec4f
{
    let f = clamp(offset, vec2f(-16.0), vec2f(16.0));
    let moved = lvsm_inSquares(f, lvsm_filterDeviation(deviation));
    let g = clamp(gradient, vec2f(-1.0), vec2f(1.0));
    let compared = clamp(gradient, vec2f(-LVSM_MOST_CODED_SLOPE), vec2f(LVSM_MOST_CODED_SLOPE));
    let t = clamp(depth, 0.0, 1.0);
    let allowed = clamp(bias, 0.0, 1.0);
    var sums = vec4f(0.0);
    for (var i = 0; i < LVSM_MAX_COMPONENTS; i++)
    {
        if (i < count)
        {
            let weight = lvsm_weightOfPlane(m.planes[i], moved);
            let light = lvsm_lightOfPlane(m.planes[i], f, moved, t, g, compared, allowed);
            let dark = weight * (1.0 - light.x);
            sums += vec4f(weight, weight * light.x, dark, dark * max(-light.y, 0.0));
        }
    }
    return sums;
}

fn lvsm_visibilityOfSums(sums: vec4f) -> f32
{
    return clamp(sums.y / max(sums.x, 1.0e-12), 0.0, 1.0);
}

fn lvsm_occluderOfSums(sums: vec4f, depth: f32) -> f32
{
    let away = select(sums.w / max(sums.z, 1.0e-12), 0.0, sums.z < 1.0e-12);
    return clamp(clamp(depth, 0.0, 1.0) - away, 0.0, 1.0);
}

/// Visibility of a receiver from a code of 64 bits.
/// code: any bits, not filtered. offset: of the receiver from the code's place, in texels of the shadow map, each
/// component clamped to [-16,16]: at most half a texel for a nearest fetch from a map of full resolution, one of half
/// resolution. depth: the receiver's, in [0,1], clamped to it. gradient: its change per texel of the shadow map, each
/// component clamped to [-1,1]. deviation: of the filter, clamped to [0.25, 64]. bias: in depth, clamped to [0,1], see
/// LVSM_MIXTURE_BIAS. Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
fn lvsm_mixtureVisibility2(code: vec2u, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32, bias: f32) -> f32
{
    let planes = lvsm_decodeMixture2(code, deviation);
    return lvsm_visibilityOfSums(lvsm_sumsOfPlanes(planes, 2, offset, depth, gradient, deviation, bias));
}

/// Visibility of a receiver from a code of 128 bits.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1], an estimate and no bound.
/// Source: the mean of planeLight, weighted by planeWeight.
fn lvsm_mixtureVisibility4(code: vec4u, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32, bias: f32) -> f32
{
    let planes = lvsm_decodeMixture4(code, deviation);
    return lvsm_visibilityOfSums(lvsm_sumsOfPlanes(planes, 4, offset, depth, gradient, deviation, bias));
}

/// Mean depth of what is in front of a receiver, from a code of 64 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
fn lvsm_mixtureOccluder2(code: vec2u, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32, bias: f32) -> f32
{
    let planes = lvsm_decodeMixture2(code, deviation);
    return lvsm_occluderOfSums(lvsm_sumsOfPlanes(planes, 2, offset, depth, gradient, deviation, bias), depth);
}

/// Mean depth of what is in front of a receiver, from a code of 128 bits: contact hardening needs it.
/// code, offset, depth, gradient, deviation, bias: as mixtureVisibility2 takes them.
/// Result in [0,1]: depth less the mean distance of the dark share from the receiver's plane; depth where all is lit.
/// Source: the mean of planeLight's distance, weighted by planeWeight and by what is dark.
fn lvsm_mixtureOccluder4(code: vec4u, offset: vec2f, depth: f32, gradient: vec2f, deviation: f32, bias: f32) -> f32
{
    let planes = lvsm_decodeMixture4(code, deviation);
    return lvsm_occluderOfSums(lvsm_sumsOfPlanes(planes, 4, offset, depth, gradient, deviation, bias), depth);
}
