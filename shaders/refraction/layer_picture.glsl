// The light that the frame shows at the end of a layer's ray, blurred over the lobe and over the pixel's footprint.
#ifndef GLINT_REFRACTION_LAYER_PICTURE_GLSL
#define GLINT_REFRACTION_LAYER_PICTURE_GLSL

#include "lib/blurred_picture.glsl"
#include "refraction/leaving_ray.glsl"

/// Taps along the longer axis of a footprint.
const float kMostTaps = 8.0;

/// Distance in pixels of the frame between the ends of this pixel's ray and the next one's, both `distance` metres
/// long.
vec2 footprintPX(Leaving ray, RayDifferential d, float distance) {
    vec3 hitVS = ray.originVS + ray.directionVS * distance;
    vec3 nextVS = hitVS + d.origin + d.direction * distance;
    vec4 hitH = frame.constants.viewToPixel * vec4(hitVS, 1.0);
    vec4 nextH = frame.constants.viewToPixel * vec4(nextVS, 1.0);
    if (hitH.w <= 0.0 || nextH.w <= 0.0)
        return vec2(0.0);
    vec2 way = nextH.xy / nextH.w - hitH.xy / hitH.w;
    float most = 0.25 * min(frame.constants.size.x, frame.constants.size.y);
    return way * min(1.0, most / max(length(way), 1e-6));
}

/// Roughness with which to sample a distant environment: covers the lobe and the pixel's footprint together. A GGX lobe
/// spreads directions by twice alpha, a footprint by half its angle.
float distantRoughness(Leaving ray) {
    float angle = 0.5 * (length(ray.dx.direction) + length(ray.dy.direction));
    return sqrt(min(length(vec2(square(ray.roughness), angle / 4.0)), 1.0));
}

/// Radiance of the frame at `uv`, which shows the surface `distance` metres along the ray at `hitZ`. A transparent
/// surface there is assumed to be in the ray's path if it is farther from the eye than the ray's start. Otherwise it is
/// the body itself, or a surface beside it.
vec3 pictureRadiance(Leaving ray, vec2 uv, float distance, float hitZ) {
    // The lobe is a cone about as wide as that of normals; for far surfaces it covers a constant angle.
    float lobe = square(ray.roughness) * (distance + ray.travelled);
    float pixel = pixelExtent(frame.constants, frame.constants.uvToView, hitZ).y;
    ivec2 px = min(ivec2(uv * frame.constants.size), ivec2(frame.constants.size) - 1);
    float otherZ = texelFetch(layersZ, px, 0).r;
    bool through = otherZ < kBackgroundZ && otherZ > -ray.originVS.z;
    // A curved surface shrinks its refracted image: the pixel's footprint in the frame is an ellipse, longer than a
    // pixel. Taps along its longer axis, each blurred as far as the next one.
    vec2 along = footprintPX(ray, ray.dx, distance);
    vec2 across = footprintPX(ray, ray.dy, distance);
    if (dot(across, across) > dot(along, along)) {
        vec2 shorter = along;
        along = across;
        across = shorter;
    }
    float taps = clamp(ceil(length(along) / max(length(across), 1.0)), 1.0, kMostTaps);
    float tapPX = max(length(across), length(along) / taps);
    // A pixel is a box, of standard deviation 1 / sqrt(12); the frame contains one such box already.
    float radius = sqrt(square(lobe / pixel) + max(square(tapPX) - 1.0, 0.0) / 12.0);
    vec3 stored = vec3(0.0);
    for (float tap = 0.5; tap < taps; tap += 1.0) {
        vec2 at = uv + along * ((tap / taps - 0.5) * frame.constants.invSize);
        stored += through ? blurredPicture(behind, at, radius) : blurredPicture(solid, at, radius);
    }
    return linearColor(stored / taps, (frame.constants.flags & kOutputGamma) != 0u);
}

#endif
