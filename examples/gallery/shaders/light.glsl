// The light, its depth metric and its shadow map's coordinates.
#ifndef GALLERY_LIGHT_GLSL
#define GALLERY_LIGHT_GLSL

#include "lvsm/depth.glsl"

layout(set = 0, binding = 0) uniform LightBlock
{
    mat4 viewProjection;
    mat4 inverseViewProjection;
    vec4 position;
    vec4 direction;
    vec4 range;
} light;

float lightDepth(vec3 point)
{
    return light.position.w > 0.0
        ? lvsm_pointLightDepth(point, light.position.xyz, light.range.x, light.range.y)
        : lvsm_planeLightDepth(point, light.position.xyz, light.direction.xyz, light.range.x, light.range.y);
}

vec3 towardsLight(vec3 point)
{
    return light.position.w > 0.0 ? normalize(light.position.xyz - point) : -light.direction.xyz;
}

float spotCone(vec3 point)
{
    float cosine = dot(-towardsLight(point), light.direction.xyz);
    return light.position.w > 0.0 ? smoothstep(light.range.z, light.range.w, cosine) : 1.0;
}

/// Texture coordinates in xy; z is 1 where the shadow map covers the point.
vec3 shadowMapCoord(vec3 point)
{
    vec4 clip = light.viewProjection * vec4(point, 1.0);
    vec2 coord = clip.xy / clip.w * 0.5 + 0.5;
    bool inside = clip.w > 0.0 && all(greaterThan(coord, vec2(0.0))) && all(lessThan(coord, vec2(1.0)));
    return vec3(coord, inside ? 1.0 : 0.0);
}

/// Where the light's ray through `coord` meets the plane through `point`.
vec3 pointOfPlane(vec2 coord, vec3 point, vec3 normal)
{
    vec4 near = light.inverseViewProjection * vec4(coord * 2.0 - 1.0, 0.0, 1.0);
    vec4 far = light.inverseViewProjection * vec4(coord * 2.0 - 1.0, 1.0, 1.0);
    vec3 from = near.xyz / near.w;
    vec3 ray = far.xyz / far.w - from;
    float height = dot(normal, point - from);
    float fall = dot(normal, ray);
    // A plane that turns away from the light is met beyond the ray's end, or never.
    float along = height * fall > 0.0 ? clamp(height / fall, 0.0, 1.0) : 1.0;
    return from + along * ray;
}

#endif
