// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config.
// Convolution shadow maps: the depth test as a Fourier series, whose terms in the occluder's depth filter linearly.
// Annen, Mertens, Bekaert, Seidel & Kautz, Convolution Shadow Maps, Eurographics Symposium on Rendering 2007.
//
// The test of t = z - d, 1 for t >= 0, is 1/2 + 2 sum of sin(c_k t) / c_k, with c_k = (2k - 1) pi for k = 1 to the
// order. sin(c_k (z - d)) separates into sines and cosines of z, which are stored, four terms to a texel each, and
// those of d. The series has period 2, and towards -1 and 1 it turns back to 1/2: depths are shrunk here by twice the
// distance from a step to its crest, so that no two depths, with that offset between them, come so far apart.

// Most terms: far more than any memory holds.
const LVSM_MAX_FOURIER_ORDER: i32 = 256;

const LVSM_PI: f32 = 3.14159265;

/// What a receiver is moved towards the light so that a lit surface is on the first crest of the series, not at 1/2.
/// order: number of terms, from 2 to 256, clamped to it. Result in depth, in (0, 1/4]: 1 / (2 order), 0.031 for 16.
/// Source: the first zero of the derivative of the series, sin(2 order pi t) / sin(pi t).
fn lvsm_fourierOffset(order: i32) -> f32
{
    return 0.5 / f32(clamp(order, 2, LVSM_MAX_FOURIER_ORDER));
}

// The angles c_k of four terms times a depth, in [-pi, pi], where sines and cosines have their stated precision.
fn lvsm_fourierAngles(depth: f32, first: i32) -> vec4f
{
    let k = clamp(first, 1, LVSM_MAX_FOURIER_ORDER);
    let halfTurns = depth * vec4f(f32(2 * k - 1), f32(2 * k + 1), f32(2 * k + 3), f32(2 * k + 5));
    return LVSM_PI * (halfTurns - 2.0 * floor(0.5 * halfTurns + 0.5));
}

// Depth shrunk so that the series does not reach its next step.
fn lvsm_fourierDepth(depth: f32, order: i32) -> f32
{
    return (1.0 - 2.0 * lvsm_fourierOffset(order)) * clamp(depth, 0.0, 1.0);
}

/// Sines to store of four terms for one depth.
/// depth: in [0,1], clamped to it. first: number of the first of the four terms, counted from 1, clamped to [1, 256].
/// order: number of all terms, from 2 to 256, clamped to it. Result: each in [-1,1]; terms beyond the order are unused.
/// A texel without any surface stores depth 1.
/// Source: CSM's basis functions sin(c_k z).
fn lvsm_fourierSines(depth: f32, first: i32, order: i32) -> vec4f
{
    return clamp(sin(lvsm_fourierAngles(lvsm_fourierDepth(depth, order), first)), vec4f(-1.0), vec4f(1.0));
}

/// Cosines to store of four terms for one depth.
/// depth: in [0,1], clamped to it. first: number of the first of the four terms, counted from 1, clamped to [1, 256].
/// order: number of all terms, from 2 to 256, clamped to it. Result: each in [-1,1]; terms beyond the order are unused.
/// A texel without any surface stores depth 1.
/// Source: CSM's basis functions cos(c_k z).
fn lvsm_fourierCosines(depth: f32, first: i32, order: i32) -> vec4f
{
    return clamp(cos(lvsm_fourierAngles(lvsm_fourierDepth(depth, order), first)), vec4f(-1.0), vec4f(1.0));
}

/// Sines or cosines as an unsigned 8-bit format holds them: -1, 0 and 1 fall on whole codes, 1, 128 and 255.
/// terms: each clamped to [-1,1]. Result: each in [1/255, 1]. Filtering may come after it.
/// Source: (127 x + 128) / 255.
fn lvsm_encodeFourier(terms: vec4f) -> vec4f
{
    return (127.0 * clamp(terms, vec4f(-1.0), vec4f(1.0)) + 128.0) / 255.0;
}

