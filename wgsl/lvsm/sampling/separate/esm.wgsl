// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, esm, sampling/common, sampling/separate/maps.
// Exponential shadow maps with the fallback for where they fail.
//
// The fallback judges four texels apart, and so needs them as they were stored: blurred ones hold light from all
// around, see ESM, section 3.4. Where a map is blurred, keep the unblurred one beside it; where it is not, pass it
// twice. With no such map there is no fallback to take: exponentialShadow of sampleSlice.

/// Visibility from an exponential shadow map, with the 2x2 filter where the threshold test finds the map at fault.
/// map: of 1 component or more, occluder terms filtered in any way. unfiltered: the terms as they were stored; map
/// itself where it has not been blurred. at: where, see mapPoint. depth: the receiver's, in [0,1]. exponent: c as when
/// stored. threshold: of violatesThreshold, which the paper has at 0.02.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: ESM section 3.3.
fn lvsm_sampleEsm(map: texture_2d_array<f32>, unfiltered: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint,
                  depth: f32, exponent: f32, threshold: f32) -> f32
{
    let empty = lvsm_occluderTerm(1.0, exponent);
    let occluder = lvsm_sampleSlice(map, filtering, at, 0, vec4f(empty, empty, empty, empty)).x;
    if (!lvsm_violatesThreshold(occluder, depth, exponent, threshold))
    {
        return lvsm_exponentialShadow(occluder, depth, exponent);
    }
    let fraction = lvsm_mapFraction(at.uv, lvsm_pointSize(at, lvsm_mapArraySize(unfiltered, filtering)));
    return lvsm_exponentialShadow2x2(lvsm_gatherSlice(unfiltered, filtering, at, 0, empty), fraction, depth, exponent);
}
