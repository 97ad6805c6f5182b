// Copies the host's cube, at the requested size, to mip 0 of a filtered cube and of the cube that the other mips are
// filtered from. Removes NaN and infinities, which would spread over a whole lobe.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "lib/environment.glsl"
#include "lib/sanitize.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform samplerCube cube;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2DArray source;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2DArray filtered;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int size = imageSize(source).x;
    if (texel.x >= size || texel.y >= size)
        return;
    vec2 p = (vec2(texel.xy) + 0.5) / float(size) * 2.0 - 1.0;
    vec4 color = textureLod(cube, cubeDirection(uint(texel.z), p), 0.0);
    color = vec4(sanitize(color.rgb), sanitize(color.a));
    imageStore(source, texel, color);
    imageStore(filtered, texel, color);
}
