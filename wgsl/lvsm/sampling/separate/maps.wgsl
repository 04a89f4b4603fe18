// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/common.
// Texels of maps with the border around them: all that the other wrappers read goes through here.

// Size of a map in texels.
// map: of 1 component or more.
fn lvsm_mapSize(map: texture_2d<f32>, filtering: sampler) -> vec2f
{
    return vec2f(textureDimensions(map));
}

// Size of each slice of an array of maps in texels.
// map: of 1 component or more.
fn lvsm_mapArraySize(map: texture_2d_array<f32>, filtering: sampler) -> vec2f
{
    return vec2f(textureDimensions(map).xy);
}

/// Filtered texel of a map.
/// map: of 1 component or more. uv: texture coordinates. dx, dy: their change to the next pixel in x and in y.
/// border: what an empty texel holds. Result: the sample, blended with border at the edge, and border off the map.
fn lvsm_sampleMap(map: texture_2d<f32>, filtering: sampler, uv: vec2f, dx: vec2f, dy: vec2f, border: vec4f) -> vec4f
{
    let coverage = lvsm_levelCoverage(uv, dx, dy, lvsm_mapSize(map, filtering));
    return lvsm_withBorder(textureSampleGrad(map, filtering, uv, dx, dy), border, coverage);
}

/// Filtered texel of a slice of a map.
/// map: of 1 component or more. at: where, see mapPoint. index: of the slice among the map's. border: what an empty
/// texel holds. Result: the sample, blended with border at the edge, and border off the map.
fn lvsm_sampleSlice(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, index: i32,
                    border: vec4f) -> vec4f
{
    let size = lvsm_pointSize(at, lvsm_mapArraySize(map, filtering));
    let coverage = lvsm_levelCoverage(at.uv, at.dx, at.dy, size);
    let place = vec3f(lvsm_pointInTexture(at, size), f32(at.slice + index));
    return lvsm_withBorder(textureSampleGrad(map, filtering, place.xy, i32(place.z), at.dx * at.rectangle.zw,
                                             at.dy * at.rectangle.zw), border, coverage);
}

// First components of four texels of level 0, clamped to the edge. corner: the texel (0,0) of them. A gather where the
// four meet is where rounding the coordinates cannot choose others.
fn lvsm_fourTexels(map: texture_2d<f32>, filtering: sampler, corner: vec2f, size: vec2f) -> vec4f
{
    return textureGather(0, map, filtering, (corner + 1.0) / size).wzxy;
}

fn lvsm_fourTexelsArray(map: texture_2d_array<f32>, filtering: sampler, corner: vec2f, size: vec2f, slice: i32) -> vec4f
{
    return textureGather(0, map, filtering, (corner + 1.0) / size, slice).wzxy;
}

/// First components of the four texels around a position, unfiltered, of level 0.
/// map: of 1 component or more. uv: texture coordinates. border: what an empty texel holds.
/// Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
fn lvsm_gatherMap(map: texture_2d<f32>, filtering: sampler, uv: vec2f, border: f32) -> vec4f
{
    let size = lvsm_mapSize(map, filtering);
    let corner = lvsm_firstCorner(uv, size);
    return lvsm_maskCorners(lvsm_fourTexels(map, filtering, corner, size), corner, size, border);
}

/// First components of the four texels around a point of a map, unfiltered, of level 0.
/// map: of 1 component or more. at: where, see mapPoint. index: of the slice among the map's. border: what an empty
/// texel holds. Result: texels (0,0), (1,0), (0,1) and (1,1), border for each that is off the map; see mapFraction.
fn lvsm_gatherSlice(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, index: i32, border: f32) -> vec4f
{
    let whole = lvsm_mapArraySize(map, filtering);
    let size = lvsm_pointSize(at, whole);
    let corner = lvsm_firstCorner(at.uv, size);
    let texels = lvsm_fourTexelsArray(map, filtering, corner + lvsm_pointOrigin(at, whole), whole, at.slice + index);
    return lvsm_maskCorners(texels, corner, size, border);
}

/// One texel of a slice of a map, unfiltered, of level 0.
/// map: of 1 component or more. at: where, see mapPoint; its coordinates count nothing here. index: of the slice among
/// the map's. texel: counted from the map's corner; off the map the nearest one on it is read.
fn lvsm_fetchSlice(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, index: i32, texel: vec2f) -> vec4f
{
    let whole = lvsm_mapArraySize(map, filtering);
    let place = lvsm_pointOrigin(at, whole) + clamp(texel, vec2f(0.0, 0.0), lvsm_pointSize(at, whole) - 1.0);
    return textureLoad(map, vec2i(place), at.slice + index, 0);
}

// Size of each slice of a map of codes in texels, and one of its texels.
fn lvsm_mapCodesSize(map: texture_2d_array<u32>) -> vec2f
{
    return vec2f(textureDimensions(map).xy);
}

fn lvsm_codeAt(map: texture_2d_array<u32>, texel: vec3i) -> vec4u
{
    return textureLoad(map, texel.xy, texel.z, 0);
}
