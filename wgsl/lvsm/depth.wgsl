// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config.
// Depth metrics: linear in light space, in [0,1], 0 at the light.
// Lauritzen & McCool, Layered Variance Shadow Maps, Graphics Interface 2008, section 5.

/// Linear step: 0 at and below lo, 1 at and above hi, linear between.
/// x, lo, hi: any unit, the same for the three. Result in [0,1].
/// Degenerate: an empty or inverted range is a step, 0 below hi and 1 from hi on; one longer than 2^126 ends there.
/// Source: Lauritzen, Summed-Area Variance Shadow Maps, GPU Gems 3 (2007), section 8.4.3.
fn lvsm_linstep(x: f32, lo: f32, hi: f32) -> f32
{
    let range = min(hi - lo, LVSM_HUGE);
    if (range < LVSM_TINY)
    {
        return select(0.0, 1.0, x >= hi);
    }
    return clamp((x - lo) / range, 0.0, 1.0);
}

/// Depth below a point or spot light: the Euclidean distance to the light, normalised between two distances.
/// position, light: world or light space, the same for both. nearDistance, farDistance: in its unit, 0 <= near < far.
/// Result in [0,1]: 0 at nearDistance or closer, 1 at farDistance or beyond.
/// Degenerate: near >= far is a step at farDistance.
/// Source: LVSM section 5.
fn lvsm_pointLightDepth(position: vec3f, light: vec3f, nearDistance: f32, farDistance: f32) -> f32
{
    let offset = position - light;
    let squared = offset.x * offset.x + offset.y * offset.y + offset.z * offset.z;
    return lvsm_linstep(sqrt(squared), nearDistance, farDistance);
}

/// Depth below a directional light: the distance to the light plane, normalised between two distances.
/// position, light: a point and any point of the light plane, in one space. direction: unit vector along the light.
/// nearDistance, farDistance: distances from the plane, near < far. Result in [0,1].
/// Degenerate: near >= far is a step at farDistance; a direction that is not of unit length scales the distance;
/// components of position - light and direction beyond 1e18 count as 1e18.
/// Source: LVSM section 5.
fn lvsm_planeLightDepth(position: vec3f, light: vec3f, direction: vec3f, nearDistance: f32, farDistance: f32) -> f32
{
    let offset = clamp(position - light, vec3f(-1.0e18), vec3f(1.0e18));
    let axis = clamp(direction, vec3f(-1.0e18), vec3f(1.0e18));
    let along = offset.x * axis.x + offset.y * axis.y + offset.z * axis.z;
    return lvsm_linstep(along, nearDistance, farDistance);
}

/// Linear depth from the projected depth of a perspective light: the distance along the light's axis, normalised.
/// z: depth after division in [0,1], 0 at the near plane (for a clip space of [-1,1] pass z / 2 + 1/2).
/// nearPlane, farPlane: distances, 0 < near < far. Result in [0,1]: 0 at the near plane, 1 at the far plane.
/// Degenerate: planes that are not positive count as 0, and two planes at 0 give z itself.
/// Source: the inverse of the perspective projection, z n / (z n + (1 - z) f).
fn lvsm_linearDepth(z: f32, nearPlane: f32, farPlane: f32) -> f32
{
    let depth = clamp(z, 0.0, 1.0);
    let atFar = depth * clamp(nearPlane, 0.0, LVSM_HUGE);
    let atNear = (1.0 - depth) * clamp(farPlane, 0.0, LVSM_HUGE);
    let sum = atFar + atNear;
    return select(clamp(atFar / sum, 0.0, 1.0), depth, sum < LVSM_TINY);
}

/// Linear depth from the reversed projected depth of a perspective light, 1 at the near plane and 0 at the far plane.
/// z: depth after division in [0,1]. nearPlane, farPlane: distances, 0 < near < far.
/// Result in [0,1]: 0 at the near plane, 1 at the far plane.
/// Degenerate: planes that are not positive count as 0, and two planes at 0 give 1 - z.
/// Source: linearDepth of 1 - z, without the cancellation that 1 - z brings near the far plane.
fn lvsm_linearDepthReversed(z: f32, nearPlane: f32, farPlane: f32) -> f32
{
    let depth = clamp(z, 0.0, 1.0);
    let atFar = (1.0 - depth) * clamp(nearPlane, 0.0, LVSM_HUGE);
    let atNear = depth * clamp(farPlane, 0.0, LVSM_HUGE);
    let sum = atFar + atNear;
    return select(clamp(atFar / sum, 0.0, 1.0), 1.0 - depth, sum < LVSM_TINY);
}

/// Depth remapped from [0,1] to [-1,1], where both exponential warps have the same reach.
/// depth: in [0,1], clamped to it. Result in [-1,1].
/// Source: the range over which LVSM section 7 warps by e^(cx) and -e^(-cx).
fn lvsm_signedDepth(depth: f32) -> f32
{
    return 2.0 * clamp(depth, 0.0, 1.0) - 1.0;
}
