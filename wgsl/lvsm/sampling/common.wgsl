// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// What reading a map needs beside the texture itself; both forms of the wrappers include it.
//
// A map is one slice of an array of textures or several that follow one another, all of it or a rectangle of each: the
// same for cascades, atlases and the faces of a cube. A point says where to read it.
//
// Borders, one rule for every wrapper and pass: what is off the map is an empty texel. All read as if the map went on
// on every side with texels of border, such as depthMoments(1). So a filtered sample blends from the outermost texel to
// border within one texel of the level that is read, half of it off the map, and every tap of a wider filter that is
// off the map takes border. The map's sampler wraps by clamping to its edge and knows nothing of this: a sampler with a
// border colour would blend twice. Minified maps blend as the nearest level does, whose texels the longer gradient
// measures. A blur that clamps to the edge instead leaves slanted ground too little variance there, and a dark line of
// dots, one a texel, on what is lit.

// Floors of the variance to begin with, for maps of half floats and of anything better, over the whole range of depth;
// a layer takes it times its squared length. The first is recommendedMinVariance of three roundings, which storing and
// two passes of a blur make, and a lit flat receiver that darkens by 1/100. By rounding alone the second would be less;
// it is a little over 2^-24, which also covers a compiler without precise, see config.glsl.
const LVSM_MIN_VARIANCE_FP16: f32 = 5.4e-5;
const LVSM_MIN_VARIANCE: f32 = 6.0e-8;

/// Where a map is read, made by mapPoint, atlasPoint or cubePoint.
struct lvsm_MapPoint
{
    // Texture coordinates in the map, which goes from 0 to 1, and their change to the next pixel in x and in y.
    uv: vec2f,
    dx: vec2f,
    dy: vec2f,
    // Corner and extent of the map in its slices, in texture coordinates of the whole.
    rectangle: vec4f,
    // The map's first slice.
    slice: i32,
}

/// Point of a map that has its slices for itself.
/// uv: texture coordinates. dx, dy: their change to the next pixel in x and in y. slice: the map's first one, such as a
/// cascade's number times the slices of each.
fn lvsm_mapPoint(uv: vec2f, dx: vec2f, dy: vec2f, slice: i32) -> lvsm_MapPoint
{
    var at: lvsm_MapPoint;
    at.uv = uv;
    at.dx = dx;
    at.dy = dy;
    at.rectangle = vec4f(0.0, 0.0, 1.0, 1.0);
    at.slice = slice;
    return at;
}

/// Point of a map that is a rectangle of an atlas; no wrapper reads what is around it.
/// uv: texture coordinates in the map, which goes from 0 to 1. dx, dy: their change to the next pixel in x and in y.
/// slice: the map's first one. rectangle: its corner, and its width and height, in texture coordinates of the atlas;
/// whole texels, and where there are levels, whole texels of the smallest that is read.
fn lvsm_atlasPoint(uv: vec2f, dx: vec2f, dy: vec2f, slice: i32, rectangle: vec4f) -> lvsm_MapPoint
{
    var at = lvsm_mapPoint(uv, dx, dy, slice);
    at.rectangle = rectangle;
    return at;
}

// A vector by the axes of the face of a cube that it points to: s and t in the face, and the distance to it. axis: the
// face's, 0 to 2. isNegative: which of the two.
fn lvsm_alongFace(along: vec3f, axis: i32, isNegative: bool) -> vec3f
{
    let turned = select(along, vec3f(-along.x, along.y, -along.z), isNegative);
    if (axis == 0)
    {
        return vec3f(-turned.z, -along.y, turned.x);
    }
    if (axis == 2)
    {
        return vec3f(turned.x, -along.y, turned.z);
    }
    return vec3f(along.x, turned.z, select(along.y, -along.y, isNegative));
}

/// Point of a cube map, whose faces are six maps in one array: +x, -x, +y, -y, +z, -z, each turned as the faces of cube
/// textures are.
/// direction: from the light to the receiver, of any length. dx, dy: its change to the next pixel in x and in y.
/// slice: the first one of +x. slicesOfFace: how many each face has, at least 1. tangent: of half the angle that a face
/// is drawn with, at least 1: size / (size - 2 margin) makes it a margin of texels larger than its share of the cube,
/// and with one as wide as the blur reaches, and a texel of the smallest level more, there is no seam.
fn lvsm_cubePoint(direction: vec3f, dx: vec3f, dy: vec3f, slice: i32, slicesOfFace: i32, tangent: f32) -> lvsm_MapPoint
{
    let size = abs(direction);
    let axis = select(select(2, 1, size.y >= size.z), 0, size.x >= size.y && size.x >= size.z);
    let isNegative = select(select(direction.z, direction.y, axis == 1), direction.x, axis == 0) < 0.0;
    let at = lvsm_alongFace(direction, axis, isNegative);
    let alongX = lvsm_alongFace(dx, axis, isNegative);
    let alongY = lvsm_alongFace(dy, axis, isNegative);
    // The quotient's derivative. No direction is the centre of +x.
    let inverse = 1.0 / max(at.z, 1.0e-18);
    let place = at.xy * inverse;
    let scale = 0.5 / max(tangent, 1.0);
    return lvsm_mapPoint(0.5 + scale * place, scale * inverse * (alongX.xy - alongX.z * place),
                         scale * inverse * (alongY.xy - alongY.z * place),
                         slice + slicesOfFace * (2 * axis + select(0, 1, isNegative)));
}

