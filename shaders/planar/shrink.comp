// The next mip of a mirror's image, by a tent two texels to each side: (1 3 3 1) / 8 along each axis where the size is
// even. The tent keeps single bright pixels from becoming squares, as a plain mean of four would make them. Radiance is
// averaged by its weight (a); the weight is averaged unweighted.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba16f) uniform image2D finer; // only read
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2D coarser;

/// `along`: offset of a texel's centre from the tent's centre, in texels.
float tent(float along) {
    return max(2.0 - abs(along), 0.0);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(coarser);
    if (any(greaterThanEqual(px, size)))
        return;
    ivec2 finerSize = imageSize(finer);
    vec2 center = (vec2(px) + 0.5) * vec2(finerSize) / vec2(size);
    ivec2 first = ivec2(floor(center - 1.5));
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    float total = 0.0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            ivec2 texel = first + ivec2(x, y);
            vec2 along = vec2(texel) + 0.5 - center;
            float share = tent(along.x) * tent(along.y);
            vec4 color = imageLoad(finer, clamp(texel, ivec2(0), finerSize - 1));
            sum += share * color.a * color.rgb;
            weights += share * color.a;
            total += share;
        }
    imageStore(coarser, px, vec4(sum / max(weights, 1e-6), weights / total));
}
