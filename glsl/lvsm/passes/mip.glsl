// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: sampling/highp.
// One texel of a level of a map from the level before, for mip.comp and mip.frag.
//
// Each texel is the mean of its share of the level before: of two texels in each direction, and where that level has an
// odd size of three, the outer ones in part. So every level has the map's mean, the last row is not left out, and
// nothing off the map is read, such as its neighbour in an atlas; what is off the map is empty for whoever samples the
// level, see sampling/common.glsl. Moments are added as 32-bit floats, whatever the driver's own levels do.
//
// mipPass of include/lvsm/passes_mip.hpp fills the block, once for each level from 1 on.
#ifndef LVSM_PASSES_MIP_GLSL
#define LVSM_PASSES_MIP_GLSL

#include "../sampling/highp.glsl"

// Where the resources are: define all of these or none, in front of this file.
#if defined(LVSM_MIP_SOURCE) != defined(LVSM_MIP_BLOCK)
#error define all of LVSM_MIP_SOURCE, LVSM_MIP_BLOCK and, for mip.comp, LVSM_MIP_TARGET, or none
#elif !defined(LVSM_MIP_SOURCE) && (__VERSION__ < 310 || !defined(GL_ES) && __VERSION__ < 420)
#define LVSM_MIP_SOURCE
#define LVSM_MIP_BLOCK layout(std140)
#elif !defined(LVSM_MIP_SOURCE)
#define LVSM_MIP_SOURCE layout(binding = 0)
#define LVSM_MIP_TARGET layout(binding = 1)
#define LVSM_MIP_BLOCK layout(binding = 2, std140)
#endif

// MipBlock of include/lvsm/passes_mip.hpp.
LVSM_MIP_BLOCK uniform lvsm_Mip
{
    // First texel and end of the map in the level before.
    ivec4 lvsm_before;
    // The same in the level that is made.
    ivec4 lvsm_region;
    // The slice that is made; for the compute shader the first one.
    int lvsm_slice;
    // The level before, as the source has it: 0 where the source is a view of that level alone.
    int lvsm_level;
};

// First texel and end of what a texel is the mean of, in units that whole numbers hold: m to a texel of the n before.
ivec2 lvsm_mipCell(int texel, int n)
{
    return ivec2(texel, texel + 1) * n;
}

// How much of a texel of the level before lies in a cell, in those units.
int lvsm_mipShare(int texel, ivec2 cell, int m)
{
    return min((texel + 1) * m, cell.y) - max(texel * m, cell.x);
}

// Where LVSM_MIP_MAXIMUM is defined, a texel is the largest of its share, each component for itself, as the Z-Max test
// of ESM needs.
vec4 lvsm_mipTexel(LVSM_HIGHP sampler2DArray source, ivec3 texel)
{
    ivec2 n = lvsm_before.zw - lvsm_before.xy;
    ivec2 m = max(lvsm_region.zw - lvsm_region.xy, 1);
    ivec2 own = texel.xy - lvsm_region.xy;
    ivec2 across = lvsm_mipCell(own.x, n.x);
    ivec2 down = lvsm_mipCell(own.y, n.y);
    ivec2 first = ivec2(across.x, down.x) / m;
    ivec2 last = (ivec2(across.y, down.y) - 1) / m;
    vec4 sum = vec4(0.0);
    for (int y = first.y; y <= last.y; ++y)
    {
        for (int x = first.x; x <= last.x; ++x)
        {
            vec4 found = texelFetch(source, ivec3(lvsm_before.xy + ivec2(x, y), texel.z), lvsm_level);
#ifdef LVSM_MIP_MAXIMUM
            sum = x == first.x && y == first.y ? found : max(sum, found);
#else
            vec2 share = vec2(ivec2(lvsm_mipShare(x, across, m.x), lvsm_mipShare(y, down, m.y))) / vec2(n);
            sum += share.x * share.y * found;
#endif
        }
    }
    return sum;
}

#endif