// Size of a point's map in texels, from that of the whole texture; and its first texel.
fn lvsm_pointSize(at: lvsm_MapPoint, size: vec2f) -> vec2f
{
    return max(floor(at.rectangle.zw * size + 0.5), vec2f(1.0));
}

fn lvsm_pointOrigin(at: lvsm_MapPoint, size: vec2f) -> vec2f
{
    return floor(at.rectangle.xy * size + 0.5);
}

// How many texels a position lies off the centres of the outermost texels of a map, in each direction.
// position: in texels from the map's corner. size: of the map in texels, at least 1.
fn lvsm_texelsBeyond(position: vec2f, size: vec2f) -> vec2f
{
    return abs(position - clamp(position, vec2f(0.5, 0.5), size - 0.5));
}

// The weight that a bilinear sample gives to texels on the map; it gives the rest to border. Exactly 1 and 0 away from
// the edge.
fn lvsm_mapCoverage(position: vec2f, size: vec2f) -> f32
{
    let share = 1.0 - min(lvsm_texelsBeyond(position, size), vec2f(1.0));
    return share.x * share.y;
}

// How many texels of level 0 those of the level are wide that a sample with these gradients reads.
fn lvsm_levelTexels(dx: vec2f, dy: vec2f, size: vec2f) -> f32
{
    return max(max(length(dx * size), length(dy * size)), 1.0);
}

// The same as mapCoverage for the level that a sample with these gradients reads.
fn lvsm_levelCoverage(uv: vec2f, dx: vec2f, dy: vec2f, size: vec2f) -> f32
{
    let levelSize = max(size / lvsm_levelTexels(dx, dy, size), vec2f(1.0));
    return lvsm_mapCoverage(clamp(uv, vec2f(-1.0), vec2f(2.0)) * levelSize, levelSize);
}

// Texture coordinates of a point in the whole texture, no nearer to the map's edge than the centres of the outermost
// texels of the coarser of the two levels that a sample may read. size: of the map.
fn lvsm_pointInTexture(at: lvsm_MapPoint, size: vec2f) -> vec2f
{
    let texels = exp2(ceil(log2(lvsm_levelTexels(at.dx, at.dy, size)) - 0.01));
    let margin = min(0.5 * texels / size, vec2f(0.5));
    return at.rectangle.xy + at.rectangle.zw * clamp(at.uv, margin, 1.0 - margin);
}

// The sample of a map that clamps to its edge as if border lay around it. Exponential terms span the whole range of
// floats: a blend with a large border rounds a small texel away, so inside the map there is none.
fn lvsm_withBorder(texel: vec4f, border: vec4f, coverage: f32) -> vec4f
{
    return select(texel, texel * coverage + border * (1.0 - coverage), coverage < 1.0);
}

// The texel (0,0) of the four that surround a position, counted from the map's corner.
fn lvsm_firstCorner(uv: vec2f, size: vec2f) -> vec2f
{
    return floor(clamp(uv, vec2f(-1.0), vec2f(2.0)) * size - 0.5);
}

// Four texels around a position with those off the map replaced.
fn lvsm_maskCorners(texels: vec4f, corner: vec2f, size: vec2f, border: f32) -> vec4f
{
    let left = corner.x >= 0.0 && corner.x < size.x;
    let right = corner.x >= -1.0 && corner.x < size.x - 1.0;
    let top = corner.y >= 0.0 && corner.y < size.y;
    let bottom = corner.y >= -1.0 && corner.y < size.y - 1.0;
    return vec4f(select(border, texels.x, left && top), select(border, texels.y, right && top),
                 select(border, texels.z, left && bottom), select(border, texels.w, right && bottom));
}

/// Position between the four texels that gatherMap reads, as bilinearVisibility takes it.
/// uv: texture coordinates. size: of the map in texels. Result: each component in [0,1].
fn lvsm_mapFraction(uv: vec2f, size: vec2f) -> vec2f
{
    return clamp(clamp(uv, vec2f(-1.0), vec2f(2.0)) * size - 0.5 - lvsm_firstCorner(uv, size), vec2f(0.0), vec2f(1.0));
}

// Where the nearest code of a point lies, and how far the point is from its centre, in its texels. size: of the map.
// place: counted from the map's corner. Result: false off the map.
fn lvsm_nearestCode(at: lvsm_MapPoint, size: vec2f, place: ptr<function, vec2f>, offset: ptr<function, vec2f>) -> bool
{
    let position = clamp(at.uv, vec2f(-1.0), vec2f(2.0)) * size;
    *place = floor(position);
    *offset = position - *place - 0.5;
    return (*place).x >= 0.0 && (*place).y >= 0.0 && (*place).x < size.x && (*place).y < size.y;
}
