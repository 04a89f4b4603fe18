// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, pcf, receiver, sampling/common, sampling/separate/maps.
// Percentage-closer filtering of a map of depths.

/// Visibility by percentage-closer filtering with a box of any width, or a Gaussian in one, over a map of depths.
/// map: of 1 component or more. at: where, see mapPoint. depth: the receiver's, in [0,1]. gradient: of the receiver's
/// depth per texel, see receiverGradient; (0, 0) takes one depth for all texels. width: of the box in texels, from 1 to
/// 65, clamped to it. deviation: of the Gaussian in texels, at least 1/64; 0 or less takes the box alone. bias: what the
/// receiver is moved towards the light, in [0,1]. Result in [0,1]; 1 where the box is off the map.
/// Source: Reeves et al. 1987.
fn lvsm_samplePcf(map: texture_2d_array<f32>, filtering: sampler, at: lvsm_MapPoint, depth: f32, gradient: vec2f,
                  width: f32, deviation: f32, bias: f32) -> f32
{
    let size = lvsm_pointSize(at, lvsm_mapArraySize(map, filtering));
    let extent = clamp(width, 1.0, f32(LVSM_MAX_FILTER_SIZE));
    let position = clamp(at.uv, vec2f(-65536.0), vec2f(65536.0)) * size - 0.5;
    let beyond = lvsm_texelsBeyond(position + 0.5, size);
    if (max(beyond.x, beyond.y) >= 0.5 * extent + 0.5)
    {
        return 1.0;
    }
    let first = floor(position - 0.5 * extent + 0.5);
    let quads = i32(0.5 * ceil(extent)) + 1;
    let inverse = 1.0 / max(deviation, 0.015625);
    let falloff = select(0.0, -0.5 * inverse * inverse, deviation > 0.0);
    var quad = at;
    var sum = vec2f(0.0, 0.0);
    for (var y = 0; y < quads; y++)
    {
        for (var x = 0; x < quads; x++)
        {
            let texel = first + 2.0 * vec2f(f32(x), f32(y));
            let offset = texel - position;
            quad.uv = (texel + 1.0) / size;
            let depths = lvsm_gatherSlice(map, filtering, quad, 0, 1.0);
            var across = vec2f(lvsm_boxWeight(offset.x, extent), lvsm_boxWeight(offset.x + 1.0, extent));
            var down = vec2f(lvsm_boxWeight(offset.y, extent), lvsm_boxWeight(offset.y + 1.0, extent));
            across *= exp(falloff * (offset.x + vec2f(0.0, 1.0)) * (offset.x + vec2f(0.0, 1.0)));
            down *= exp(falloff * (offset.y + vec2f(0.0, 1.0)) * (offset.y + vec2f(0.0, 1.0)));
            let receivers = vec4f(lvsm_planeDepth(depth, gradient, offset),
                                   lvsm_planeDepth(depth, gradient, offset + vec2f(1.0, 0.0)),
                                   lvsm_planeDepth(depth, gradient, offset + vec2f(0.0, 1.0)),
                                   lvsm_planeDepth(depth, gradient, offset + vec2f(1.0, 1.0)));
            sum = lvsm_pcfAdd(sum, depths, across.xyxy * down.xxyy, receivers, bias);
        }
    }
    return lvsm_pcfVisibility(sum);
}
