// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config.
// Trigonometric moments: four numbers in unorm16 that hardware filters, and the bound that they give.
//
// A depth is a point on an arc of the unit circle; stored are the means of that complex number z and of its square. An
// arc is curved alike everywhere, so that rounding costs the same at every depth, and less than it costs the powers of a
// depth. For a third of a window each at depths 0, 0.5 and 1 both means are 0: so the bias against rounding is a factor.
//
// The arc is 4 pi / 3 long. Up to pi the bound would be one without exception, but rounding would cost what is won; here
// it can fall below the truth: by less than 0.01, and by less than 1e-4 where a window's depths are at most 3/4 apart.

/// Least bias with which rounding never makes trigonometric moments invalid.
/// storedError: largest error of a stored component, in [0,1], clamped to it; half a step of unorm, times one and the
/// number of blurs that round again. Result in [0,1].
/// Source: bias I + T(error) has no negative eigenvalue, for T the Toeplitz matrix of any error of that size.
fn lvsm_recommendedTrigonometricBias(storedError: f32) -> f32
{
    return min(5.14974 * clamp(storedError, 0.0, 1.0), 1.0);
}

// The point (cos a, sin a) of a depth, for a = (depth - 1/2) 4 pi / 3. Polynomials for the sine and cosine of a / 2, off
// by 2e-8 at most: of its own functions Vulkan promises 2^-11 only.
fn lvsm_arcPoint(depth: f32) -> vec2f
{
    let x = clamp(depth, 0.0, 1.0) - 0.5;
    let u = x * x;
    let sine = x * (2.09439482 + u * (-1.53115888 + u * (0.335603377 - u * 0.0338900668)));
    let cosine = 1.0 + u * (-2.19324526 + u * (0.801715566 + u * (-0.117164665 + u * 0.00890638713)));
    return vec2f(1.0 - 2.0 * sine * sine, 2.0 * sine * cosine);
}

/// Trigonometric moments to store for one depth.
/// depth: in [0,1], clamped to it. Result: each in [0,1], from the point (x, y) of the depth on the arc: (2/3 x + 1/3,
/// 1/2 + 1/2 y, x^2, 1/2 + x y), which is linear in the point and in its square.
/// A texel without any surface stores depth 1: (0, 0.9330127, 0.25, 0.0669873).
fn lvsm_trigonometricMoments(depth: f32) -> vec4f
{
    let p = lvsm_arcPoint(depth);
    return clamp(vec4f(0.666666667 * p.x + 0.333333333, 0.5 + 0.5 * p.y, p.x * p.x, 0.5 + p.x * p.y), vec4f(0.0),
                 vec4f(1.0));
}

/// Visibility of a receiver from trigonometric moments: an upper bound on the lit share of the filter window.
/// moments: as trigonometricMoments made them, filtered. depth: the receiver's, in [0,1], clamped to it.
/// bias: share of a wide distribution that is mixed in against rounding, in [0,1], see recommendedTrigonometricBias.
/// Result in [0,1]. Exact for up to two occluder depths and the receiver's, but for the bias.
/// Degenerate: moments that no distribution has are moved towards the boundary of those that are.
/// Source: Markov's and Krein's bound for two trigonometric moments. The distribution that meets it has an atom at the
/// receiver's point t and two at the zeros of the kernel polynomial, whose coefficients are the inverse of the Toeplitz
/// matrix of the moments times (1, t, t^2). All is times its determinant.
fn lvsm_trigonometricVisibility(moments: vec4f, depth: f32, bias: f32) -> f32
{
    let keep = 1.0 - clamp(bias, 0.0, 1.0);
    let means = vec4f(1.5, 2.0, 2.0, 2.0) * keep * clamp(moments, vec4f(0.0), vec4f(1.0)) -
                vec4f(0.5, 1.0, 1.0, 1.0) * keep;
    let m = means.xy;
    let t = lvsm_arcPoint(depth);

    // Variance of z, and the mean of (z - m)^2.
    let a = max(1.0 - dot(m, m), 1.0e-9);
    let e = vec2f(means.z - (m.x * m.x - m.y * m.y), means.w - 2.0 * m.x * m.y);
    let determinant = max((a - e.x) * (a + e.x) - e.y * e.y, 1.0e-18);
    let d = t - m;
    let w = vec2f((a - e.x) * d.x - e.y * d.y, (a + e.x) * d.y - e.y * d.x);
    let mass = determinant / (determinant + max(2.0 * dot(d, w), 0.0));

    // The other two atoms, w (-middle +- i root) / norm, share the rest.
    let middle = 0.5 * determinant - dot(m, w);
    let norm = dot(w, w);
    let root = sqrt(max(norm - middle * middle, 1.0e-36));
    let rest = 0.5 - 0.5 * mass;
    let lean = w.x * (m.y - mass * t.y) - w.y * (m.x - mass * t.x);
    let skewed = clamp(0.5 * lean / root, -rest, rest);

    // What is in front lies beyond the line from the receiver to a point a little before the arc's begin; what is off the
    // arc counts as behind.
    let chord = vec2f(-0.53, -0.848) - t;
    let level = -middle * (w.x * chord.y - w.y * chord.x) - norm * (0.53 * t.y - 0.848 * t.x);
    let rise = -root * dot(w, chord);
    let bound = mass + select(0.0, rest + skewed, level + rise > 0.0) + select(0.0, rest - skewed, level > rise);
    return clamp(bound, 0.0, 1.0);
}
