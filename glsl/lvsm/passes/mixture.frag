#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, components, mixture, sampling/highp, depth, passes/depths, passes/mixture.
#extension GL_GOOGLE_include_directive : require
// Makes a map of mixtures of planes where there is no compute shader: one direction of a round a draw, along x and then
// along y.
//
// Draw what mixtureDraws of include/lvsm/passes_mixture.hpp gives, the blocks and the rectangles; mixture.glsl has the
// settings. All draws but the last write two or four targets rgba32ui, which the next reads as slices of an array; the
// last writes rgba32ui, or rg32ui for the codes of two planes. The codes are those of mixture.comp.
// GLSL 3.30, ES 3.00 and WebGL2: put their #version in the first line's place, and in ES `precision highp float;` and
// `precision highp int;` after it.
#include "mixture.glsl"

LVSM_MIXTURE_SOURCE uniform LVSM_MIXTURE_TEXTURE lvsm_source;
layout(location = 0) out LVSM_HIGHP uvec4 lvsm_result;
#ifdef LVSM_MIXTURE_TO_MIXTURES
layout(location = 1) out LVSM_HIGHP uvec4 lvsm_second;
#if LVSM_MIXTURE_COUNT == 4
layout(location = 2) out LVSM_HIGHP uvec4 lvsm_third;
layout(location = 3) out LVSM_HIGHP uvec4 lvsm_fourth;
#endif
#endif

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy) + lvsm_origins.zw;
    uvec4 components[LVSM_MIXTURE_COUNT];
    lvsm_readMixture(lvsm_source, texel, components);
    if (lvsm_steps != ivec2(0))
    {
        uvec4 before[LVSM_MIXTURE_COUNT];
        uvec4 after[LVSM_MIXTURE_COUNT];
        lvsm_readMixture(lvsm_source, texel - lvsm_steps, before);
        lvsm_readMixture(lvsm_source, texel + lvsm_steps, after);
        lvsm_Mixture mixture = lvsm_mixThree(components, before, after, lvsm_steps, lvsm_shares.x);
        for (int k = 0; k < LVSM_MIXTURE_COUNT; ++k)
            components[k] = lvsm_packComponent(mixture.components[k]);
    }
#ifdef LVSM_MIXTURE_TO_MIXTURES
    lvsm_result = components[0];
    lvsm_second = components[1];
#if LVSM_MIXTURE_COUNT == 4
    lvsm_third = components[2];
    lvsm_fourth = components[3];
#endif
#else
    lvsm_result = lvsm_codeOf(lvsm_unpackMixture(components));
#endif
}
