// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config.
// Filter kernels: weights of separable blurs, pairs of taps that one bilinear fetch serves, and the head room of sums.

// Most taps that a kernel is computed for.
const LVSM_MAX_FILTER_SIZE: i32 = 65;

/// Weight of one tap of a binomial filter: a row of Pascal's triangle, normalised.
/// index: of the tap, from 0 to size - 1; any other weighs 0. size: number of taps, from 1 to 65, clamped to it.
/// Result in [0,1]. The weights of a size add up to 1; their variance is (size - 1) / 4 texels squared.
/// Source: the binomial coefficient C(size - 1, index) / 2^(size - 1).
fn lvsm_binomialWeight(index: i32, size: i32) -> f32
{
    let last = clamp(size, 1, LVSM_MAX_FILTER_SIZE) - 1;
    if (index < 0 || index > last)
    {
        return 0.0;
    }
    let steps = min(index, last - index);
    var weight = 1.0;
    for (var j = 1; j <= last; j++)
    {
        weight *= 0.5;
        if (j <= steps)
        {
            weight *= f32(last + 1 - j) / f32(j);
        }
    }
    return weight;
}

// A Gaussian at one of count taps, 1 at the tap or taps in the middle. Distances from the middle are m / 2 for integers
// m of one parity: relative to the least of them even a vanishing sigma leaves the middle its weight.
fn lvsm_gaussianFalloff(index: i32, count: i32, sigma: f32) -> f32
{
    let deviation = clamp(sigma, 0.015625, 1048576.0);
    let m = 2 * index - (count - 1);
    let squared = 0.25 * f32(m * m - (1 - (count & 1)));
    return exp(-0.5 * squared / (deviation * deviation));
}

/// Weight of one tap of a Gaussian filter, sampled at the taps' centres and normalised.
/// index: of the tap, from 0 to size - 1; any other weighs 0. size: number of taps, from 1 to 65, clamped to it.
/// sigma: standard deviation in texels, from 1/64 to 2^20, clamped to it.
/// Result in [0,1]. The weights of a size add up to 1.
/// Degenerate: the least sigma leaves the middle alone, the greatest is a box.
/// Source: e^(-x^2 / (2 sigma^2)), x the distance from the middle.
fn lvsm_gaussianWeight(index: i32, size: i32, sigma: f32) -> f32
{
    let count = clamp(size, 1, LVSM_MAX_FILTER_SIZE);
    if (index < 0 || index >= count)
    {
        return 0.0;
    }
    var sum = 0.0;
    for (var i = 0; i < count; i++)
    {
        sum += lvsm_gaussianFalloff(i, count, sigma);
    }
    return clamp(lvsm_gaussianFalloff(index, count, sigma) / max(sum, 1.0), 0.0, 1.0);
}

/// Weight of one texel of a box filter of any width, whole texels or not.
/// offset: of the texel's centre from the box's, in texels. width: in texels, from 2^-20 to 2^20, clamped to it.
/// Result in [0,1]: the texel's share of the box. The weights of all texels add up to 1 wherever the box is centred.
/// Degenerate: a box inside one texel gives that texel all.
/// Source: the overlap of two intervals, divided by the width.
fn lvsm_boxWeight(offset: f32, width: f32) -> f32
{
    let extent = clamp(width, 9.5367431640625e-7, 1048576.0);
    let reach = 0.5 * extent;
    let centre = clamp(abs(offset), 0.0, 2097152.0);
    let overlap = min(centre + 0.5, reach) - max(centre - 0.5, -reach);
    return clamp(overlap / extent, 0.0, 1.0);
}

/// Two neighbouring taps as one bilinear fetch.
/// first, second: their weights, from 0 to 2^125, clamped to it.
/// Result: the fetch's offset from the first tap's centre towards the second's, in [0,1] texels, and its weight, the
/// sum of the two, in [0, 2^126]. Hardware that keeps 8 bits of the offset misplaces up to 2^-9 of that weight.
/// Degenerate: two weights of 0 give (0, 0).
/// Source: first a + second b = (first + second) mix(a, b, offset), solved for offset.
fn lvsm_linearPair(first: f32, second: f32) -> vec2f
{
    let a = clamp(first, 0.0, 0.5 * LVSM_HUGE);
    let b = clamp(second, 0.0, 0.5 * LVSM_HUGE);
    return vec2f(clamp(b / max(a + b, LVSM_TINY), 0.0, 1.0), a + b);
}

