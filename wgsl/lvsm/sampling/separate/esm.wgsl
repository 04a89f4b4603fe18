// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, esm, sampling/common, sampling/separate/maps.
// Exponential shadow maps with the fallback for where they fail.
//
// The fallback judges four texels apart, and so needs them as they were stored: blurred ones hold light from all
// around, see ESM, section 3.4. Where a map is blurred, keep the unblurred one beside it; where it is not, pass it
// twice. With no such map there is no fallback to take: exponentialShadow of sampleSlice.

// The fallback: four terms judged apart.
// map: of 1 component or more, as they were stored.
fn lvsm_sampleFourTerms(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32,
                        exponent: f32) -> f32
{
    let fraction = lvsm_mapFraction(at.uv, lvsm_pointSize(at, lvsm_mapArraySize(map, filtering)));
    let terms = lvsm_gatherSlice(map, filtering, at, 0, lvsm_occluderTerm(1.0, exponent));
    return lvsm_exponentialShadow2x2(terms, fraction, depth, exponent);
}

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
    return lvsm_sampleFourTerms(unfiltered, filtering, at, depth, exponent);
}

// The greatest depth under all texels that a sample blends: four of level 0 and, where it is minified, four of the
// coarser of its two levels, which hold those of the finer.
// map: of 1 component or more.
fn lvsm_greatestDepth(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint) -> f32
{
    let greatest = lvsm_maxDepth(lvsm_gatherSlice(map, filtering, at, 0, 1.0));
    let size = lvsm_pointSize(at, lvsm_mapArraySize(map, filtering));
    let level = ceil(log2(lvsm_levelTexels(at.dx, at.dy, size)) - 0.01);
    if (level < 0.5)
    {
        return greatest;
    }
    let texels = exp2(level);
    let levelSize = max(floor((size + 0.5) / texels), vec2f(1.0));
    let corner = lvsm_firstCorner(at.uv, levelSize);
    var centre = at;
    centre.dx = vec2f(texels / size.x, 0.0);
    centre.dy = vec2f(0.0, texels / size.y);
    var four = vec4f(0.0, 0.0, 0.0, 0.0);
    for (var i = 0; i < 4; i++)
    {
        centre.uv = (corner + vec2f(f32(i & 1), f32(i >> 1)) + 0.5) / levelSize;
        four[i] = lvsm_sampleSlice(map, filtering, centre, 0, vec4f(1.0, 1.0, 1.0, 1.0)).x;
    }
    return max(greatest, lvsm_maxDepth(four));
}

/// Visibility from an exponential shadow map, with the 2x2 filter where a map of greatest depths finds it at fault.
/// map: of 1 component or more, occluder terms filtered in any way. unfiltered: the terms as they were stored; map
/// itself where it has not been blurred. greatest: of 1 component or more, the greatest depth under map's blur at each
/// texel, by passes/blur with LVSM_BLUR_MAXIMUM, and where map has levels, by passes/mip with LVSM_MIP_MAXIMUM; the
/// depths themselves where map has not been blurred. at: where, see mapPoint. depth: the receiver's, in [0,1].
/// exponent: c as when stored. offset: of violatesZMax, at least by what a lit receiver's plane rises under the filter.
/// Result in [0,1]; 1 half a texel off the map and beyond.
/// Source: ESM section 3.3.
fn lvsm_sampleEsmZMax(map: texture_2d_array<f32>, unfiltered: texture_2d_array<f32>, greatest: texture_2d_array<f32>,
                      filtering: sampler, at: lvsm_MapPoint, depth: f32, exponent: f32, offset: f32) -> f32
{
    if (lvsm_violatesZMax(depth, lvsm_greatestDepth(greatest, filtering, at), offset))
    {
        return lvsm_sampleFourTerms(unfiltered, filtering, at, depth, exponent);
    }
    let empty = lvsm_occluderTerm(1.0, exponent);
    let occluder = lvsm_sampleSlice(map, filtering, at, 0, vec4f(empty, empty, empty, empty)).x;
    return lvsm_exponentialShadow(occluder, depth, exponent);
}
