#version 450

#include "cutout.glsl"

layout(set = 0, binding = 1) uniform View
{
    mat4 viewProjection;
    vec4 eye;
} view;

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
    // Thin surfaces are seen from both sides.
    float side = dot(worldFaceNormal, view.eye.xyz - worldPosition) < 0.0 ? -1.0 : 1.0;
    positionAndObject = vec4(worldPosition, objectNumber);
    shadingNormal = vec4(normalize(worldNormal) * side, 0.0);
    planeNormal = vec4(normalize(worldFaceNormal) * side, 0.0);
    colour = vec4(albedo, 1.0);
}
