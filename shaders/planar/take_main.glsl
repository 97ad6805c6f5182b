// A host's picture from behind a mirror -> Glint's own: the world behind the mirror as it would be seen through it. Left
// and right are exchanged back, depth becomes viewZ. Include after `hostDepth`.
#include "lib/host_surface.glsl"
#include "lib/sanitize.glsl"
#include "shared/planar.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants; // of the mirrored view
}
frame;
layout(set = 0, binding = 1) uniform sampler2D hostRadiance;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D radiance; // and its weight
layout(set = 0, binding = 4, r32f) uniform writeonly image2D viewZ;

layout(push_constant, scalar) uniform PushBlock {
    PlanarTakeConstants settings;
};

/// How much a texel counts where many are read together. A rough surface sees what is close to it at wide angles, so
/// that little of it falls into its lobe but right there; in the picture, which is the eye's, it lies no wider than what
/// is far behind it. With s, the part of the way from the eye that comes after the mirror, its lean grows by 1/s, and
/// GGX' density of half vectors falls with up to the fourth power of that, at the lobe's middle not at all. The square,
/// 2 / (1 + 1/s^2), stands between.
float weightOf(vec2 uv, float z) {
    const float kLeast = 1.0e-3;
    if (z >= kBackgroundZ || isOrthographic(frame.constants))
        return 1.0;
    float beyond = dot(settings.planeVS.xyz, viewPosition(frame.constants, uv, z)) + settings.planeVS.w;
    float part = clamp(beyond / max(beyond - settings.planeVS.w, 1e-9), 1e-3, 1.0);
    float lean2 = 1.0 / (part * part);
    return max(2.0 / (1.0 + lean2), kLeast);
}

/// The host's picture may have another size: the nearest texel of depth, whose mean is no surface's, and linearly
/// between those of radiance.
void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(viewZ);
    if (any(greaterThanEqual(px, size)))
        return;
    vec2 uv = (vec2(size.x - 1 - px.x, px.y) + 0.5) / vec2(size);
    ivec2 hostSize = textureSize(hostRadiance, 0);
    ivec2 hostPx = clamp(ivec2(uv * vec2(hostSize)), ivec2(0), hostSize - 1);
    float z = hostViewZ(frame.constants, texelFetch(hostDepth, hostPx, 0).r);
    imageStore(viewZ, px, vec4(z));
    imageStore(radiance, px, vec4(sanitize(textureLod(hostRadiance, uv, 0.0).rgb), weightOf(uv, z)));
}
