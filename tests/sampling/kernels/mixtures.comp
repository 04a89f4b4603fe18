#version 450
#extension GL_GOOGLE_include_directive : require
// Reads maps of mixtures for one receiver a thread; SEPARATE chooses textures and samplers apart.
layout(local_size_x = 1) in;
#ifdef SEPARATE
#include "lvsm/sampling/separate.glsl"
layout(binding = 2) uniform utexture2DArray two;
layout(binding = 3) uniform utexture2DArray four;
layout(binding = 4) uniform sampler filtering;
#define MAP(map) map, filtering
#else
#include "lvsm/sampling/combined.glsl"
layout(binding = 2) uniform usampler2DArray two;
layout(binding = 3) uniform usampler2DArray four;
#define MAP(map) map
#endif
// Two for a receiver: uv, depth and texels; gradient, deviation and slice.
layout(std430, binding = 0) readonly buffer Inputs { vec4 inputs[]; };
layout(std430, binding = 1) writeonly buffer Outputs { vec4 outputs[]; };

// From the whole map, and from a rectangle of it.
void main()
{
    vec4 receiver = inputs[2u * gl_WorkGroupID.x];
    vec4 plane = inputs[2u * gl_WorkGroupID.x + 1u];
    vec2 none = vec2(0.0, 0.0);
    lvsm_MapPoint at = lvsm_mapPoint(receiver.xy, none, none, int(plane.w));
    lvsm_MapPoint inPart = lvsm_atlasPoint(receiver.xy, none, none, int(plane.w), vec4(0.25, 0.25, 0.5, 0.5));
    outputs[gl_WorkGroupID.x] =
        vec4(lvsm_sampleMixture2(MAP(two), at, receiver.z, plane.xy, receiver.w, plane.z),
             lvsm_sampleMixture4(MAP(four), at, receiver.z, plane.xy, receiver.w, plane.z),
             lvsm_sampleMixture2(MAP(two), inPart, receiver.z, plane.xy, receiver.w, plane.z),
             lvsm_sampleMixture4(MAP(four), inPart, receiver.z, plane.xy, receiver.w, plane.z));
}
