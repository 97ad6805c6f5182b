// Reads and writes one storage image.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba32f) uniform image2D sum;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(px, imageSize(sum))))
        imageStore(sum, px, imageLoad(sum, px) * 2.0 + 1.0);
}
