// A filter that takes three quarters of the light (seams_test.cpp).
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D signal;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2D filtered;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, imageSize(filtered))))
        return;
    vec4 value = texelFetch(signal, px, 0);
    imageStore(filtered, px, vec4(value.rgb * 0.25, value.a));
}