/// One bilinear fetch of a binomial filter: size taps cost (size + 1) / 2 fetches, so 9 taps cost 5.
/// index: of the fetch, from 0 to (size - 1) / 2; any other gives (0, 0). size: taps, from 1 to 65, clamped to it.
/// Result: the fetch's offset from the filter's centre, in texels, in [-32, 32], and its weight, in [0,1].
/// Source: linearPair of taps 2 index and 2 index + 1.
fn lvsm_binomialTap(index: i32, size: i32) -> vec2f
{
    let last = clamp(size, 1, LVSM_MAX_FILTER_SIZE) - 1;
    if (index < 0 || index > last / 2)
    {
        return vec2f(0.0, 0.0);
    }
    let pair = lvsm_linearPair(lvsm_binomialWeight(2 * index, size), lvsm_binomialWeight(2 * index + 1, size));
    return vec2f(f32(2 * index) - 0.5 * f32(last) + pair.x, pair.y);
}

/// One bilinear fetch of a Gaussian filter: size taps cost (size + 1) / 2 fetches, so 9 taps cost 5.
/// index: of the fetch, from 0 to (size - 1) / 2; any other gives (0, 0). size: taps, from 1 to 65, clamped to it.
/// sigma: standard deviation in texels, from 1/64 to 2^20, clamped to it.
/// Result: the fetch's offset from the filter's centre, in texels, in [-32, 32], and its weight, in [0,1].
/// Source: linearPair of taps 2 index and 2 index + 1.
fn lvsm_gaussianTap(index: i32, size: i32, sigma: f32) -> vec2f
{
    let last = clamp(size, 1, LVSM_MAX_FILTER_SIZE) - 1;
    if (index < 0 || index > last / 2)
    {
        return vec2f(0.0, 0.0);
    }
    let pair = lvsm_linearPair(lvsm_gaussianWeight(2 * index, size, sigma),
                               lvsm_gaussianWeight(2 * index + 1, size, sigma));
    return vec2f(f32(2 * index) - 0.5 * f32(last) + pair.x, min(pair.y, 1.0));
}

/// How often a binomial sum with whole weights, not yet divided, holds its largest sample: head room for maxExponent.
/// size: number of taps, from 1 to 65, clamped to it. dimensions: 1 for one pass of a separable blur, 2 for both before
/// the division, from 1 to 3, clamped to it. Result in [1, 2^126]: 2^((size - 1) dimensions).
/// Source: the sum of a row of Pascal's triangle.
fn lvsm_binomialHeadRoom(size: i32, dimensions: i32) -> f32
{
    let doublings = min((clamp(size, 1, LVSM_MAX_FILTER_SIZE) - 1) * clamp(dimensions, 1, 3), 126);
    var room = 1.0;
    for (var i = 0; i < doublings; i++)
    {
        room *= 2.0;
    }
    return room;
}

/// How often a sum over a rectangle, not yet divided, holds its largest sample: head room for maxExponent.
/// width, height: of the box in texels, or of the whole map for a summed-area table, from 1 to 2^63, clamped to it.
/// Result: width height, in [1, 2^126].
/// Source: the sum of that many samples, each at most the largest.
fn lvsm_boxHeadRoom(width: f32, height: f32) -> f32
{
    return clamp(width, 1.0, 9.223372036854775808e18) * clamp(height, 1.0, 9.223372036854775808e18);
}

/// Visibility between four texels, after each has been tested: the order that percentage-closer filtering needs.
/// corners: of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy; each clamped to [0,1].
/// fraction: position between the centres of the first and the last, each component clamped to [0,1]. Result in [0,1].
/// Source: bilinear interpolation.
fn lvsm_bilinearVisibility(corners: vec4f, fraction: vec2f) -> f32
{
    let c = clamp(corners, vec4f(0.0), vec4f(1.0));
    let f = clamp(fraction, vec2f(0.0), vec2f(1.0));
    let rows = c.xz * (1.0 - f.x) + c.yw * f.x;
    return clamp(rows.x * (1.0 - f.y) + rows.y * f.y, 0.0, 1.0);
}
