// Colours the viewer's panels. Colours are display-encoded and blended as such, as Dear ImGui expects.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shared/gui.h"

layout(set = 1, binding = 0) uniform sampler2D textures[];
layout(push_constant, scalar) uniform PushBlock {
    GuiConstants constants;
};

layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 color;
layout(location = 0) out vec4 blended;

void main() {
    vec4 straight = color * textureLod(textures[constants.texture], uv, 0.0);
    blended = vec4(straight.rgb * straight.a, straight.a);
}
