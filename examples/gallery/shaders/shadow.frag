#version 450

#include "cutout.glsl"

layout(location = 5) in vec2 placeOnLeaf;

void main()
{
    if (isCutOut(placeOnLeaf))
        discard;
}
