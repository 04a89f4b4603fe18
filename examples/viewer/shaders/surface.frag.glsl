// Seen from the eye: the surface's colour, and how much light comes to it where nothing shadows it.
#include <lvsm>
#include <viewer_light>
layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 arriving;

void main()
{
    vec4 texel = texture(albedo, coord);
    if (texel.a < cutoff)
        discard;
    vec3 plane = planeNormal();
    vec3 shading = normalize(facing);
    shading = dot(shading, plane) < 0.0 ? -shading : shading;
    vec3 direction = towardsLight(world);
    float cosine = dot(plane, direction) > 0.0 ? max(dot(shading, direction), 0.0) : 0.0;
    bool covered = dot(plane, direction) > 0.0 && mapCoord(world).z > 0.0;
    colour = vec4(tint * texel.rgb, 1.0);
    arriving = vec4(cosine * spotCone(world), covered ? 1.0 : 0.0, 0.0, 1.0);
}
