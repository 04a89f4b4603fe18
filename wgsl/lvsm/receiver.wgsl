// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config.
// The receiver's slope: what keeps a slanted surface from shadowing itself over a filter window.
//
// All functions take the gradient of the receiver's depth over the texels of the map, (dz/dx, dz/dy), from
// receiverGradient or from the surface's normal. They serve every technique: shift the receiver's depth before it is
// judged, or raise the variance floor that the technique is given.

/// Gradient of the receiver's depth over the map, from screen derivatives.
/// dx, dy: derivatives along the screen's x and y of the receiver's (x, y, depth) in the map, x and y in texels.
/// Components beyond 1e18 count as 1e18. Result: change of depth per texel along the map's x and y, each in [-1,1].
/// Degenerate: a receiver that is a line in the map has no gradient: (0, 0).
/// Source: dx.z = g.x dx.x + g.y dx.y and the same for dy, solved by Cramer's rule.
fn lvsm_receiverGradient(dx: vec3f, dy: vec3f) -> vec2f
{
    let a = clamp(dx, vec3f(-1.0e18), vec3f(1.0e18));
    let b = clamp(dy, vec3f(-1.0e18), vec3f(1.0e18));
    let determinant = a.x * b.y - a.y * b.x;
    if (determinant < LVSM_TINY && determinant > -LVSM_TINY)
    {
        return vec2f(0.0, 0.0);
    }
    let adjugate = vec2f(a.z * b.y - b.z * a.y, b.z * a.x - a.z * b.x);
    return clamp(adjugate / determinant, vec2f(-1.0), vec2f(1.0));
}

/// Depth of the receiver's plane at an offset from the receiver: what a tap of the filter should be compared with.
/// depth: the receiver's, in [0,1]. gradient: of the depth per texel, its components clamped to [-1,1].
/// offset: of the tap in texels, clamped to [-1e18, 1e18]. Result in [0,1].
fn lvsm_planeDepth(depth: f32, gradient: vec2f, offset: vec2f) -> f32
{
    let rise = clamp(gradient, vec2f(-1.0), vec2f(1.0)) * clamp(offset, vec2f(-1.0e18), vec2f(1.0e18));
    let plane = depth + (rise.x + rise.y);
    return clamp(plane, 0.0, 1.0);
}

/// Depth of the receiver moved towards the light, in proportion to its slope.
/// depth: the receiver's, in [0,1]. gradient: of the depth per texel, its components clamped to [-1,1].
/// shift: in texels, >= 0, less counts as 0, more than 1e18 as that. The filter's radius takes the receiver in front of
/// all of its own samples and lifts shadows off their contact as far; 0 to 0.3 suits meshes.
/// Result in [0,1]: depth - shift (|dz/dx| + |dz/dy|).
fn lvsm_shiftReceiver(depth: f32, gradient: vec2f, shift: f32) -> f32
{
    let slope = min(abs(gradient), vec2f(1.0));
    return clamp(depth - clamp(shift, 0.0, 1.0e18) * (slope.x + slope.y), 0.0, 1.0);
}

/// Variance floor for a slanted receiver: four times the variance that its own plane has over the filter.
/// minVariance: the global floor in depth squared, >= 0, less counts as 0.
/// gradient: of the depth per texel, its components clamped to [-1,1].
/// deviation: standard deviation of the filter along each axis in texels, in [0, 65536], clamped to it; that of a
/// binomial filter of n taps is sqrt(n - 1) / 2, of a box of n texels sqrt((n^2 - 1) / 12).
/// Result in depth squared: at least minVariance.
/// Source: the variance of a plane's depth under a filter is |gradient|^2 deviation^2. A floor of four times as much
/// leaves its own samples, which reach two deviations in front of it, at least half lit by LVSM equation 3.
fn lvsm_receiverMinVariance(minVariance: f32, gradient: vec2f, deviation: f32) -> f32
{
    let slope = clamp(gradient, vec2f(-1.0), vec2f(1.0));
    let width = clamp(deviation, 0.0, 65536.0);
    return max(max(minVariance, 0.0), 4.0 * (slope.x * slope.x + slope.y * slope.y) * (width * width));
}
