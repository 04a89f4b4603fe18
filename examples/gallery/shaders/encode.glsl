// Turns the depth map into what the technique stores.
layout(local_size_x = 16, local_size_y = 16) in;
layout(set = 0, binding = 3, STORAGE_FORMAT) uniform writeonly image2DArray target;

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel.xy, textureSize(source, 0).xy)))
        return;
    float depth = texelFetch(source, ivec3(texel.xy, 0), 0).r;
    imageStore(target, texel, encode(depth, texel.z));
}
