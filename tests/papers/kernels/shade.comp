#version 450
// A viewport of receivers, each judged once: VISIBILITY(at, depth) is a call of a sampling wrapper.
#extension GL_GOOGLE_include_directive : require
#include "lvsm/lvsm.glsl"
#include "lvsm/sampling/combined.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray map;
// Unfiltered terms, for ESM.
layout(binding = 1) uniform sampler2DArray unfiltered;
// The greatest depths, for ESM.
layout(binding = 2) uniform sampler2DArray greatest;
layout(binding = 3, r32f) uniform writeonly image2D target;
layout(binding = 4) readonly buffer Splits
{
    float splits[LVSM_MAX_LAYERS + 1];
};

// LVSM without transitions: one sample, whatever the number of layers.
float oneLayer(lvsm_MapPoint at, float depth, int layerCount)
{
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    vec4 texel = lvsm_sampleSlice(map, at, layer / 2, vec4(1.0, 1.0, 1.0, 1.0));
    vec2 interval = lvsm_layerInterval(splits[layer], splits[layer + 1], 0.01);
    return lvsm_layeredVisibility(lvsm_unpackLayer(texel, layer), depth, interval, 1e-5);
}

// VSM with a filter of 3 x 3 samples, each judged apart.
float nineSamples(lvsm_MapPoint at, float depth)
{
    vec2 texel = 1.0 / lvsm_mapArraySize(map);
    float sum = 0.0;
    for (int i = 0; i < 9; ++i)
    {
        lvsm_MapPoint moved = at;
        moved.uv += texel * vec2(float(i % 3 - 1), float(i / 3 - 1));
        sum += lvsm_sampleVariance(map, moved, depth, LVSM_MIN_VARIANCE);
    }
    return sum / 9.0;
}

float esmByZMax(lvsm_MapPoint at, float depth)
{
    float most = lvsm_sampleSlice(greatest, at, 0, vec4(1.0, 1.0, 1.0, 1.0)).x;
    float empty = lvsm_occluderTerm(1.0, 80.0);
    if (!lvsm_violatesZMax(depth, most, 0.004))
        return lvsm_exponentialShadow(lvsm_sampleSlice(map, at, 0, vec4(empty, empty, empty, empty)).x, depth, 80.0);
    vec2 fraction = lvsm_mapFraction(at.uv, lvsm_mapArraySize(unfiltered));
    return lvsm_exponentialShadow2x2(lvsm_gatherSlice(unfiltered, at, 0, empty), fraction, depth, 80.0);
}

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (pixel.x >= size.x || pixel.y >= size.y)
        return;
    // Somewhat narrower than the map, so that nothing is off it, and over all depths, so that every layer is seen.
    vec2 share = 0.9 / vec2(size);
    vec2 uv = 0.05 + share * (vec2(pixel) + 0.5);
    lvsm_MapPoint at = lvsm_mapPoint(uv, vec2(share.x, 0.0), vec2(0.0, share.y), 0);
    imageStore(target, pixel, vec4(VISIBILITY(at, uv.y)));
}
