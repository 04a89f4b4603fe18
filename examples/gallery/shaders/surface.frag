#version 450

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

layout(location = 0) out vec4 positionAndObject;
layout(location = 1) out vec4 shadingNormal;
layout(location = 2) out vec4 planeNormal;
layout(location = 3) out vec4 colour;

void main()
{
    // Thin surfaces are seen from both sides.
    float side = dot(worldFaceNormal, view.eye.xyz - worldPosition) < 0.0 ? -1.0 : 1.0;
    positionAndObject = vec4(worldPosition, objectNumber);
    shadingNormal = vec4(normalize(worldNormal) * side, 0.0);
    planeNormal = vec4(normalize(worldFaceNormal) * side, 0.0);
    colour = vec4(albedo, 1.0);
}
