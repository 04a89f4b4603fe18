// Ground truth: every texel of the unfiltered map under the blur and the bilinear sample after it is compared with the
// receiver's own plane, with the same weights.
#version 450

#include "kernel.glsl"
#include "light.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(set = 0, binding = 1) uniform sampler2DArray positions;
layout(set = 0, binding = 2) uniform sampler2DArray shadingNormals;
layout(set = 0, binding = 3) uniform sampler2DArray planeNormals;
layout(set = 0, binding = 4) uniform sampler2DArray shadowMap;
layout(set = 0, binding = 5, rgba32f) uniform writeonly image2DArray target;

// What rises less than this above the receiver's plane, for each metre from the receiver, is the receiver's own curved
// surface and not an occluder. And a little more, for rounding.
const float OWN_SLOPE = 0.3;
const float SLACK = 1e-4;

float blurredBilinearWeight(int tap, float fraction)
{
    float right = tap > 0 ? WEIGHTS[tap - 1] : 0.0;
    float left = tap <= 2 * RADIUS ? WEIGHTS[tap] : 0.0;
    return mix(left, right, fraction);
}

float exactVisibility(vec2 coord, vec3 point, vec3 normal)
{
    ivec2 size = textureSize(shadowMap, 0).xy;
    vec2 corner = coord * vec2(size) - 0.5;
    ivec2 first = ivec2(floor(corner)) - RADIUS;
    vec2 fraction = fract(corner);
    float lit = 0.0;
    for (int y = 0; y <= 2 * RADIUS + 1; ++y)
    {
        float rowWeight = blurredBilinearWeight(y, fraction.y);
        for (int x = 0; x <= 2 * RADIUS + 1; ++x)
        {
            ivec2 tap = clamp(first + ivec2(x, y), ivec2(0), size - 1);
            vec3 receiver = pointOfPlane((vec2(tap) + 0.5) / vec2(size), point, normal);
            float rise = OWN_SLOPE * distance(receiver, point) / (light.range.y - light.range.x);
            bool visible = texelFetch(shadowMap, ivec3(tap, 0), 0).r >= lightDepth(receiver) - rise - SLACK;
            lit += visible ? rowWeight * blurredBilinearWeight(x, fraction.x) : 0.0;
        }
    }
    return lit;
}

void main()
{
    ivec3 pixel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(pixel.xy, textureSize(positions, 0).xy)))
        return;
    vec4 surface = texelFetch(positions, pixel, 0);
    vec3 normal = texelFetch(planeNormals, pixel, 0).xyz;
    vec3 toLight = towardsLight(surface.xyz);
    vec3 coord = shadowMapCoord(surface.xyz);
    bool facing = surface.w > 0.0 && dot(normal, toLight) > 0.0;
    float cosine = facing ? max(dot(texelFetch(shadingNormals, pixel, 0).xyz, toLight), 0.0) : 0.0;
    float arriving = cosine * spotCone(surface.xyz);
    bool covered = facing && coord.z > 0.0;
    float visibility = covered ? exactVisibility(coord.xy, surface.xyz, normal) : 1.0;
    imageStore(target, pixel, vec4(visibility, arriving, covered ? 1.0 : 0.0, 0.0));
}
