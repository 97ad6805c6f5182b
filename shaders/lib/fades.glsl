// The weight of a hit, one factor for each reason. Each factor is 1 where its setting is off. Formulas are those of
// Babylon.js' SSRRenderingPipeline; the linear border is Unity HDRP's screen weight distance.
#ifndef GLINT_LIB_FADES_GLSL
#define GLINT_LIB_FADES_GLSL

/// Babylon.js' border fade: begins far inside the image and reaches 0 before the border's middle.
float fadeBorderSmooth(vec2 hitUV) {
    vec2 d = smoothstep(vec2(0.2), vec2(0.6), abs(vec2(0.5) - hitUV));
    return clamp(1.0 - (d.x + d.y), 0.0, 1.0);
}

/// 0 at the border, 1 from `width` (UV) inside, for each axis separately.
float fadeBorderLinear(vec2 hitUV, float width) {
    vec2 inside = clamp(min(hitUV, vec2(1.0) - hitUV) / max(width, 1e-6), 0.0, 1.0);
    return inside.x * inside.y;
}

float fadeDistance(float distance, float maxDistance) {
    return 1.0 - clamp(distance / maxDistance, 0.0, 1.0);
}

float fadeIterations(float iterations, float maxIterations) {
    return 1.0 - clamp(iterations / maxIterations, 0.0, 1.0);
}

/// `VoR` = dot(direction to the eye, reflected direction): rays that return to the eye see surfaces that the screen
/// does not show.
float fadeFacingCamera(float VoR) {
    return 1.0 - smoothstep(0.25, 0.5, VoR);
}

/// `NoR` = dot(normal at the hit, -ray direction): below 0 the ray hit the surface from behind.
float fadeBackface(float NoR) {
    return smoothstep(-0.17, 0.0, NoR);
}

/// 1 up to `start`, 0 from `end`, in perceptual roughness.
float fadeRoughness(float perceptualRoughness, float start, float end) {
    return end > start ? 1.0 - smoothstep(start, end, perceptualRoughness) : (perceptualRoughness <= end ? 1.0 : 0.0);
}

#endif
