// Converts the host's G-buffer into Glint's own conventions, once: every later pass reads viewZ in metres and one
// packed surface. include/glint/gbuffer.hpp lists what a host may state.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/camera.glsl"
#include "lib/sanitize.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2D depth;
layout(set = 0, binding = 2) uniform sampler2D normal;
layout(set = 0, binding = 3) uniform sampler2D material;
layout(set = 0, binding = 4, r32f) uniform writeonly image2D viewZ;
layout(set = 0, binding = 5, rg32ui) uniform writeonly uimage2D surface;

vec3 loadNormalVS(ivec2 px) {
    uint flags = frame.constants.flags;
    vec3 stored = texelFetch(normal, px, 0).xyz;
    if ((flags & kInputNormalUnorm) != 0u)
        stored = stored * 2.0 - 1.0;
    vec3 decoded = (flags & kInputNormalOctahedral) != 0u ? decodeOctahedral(stored.xy) : stored;
    if ((flags & kInputNormalView) != 0u) {
        if ((flags & kInputLeftHanded) != 0u)
            decoded.z = -decoded.z;
    } else {
        decoded = mat3(frame.constants.worldToView) * decoded;
    }
    // A cleared or broken normal faces the camera: it reflects nothing odd and spreads no NaN.
    float squaredLength = dot(decoded, decoded);
    return squaredLength > 1e-12 && squaredLength < 1e12 ? decoded * inversesqrt(squaredLength) : vec3(0.0, 0.0, 1.0);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;

    float z = viewZFromDepth(frame.constants, texelFetch(depth, px, 0).r);
    vec4 stored = texelFetch(material, px, 0);
    float perceptualRoughness = stored[frame.constants.roughnessChannel];
    if ((frame.constants.flags & kInputSmoothness) != 0u)
        perceptualRoughness = 1.0 - perceptualRoughness;
    vec3 f0 = sanitize(stored.rgb);

    Surface result;
    result.normalVS = loadNormalVS(px);
    result.perceptualRoughness = clamp(sanitize(perceptualRoughness), 0.0, 1.0);
    result.reflectivity = clamp(max(f0.r, max(f0.g, f0.b)), 0.0, 1.0);
    imageStore(viewZ, px, vec4(z > 0.0 ? z : kBackgroundZ)); // a NaN depth is background too
    imageStore(surface, px, uvec4(packSurface(result), 0u, 0u));
}
