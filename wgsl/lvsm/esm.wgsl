// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter.
// Exponential shadow maps: the depth test as e^(-c d) e^(c z), which filters linearly in its second factor.
// Annen, Mertens, Seidel, Flerackers & Kautz, Exponential Shadow Maps, Graphics Interface 2008.
//
// Either store occluderTerm, filter it linearly, and judge with exponentialShadow: c is bound by the format. Or store
// the depth itself, filter with logAdd and logFiltered, and judge with logShadow: stable for any c.

// Largest c for which both factors are normal floats: 126 ln 2 = 87.33654, less 4e-5 for the error of exp,
// 3 + 2 |x| units in the last place. 80, which the paper uses in fp32, leaves room for a sum of 6141 samples.
const LVSM_MAX_TERM_EXPONENT: f32 = 87.3365;

/// Largest c whose occluder terms a storage format can hold and a filter can sum.
/// largest: the format's largest finite value, see LVSM_LARGEST constants; less than 1 counts as 1.
/// headRoom: how often an unnormalised filter sum holds its largest sample, >= 1 (1 for weights that sum to 1). Each
/// rounding to fp16 on the way needs 1/2048 more of it.
/// Result in [0, 87.3365]: 11.09 for fp16 and 87.3365 for fp32 without head room. Rounding by a share of the term (at
/// most 2^-11 in fp16, 2^-24 in fp32) changes visibility by the same share.
/// Source: headRoom e^c <= largest, solved for c; ESM section 3.1.
fn lvsm_maxTermExponent(largest: f32, headRoom: f32) -> f32
{
    let ratio = max(largest, 1.0) / clamp(headRoom, 1.0, LVSM_HUGE);
    return clamp(log(max(ratio, 1.0)), 0.0, LVSM_MAX_TERM_EXPONENT);
}

/// Occluder term to store for one depth: e^(c z).
/// depth: in [0,1], clamped to it. exponent: c, clamped to [0, 87.3365]. Result in [1, 8.6e37], rising with depth.
/// A texel without any surface stores depth 1.
/// Source: ESM equation 3.
fn lvsm_occluderTerm(depth: f32, exponent: f32) -> f32
{
    return max(exp(clamp(exponent, 0.0, LVSM_MAX_TERM_EXPONENT) * clamp(depth, 0.0, 1.0)), 1.0);
}

// The receiver's factor, e^(-c d).
fn lvsm_receiverTerm(depth: f32, exponent: f32) -> f32
{
    return exp(-clamp(exponent, 0.0, LVSM_MAX_TERM_EXPONENT) * clamp(depth, 0.0, 1.0));
}

/// Visibility of a receiver from the filtered occluder term, clamped to 1.
/// occluder: as occluderTerm made it, filtered. depth: the receiver's, in [0,1], clamped to it. exponent: c as when
/// stored, clamped to [0, 87.3365]. Result in [0,1]. Not a bound: it darkens too little near an occluder, and where the
/// window holds depths beyond the receiver, see violatesThreshold and violatesZMax.
/// Source: ESM equation 4 and section 3.2.
fn lvsm_exponentialShadow(occluder: f32, depth: f32, exponent: f32) -> f32
{
    return clamp(lvsm_receiverTerm(depth, exponent) * occluder, 0.0, 1.0);
}

/// Whether the window must hold depths beyond the receiver, so that exponentialShadow is wrong: the cheap test.
/// occluder: the filtered occluder term. depth: the receiver's, in [0,1], clamped to it. exponent: c as when stored,
/// clamped to [0, 87.3365]. threshold: the accepted excess over 1, >= 0, less counts as 0; the paper shows 0.02.
/// Result: true where the unclamped shadow exceeds 1 + threshold. It can miss: only the filtered value is seen.
/// Source: ESM section 3.3, threshold classification.
fn lvsm_violatesThreshold(occluder: f32, depth: f32, exponent: f32, threshold: f32) -> bool
{
    return lvsm_receiverTerm(depth, exponent) * occluder > 1.0 + max(threshold, 0.0);
}

