// Counts how many of the camera's pixels that face the light read each texel of its map.
#version 450

#include "light.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(set = 0, binding = 1) uniform sampler2DArray positions;
layout(set = 0, binding = 2) uniform sampler2DArray planeNormals;
layout(set = 0, binding = 3, r32ui) uniform uimage2DArray target;

void main()
{
    ivec3 pixel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(pixel.xy, textureSize(positions, 0).xy)))
        return;
    vec4 surface = texelFetch(positions, pixel, 0);
    bool isFacing = dot(texelFetch(planeNormals, pixel, 0).xyz, towardsLight(surface.xyz)) > 0.0;
    if (surface.w == 0.0 || !isFacing || !isCovered(surface.xyz))
        return;
    lvsm_MapPoint at = lightMapPoint(surface.xyz, vec3(0.0), vec3(0.0), 1);
    ivec2 size = imageSize(target).xy;
    imageAtomicAdd(target, ivec3(clamp(ivec2(at.uv * vec2(size)), ivec2(0), size - 1), at.slice), 1u);
}
