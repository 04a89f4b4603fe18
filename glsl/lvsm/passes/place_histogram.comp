#version 450
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, passes/place, depth, sampling/highp, passes/depths.
#extension GL_GOOGLE_include_directive : require
// Counts what one texture of depths holds, linear ones or a depth buffer (see depths.glsl): the second occluders of its 2x2 neighbourhoods for the relaxation, or its depths
// for optimal splits. Run it over the groups that placePass gives, then place.comp.
#include "place.glsl"
#include "depths.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
LVSM_PLACE_DEPTHS uniform LVSM_DEPTH_TEXTURE lvsm_depths;
#ifdef LVSM_PLACE_WEIGHTS
LVSM_PLACE_WEIGHTS uniform LVSM_HIGHP usampler2D lvsm_seen;
#endif

// Low words of the group's own sums: what they carry goes to the buffer at once.
shared uint lvsm_weights[LVSM_PLACE_BINS];
shared uint lvsm_weighted[LVSM_PLACE_BINS];

float lvsm_placedDepth(ivec2 texel)
{
    return clamp(lvsm_depthAt(lvsm_depths, min(texel, lvsm_map.zw - 1), 0), 0.0, 1.0);
}

// What a texel's neighbourhood counts for, from 0 to 1.
float lvsm_placedShare(ivec2 texel)
{
#ifdef LVSM_PLACE_WEIGHTS
    return float(min(texelFetch(lvsm_seen, texel, 0).x, 256u)) / 256.0;
#else
    return 1.0;
#endif
}

// How much a neighbourhood weighs and under which value. Of four numbers the variance comes from their differences,
// which do not cancel.
vec2 lvsm_placedSample(ivec2 texel)
{
    float d00 = lvsm_placedDepth(texel);
    float d10 = lvsm_placedDepth(texel + ivec2(1, 0));
    float d01 = lvsm_placedDepth(texel + ivec2(0, 1));
    float d11 = lvsm_placedDepth(texel + ivec2(1, 1));
    float left = d00 - d01;
    float right = d10 - d11;
    float across = (d00 - d10) + (d01 - d11);
    float squares = (left + right) * (left + right) + across * across + (left - right) * (left - right);
    if (lvsm_optimal != 0)
        return vec2(sqrt(squares) * lvsm_placedShare(texel), d00);
    bool whole = all(lessThan(texel + 1, max(lvsm_map.zw, lvsm_map.xy + 2)));
    float variance = 0.0625 * squares;
    float weight = whole && variance >= lvsm_minVariance ? min(variance, max(lvsm_maxVariance, 0.0)) : 0.0;
    return vec2(weight * lvsm_placedShare(texel), clamp(0.25 * ((d00 + d10) + (d01 + d11)) + sqrt(variance), 0.0, 1.0));
}

uint lvsm_fixed(float value)
{
    return uint(clamp(value, 0.0, 2.0) * 1073741824.0);
}

void lvsm_addWord(int word, uint amount)
{
    uint before = atomicAdd(lvsm_histogram[word], amount);
    if (before + amount < before)
        atomicAdd(lvsm_histogram[word + 1], 1u);
}

void main()
{
    for (int bin = int(gl_LocalInvocationIndex); bin < LVSM_PLACE_BINS; bin += 256)
    {
        lvsm_weights[bin] = 0u;
        lvsm_weighted[bin] = 0u;
    }
    barrier();
    for (int i = 0; i < 4; ++i)
    {
        ivec2 texel = lvsm_map.xy + ivec2(gl_WorkGroupID.xy) * 32 + ivec2(gl_LocalInvocationID.xy) +
                      16 * ivec2(i & 1, i >> 1);
        vec2 found = all(lessThan(texel, lvsm_map.zw)) ? lvsm_placedSample(texel) : vec2(0.0);
        uint weight = lvsm_fixed(found.x);
        uint weighted = lvsm_fixed(found.x * found.y);
        if (weight == 0u)
            continue;
        int bin = min(int(found.y * float(LVSM_PLACE_BINS)), LVSM_PLACE_BINS - 1);
        uint before = atomicAdd(lvsm_weights[bin], weight);
        if (before + weight < before)
            atomicAdd(lvsm_histogram[4 * bin + 1], 1u);
        before = atomicAdd(lvsm_weighted[bin], weighted);
        if (before + weighted < before)
            atomicAdd(lvsm_histogram[4 * bin + 3], 1u);
    }
    barrier();
    for (int bin = int(gl_LocalInvocationIndex); bin < LVSM_PLACE_BINS; bin += 256)
    {
        if (lvsm_weights[bin] != 0u)
            lvsm_addWord(4 * bin, lvsm_weights[bin]);
        if (lvsm_weighted[bin] != 0u)
            lvsm_addWord(4 * bin + 2, lvsm_weighted[bin]);
    }
}
