// A shadow map as it is: one comparison with the nearest texel, no filter.
#include "technique.glsl"
#include "lvsm/layers.glsl"

vec4 encode(float depth, int texel)
{
    return vec4(depth, 0.0, 0.0, 0.0);
}

vec2 receive(vec2 coord, float depth)
{
    ivec2 texel = ivec2(coord * vec2(textureSize(source, 0).xy));
    float occluder = texelFetch(source, ivec3(texel, 0), 0).r;
    return vec2(lvsm_stepWarp(occluder, depth - technique.bias), 0.0);
}
