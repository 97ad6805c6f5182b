// Writes one sample of every pixel and keeps the others. The source holds all samples, image beside image.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(set = 0, binding = 0) uniform sampler2D source;
layout(push_constant, scalar) uniform PushBlock {
    uint index;
    uint width; // pixels of one image
} which;
layout(location = 0) out vec4 color;

void main() {
    gl_SampleMask[0] = 1 << which.index;
    color = texelFetch(source, ivec2(gl_FragCoord.xy) + ivec2(which.index * which.width, 0), 0);
}
