// The light, its depth metric, its map's coordinates, and what of a surface is cut out by its texture.
uniform mat4 toLight[6]; // a point light has six faces, others the first alone
uniform mat4 fromLight[6];
uniform int faceCount;
uniform vec4 lightPosition; // w is 1 for a light that has a place
uniform vec3 lightDirection;
uniform vec2 lightRange;
uniform vec2 lightCone;
uniform sampler2D albedo;
uniform float cutoff;

in vec3 world;
in vec3 facing;
in vec3 tint;
in vec2 coord;

float lightDepth(vec3 point)
{
    if (lightPosition.w > 0.0)
        return lvsm_pointLightDepth(point, lightPosition.xyz, lightRange.x, lightRange.y);
    return lvsm_planeLightDepth(point, lightPosition.xyz, lightDirection, lightRange.x, lightRange.y);
}

vec3 towardsLight(vec3 point)
{
    return lightPosition.w > 0.0 ? normalize(lightPosition.xyz - point) : -lightDirection;
}

float spotCone(vec3 point)
{
    float cosine = dot(-towardsLight(point), lightDirection);
    return lightPosition.w > 0.0 ? smoothstep(lightCone.x, lightCone.y, cosine) : 1.0;
}

// The face of the light's cube that sees a point: +x, -x, +y, -y, +z, -z.
int faceOf(vec3 point)
{
    vec3 along = point - lightPosition.xyz;
    vec3 size = abs(along);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return faceCount == 1 ? 0 : 2 * axis + (along[axis] < 0.0 ? 1 : 0);
}

// Texture coordinates in xy; z is 1 where the map covers the point.
vec3 mapCoord(vec3 point)
{
    vec4 clip = toLight[faceOf(point)] * vec4(point, 1.0);
    vec2 at = clip.xy / clip.w * 0.5 + 0.5;
    bool inside = clip.w > 0.0 && all(greaterThan(at, vec2(0.0))) && all(lessThan(at, vec2(1.0)));
    return vec3(at, inside ? 1.0 : 0.0);
}

// The surface's plane, turned to the eye: thin surfaces are seen from both sides.
vec3 planeNormal()
{
    vec3 across = cross(dFdx(world), dFdy(world));
    return across / max(length(across), 1.0e-20);
}
