// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, components, mixture, receiver, sampling/common, sampling/separate/maps.
// Mixtures of planes: a map of codes, which is read by one nearest fetch.
//
// No sampler filters a map of codes, and it has no mip levels. Its texture is one of whole numbers, whose sampler is set
// to nearest. The bias is that of the topic mixture, and receivers are shifted by half a texel of their slope. passes/mixture
// makes the map, and mixturePasses of include/lvsm/passes_mixture.hpp tells the window's deviation.

/// Visibility from a map of mixtures of two planes.
/// map: of codes of 64 bits. at: where, see mapPoint; its gradients count nothing here. depth: the receiver's, in [0,1].
/// gradient: of the receiver's depth per texel of the shadow map, see receiverGradient. texels: of the shadow map to one of
/// the codes along each axis, 1, or 2 at half resolution. deviation: of the window in texels of the shadow map.
/// Result in [0,1], an estimate and no bound; 1 off the map.
/// Source: mixtureVisibility2.
fn lvsm_sampleMixture2(map: texture_2d_array<u32>, at: lvsm_MapPoint, depth: f32, gradient: vec2f, texels: f32,
                       deviation: f32) -> f32
{
    let whole = lvsm_mapCodesSize(map);
    var place: vec2f;
    var offset: vec2f;
    if (!lvsm_nearestCode(at, lvsm_pointSize(at, whole), &place, &offset))
    {
        return 1.0;
    }
    let code = lvsm_codeAt(map, vec3i(vec2i(place + lvsm_pointOrigin(at, whole)), at.slice)).xy;
    return lvsm_mixtureVisibility2(code, texels * offset, lvsm_shiftReceiver(depth, gradient, 0.5), gradient,
                                   deviation, LVSM_MIXTURE_BIAS);
}

/// Visibility from a map of mixtures of four planes.
/// map: of codes of 128 bits. at: where, see mapPoint; its gradients count nothing here. depth: the receiver's, in [0,1].
/// gradient: of the receiver's depth per texel of the shadow map, see receiverGradient. texels: of the shadow map to one of
/// the codes along each axis, 1, or 2 at half resolution. deviation: of the window in texels of the shadow map.
/// Result in [0,1], an estimate and no bound; 1 off the map.
/// Source: mixtureVisibility4.
fn lvsm_sampleMixture4(map: texture_2d_array<u32>, at: lvsm_MapPoint, depth: f32, gradient: vec2f, texels: f32,
                       deviation: f32) -> f32
{
    let whole = lvsm_mapCodesSize(map);
    var place: vec2f;
    var offset: vec2f;
    if (!lvsm_nearestCode(at, lvsm_pointSize(at, whole), &place, &offset))
    {
        return 1.0;
    }
    let code = lvsm_codeAt(map, vec3i(vec2i(place + lvsm_pointOrigin(at, whole)), at.slice));
    return lvsm_mixtureVisibility4(code, texels * offset, lvsm_shiftReceiver(depth, gradient, 0.5), gradient,
                                   deviation, LVSM_MIXTURE_BIAS);
}
