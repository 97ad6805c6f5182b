// Shadow maps: where to sample them, and the offset from the surface that prevents self-shadowing.
#ifndef GLINT_LIB_SHADOW_GLSL
#define GLINT_LIB_SHADOW_GLSL

#include "lib/math.glsl"
#include "shared/light.h"

/// Half the width of the soft edge, in texels; the filter below reads this far.
const float kShadowFilterRadius = 2.0;

struct ShadowLookup {
    vec2 uv;      // in the atlas
    float depth;  // reversed: larger is nearer to the light
    vec2 uvMin;   // the light's own tile: filters must not reach into a neighbour's
    vec2 uvMax;
    bool covered; // false: outside the map, and lit
};

/// Offsets the point from its surface along the normal by about the filter's footprint, more at grazing light: Holbert
/// 2011, "Saying Goodbye to Shadow Acne", GDC. Unlike a depth bias the offset does not detach contact shadows.
ShadowLookup shadowLookup(Light light, vec3 positionWS, vec3 normalWS, vec3 L, vec2 atlasTexel) {
    float NoL = saturate(dot(normalWS, L));
    float texelSize = light.shadowTexelSize;
    if (light.type != kLightDirectional)
        texelSize *= distance(positionWS, light.positionWS);
    float offset = texelSize * (kShadowFilterRadius + 0.5) * sqrt(1.0 - NoL * NoL) + texelSize * 0.5;
    vec4 p = light.worldToShadow * vec4(positionWS + normalWS * offset, 1.0);
    ShadowLookup result;
    vec2 tileUV = p.xy / p.w;
    result.depth = p.z / p.w;
    result.covered = p.w > 0.0 && all(greaterThanEqual(tileUV, vec2(0.0))) && all(lessThanEqual(tileUV, vec2(1.0))) &&
                     result.depth >= 0.0 && result.depth <= 1.0;
    result.uv = light.shadowTile.xy + tileUV * light.shadowTile.zw;
    result.uvMin = light.shadowTile.xy + 0.5 * atlasTexel;
    result.uvMax = light.shadowTile.xy + light.shadowTile.zw - 0.5 * atlasTexel;
    return result;
}

/// Fraction of the light that arrives, [0, 1]: a 4x4 tent of hardware-filtered comparisons, about 5 texels wide. Reeves
/// et al. 1987, "Rendering Antialiased Shadows with Depth Maps" (percentage closer filtering).
float filterShadow(sampler2DShadow atlas, ShadowLookup at, vec2 atlasTexel) {
    float lit = 0.0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            vec2 offset = vec2(x, y) - 1.5;
            float weight = (2.0 - abs(offset.x)) * (2.0 - abs(offset.y));
            lit += weight * texture(atlas, vec3(clamp(at.uv + offset * atlasTexel, at.uvMin, at.uvMax), at.depth));
        }
    return lit / 16.0; // sum of the weights: (0.5 + 1.5 + 1.5 + 0.5)^2
}

#endif
