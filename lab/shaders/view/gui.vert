// Places a vertex of the viewer's panels: pixels from the top left -> clip space.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shared/gui.h"

layout(scalar, set = 0, binding = 0) readonly buffer VertexBlock {
    GuiVertex list[];
} vertices;
layout(push_constant, scalar) uniform PushBlock {
    GuiConstants constants;
};

layout(location = 0) out vec2 uv;
layout(location = 1) out vec4 color;

void main() {
    GuiVertex vertex = vertices.list[gl_VertexIndex];
    uv = vertex.uv;
    color = unpackUnorm4x8(vertex.color);
    vec2 clip = (vertex.positionPX - constants.originPX) * constants.scale - 1.0;
    gl_Position = vec4(clip.x, -clip.y, 0.0, 1.0); // our viewports have +Y up
}
