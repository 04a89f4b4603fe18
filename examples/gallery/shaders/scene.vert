#version 450

layout(set = 0, binding = 1) uniform View
{
    mat4 viewProjection;
    vec4 eye;
} view;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 faceNormal;
layout(location = 3) in vec3 colour;
layout(location = 4) in float object;
layout(location = 5) in vec2 place;

layout(location = 0) out vec3 worldPosition;
layout(location = 1) out vec3 worldNormal;
layout(location = 2) out vec3 worldFaceNormal;
layout(location = 3) out vec3 albedo;
layout(location = 4) out float objectNumber;
layout(location = 5) out vec2 placeOnLeaf;

void main()
{
    gl_Position = view.viewProjection * vec4(position, 1.0);
    worldPosition = position;
    worldNormal = normal;
    worldFaceNormal = faceNormal;
    albedo = colour;
    objectNumber = object;
    placeOnLeaf = place;
}
