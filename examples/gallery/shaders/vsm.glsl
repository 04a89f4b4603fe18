// Variance shadow map: LVSM paper, section 3.
#include "technique.glsl"
#include "lvsm/moments.glsl"

vec4 encode(float depth, int texel)
{
    return vec4(lvsm_depthMoments(depth), 0.0, 0.0);
}

vec2 receive(vec2 coord, float depth)
{
    vec2 moments = textureLod(source, vec3(coord, 0.0), 0.0).xy;
    return vec2(lvsm_chebyshevUpperBound(moments, depth - technique.bias, technique.minVariance), 0.0);
}
