// Seen from the eye: every texel of the unfiltered map under the blur and the bilinear sample after it is compared with
// the receiver's own plane, with the same weights. It has nothing of the library but the depth's metric.
#include <lvsm>
#include <viewer_light>
uniform highp sampler2DArray map; // depths, a slice for each face of the light
uniform float weights[MAX_TAPS];
uniform int radius;
layout(location = 0) out vec4 result;

// What rises less than this above the receiver's plane, for each metre from the receiver, is the receiver's own curved
// surface and not an occluder. And a little more, for rounding. As in the gallery.
const float OWN_SLOPE = 0.3;
const float SLACK = 1.0e-4;

float weightOf(int tap, float between)
{
    float right = tap > 0 ? weights[tap - 1] : 0.0;
    float left = tap <= 2 * radius ? weights[tap] : 0.0;
    return mix(left, right, between);
}

// Where the light's ray through a point of the map meets the plane.
vec3 onPlane(int face, vec2 at, vec3 point, vec3 normal)
{
    vec4 near = fromLight[face] * vec4(at * 2.0 - 1.0, -1.0, 1.0);
    vec4 far = fromLight[face] * vec4(at * 2.0 - 1.0, 1.0, 1.0);
    vec3 from = near.xyz / near.w;
    vec3 ray = far.xyz / far.w - from;
    float height = dot(normal, point - from);
    float fall = dot(normal, ray);
    // A plane that turns away from the light is met beyond the ray's end, or never.
    float along = height * fall > 0.0 ? clamp(height / fall, 0.0, 1.0) : 1.0;
    return from + along * ray;
}

void main()
{
    vec3 normal = planeNormal();
    vec3 at = mapCoord(world);
    if (texture(albedo, coord).a < cutoff)
        discard;
    result = vec4(1.0, -1.0, 0.0, 0.0);
    if (at.z == 0.0)
        return;
    int face = faceOf(world);
    ivec2 size = textureSize(map, 0).xy;
    vec2 corner = at.xy * vec2(size) - 0.5;
    ivec2 first = ivec2(floor(corner)) - radius;
    vec2 between = fract(corner);
    float lit = 0.0;
    for (int y = 0; y <= 2 * radius + 1; ++y)
    {
        float row = weightOf(y, between.y);
        for (int x = 0; x <= 2 * radius + 1; ++x)
        {
            ivec2 tap = first + ivec2(x, y);
            vec3 receiver = onPlane(face, (vec2(tap) + 0.5) / vec2(size), world, normal);
            float rise = OWN_SLOPE * distance(receiver, world) / (lightRange.y - lightRange.x);
            bool isOn = all(greaterThanEqual(tap, ivec2(0))) && all(lessThan(tap, size));
            float occluder = isOn ? texelFetch(map, ivec3(clamp(tap, ivec2(0), size - 1), face), 0).r : 1.0;
            lit += occluder >= lightDepth(receiver) - rise - SLACK ? row * weightOf(x, between.x) : 0.0;
        }
    }
    result.x = lit;
}
