// How much light reaches each pixel of the camera's picture: one call of a technique's wrapper, which the macro
// VISIBILITY is. It may use all that is declared here.
#version 450

// The splits, where the placement and the store pass have them.
#define LVSM_STORE_DEPTHS layout(binding = 30)
#define LVSM_STORE_TARGET layout(binding = 31)
#define LVSM_STORE_BLOCK layout(set = 0, binding = 2, std140)
#include "lvsm/passes/store.glsl"
#include "lvsm/sampling/combined.glsl"
#include "light.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(set = 0, binding = 1) uniform Shading
{
    // What a receiver is moved towards the light, in depth.
    float bias;
    // Width of the transition between layers, in depth.
    float transition;
    // Slices that one face of the light's map takes.
    int slicesOfFace;
};
layout(set = 0, binding = 3) uniform MAP_TYPE map;
layout(set = 0, binding = 4) uniform sampler2DArray unfiltered;
layout(set = 0, binding = 5) uniform sampler2DArray greatest;
layout(set = 0, binding = 6) uniform sampler2DArray positions;
layout(set = 0, binding = 7) uniform sampler2DArray alongX;
layout(set = 0, binding = 8) uniform sampler2DArray alongY;
layout(set = 0, binding = 9, rg32f) uniform writeonly image2DArray target;

void main()
{
    ivec3 pixel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(pixel.xy, textureSize(positions, 0).xy)))
        return;
    vec4 surface = texelFetch(positions, pixel, 0);
    vec2 result = vec2(1.0, -1.0);
    if (surface.w > 0.0 && isCovered(surface.xyz))
    {
        vec3 dx = texelFetch(alongX, pixel, 0).xyz;
        vec3 dy = texelFetch(alongY, pixel, 0).xyz;
        lvsm_MapPoint at = lightMapPoint(surface.xyz, dx, dy, slicesOfFace);
        float exactDepth = lightDepth(surface.xyz);
        vec2 size = vec2(textureSize(map, 0).xy);
        vec2 gradient = lvsm_receiverGradient(vec3(at.dx * size, lightDepth(surface.xyz + dx) - exactDepth),
                                              vec3(at.dy * size, lightDepth(surface.xyz + dy) - exactDepth));
        float depth = exactDepth - bias;
        float splits[LVSM_MAX_LAYERS + 1];
        for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
            splits[i] = lvsm_splits[i / 4][i % 4];
        float layer = lvsm_layerCount > 0 ? float(lvsm_layerIndex(depth, splits, lvsm_layerCount)) : 0.0;
        result = vec2(VISIBILITY, layer);
    }
    imageStore(target, pixel, vec4(result, 0.0, 0.0));
}
