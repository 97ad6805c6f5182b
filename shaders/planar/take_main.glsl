// Converts a host's image from behind a mirror to Glint's own: the world behind the mirror as if seen through it. Left
// and right are flipped back, depth becomes viewZ.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl" // of the mirrored view
#include "lib/camera.glsl"
#include "lib/host_surface.glsl"
#include "lib/math.glsl"
#include "lib/sanitize.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D hostRadiance;
#ifdef GLINT_DEPTH_SAMPLES
layout(set = 0, binding = 2) uniform sampler2DMS hostDepth;
#else
layout(set = 0, binding = 2) uniform sampler2D hostDepth;
#endif
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D radiance; // and what tells of its distance
layout(set = 0, binding = 4, r32f) uniform writeonly image2D viewZ;

/// The host's image may have another size. Fetch the nearest texel of depth, because a mean of depths is on no surface;
/// interpolate radiance linearly. The fourth channel is brightness over the metres from the eye: over the mean
/// brightness of a mip it tells how far what is bright is.
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
    const float kLargest = 6e4; // below the largest half
    vec3 color = sanitize(textureLod(hostRadiance, uv, 0.0).rgb);
    float nearness = z < kBackgroundZ ? 1.0 / max(length(viewPosition(frame.constants, uv, z)), 1e-3) : 0.0;
    imageStore(radiance, px, vec4(color, min(meanComponent(color) * nearness, kLargest)));
}
