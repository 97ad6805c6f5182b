// Rough reflections without noise: the answer of a mirror ray is the mean of the picture over the lobe's width at the
// hit, from smaller copies of the picture (trace/picture.comp). docs/techniques/cones.md
#ifndef GLINT_TRACE_CONE_GLSL
#define GLINT_TRACE_CONE_GLSL

#include "generate/lobe.glsl"
#include "shared/trace_constants.h"

/// Radiance, and 1 / viewZ of what shows it (0: the background). Level n covers 2^(n+1) pixels a side.
layout(set = 0, binding = 46) uniform sampler2D picture;

/// A mirror ray and the lobe around it.
struct LobeCone {
    float alpha; // 0: a line
    float NoV;
    vec3 upVS; // unit, at right angles to the ray, towards the surface's normal
};

/// A line for mirrors, and where rays sample the lobe instead.
LobeCone makeCone(vec3 directionVS, vec3 normalVS, float perceptualRoughness) {
    bool blurs = (frame.settings.trace.flags & kTraceCones) != 0u && !isMirror(perceptualRoughness);
    float NoV = clamp(dot(directionVS, normalVS), 0.0, 1.0);
    return LobeCone(blurs ? lobeTangent(perceptualRoughness) : 0.0, NoV,
                normalizeOr(normalVS - NoV * directionVS, vec3(0.0)));
}

/// Half of the lobe lies within so many pixels of a hit at `hitVS`, along `upVS`; the ray is `metres` long.
float coneRadius(LobeCone cone, vec3 hitVS, float metres) {
    return 2.0 * cone.alpha * metres / pixelExtent(frame.constants, frame.constants.uvToView, -hitVS.z).y;
}

/// Share of the blurred picture in the answer: a cone narrower than a pixel is the pixel.
float blurredShare(float radiusPX) {
    return smoothstep(0.25, 1.25, radiusPX);
}

/// Facets along the plane of incidence, in units of alpha: the middles of five equal parts of GGX, whose slopes in one
/// direction lie below x with a probability of (1 + x / sqrt(1 + x^2)) / 2.
const int kConeTaps = 5;
const float kFacets[kConeTaps] = float[kConeTaps](0.0, 0.4364, -0.4364, 1.3333, -1.3333);

/// The picture shows what lies beside a hit on screen, which need not be what the lobe meets beside it: a thing in front,
/// seen from the eye's side. What lies farther off the ray than the lobe's width and this counts little; radians.
const float kBeside = 0.2;
const float kLeastShare = 0.001;

/// Where such things are most of what there is, smooth surfaces take the pixel itself. Rough ones, whose answer cannot
/// be a sharp picture, take what there is. Between these values of alpha a mixture.
const float kSmoothAlpha = 0.09;
const float kRoughAlpha = 0.25;

/// Mean radiance of the picture over the lobe at a hit, and its share in the answer. Each of the facets sends its part
/// of the lobe to a place of its own on a line through the hit. At a grazing angle more is seen of facets that tilt
/// towards the eye, and those that reflect below the surface do not count. Across that line a part is as wide as its
/// facets scatter there: in units of alpha their slopes have a variance of 1 + x^2, and count by how much of them is
/// seen. `shift`: from pixels of this frame to those of the picture.
vec4 coneRadiance(LobeCone cone, vec3 originVS, vec3 hitVS, vec2 shift) {
    vec2 size = vec2(textureSize(picture, 0));
    float metres = distance(hitVS, originVS);
    vec3 directionVS = (hitVS - originVS) / metres;
    float radius = coneRadius(cone, hitVS, metres);
    vec2 tiles = ceil(frame.constants.size / float(kPictureTile)); // the image may be larger
    vec2 texels = tiles * (0.5 * float(kPictureTile));
    vec4 hitH = frame.constants.viewToPixel * vec4(hitVS, 1.0);
    vec4 upH = frame.constants.viewToPixel * vec4(cone.upVS * metres, 0.0);
    float sine = sqrt(1.0 - square(cone.NoV));
    vec4 sum = vec4(0.0);
    float whole = 0.0;
    for (int i = 0; i < kConeTaps; ++i) {
        float slope = cone.alpha * kFacets[i] * sine; // straight from above the width across is all
        float visible = cone.NoV + slope * sine;      // of the facet, relative to 1 for one that faces the eye
        float along = 2.0 * slope / (1.0 - square(slope));
        vec4 atH = hitH + along * upH;
        if (visible <= 0.0 || cone.NoV + along * sine <= 0.0 || atH.w <= 0.0)
            continue;
        vec2 px = atH.xy / atH.w;
        // Between texels the picture is blurred by half a texel.
        float across = radius * visible * sqrt(1.0 + square(kFacets[i]));
        float lod = clamp(log2(max(across, 1.0)), 0.0, float(kPictureLevels - 1u));
        vec2 at = min(0.5 * (px + shift), texels - 0.5 * exp2(ceil(lod)));
        vec4 shown = textureLod(picture, at / size, lod);
        vec3 shownVS = viewPosition(frame.constants, px * frame.constants.invSize, 1.0 / max(shown.a, 1e-6));
        float off = 2.0 * (1.0 - dot(normalize(shownVS - originVS), directionVS)); // square of the angle
        float weight = visible * mix(1.0, kLeastShare, smoothstep(1.0, 4.0, off / square(kBeside + 2.0 * cone.alpha)));
        whole += visible;
        sum += weight * vec4(shown.rgb, 1.0);
    }
    float known = sum.a / max(whole, 1e-6);
    float share = mix(known, float(whole > 0.0), smoothstep(kSmoothAlpha, kRoughAlpha, cone.alpha));
    return vec4(sum.rgb / max(sum.a, 1e-6), share);
}

#endif
