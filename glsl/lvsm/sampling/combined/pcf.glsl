// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, pcf, receiver, sampling/highp, sampling/common, sampling/combined/maps.
// Percentage-closer filtering of a map of depths.
#ifndef LVSM_SAMPLING_COMBINED_PCF_GLSL
#define LVSM_SAMPLING_COMBINED_PCF_GLSL

#include "../../pcf.glsl"
#include "../../receiver.glsl"
#include "maps.glsl"

/// Visibility by percentage-closer filtering with a box of any width, or a Gaussian in one, over a map of depths.
/// map: of 1 component or more. at: where, see mapPoint. depth: the receiver's, in [0,1]. gradient: of the receiver's
/// depth per texel, see receiverGradient; (0, 0) takes one depth for all texels. width: of the box in texels, from 1 to
/// 65, clamped to it. deviation: of the Gaussian in texels, at least 1/64; 0 or less takes the box alone. bias: what the
/// receiver is moved towards the light, in [0,1]. Result in [0,1]; 1 where the box is off the map.
/// Source: Reeves et al. 1987.
float lvsm_samplePcf(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, float depth, vec2 gradient, float width,
                     float deviation, float bias)
{
    vec2 size = lvsm_pointSize(at, lvsm_mapArraySize(map));
    float extent = clamp(width, 1.0, float(LVSM_MAX_FILTER_SIZE));
    vec2 position = clamp(at.uv, -65536.0, 65536.0) * size - 0.5;
    vec2 beyond = lvsm_texelsBeyond(position + 0.5, size);
    if (max(beyond.x, beyond.y) >= 0.5 * extent + 0.5)
        return 1.0;
    vec2 first = floor(position - 0.5 * extent + 0.5);
    int quads = int(0.5 * ceil(extent)) + 1;
    float inverse = 1.0 / max(deviation, 0.015625);
    float falloff = deviation > 0.0 ? -0.5 * inverse * inverse : 0.0;
    lvsm_MapPoint quad = at;
    vec2 sum = vec2(0.0, 0.0);
    for (int y = 0; y < quads; ++y)
    {
        for (int x = 0; x < quads; ++x)
        {
            vec2 texel = first + 2.0 * vec2(float(x), float(y));
            vec2 offset = texel - position;
            quad.uv = (texel + 1.0) / size;
            vec4 depths = lvsm_gatherSlice(map, quad, 0, 1.0);
            vec2 across = vec2(lvsm_boxWeight(offset.x, extent), lvsm_boxWeight(offset.x + 1.0, extent));
            vec2 down = vec2(lvsm_boxWeight(offset.y, extent), lvsm_boxWeight(offset.y + 1.0, extent));
            across *= exp(falloff * (offset.x + vec2(0.0, 1.0)) * (offset.x + vec2(0.0, 1.0)));
            down *= exp(falloff * (offset.y + vec2(0.0, 1.0)) * (offset.y + vec2(0.0, 1.0)));
            vec4 receivers = vec4(lvsm_planeDepth(depth, gradient, offset),
                                  lvsm_planeDepth(depth, gradient, offset + vec2(1.0, 0.0)),
                                  lvsm_planeDepth(depth, gradient, offset + vec2(0.0, 1.0)),
                                  lvsm_planeDepth(depth, gradient, offset + vec2(1.0, 1.0)));
            sum = lvsm_pcfAdd(sum, depths, across.xyxy * down.xxyy, receivers, bias);
        }
    }
    return lvsm_pcfVisibility(sum);
}

#endif
