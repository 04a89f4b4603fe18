#version 450

#include "light.glsl"

layout(location = 0) in vec3 worldPosition;
layout(location = 0) out float depth;

void main()
{
    depth = lightDepth(worldPosition);
}
