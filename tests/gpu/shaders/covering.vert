// One triangle over the whole image.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(scalar, set = 0, binding = 0) uniform ScaleBlock {
    vec4 factor;
} scale;

void main() {
    vec2 corner = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner * scale.factor.x, 0.5, 1.0);
}
