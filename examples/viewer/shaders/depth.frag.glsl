// Seen from the light: linear depths, unwarped.
#include <lvsm>
#include <viewer_light>
layout(location = 0) out vec4 result;

void main()
{
    if (texture(albedo, coord).a < cutoff)
        discard;
    result = vec4(lightDepth(world));
}
