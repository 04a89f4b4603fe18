// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, sampling/highp.
// Depths as the first pass reads them. Without a setting the texture holds linear depths, in [0,1] and 1 where there is
// no surface. For a depth buffer, multisampled or not, define in front of the pass
//   #define LVSM_DEPTH_SOURCE layout(binding = 4, std140)   where the block lvsm_Depths is, which converts its depths
//   #define LVSM_DEPTH_SAMPLES 4                            where the texture is multisampled: so many samples
// Passes that store filter what they store over the samples; passes that place read the first sample.
#ifndef LVSM_PASSES_DEPTHS_GLSL
#define LVSM_PASSES_DEPTHS_GLSL

#include "../depth.glsl"
#include "../sampling/highp.glsl"

#ifdef LVSM_DEPTH_SAMPLES
#define LVSM_DEPTH_TEXTURE LVSM_HIGHP sampler2DMS
#else
#define LVSM_DEPTH_TEXTURE LVSM_HIGHP sampler2D
#define LVSM_DEPTH_SAMPLES 1
#endif

#ifdef LVSM_DEPTH_SOURCE
// DepthBlock of include/lvsm/passes_depth.hpp.
LVSM_DEPTH_SOURCE uniform lvsm_Depths
{
    // Tangents across the light's view at a texel's centre: the centre times xy plus zw. All 0 for distances to a plane.
    vec4 lvsm_tangents;
    // What the projected depths 0 and 1 are: distances along the view, or 1 over them in perspective.
    vec2 lvsm_distances;
    // Distances of the depths 0 and 1.
    vec2 lvsm_range;
    int lvsm_isPerspective;
};
#endif

// Linear depth of what the texture holds for a texel.
float lvsm_depthOf(float value, ivec2 texel)
{
#ifdef LVSM_DEPTH_SOURCE
    float z = clamp(value, 0.0, 1.0);
    float between = (1.0 - z) * lvsm_distances.x + z * lvsm_distances.y;
    float along = lvsm_isPerspective != 0 ? 1.0 / max(between, LVSM_ROOT_TINY) : between;
    vec2 across = (vec2(texel) + 0.5) * lvsm_tangents.xy + lvsm_tangents.zw;
    return lvsm_linstep(along * sqrt(1.0 + dot(across, across)), lvsm_range.x, lvsm_range.y);
#else
    return value;
#endif
}

// index: of the sample, for a multisampled texture. In others it has no meaning.
float lvsm_depthAt(LVSM_DEPTH_TEXTURE depths, ivec2 texel, int index)
{
#if LVSM_DEPTH_SAMPLES > 1
    return lvsm_depthOf(texelFetch(depths, texel, index).x, texel);
#else
    return lvsm_depthOf(texelFetch(depths, texel, 0).x, texel);
#endif
}

// Change of depth to the next texel, of a texel between two neighbours: the lesser of the two, which the same surface
// has more likely. firstTexel, lastTexel: whether there is no neighbour on that side.
float lvsm_lesserChange(float before, float depth, float behind, bool firstTexel, bool lastTexel)
{
    float backward = depth - before;
    float forward = behind - depth;
    if (firstTexel || lastTexel)
        return firstTexel ? forward : backward;
    return abs(backward) < abs(forward) ? backward : forward;
}

// Change of depth to the next texel in x and in y, from the four neighbours within a region (first texel and end).
vec2 lvsm_slopeAt(LVSM_DEPTH_TEXTURE depths, ivec2 texel, int index, ivec4 region)
{
    ivec2 first = max(texel - 1, region.xy);
    ivec2 last = min(texel + 1, region.zw - 1);
    float depth = lvsm_depthAt(depths, texel, index);
    return vec2(lvsm_lesserChange(lvsm_depthAt(depths, ivec2(first.x, texel.y), index), depth,
                                  lvsm_depthAt(depths, ivec2(last.x, texel.y), index), first.x == texel.x,
                                  last.x == texel.x),
                lvsm_lesserChange(lvsm_depthAt(depths, ivec2(texel.x, first.y), index), depth,
                                  lvsm_depthAt(depths, ivec2(texel.x, last.y), index), first.y == texel.y,
                                  last.y == texel.y));
}

#endif