/// Sines or cosines back from an unsigned 8-bit format.
/// texel: as encodeFourier made it, filtered; each clamped to [0,1]. Result: each in [-1,1].
/// Source: the inverse of encodeFourier.
fn lvsm_decodeFourier(texel: vec4f) -> vec4f
{
    return clamp((255.0 * clamp(texel, vec4f(0.0), vec4f(1.0)) - 128.0) / 127.0, vec4f(-1.0), vec4f(1.0));
}

/// Factor of one term that suppresses the ringing of the cut series, at the cost of a softer step.
/// index: of the term, counted from 1, clamped to [1, order]. order: number of terms, from 2 to 256, clamped to it.
/// strength: 0 leaves the term as it is, less counts as 0; at most 2^126. Result in [0,1], falling with index.
/// Source: CSM's attenuation e^(-strength (k / order)^2).
fn lvsm_fourierAttenuation(index: i32, order: i32, strength: f32) -> f32
{
    let count = clamp(order, 2, LVSM_MAX_FOURIER_ORDER);
    let ratio = f32(clamp(index, 1, count)) / f32(count);
    return clamp(exp(-clamp(strength, 0.0, LVSM_HUGE) * (ratio * ratio)), 0.0, 1.0);
}

// Weight of one term in the sum, 0 beyond the order.
fn lvsm_fourierWeight(index: i32, order: i32, strength: f32) -> f32
{
    let weight = 2.0 * lvsm_fourierAttenuation(index, order, strength) / (LVSM_PI * f32(2 * index - 1));
    return select(0.0, weight, index <= order);
}

/// Share of four terms in the series at a receiver: add those of all terms and pass the sum to fourierVisibility.
/// sines, cosines: as stored for the four terms, filtered, each clamped to [-1,1]. depth: the receiver's, in [0,1],
/// clamped to it. offset: towards the light, clamped to [0,1], see fourierOffset. first: number of the first of the
/// four, counted from 1, clamped to [1, 256]. order: number of all terms, from 2 to 256, clamped to it; terms beyond it
/// count nothing. strength: of fourierAttenuation. Result in [-1.51, 1.51].
/// Source: CSM's reconstruction, 2 / c_k (cos(c_k d) sin(c_k z) - sin(c_k d) cos(c_k z)).
fn lvsm_fourierSum(sines: vec4f, cosines: vec4f, depth: f32, offset: f32, first: i32, order: i32, strength: f32) -> f32
{
    let k = clamp(first, 1, LVSM_MAX_FOURIER_ORDER);
    let count = clamp(order, 2, LVSM_MAX_FOURIER_ORDER);
    let angles = lvsm_fourierAngles(lvsm_fourierDepth(depth, order) - clamp(offset, 0.0, 1.0), k);
    let terms = cos(angles) * clamp(sines, vec4f(-1.0), vec4f(1.0)) -
                sin(angles) * clamp(cosines, vec4f(-1.0), vec4f(1.0));
    return lvsm_fourierWeight(k, count, strength) * terms.x + lvsm_fourierWeight(k + 1, count, strength) * terms.y +
           lvsm_fourierWeight(k + 2, count, strength) * terms.z + lvsm_fourierWeight(k + 3, count, strength) * terms.w;
}

/// Visibility of a receiver from the summed series.
/// sum: of fourierSum over all terms. scale: 1, or 2 to take what a surface has of itself without offset, 1/2, for full
/// light; >= 0, less counts as 0, at most 2^126. Result in [0,1].
/// Source: CSM's reconstruction, scaled and clamped.
fn lvsm_fourierVisibility(sum: f32, scale: f32) -> f32
{
    return clamp(clamp(scale, 0.0, LVSM_HUGE) * clamp(0.5 + sum, 0.0, 1.0), 0.0, 1.0);
}
