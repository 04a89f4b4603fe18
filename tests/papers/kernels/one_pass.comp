#version 450
// A blur of REACH texels to each side in one pass, by all of its texels: what a separable one is compared with.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray source;
layout(binding = 1, rgba32f) uniform writeonly image2DArray target;
layout(binding = 2) readonly buffer Weights
{
    float weights[2 * REACH + 1];
};

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 size = vec2(textureSize(source, 0).xy);
    vec4 sum = vec4(0.0);
    for (int y = -REACH; y <= REACH; ++y)
    {
        for (int x = -REACH; x <= REACH; ++x)
        {
            sum += weights[x + REACH] * weights[y + REACH] * textureLod(source, vec3((vec2(texel + ivec2(x, y)) + 0.5) / size, 0.0), 0.0);
        }
    }
    imageStore(target, ivec3(texel, 0), sum);
}
