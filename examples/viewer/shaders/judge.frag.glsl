// Seen from the eye: what a technique makes of its map. In front of this stand its settings, store and visibility.
#include <viewer_light>
uniform LVSM_HIGHP MAP_SAMPLER map;
uniform LVSM_HIGHP sampler2DArray unfiltered;
uniform int slicesOfFace;
uniform float mapSize; // of the depths
uniform float tangent;
layout(location = 0) out vec4 result;

void main()
{
    vec3 direction = world - lightPosition.xyz;
    vec2 uv = mapCoord(world).xy;
    float depth = lightDepth(world);
    lvsm_MapPoint at = lvsm_mapPoint(uv, dFdx(uv), dFdy(uv), 0);
    vec3 across = dFdx(direction);
    vec3 down = dFdy(direction);
    vec2 change = vec2(dFdx(depth), dFdy(depth));
    if (texture(albedo, coord).a < cutoff)
        discard;
    if (faceCount > 1)
        at = lvsm_cubePoint(direction, across, down, 0, slicesOfFace, tangent);
    if (mapCoord(world).z == 0.0)
    {
        result = vec4(1.0, -1.0, 0.0, 0.0);
        return;
    }
    vec2 gradient = lvsm_receiverGradient(vec3(at.dx * mapSize, change.x), vec3(at.dy * mapSize, change.y));
    float lit = VISIBILITY;
    result = vec4(lit, LAYER, stored(map, at, depth));
}
