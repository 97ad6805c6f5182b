// Counts the samples in which a transparent surface is visible.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "render/transparent_present.glsl"

layout(location = 0) out float outCovered;

void main() {
    if (!isTransparentPresent())
        discard;
    outCovered = 1.0;
}
