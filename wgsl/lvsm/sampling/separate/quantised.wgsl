// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, depth, moments, layers, moments4, quantised, sampling/common, sampling/separate/maps.
// Quantised moments: a code that no hardware filters, so that four texels are judged and their visibilities mixed.

/// Visibility from a map of quantised moments in four unorm16.
/// map: of 4 components, as quantiseMoments4 made them; its own filter is not asked. at: where, see mapPoint. depth: the
/// receiver's, in [0,1]. Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: HPG 2017.
fn lvsm_sampleQuantised4(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32) -> f32
{
    let size = lvsm_pointSize(at, lvsm_mapArraySize(map, filtering));
    let corner = lvsm_firstCorner(at.uv, size);
    var lit = vec4f(0.0, 0.0, 0.0, 0.0);
    for (var i = 0; i < 4; i++)
    {
        let code = lvsm_fetchSlice(map, filtering, at, 0, corner + vec2f(f32(i & 1), f32(i >> 1)));
        lit[i] = lvsm_quantisedVisibility4(code, depth, LVSM_DEPTH_ERROR_QUANTISED64);
    }
    return lvsm_bilinearVisibility(lvsm_maskCorners(lit, corner, size, 1.0), lvsm_mapFraction(at.uv, size));
}

/// Visibility from a map of quantised moments in 32 bits.
/// map: of 2 components or more, the words of packQuantised4 over 65535, as two unorm16 hold them; its own filter is not
/// asked. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: HPG 2017.
fn lvsm_samplePackedQuantised4(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32) -> f32
{
    let size = lvsm_pointSize(at, lvsm_mapArraySize(map, filtering));
    let corner = lvsm_firstCorner(at.uv, size);
    var lit = vec4f(0.0, 0.0, 0.0, 0.0);
    for (var i = 0; i < 4; i++)
    {
        let texel = lvsm_fetchSlice(map, filtering, at, 0, corner + vec2f(f32(i & 1), f32(i >> 1))).xy;
        let code = lvsm_unpackQuantised4(vec2i(65535.0 * texel + 0.5));
        lit[i] = lvsm_quantisedVisibility4(code, depth, LVSM_DEPTH_ERROR_QUANTISED32);
    }
    return lvsm_bilinearVisibility(lvsm_maskCorners(lit, corner, size, 1.0), lvsm_mapFraction(at.uv, size));
}
