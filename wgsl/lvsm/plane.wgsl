// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket.
// Bracketed layers judged relative to the receiver's plane: a slanted surface is neither its own shadow nor its own
// variance.
//
// Over the filter window a receiver's plane departs from the receiver's depth by u, the gradient times the offset from
// the receiver. Depth less u has the same mean, and a variance that differs by the covariance of depth and u. A
// Gaussian filter makes that known: it is the filter's variance times the gradient of the filtered mean, along u. So
// the four neighbouring texels of the same map tell it, and nothing more needs to be stored.

/// Covariance of a filtered mean with the receiver's plane over the filter window.
/// neighbours: the filtered first moment of a layer one texel to the right, left, up and down, each in [0,1], clamped
/// to it. gradient: of the receiver's depth per texel, right and up, each clamped to [-1,1].
/// deviation: standard deviation of the filter along each axis in texels, in [0, 65536], clamped to it.
/// Result: in depth times the unit of the mean, in [-4.3e9, 4.3e9].
/// Source: for a Gaussian filter E[offset x] is the gradient of E[x] times the filter's variance, by parts; central
/// differences.
fn lvsm_planeCovariance(neighbours: vec4f, gradient: vec2f, deviation: f32) -> f32
{
    let width = clamp(deviation, 0.0, 65536.0);
    let means = clamp(neighbours, vec4f(0.0), vec4f(1.0));
    let slope = clamp(gradient, vec2f(-1.0), vec2f(1.0));
    let along = slope.x * (means.x - means.y) + slope.y * (means.z - means.w);
    return 0.5 * (width * width) * along;
}

/// Variance of the receiver's plane over the filter window.
/// gradient: of the receiver's depth per texel, its components clamped to [-1,1]. deviation: standard deviation of the
/// filter along each axis in texels, in [0, 65536], clamped to it. Result in depth squared, in [0, 8.6e9].
/// Source: the variance of a linear function under a filter of equal deviations.
fn lvsm_planeVariance(gradient: vec2f, deviation: f32) -> f32
{
    let slope = clamp(gradient, vec2f(-1.0), vec2f(1.0));
    let width = clamp(deviation, 0.0, 65536.0);
    return (slope.x * slope.x + slope.y * slope.y) * (width * width);
}

/// Visibility of a slanted receiver from the moments of its layer and of the two neighbours, relative to its plane.
/// front, moments, behind: as bracketMoments takes them. covariances: of the three with the plane, as planeCovariance
/// gives them, each clamped to [-1,1]. depth: the receiver's, in [0,1]. interval: begin and end of the layer, or of the
/// union of layers that the plane reaches; its length counts as 2^-10 at least. variance: of the plane, clamped to
/// [0,1]. minVariance: the global floor in depth squared, >= 0. amount: light that what is left in the layer is reduced
/// by, as reduceLightBleeding takes it: occluders in the receiver's own layer are often spread from contact on, which
/// the bound takes for light; 0.15 suits meshes. Result in [0,1], an estimate and no bound.
/// Source: bracketMoments; boundedUpperBound of depth less the plane, whose departure is shared out among what is in
/// front, behind and left; the floor takes a tenth of the plane's variance, for what bends and for what is no Gaussian.
fn lvsm_planeBracketedVisibility(front: vec2f, moments: vec2f, behind: vec2f, covariances: vec3f, depth: f32,
                                 interval: vec2f, variance: f32, minVariance: f32, amount: f32) -> f32
{
    let spread = clamp(variance, 0.0, 1.0);
    let least = lvsm_layerMinVariance(max(minVariance, 0.1 * spread), interval);
    let left = lvsm_bracketMoments(front, moments, behind, least);
    let scale = 1.0 / clamp(interval.y - interval.x, 0.0009765625, 1.0);

    // Departures of the plane where the window is in front of the layer, behind it, and in it.
    let departures = scale * clamp(covariances, vec3f(-1.0), vec3f(1.0));
    let shareInFront = max(1.0 - left.x - left.y, 0.0);
    let inFront = departures.x * shareInFront / clamp(1.0 - front.x, 0.001, 1.0);
    let beyond = departures.z * left.x / clamp(behind.x, 0.001, 1.0);
    let inverse = 1.0 / max(left.y, 0.001);
    let m1 = (left.z + (beyond - inFront)) * inverse;
    let m2 = ((left.w - 2.0 * (departures.y - beyond)) + left.y * (spread * (scale * scale))) * inverse;

    let bound = lvsm_boundedUpperBound(vec2f(m1, m2), lvsm_layerWarp(depth, interval), least * inverse);
    return clamp(left.x + left.y * lvsm_reduceLightBleeding(bound, amount), 0.0, 1.0);
}
