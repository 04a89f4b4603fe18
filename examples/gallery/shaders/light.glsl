// The light, its depth metric, and where its shadow map has a point: one map, or the six faces of a cube.
#ifndef GALLERY_LIGHT_GLSL
#define GALLERY_LIGHT_GLSL

#include "lvsm/depth.glsl"
#include "lvsm/sampling/common.glsl"

struct Face
{
    mat4 viewProjection;
    // The far plane at texture coordinates (u, v) is corner + u across + v down.
    vec4 corner;
    vec4 across;
    vec4 down;
};

layout(set = 0, binding = 0) uniform LightBlock
{
    // Of a light that has one in xyz, with w = 1, or any point of a directional light's plane.
    vec4 position;
    vec4 direction;
    // Distances where depth is 0 and 1, and cosines where the spot's edge is dark and where it is bright.
    vec4 range;
    // How many faces, the tangent of half a cube face's angle, and the distance of the far plane.
    vec4 shape;
    Face faces[6];
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

/// Share of the light that is sent towards a point: a spot's cone, and a lamp's reach.
float lightTowards(vec3 point)
{
    if (light.shape.x > 1.0)
        return 1.0 - smoothstep(0.6, 0.95, lightDepth(point));
    float cosine = dot(-towardsLight(point), light.direction.xyz);
    return light.position.w > 0.0 ? smoothstep(light.range.z, light.range.w, cosine) : 1.0;
}

vec2 coordOn(int face, vec3 point)
{
    vec4 clip = light.faces[face].viewProjection * vec4(point, 1.0);
    return clip.xy / clip.w * 0.5 + 0.5;
}

/// dx, dy: change of the point to the next pixel.
lvsm_MapPoint lightMapPoint(vec3 point, vec3 dx, vec3 dy, int slicesOfFace)
{
    if (light.shape.x > 1.0)
        return lvsm_cubePoint(point - light.position.xyz, dx, dy, 0, slicesOfFace, light.shape.y);
    vec2 uv = coordOn(0, point);
    return lvsm_mapPoint(uv, coordOn(0, point + dx) - uv, coordOn(0, point + dy) - uv, 0);
}

/// Whether the shadow map has the point.
bool isCovered(vec3 point)
{
    vec4 clip = light.faces[0].viewProjection * vec4(point, 1.0);
    bool inside = clip.w > 0.0 && all(lessThan(abs(clip.xy), vec2(clip.w)));
    return lightDepth(point) < 1.0 && (light.shape.x > 1.0 || inside);
}

/// Where the light's ray through `coord` of a face meets the plane through `point`.
vec3 pointOfPlane(int face, vec2 coord, vec3 point, vec3 normal)
{
    Face own = light.faces[face];
    vec3 far = own.corner.xyz + coord.x * own.across.xyz + coord.y * own.down.xyz;
    vec3 from = light.position.w > 0.0 ? light.position.xyz : far - light.shape.z * light.direction.xyz;
    float height = dot(normal, point - from);
    float fall = dot(normal, far - from);
    // A plane that turns away from the light is met beyond the ray's end, or never.
    float along = height * fall > 0.0 ? clamp(height / fall, 0.0, 1.0) : 1.0;
    return mix(from, far, along);
}

#endif
