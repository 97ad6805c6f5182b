// Copies an image with one sample a pixel to all samples of another image.
#version 460

layout(set = 0, binding = 0) uniform sampler2D radiance;

layout(location = 0) out vec4 outRadiance;

void main() {
    outRadiance = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0);
}
