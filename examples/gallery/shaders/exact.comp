// Ground truth: every texel of the unfiltered map under a technique's filter is compared with the receiver's own plane,
// with the filter's weights.
#version 450

#include "lvsm/filter.glsl"
#include "light.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(set = 0, binding = 1) uniform sampler2DArray positions;
layout(set = 0, binding = 2) uniform sampler2DArray shadingNormals;
layout(set = 0, binding = 3) uniform sampler2DArray planeNormals;
layout(set = 0, binding = 4) uniform sampler2DArray shadowMap;
layout(set = 0, binding = 5, rgba32f) uniform writeonly image2DArray target;
layout(set = 0, binding = 6) uniform Window
{
    // Texels to each side that the filter reads.
    int reach;
    // Width of a box in texels, 0 for the taps below.
    float extent;
    // Of a Gaussian in the box, 1 / (2 deviation^2).
    float falloff;
    // A blur from its middle outwards, read by a linear filter.
    vec4 taps[17];
};

// What rises less than this above the receiver's plane, for each metre from the receiver, is the receiver's own curved
// surface and not an occluder. And a little more, for rounding.
const float OWN_SLOPE = 0.3;
const float SLACK = 1e-4;

// offset: of a texel's centre from the receiver, in texels.
float weightAt(float offset)
{
    float away = abs(offset);
    if (extent > 0.0)
        return lvsm_boxWeight(offset, extent) * exp(-falloff * offset * offset);
    int tap = int(away);
    return mix(taps[tap / 4][tap % 4], taps[(tap + 1) / 4][(tap + 1) % 4], away - float(tap));
}

float exactVisibility(vec3 point, vec3 normal)
{
    lvsm_MapPoint at = lightMapPoint(point, vec3(0.0), vec3(0.0), 1);
    ivec2 size = textureSize(shadowMap, 0).xy;
    vec2 place = at.uv * vec2(size) - 0.5;
    ivec2 first = ivec2(floor(place)) - reach;
    float lit = 0.0;
    float sum = 0.0;
    for (int y = 0; y <= 2 * reach + 1; ++y)
    {
        for (int x = 0; x <= 2 * reach + 1; ++x)
        {
            ivec2 tap = first + ivec2(x, y);
            float weight = weightAt(float(tap.x) - place.x) * weightAt(float(tap.y) - place.y);
            sum += weight;
            bool isOn = all(greaterThanEqual(tap, ivec2(0))) && all(lessThan(tap, size));
            float occluder = isOn ? texelFetch(shadowMap, ivec3(tap, at.slice), 0).r : 1.0;
            vec3 receiver = pointOfPlane(at.slice, (vec2(tap) + 0.5) / vec2(size), point, normal);
            float rise = OWN_SLOPE * distance(receiver, point) / (light.range.y - light.range.x);
            lit += occluder >= lightDepth(receiver) - rise - SLACK ? weight : 0.0;
        }
    }
    return lit / max(sum, 1e-6);
}

void main()
{
    ivec3 pixel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(pixel.xy, textureSize(positions, 0).xy)))
        return;
    vec4 surface = texelFetch(positions, pixel, 0);
    vec3 normal = texelFetch(planeNormals, pixel, 0).xyz;
    vec3 toLight = towardsLight(surface.xyz);
    bool facing = surface.w > 0.0 && dot(normal, toLight) > 0.0;
    float cosine = facing ? max(dot(texelFetch(shadingNormals, pixel, 0).xyz, toLight), 0.0) : 0.0;
    float arriving = cosine * lightTowards(surface.xyz);
    bool covered = facing && isCovered(surface.xyz);
    float visibility = covered ? exactVisibility(surface.xyz, normal) : 1.0;
    imageStore(target, pixel, vec4(visibility, arriving, covered ? 1.0 : 0.0, 0.0));
}
