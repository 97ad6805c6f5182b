// A source of one colour (seams_test.cpp): answers for half of what it could.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba16f) uniform writeonly image2D answer;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(px, imageSize(answer))))
        imageStore(answer, px, vec4(2.0, 1.0, 0.5, 0.5));
}
