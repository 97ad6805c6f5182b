// The least work of a screen-space effect: read each needed part of the G-buffer once, and write one image. Its time is
// the unit in which effects are measured (docs/truth.md, "Time").
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;
layout(set = 0, binding = 2) uniform sampler2D material;
layout(set = 0, binding = 3) uniform sampler2D litRadiance;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D result;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, imageSize(result))))
        return;
    // A sum, so that no read can be optimized away.
    vec4 sum = texelFetch(litRadiance, px, 0) + texelFetch(material, px, 0);
    sum.xy += texelFetch(normal, px, 0).xy;
    sum.z += texelFetch(depth, px, 0).r;
    imageStore(result, px, sum);
}
