#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, components, mixture, sampling/highp, depth, passes/depths, passes/mixture.
#extension GL_GOOGLE_include_directive : require
// Makes a map of mixtures of planes from one texture of depths, linear ones or a depth buffer (see depths.glsl): two
// rounds of the tree a dispatch, in shared memory.
//
// Run it with what mixturePasses of include/lvsm/passes_mixture.hpp gives, the blocks and how many groups; mixture.glsl
// has the settings. The target is a uimage2DArray: rgba32ui, but for the codes of two planes rg32ui. OpenGL ES has no
// image of two components: define LVSM_MIXTURE_FORMAT rgba32ui there, or draw mixture.frag.
// GLSL ES 3.10: put `#version 310 es` in the first line's place, `precision highp float;` and `precision highp int;`
// after it.
#include "mixture.glsl"

#if defined(LVSM_MIXTURE_TO_MIXTURES) || LVSM_MIXTURE_COUNT == 4
#undef LVSM_MIXTURE_FORMAT
#define LVSM_MIXTURE_FORMAT rgba32ui
#elif !defined(LVSM_MIXTURE_FORMAT)
#define LVSM_MIXTURE_FORMAT rg32ui
#endif
#ifndef LVSM_MIXTURE_TARGET
#error define all of LVSM_MIXTURE_SOURCE, LVSM_MIXTURE_TARGET and LVSM_MIXTURE_BLOCK, or none
#endif

layout(local_size_x = 8, local_size_y = 8) in;
LVSM_MIXTURE_SOURCE uniform LVSM_MIXTURE_TEXTURE lvsm_source;
LVSM_MIXTURE_TARGET layout(LVSM_MIXTURE_FORMAT) uniform writeonly LVSM_HIGHP uimage2DArray lvsm_target;

// The group's texels and a halo of three, at most: 12.25 KiB of four components.
const int LVSM_MIXTURE_TILE = 14;
shared uvec4 lvsm_tile[LVSM_MIXTURE_TILE * LVSM_MIXTURE_TILE * LVSM_MIXTURE_COUNT];

int lvsm_placeInTile(ivec2 at)
{
    return (at.y * LVSM_MIXTURE_TILE + at.x) * LVSM_MIXTURE_COUNT;
}

void lvsm_fillTile(ivec2 first, int side, int thread)
{
    for (int i = thread; i < side * side; i += 64)
    {
        ivec2 at = ivec2(i % side, i / side);
        uvec4 components[LVSM_MIXTURE_COUNT];
        lvsm_readMixture(lvsm_source, first + lvsm_spacing * at, components);
        for (int k = 0; k < LVSM_MIXTURE_COUNT; ++k)
            lvsm_tile[lvsm_placeInTile(at) + k] = components[k];
    }
    barrier();
}

void lvsm_readTile(ivec2 at, out uvec4 components[LVSM_MIXTURE_COUNT])
{
    for (int k = 0; k < LVSM_MIXTURE_COUNT; ++k)
        components[k] = lvsm_tile[lvsm_placeInTile(at) + k];
}

// One direction of a round, in place: a line of texels is read whole by its threads before they write. share: of
// each outer texel. begin, end: of what the tile holds, less in the direction afterwards.
void lvsm_mixTile(ivec2 along, float share, inout ivec2 begin, inout ivec2 end, int thread)
{
    ivec2 across = ivec2(1) - min(abs(along), 1);
    begin += abs(along);
    end -= abs(along);
    ivec2 size = end - begin;
    int run = across.x == 0 ? size.x : size.y;
    int lines = across.x == 0 ? size.y : size.x;
    int atOnce = 64 / run;
    for (int done = 0; done < lines; done += atOnce)
    {
        int mine = done + thread / run;
        bool isActive = thread < atOnce * run && mine < lines;
        ivec2 at = begin + mine * across + (thread % run) * (ivec2(1) - across);
        lvsm_Mixture mixture = lvsm_noMixture();
        if (isActive)
        {
            uvec4 middle[LVSM_MIXTURE_COUNT];
            uvec4 before[LVSM_MIXTURE_COUNT];
            uvec4 after[LVSM_MIXTURE_COUNT];
            lvsm_readTile(at, middle);
            lvsm_readTile(at - along, before);
            lvsm_readTile(at + along, after);
            mixture = lvsm_mixThree(middle, before, after, lvsm_spacing * along, share);
        }
        barrier();
        for (int k = 0; k < LVSM_MIXTURE_COUNT && isActive; ++k)
            lvsm_tile[lvsm_placeInTile(at) + k] = lvsm_packComponent(mixture.components[k]);
        barrier();
    }
}

void lvsm_writeTexel(ivec2 at, ivec2 texel)
{
    if (texel.x >= lvsm_region.z || texel.y >= lvsm_region.w)
        return;
    uvec4 components[LVSM_MIXTURE_COUNT];
    lvsm_readTile(at, components);
#ifdef LVSM_MIXTURE_TO_MIXTURES
    for (int k = 0; k < LVSM_MIXTURE_COUNT; ++k)
        imageStore(lvsm_target, ivec3(texel - lvsm_origins.zw, k), components[k]);
#else
    imageStore(lvsm_target, ivec3(texel - lvsm_origins.zw, lvsm_slice), lvsm_codeOf(lvsm_unpackMixture(components)));
#endif
}

void main()
{
    int thread = int(gl_LocalInvocationIndex);
    ivec2 group = ivec2(gl_WorkGroupID.xy);
    ivec2 first = lvsm_region.xy + (group / lvsm_spacing) * (8 * lvsm_spacing) + group % lvsm_spacing;
    int halo = lvsm_steps.x + lvsm_steps.y;
    lvsm_fillTile(first - lvsm_spacing * halo, 8 + 2 * halo, thread);
    ivec2 begin = ivec2(0);
    ivec2 end = ivec2(8 + 2 * halo);
    for (int turn = 0; turn < 4; ++turn)
    {
        int step = turn < 2 ? lvsm_steps.x : lvsm_steps.y;
        float share = turn < 2 ? lvsm_shares.x : lvsm_shares.y;
        if (step > 0)
            lvsm_mixTile((turn & 1) == 0 ? ivec2(step, 0) : ivec2(0, step), share, begin, end, thread);
    }
    ivec2 local = ivec2(gl_LocalInvocationID.xy);
    lvsm_writeTexel(local + halo, first + lvsm_spacing * local);
}
