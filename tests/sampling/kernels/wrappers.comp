#version 450
#extension GL_GOOGLE_include_directive : require
// Calls every wrapper for one receiver a thread; SEPARATE chooses textures and samplers apart. The other form is there,
// too: one shader may have both.
layout(local_size_x = 1) in;
#include "lvsm/sampling/combined.glsl"
#include "lvsm/sampling/separate.glsl"
#ifdef SEPARATE
layout(binding = 2) uniform texture2D map;
layout(binding = 3) uniform texture2DArray layers;
layout(binding = 4) uniform texture2D terms;
layout(binding = 5) uniform texture2D blurred;
layout(binding = 6) uniform sampler filtering;
#define MAP map, filtering
#define LAYERS layers, filtering
#define ESM blurred, terms, filtering
#else
layout(binding = 2) uniform sampler2D map;
layout(binding = 3) uniform sampler2DArray layers;
layout(binding = 4) uniform sampler2D terms;
layout(binding = 5) uniform sampler2D blurred;
#define MAP map
#define LAYERS layers
#define ESM blurred, terms
#endif
layout(std430, binding = 0) readonly buffer Inputs { vec4 inputs[]; };
layout(std430, binding = 1) writeonly buffer Outputs { float outputs[]; };

#include "wrappers.glsl"

void main()
{
    float results[21];
    callWrappers(inputs[2u * gl_WorkGroupID.x], inputs[2u * gl_WorkGroupID.x + 1u], results);
    for (int i = 0; i < 21; ++i)
        outputs[21u * gl_WorkGroupID.x + uint(i)] = results[i];
}
