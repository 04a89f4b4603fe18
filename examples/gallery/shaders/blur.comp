#version 450

#include "kernel.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(set = 0, binding = 0) uniform sampler2DArray source;
layout(set = 0, binding = 1, STORAGE_FORMAT) uniform writeonly image2DArray target;
layout(set = 0, binding = 2) uniform Pass { ivec2 along; };

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    ivec2 size = textureSize(source, 0).xy;
    if (any(greaterThanEqual(texel.xy, size)))
        return;
    vec4 sum = vec4(0.0);
    for (int i = -RADIUS; i <= RADIUS; ++i)
    {
        ivec2 tap = clamp(texel.xy + along * i, ivec2(0), size - 1);
        sum += WEIGHTS[i + RADIUS] * texelFetch(source, ivec3(tap, texel.z), 0);
    }
    imageStore(target, texel, sum);
}
