// Copies an image drawn by a camera that looks along a face's axis to that face. Cube maps are left-handed and a
// camera's image is not, so the image is flipped horizontally. Alpha: 1 / metres to the visible surface, 0 for the sky.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/sanitize.glsl"
#include "shared/environment.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D picture;
layout(set = 0, binding = 2) uniform sampler2D depth;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2DArray cube;
layout(push_constant, scalar) uniform PushBlock {
    FaceConstants constants;
};

vec4 seen(ivec2 px) {
    vec2 through = (vec2(px) + 0.5) / vec2(textureSize(picture, 0)) * 2.0 - 1.0; // at viewZ 1: half a right angle
    float invViewZ = texelFetch(depth, px, 0).r / constants.near;
    return vec4(sanitize(texelFetch(picture, px, 0).rgb), sanitize(invViewZ / length(vec3(through, 1.0))));
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(cube).xy;
    if (any(greaterThanEqual(texel, size)))
        return;
    int samples = textureSize(picture, 0).x / size.x; // along a texel's side
    ivec2 first = ivec2(size.x - 1 - texel.x, texel.y) * samples;
    vec3 sum = vec3(0.0);
    float nearest = 0.0; // no mean: no surface lies half way between two surfaces
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) {
            vec4 here = seen(first + ivec2(x, y));
            sum += here.rgb;
            nearest = max(nearest, here.a);
        }
    imageStore(cube, ivec3(texel, constants.face), vec4(sum / float(samples * samples), nearest));
}
