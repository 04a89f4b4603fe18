#version 450
#extension GL_GOOGLE_include_directive : require
// Calls every wrapper for one receiver a thread; SEPARATE chooses textures and samplers apart.
layout(local_size_x = 1) in;
#ifdef SEPARATE
#include "lvsm/sampling/separate.glsl"
layout(binding = 2) uniform texture2D map;
layout(binding = 3) uniform texture2DArray layers;
layout(binding = 4) uniform texture2D terms;
layout(binding = 5) uniform sampler filtering;
#define MAP map, filtering
#define LAYERS layers, filtering
#define TERMS terms, filtering
#else
#include "lvsm/sampling/combined.glsl"
layout(binding = 2) uniform sampler2D map;
layout(binding = 3) uniform sampler2DArray layers;
layout(binding = 4) uniform sampler2D terms;
#define MAP map
#define LAYERS layers
#define TERMS terms
#endif
// uv, depth, change of the coordinates to the next pixel
layout(std430, binding = 0) readonly buffer Inputs { vec4 inputs[]; };
layout(std430, binding = 1) writeonly buffer Outputs { float outputs[]; };

void main()
{
    vec4 receiver = inputs[gl_WorkGroupID.x];
    vec2 uv = receiver.xy;
    float depth = receiver.z;
    vec2 dx = vec2(receiver.w, 0.0);
    vec2 dy = vec2(0.0, receiver.w);
    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = min(0.25 * float(i), 1.0);

    vec4 border = vec4(1.0, 2.0, 3.0, 4.0);
    vec4 texels[4];
    texels[0] = lvsm_sampleMap(MAP, uv, dx, dy, border);
    texels[1] = lvsm_sampleMapArray(LAYERS, uv, 1, dx, dy, border);
    texels[2] = lvsm_gatherMap(MAP, uv, 5.0);
    texels[3] = lvsm_gatherMapArray(LAYERS, uv, 1, 5.0);
    uint result = 21u * gl_WorkGroupID.x;
    for (int t = 0; t < 4; ++t)
    {
        for (int c = 0; c < 4; ++c)
            outputs[result + uint(4 * t + c)] = texels[t][c];
    }
    vec2 fraction = lvsm_mapFraction(uv, vec2(8.0, 8.0));
    outputs[result + 16u] = fraction.x;
    outputs[result + 17u] = fraction.y;
    outputs[result + 18u] = lvsm_sampleLayers(LAYERS, uv, dx, dy, depth, splits, 4, 0.0625, 0.0625, 0.01);
    outputs[result + 19u] = lvsm_samplePcf(MAP, uv, 3.5, depth, vec2(0.01, -0.02), 0.001);
    outputs[result + 20u] = lvsm_sampleEsm(TERMS, uv, dx, dy, depth, 20.0, 0.02);
}
