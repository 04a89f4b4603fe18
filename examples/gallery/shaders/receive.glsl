// Evaluates the technique for every pixel of the camera's picture.
layout(local_size_x = 16, local_size_y = 16) in;
layout(set = 0, binding = 3) uniform sampler2DArray positions;
layout(set = 0, binding = 4, rg32f) uniform writeonly image2DArray target;

void main()
{
    ivec3 pixel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(pixel.xy, textureSize(positions, 0).xy)))
        return;
    vec4 surface = texelFetch(positions, pixel, 0);
    vec3 coord = shadowMapCoord(surface.xyz);
    bool covered = surface.w > 0.0 && coord.z > 0.0;
    vec2 result = covered ? receive(coord.xy, lightDepth(surface.xyz)) : vec2(1.0, -1.0);
    imageStore(target, pixel, vec4(result, 0.0, 0.0));
}
