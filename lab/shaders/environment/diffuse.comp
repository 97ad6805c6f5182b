// Irradiance / pi for each direction: the cosine-weighted mean of the environment, summed exactly over the texels of a
// small mip of the source, each with its solid angle. No series expansion, so no ringing around a bright sun.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "lib/environment.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform samplerCube source;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2DArray diffuse;

const int kSourceSize = 32; // summed texels along a face's side; the cosine is smooth on their scale

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    uint size = uint(imageSize(diffuse).x);
    if (texel.x >= size || texel.y >= size)
        return;
    vec3 N = normalize(cubeDirection(texel.z, (vec2(texel.xy) + 0.5) / float(size) * 2.0 - 1.0));
    float mip = max(log2(float(textureSize(source, 0).x) / float(kSourceSize)), 0.0);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint face = 0u; face < 6u; ++face)
        for (int y = 0; y < kSourceSize; ++y)
            for (int x = 0; x < kSourceSize; ++x) {
                vec3 direction = cubeDirection(face, (vec2(x, y) + 0.5) / float(kSourceSize) * 2.0 - 1.0);
                float length2 = dot(direction, direction);
                float NoL = dot(N, direction) * inversesqrt(length2);
                if (NoL <= 0.0)
                    continue;
                float weight = NoL / (length2 * sqrt(length2)); // solid angle of a face's texel: area / distance^3
                sum += textureLod(source, direction, mip).rgb * weight;
                weights += weight;
            }
    imageStore(diffuse, ivec3(texel), vec4(sum / weights, 1.0));
}
