// Writes the opacity of a frame's opaque surfaces to the alpha of its image, before blended surfaces add theirs.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D albedo; // alpha: fraction of the pixel that surfaces cover
layout(set = 0, binding = 1, rgba16f) uniform image2D picture;
layout(push_constant, scalar) uniform PushBlock {
    uvec2 size;
};

void main() {
    uvec2 px = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(px, size)))
        return;
    vec3 radiance = imageLoad(picture, ivec2(px)).rgb;
    imageStore(picture, ivec2(px), vec4(radiance, texelFetch(albedo, ivec2(px), 0).a));
}
