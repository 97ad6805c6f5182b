// A picture drawn by a camera that looks along a face's axis, onto that face. Cube maps are left-handed and a camera's
// picture is not, so it is turned left to right.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/sanitize.glsl"
#include "shared/environment.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D picture;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2DArray cube;
layout(push_constant, scalar) uniform PushBlock {
    FaceConstants constants;
};

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(cube).xy;
    if (any(greaterThanEqual(texel, size)))
        return;
    int samples = textureSize(picture, 0).x / size.x; // along a texel's side
    ivec2 first = ivec2(size.x - 1 - texel.x, texel.y) * samples;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x)
            sum += sanitize(texelFetch(picture, first + ivec2(x, y), 0).rgb);
    imageStore(cube, ivec3(texel, constants.face), vec4(sum / float(samples * samples), 1.0));
}
