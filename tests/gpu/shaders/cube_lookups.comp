// Samples a cube map in a list of directions, one for each thread.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(set = 0, binding = 0) uniform samplerCube cube;
layout(scalar, set = 0, binding = 1) readonly buffer DirectionsBlock {
    vec3 value[];
} directions;
layout(scalar, set = 0, binding = 2) writeonly buffer FoundBlock {
    vec4 value[];
} found;

void main() {
    found.value[gl_GlobalInvocationID.x] = textureLod(cube, directions.value[gl_GlobalInvocationID.x], 0.0);
}
