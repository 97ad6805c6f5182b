// Puts the reflections into the host's picture: what they replace is taken out, never added to.
//   physical  out = lit - w * fallbackSpecular + R, with R the reflected radiance under the material's specular response
//   lerp      out = lit * (1 - m) + reflection * m, Babylon.js' model; what no source answered is the pixel's own colour
// docs/techniques/composite.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/brdf.glsl"
#include "lib/camera.glsl"
#include "lib/environment.glsl"
#include "lib/input_color.glsl"
#include "lib/outcome_color.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform usampler2D surface;
layout(set = 0, binding = 3) uniform sampler2D material;
layout(set = 0, binding = 4) uniform sampler2D litRadiance;
layout(set = 0, binding = 5) uniform sampler2D fallbackSpecular;
layout(set = 0, binding = 6) uniform sampler2D reflected;
layout(set = 0, binding = 7) uniform usampler2D rayRecord;
layout(set = 0, binding = 8) uniform sampler2D dfg;
layout(set = 0, binding = 9, rgba16f) uniform writeonly image2D composite;
layout(push_constant, scalar) uniform PushBlock {
    CompositeConstants settings;
};

/// Reflectance under the user's hand: strength first, then the exponent over both.
vec3 falloff(vec3 reflectance) {
    vec3 response = reflectance * settings.strength;
    return settings.falloffExponent == 1.0 ? response : pow(response, vec3(settings.falloffExponent));
}

/// The share of reflected light that this surface sends to the eye.
vec3 physicalResponse(vec3 f0, float perceptualRoughness, float NoV) {
    return settings.fresnel != 0u ? specularResponse(f0, 1.0, textureLod(dfg, dfgUV(vec2(NoV, perceptualRoughness), textureSize(dfg, 0).x), 0.0).rg) : f0;
}

vec3 physical(vec3 lit, vec3 fallback, vec4 reflection, vec3 f0, float perceptualRoughness, float NoV) {
    vec3 response = falloff(physicalResponse(f0, perceptualRoughness, NoV));
    return lit - reflection.a * fallback + reflection.rgb * response;
}

vec3 lerped(vec3 lit, vec4 reflection, vec3 f0, float NoV) {
    vec3 fresnel = F_Schlick(f0, 1.0, NoV);
    vec3 m = clamp(falloff(settings.fresnel != 0u ? fresnel : f0), 0.0, 1.0);
    vec3 color = reflection.rgb;
    if (settings.fresnel == 0u) // as Babylon.js: without it in the factor, the colour itself takes the Fresnel term
        color *= fresnel;
    color = clamp(color, 0.0, 1000.0) + (1.0 - reflection.a) * lit;
    return lit * (1.0 - m) + color * m;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    bool fromGamma = (frame.constants.flags & kInputGamma) != 0u;
    bool toGamma = (frame.constants.flags & kOutputGamma) != 0u;
    vec4 stored = texelFetch(litRadiance, px, 0);
    vec3 lit = linearColor(stored.rgb, fromGamma);
    float z = texelFetch(viewZ, px, 0).r;
    vec3 result = lit;
    bool untouched = true; // where nothing is reflected, the host's own bits
    vec4 reflection = texelFetch(reflected, px, 0);
    if (z < kBackgroundZ && reflection.a > 0.0) {
        Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
        vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
        vec3 toSurfaceVS = viewDirection(frame.constants, viewPosition(frame.constants, uv, z));
        float NoV = clamp(dot(here.normalVS, -toSurfaceVS), 0.0, 1.0);
        vec3 f0 = clamp(sanitize(texelFetch(material, px, 0).rgb), 0.0, 1.0);
        if (here.reflectivity > 0.0) {
            if (settings.model == 0u) {
                bool hasFallback = (frame.constants.flags & kInputFallback) != 0u;
                vec3 fallback = vec3(0.0);
                if (hasFallback)
                    fallback = linearColor(texelFetch(fallbackSpecular, px, 0).rgb, fromGamma);
                result = physical(lit, fallback, reflection, f0, here.perceptualRoughness, NoV);
            } else {
                result = lerped(lit, reflection, f0, NoV);
            }
            result = sanitize(result); // two large halves make an infinite one
            untouched = false;
        }
    }
    if (settings.debugOutcome != 0u && z < kBackgroundZ) {
        ivec2 tracePX = fullToTracePixel(frame.constants, px);
        RayRecord ray = unpackRayRecord(texelFetch(rayRecord, tracePX, 0).xy);
        if (ray.outcome != kOutcomeNone) {
            result = outcomeColor(ray, settings.maxSteps);
            untouched = false;
        }
    }
    if (untouched && fromGamma == toGamma)
        result = stored.rgb;
    else if (toGamma)
        result = encodeSrgb(result);
    imageStore(composite, px, vec4(result, stored.a));
}
