// Turns a fraction of the surfaces' pixels into mirrors and makes the rest reflect nothing, for timing an effect
// against the fraction of the frame that reflects. Whole tiles, as objects in a frame are, spread evenly over it.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(set = 0, binding = 0) uniform sampler2D depth; // 0: background
layout(push_constant, scalar) uniform PushBlock {
    float share;   // [0, 1]
    uint tileSize; // pixels
};

layout(location = 0) out vec4 outMaterial; // F0, perceptual roughness

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    // Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences": the R2 lattice; any fraction of its
    // values is spread evenly.
    vec2 tile = vec2(px / int(tileSize));
    float value = fract(dot(tile, vec2(0.7548776662, 0.5698402910)) + 0.5 / 256.0);
    bool mirror = texelFetch(depth, px, 0).r > 0.0 && value < share;
    outMaterial = mirror ? vec4(0.9, 0.9, 0.9, 0.0) : vec4(0.0);
}
