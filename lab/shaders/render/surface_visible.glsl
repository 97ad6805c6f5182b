// The common part of every opaque pass: the visible part of a surface, and its motion.
#ifndef GLINT_RENDER_SURFACE_VISIBLE_GLSL
#define GLINT_RENDER_SURFACE_VISIBLE_GLSL

#include "render/surface_bindings.glsl"

/// A discard in the code disables early depth tests, so fully opaque surfaces are drawn without one.
layout(constant_id = 0) const bool kAlphaTest = false;

/// Ends the invocation where the material has a hole.
MaterialSample visibleSurface(SurfacePoint point) {
    Material material = drawnMaterial();
    if (kAlphaTest && sampleBaseColor(material, point).a < material.alphaCutoff)
        discard;
    return sampleMaterial(material, point);
}

vec2 clipToUV(vec4 positionCS) {
    return positionCS.xy / positionCS.w * vec2(0.5, -0.5) + 0.5;
}

/// Previous UV - current UV, without jitter; previous viewZ - current viewZ, metres.
vec4 motion() {
    vec2 now = clipToUV(currentCS) - view.constants.jitterUV;
    vec2 before = clipToUV(previousCS) - view.constants.prevJitterUV;
    return vec4(before - now, depthMotion, 0.0);
}

#endif
