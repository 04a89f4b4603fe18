// Meshes seen from the eye or from the light; corners in world space.
out vec3 world;
out vec3 facing;
out vec3 tint;
out vec2 coord;

void main()
{
    vec4 placed = modelMatrix * vec4(position, 1.0);
    world = placed.xyz;
    facing = mat3(modelMatrix) * normal;
    tint = color;
    coord = uv;
    gl_Position = projectionMatrix * viewMatrix * placed;
}
