// Shows an image that a pass wrote: unscaled values in full precision, the nearest texel where its size is another.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 8, local_size_y = 8) in;

#ifdef GLINT_INTEGERS
layout(set = 0, binding = 0) uniform usampler2D shown;
#else
layout(set = 0, binding = 0) uniform sampler2D shown;
#endif
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D view;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(view);
    if (any(greaterThanEqual(px, size)))
        return;
    ivec2 texel = ivec2((vec2(px) + 0.5) * vec2(textureSize(shown, 0)) / vec2(size));
    imageStore(view, px, vec4(texelFetch(shown, texel, 0)));
}
