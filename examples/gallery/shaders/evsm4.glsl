// Exponential variance shadow map with both warps: LVSM paper, section 7.
#include "technique.glsl"
#include "lvsm/exponential.glsl"

vec4 encode(float depth, int texel)
{
    return lvsm_exponentialMoments(depth, technique.exponents);
}

vec2 receive(vec2 coord, float depth)
{
    vec4 moments = textureLod(source, vec3(coord, 0.0), 0.0);
    float receiver = depth - technique.bias;
    return vec2(lvsm_exponentialVisibility4(moments, receiver, technique.exponents, technique.minVariance), 0.0);
}
