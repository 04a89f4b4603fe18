#version 450

#include "cutout.glsl"

layout(set = 0, binding = 1) uniform View
{
    mat4 viewProjection;
    // With w = 0 it is a direction towards the eye.
    vec4 eye;
} view;
#ifdef PEELED
// What was drawn before this peel: only what lies behind is seen.
layout(set = 0, binding = 2) uniform sampler2D before;
#endif

// As in mesh.hpp.
const float THIN = 3.0;

layout(location = 0) in vec3 worldPosition;
layout(location = 1) in vec3 worldNormal;
layout(location = 2) in vec3 worldFaceNormal;
layout(location = 3) in vec3 albedo;
layout(location = 4) in float objectNumber;
layout(location = 5) in vec2 placeOnLeaf;

layout(location = 0) out vec4 positionAndObject;
layout(location = 1) out vec4 shadingNormal;
layout(location = 2) out vec4 planeNormal;
layout(location = 3) out vec4 colour;
// Change of the position to the next pixel in x and in y.
layout(location = 4) out vec4 alongX;
layout(location = 5) out vec4 alongY;

void main()
{
    alongX = vec4(dFdx(worldPosition), 0.0);
    alongY = vec4(dFdy(worldPosition), 0.0);
    if (isCutOut(placeOnLeaf))
        discard;
    vec3 towardsEye = view.eye.w > 0.0 ? view.eye.xyz - worldPosition : view.eye.xyz;
    float side = dot(worldFaceNormal, towardsEye) < 0.0 ? -1.0 : 1.0;
    float object = objectNumber;
#ifdef PEELED
    if (gl_FragCoord.z <= texelFetch(before, ivec2(gl_FragCoord.xy), 0).x)
        discard;
    // A body's far side turns its back to the light: no receiver.
    if (side < 0.0 && objectNumber != THIN)
        object = 0.0;
#endif
    positionAndObject = vec4(worldPosition, object);
    shadingNormal = vec4(normalize(worldNormal) * side, 0.0);
    planeNormal = vec4(normalize(worldFaceNormal) * side, 0.0);
    colour = vec4(albedo, 1.0);
}
