// Converts a host's image from behind a mirror to Glint's own: the world behind the mirror as if seen through it. Left
// and right are flipped back, depth becomes viewZ.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl" // of the mirrored view
#include "lib/host_surface.glsl"
#include "lib/sanitize.glsl"
#include "shared/planar.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D hostRadiance;
#ifdef GLINT_DEPTH_SAMPLES
layout(set = 0, binding = 2) uniform sampler2DMS hostDepth;
#else
layout(set = 0, binding = 2) uniform sampler2D hostDepth;
#endif
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D radiance; // radiance and its weight
layout(set = 0, binding = 4, r32f) uniform writeonly image2D viewZ;

layout(push_constant, scalar) uniform PushBlock {
    PlanarTakeConstants settings;
};

/// Weight of a texel where many are averaged. A rough surface sees close geometry at wide angles, so that little of it
/// falls into the lobe beyond the closest part. In the image, drawn from the eye, close geometry lies no wider than
/// distant geometry. With s, the part of the path from the eye that comes after the mirror, the angle of the half
/// vector grows by 1/s, and GGX' density of half vectors falls with up to the fourth power of that angle, at the lobe's
/// middle not at all. The square, 2 / (1 + 1/s^2), lies between.
float weightOf(vec2 uv, float z) {
    const float kLeast = 1.0e-3;
    if (z >= kBackgroundZ || isOrthographic(frame.constants))
        return 1.0;
    float beyond = dot(settings.planeVS.xyz, viewPosition(frame.constants, uv, z)) + settings.planeVS.w;
    float part = clamp(beyond / max(beyond - settings.planeVS.w, 1e-9), 1e-3, 1.0);
    float lean2 = 1.0 / (part * part);
    return max(2.0 / (1.0 + lean2), kLeast);
}

/// The host's image may have another size. Fetch the nearest texel of depth, because a mean of depths is on no surface;
/// interpolate radiance linearly.
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
