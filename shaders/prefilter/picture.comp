// Copies a picture to level 0 of an image with mips.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D picture;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2D copy;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(px, imageSize(copy))))
        imageStore(copy, px, texelFetch(picture, px, 0));
}
