// Converts an equirectangular image to the faces of a cube, four samples a texel.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "lib/environment.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D equirect;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2DArray cube;

vec3 radianceFrom(vec3 direction) {
    vec2 uv = equirectangularUV(direction);
    // The image wraps around horizontally, but its poles must not blend: stay half a texel inside.
    float margin = 0.5 / float(textureSize(equirect, 0).y);
    return textureLod(equirect, vec2(uv.x, clamp(uv.y, margin, 1.0 - margin)), 0.0).rgb;
}

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    uint size = uint(imageSize(cube).x);
    if (texel.x >= size || texel.y >= size)
        return;
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < 4u; ++i) {
        vec2 p = (vec2(texel.xy) + 0.25 + 0.5 * vec2(i & 1u, i >> 1u)) / float(size) * 2.0 - 1.0;
        sum += radianceFrom(normalize(cubeDirection(texel.z, p)));
    }
    imageStore(cube, ivec3(texel), vec4(min(sum * 0.25, vec3(65000.0)), 1.0)); // half floats end at 65504
}
