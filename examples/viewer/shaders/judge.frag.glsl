// Seen from the eye: what a technique makes of its map. In front of this stand its settings, store and visibility.
#include <viewer_light>
uniform LVSM_HIGHP sampler2DArray map;
uniform LVSM_HIGHP sampler2DArray unfiltered;
layout(location = 0) out vec4 result;

void main()
{
    vec2 uv = mapCoord(world).xy;
    vec2 texels = uv * vec2(textureSize(map, 0).xy);
    float depth = lightDepth(world);
    vec3 across = vec3(dFdx(texels), dFdx(depth));
    vec3 down = vec3(dFdy(texels), dFdy(depth));
    lvsm_MapPoint at = lvsm_mapPoint(uv, dFdx(uv), dFdy(uv), 0);
    if (texture(albedo, coord).a < cutoff)
        discard;
    if (mapCoord(world).z == 0.0)
    {
        result = vec4(1.0, -1.0, 0.0, 0.0);
        return;
    }
    vec2 gradient = lvsm_receiverGradient(across, down);
    float lit = VISIBILITY;
    result = vec4(lit, LAYER, stored(map, at, depth));
}