/// Whether the window holds depths beyond the receiver, so that exponentialShadow is wrong: the conservative test.
/// depth: the receiver's. zMax: the greatest depth in the window, of a map made with maxDepth. offset: added to depth
/// so that a lit surface is not flagged by itself, >= 0; the paper shows 0.001. All clamped to [0,1].
/// Result: true where depth + offset < zMax.
/// Source: ESM section 3.3, Z-Max classification.
fn lvsm_violatesZMax(depth: f32, zMax: f32, offset: f32) -> bool
{
    return clamp(depth, 0.0, 1.0) + clamp(offset, 0.0, 1.0) < clamp(zMax, 0.0, 1.0);
}

/// The greatest of four depths: one step of the max filter and of the mip chain that violatesZMax reads.
/// depths: each clamped to [0,1]. Result in [0,1].
/// Source: ESM section 3.3.
fn lvsm_maxDepth(depths: vec4f) -> f32
{
    return clamp(max(max(depths.x, depths.y), max(depths.z, depths.w)), 0.0, 1.0);
}

/// Visibility where exponentialShadow fails: four texels judged apart, then interpolated.
/// occluders: unfiltered terms of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy.
/// fraction: position between the centres of the first and the last, each component clamped to [0,1].
/// depth: the receiver's, in [0,1], clamped to it. exponent: c as when stored, clamped to [0, 87.3365].
/// Result in [0,1].
/// Source: ESM section 3.3, the custom filter.
fn lvsm_exponentialShadow2x2(occluders: vec4f, fraction: vec2f, depth: f32, exponent: f32) -> f32
{
    return lvsm_bilinearVisibility(lvsm_receiverTerm(depth, exponent) * occluders, fraction);
}

/// One more sample of a filter over occluder terms that are never formed: only their logarithms, the depths, are.
/// sum: (greatest depth, sum of weights relative to its term) so far, (0, 0) at first; clamped to [0,1] and [0, 2^125].
/// depth: the sample, or what logFiltered gave in an earlier pass, clamped to [0,1]. weight: of the sample, clamped to
/// [0, 2^125]. exponent: c, clamped to [1, 2^126]. Result: the new sum, in [0,1] and [0, 2^126].
/// Source: the sum of ESM equation 4 with its largest term taken out.
fn lvsm_logAdd(sum: vec2f, depth: f32, weight: f32, exponent: f32) -> vec2f
{
    let c = clamp(exponent, 1.0, LVSM_HUGE);
    let z = clamp(depth, 0.0, 1.0);
    let before = clamp(sum.x, 0.0, 1.0);
    let greatest = max(before, z);
    let kept = clamp(sum.y, 0.0, 0.5 * LVSM_HUGE) * exp(c * (before - greatest));
    return vec2f(greatest, kept + clamp(weight, 0.0, 0.5 * LVSM_HUGE) * exp(c * (z - greatest)));
}

/// The filtered value of a log-space filter: the depth whose occluder term is the filtered one.
/// sum: as logAdd left it, after weights that add up to 1. exponent: c, clamped to [1, 2^126].
/// Result in [0,1]: ln(sum of weight e^(c depth)) / c, between the least and the greatest depth.
/// Degenerate: no samples give 0.
/// Source: ESM equation 4, its logarithm divided by c.
fn lvsm_logFiltered(sum: vec2f, exponent: f32) -> f32
{
    let c = clamp(exponent, 1.0, LVSM_HUGE);
    return clamp(clamp(sum.x, 0.0, 1.0) + log(clamp(sum.y, LVSM_TINY, LVSM_HUGE)) / c, 0.0, 1.0);
}

/// Visibility of a receiver from a value filtered in log space: exponentialShadow for any c.
/// filtered: as logFiltered gave it, clamped to [0,1]. depth: the receiver's, in [0,1], clamped to it.
/// exponent: c, clamped to [1, 2^126]. Result in [0,1]: 1 where filtered is at depth or farther.
/// Source: ESM equation 4 and section 3.2.
fn lvsm_logShadow(filtered: f32, depth: f32, exponent: f32) -> f32
{
    let difference = clamp(filtered, 0.0, 1.0) - clamp(depth, 0.0, 1.0);
    return clamp(exp(clamp(exponent, 1.0, LVSM_HUGE) * min(difference, 0.0)), 0.0, 1.0);
}
