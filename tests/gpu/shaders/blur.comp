// Reads a sampled image and writes a storage image, scaled by a uniform: every kind of binding other than a buffer's.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform ScaleBlock {
    vec4 factor;
} scale;
layout(set = 0, binding = 1) uniform sampler2D source;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D result;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(px, imageSize(result))))
        imageStore(result, px, texelFetch(source, px, 0) * scale.factor);
}
