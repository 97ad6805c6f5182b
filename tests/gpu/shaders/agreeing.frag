// Shares its vertex stage's binding, and reads an image.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(scalar, set = 0, binding = 0) uniform ScaleBlock {
    vec4 factor;
} scale;
layout(set = 0, binding = 1) uniform sampler2D source;
layout(location = 0) out vec4 color;

void main() {
    color = texelFetch(source, ivec2(gl_FragCoord.xy), 0) * scale.factor.y;
}
