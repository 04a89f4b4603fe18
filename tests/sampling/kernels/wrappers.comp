#version 450
#extension GL_GOOGLE_include_directive : require
// Calls every wrapper for one receiver a thread; SEPARATE chooses textures and samplers apart. The other form is there,
// too: one shader may have both.
layout(local_size_x = 1) in;
#include "lvsm/sampling/combined.glsl"
#include "lvsm/sampling/separate.glsl"
#define COMPONENTS 4
#ifdef SEPARATE
layout(binding = 2) uniform texture2D map;
layout(binding = 3) uniform texture2DArray slices;
layout(binding = 4) uniform texture2DArray unfiltered;
layout(binding = 5) uniform texture2DArray greatest;
layout(binding = 6) uniform sampler filtering;
#define MAP map, filtering
#define SLICES slices, filtering
#define ESM slices, unfiltered, filtering
#define ZMAX slices, unfiltered, greatest, filtering
#else
layout(binding = 2) uniform sampler2D map;
layout(binding = 3) uniform sampler2DArray slices;
layout(binding = 4) uniform sampler2DArray unfiltered;
layout(binding = 5) uniform sampler2DArray greatest;
#define MAP map
#define SLICES slices
#define ESM slices, unfiltered
#define ZMAX slices, unfiltered, greatest
#endif
layout(std430, binding = 0) readonly buffer Inputs { vec4 receivers[]; };
layout(std430, binding = 1) writeonly buffer Outputs { float outputs[]; };

#include "wrappers.glsl"

void main()
{
    vec4 inputs[4];
    for (int i = 0; i < 4; ++i)
        inputs[i] = receivers[4u * gl_WorkGroupID.x + uint(i)];
    float results[RESULTS];
    callWrappers(inputs, results);
    for (int i = 0; i < RESULTS; ++i)
        outputs[uint(RESULTS) * gl_WorkGroupID.x + uint(i)] = results[i];
}
