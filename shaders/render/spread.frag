// A picture with one sample a pixel into all samples of another.
#version 460

layout(set = 0, binding = 0) uniform sampler2D radiance;

layout(location = 0) out vec4 outRadiance;

void main() {
    outRadiance = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0);
}
