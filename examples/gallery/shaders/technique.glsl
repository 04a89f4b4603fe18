// What every technique is given. A technique defines
//   vec4 encode(float depth, int texel)              what to store for a depth, in array layer `texel` of its image
//   vec2 receive(vec2 coord, float depth)            visibility of a receiver, and the number of its layer
#ifndef GALLERY_TECHNIQUE_GLSL
#define GALLERY_TECHNIQUE_GLSL

#include "light.glsl"

layout(set = 0, binding = 1) uniform TechniqueBlock
{
    vec2 exponents;
    float minVariance;
    float bias;
    float overlap;
    float transition;
    int layerCount;
    vec4 splits[9];
} technique;

layout(set = 0, binding = 2) uniform sampler2DArray source;

#endif
