// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter.
// One texel of a separable blur, for blur.comp and blur.frag.
#ifndef LVSM_PASSES_BLUR_GLSL
#define LVSM_PASSES_BLUR_GLSL

#include "../filter.glsl"

// Number of taps, odd, up to 65; 9 taps cost 5 fetches.
#ifndef LVSM_BLUR_SIZE
#define LVSM_BLUR_SIZE 9
#endif

// Offset from the texel's centre, in texels, and weight of a fetch: binomial, or Gaussian with LVSM_BLUR_SIGMA texels.
vec2 lvsm_blurTap(int fetch)
{
#ifdef LVSM_BLUR_SIGMA
    return lvsm_gaussianTap(fetch, LVSM_BLUR_SIZE, LVSM_BLUR_SIGMA);
#else
    return lvsm_binomialTap(fetch, LVSM_BLUR_SIZE);
#endif
}

// source: filters linearly and clamps to its edge. texel: of its level 0. direction: (1, 0) or (0, 1).
vec4 lvsm_blurredTexel(sampler2DArray source, ivec3 texel, vec2 direction)
{
    vec2 size = vec2(textureSize(source, 0).xy);
    vec4 sum = vec4(0.0);
    for (int fetch = 0; fetch <= (LVSM_BLUR_SIZE - 1) / 2; ++fetch)
    {
        vec2 tap = lvsm_blurTap(fetch);
        vec2 position = vec2(texel.xy) + 0.5 + tap.x * direction;
        sum += tap.y * textureLod(source, vec3(position / size, float(texel.z)), 0.0);
    }
    return sum;
}

#endif
