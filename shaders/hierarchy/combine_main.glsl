// The one rule: sources are asked front to back, each gets only what those before it left, and the walk ends at 1.
// Replace, never add twice. Here: the screen, rays through the host's triangles, its probes, then the environment
// ("sky") for the rest.
#include "hierarchy/source_log.glsl"
#include "lib/camera.glsl"
#include "lib/sanitize.glsl"
#include "lib/surface.glsl"
#include "shared/rays_constants.h"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
}
frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform usampler2D surface;
layout(set = 0, binding = 3) uniform sampler2D radianceWeight;
layout(set = 0, binding = 4) uniform samplerCube environment;
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D reflected; // sum of weight * radiance; total weight
layout(set = 0, binding = 6, rgba8) uniform writeonly image2D weights;     // screen, sky, rays, probes
layout(set = 0, binding = 7) uniform sampler2D raysAnswer;
layout(set = 0, binding = 8) uniform usampler2D raysRecord;
layout(set = 0, binding = 9) uniform sampler2D probesAnswer;
layout(push_constant, scalar) uniform PushBlock {
    HierarchyConstants settings;
};

/// What is left of a weight of `wanted` after `taken`.
float takeRest(float wanted, float taken) {
    return clamp(min(wanted, 1.0 - taken), 0.0, 1.0);
}

vec3 environmentRadiance(vec3 directionVS, float perceptualRoughness) {
    vec3 directionWS = mat3(frame.constants.viewToWorld) * directionVS;
    vec3 direction = mat3(frame.constants.worldToEnvironment) * directionWS;
    float mip = perceptualRoughness * max(frame.constants.environmentMips - 1.0, 0.0);
    return sanitize(sanitize(textureLod(environment, direction, mip).rgb) * frame.constants.environmentStrength);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = texelFetch(viewZ, px, 0).r;
    vec3 sum = vec3(0.0);
    float total = 0.0;
    vec4 shares = vec4(0.0);
    if (z < kBackgroundZ) {
        bool replaced = settings.rays != 0u && (texelFetch(raysRecord, px, 0).z & kRaysReplaceScreen) != 0u;
        if (settings.screen != 0u && !replaced) {
            vec4 answer = texelFetch(radianceWeight, px, 0);
            shares.x = takeRest(answer.a, total);
            sum += shares.x * answer.rgb;
            logSource(px, kLoggedScreen, shares.x, answer.rgb);
            total += shares.x;
        }
        if (settings.rays != 0u && total < 1.0) {
            vec4 answer = texelFetch(raysAnswer, px, 0);
            shares.z = takeRest(answer.a, total);
            sum += shares.z * answer.rgb;
            logSource(px, kLoggedRays, shares.z, answer.rgb);
            total += shares.z;
        }
        if (settings.probes != 0u && total < 1.0) {
            vec4 answer = texelFetch(probesAnswer, px, 0);
            shares.w = takeRest(answer.a, total);
            sum += shares.w * answer.rgb;
            logSource(px, kLoggedProbes, shares.w, answer.rgb);
            total += shares.w;
        }
        if (settings.sky != 0u && (frame.constants.flags & kInputEnvironment) != 0u && total < 1.0) {
            Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
            vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
            vec3 toSurfaceVS = viewDirection(frame.constants, viewPosition(frame.constants, uv, z));
            shares.y = takeRest(1.0, total);
            vec3 radiance = environmentRadiance(reflect(toSurfaceVS, here.normalVS), here.perceptualRoughness);
            sum += shares.y * radiance;
            logSource(px, kLoggedSky, shares.y, radiance);
            total += shares.y;
        }
    }
    imageStore(reflected, px, vec4(sum, total));
    imageStore(weights, px, shares);
}
