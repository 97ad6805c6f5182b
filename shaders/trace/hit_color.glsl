// The colour of a ray's hit: this frame's colour, or with screen.colorSource previous the previous frame's. The
// previous frame holds its own reflections, so a mirror shows mirrors.
#ifndef GLINT_TRACE_HIT_COLOR_GLSL
#define GLINT_TRACE_HIT_COLOR_GLSL

#include "frame/prepared.glsl"
#include "lib/camera.glsl"
#include "lib/history.glsl"
#include "lib/input_color.glsl"
#include "lib/math.glsl"
#include "lib/surface.glsl"
#include "trace/met_surface.glsl"

layout(set = 0, binding = 3) uniform sampler2D litRadiance;
layout(set = 0, binding = 6) uniform sampler2D prevColor; // the previous frame's colour
layout(set = 0, binding = 7) uniform sampler2D prevViewZ; // the previous frame's viewZ
layout(set = 0, binding = 8) uniform sampler2D motion;    // lib/previous_place.glsl

#include "lib/previous_radiance.glsl"
#include "trace/cone.glsl"
#include "trace/one_surface.glsl"
#include "trace/shown_radiance.glsl"

const float kSamePlace = 0.002; // of viewZ: two texels of one surface lie on one plane

/// How far off a plane through a point at `viewZ` a pixel of the same plane may lie, metres. `pixel`: its extent there.
float samePlaceSlack(vec2 pixel, float viewZ) {
    return kSamePlace * viewZ + 0.25 * pixel.y;
}

/// radianceBefore of the surface at `px`. `shownPX`: where the previous frame showed it.
bool previousRadiance(ivec2 px, out vec3 radiance, out vec2 shownPX) {
    radiance = vec3(0.0);
    shownPX = vec2(0.0);
    float z = texelFetch(metViewZ, px, 0).r;
    if (z >= kBackgroundZ)
        return false;
    vec3 normalVS = unpackSurface(texelFetch(metSurface, px, 0).xy).normalVS;
    PreviousPlace before = previousPlace(px, z, normalVS, !kAmongTransparents);
    shownPX = before.px;
    return radianceBefore(before, kAmongTransparents, radiance);
}

/// True if pixels of the hit's surface look more than `times` as large from the ray's start as from the eye. On the ray, a
/// pixel of the mirror spans what a pixel spans at the distance of the whole path. A pixel at the hit is as wide as its own
/// distance makes it, stretched by the surface's tilt to the eye and foreshortened by its tilt to the ray. Holds for a flat
/// mirror: a concave one may magnify more.
bool isMagnified(float times, vec3 hitVS, vec3 normalVS, vec3 originVS) {
    vec3 directionVS = normalize(hitVS - originVS);
    float wayOfMirror = length(originVS) + distance(originVS, hitVS);
    float growth = isOrthographic(frame.constants) ? 1.0 : wayOfMirror / length(hitVS); // of a pixel, along the way
    return abs(dot(normalVS, directionVS)) > times * growth * abs(dot(normalVS, viewDirection(frame.constants, hitVS)));
}

/// This frame's radiance at `px`: one texel, or where texels look large, bilinear over those of the four texels that
/// show the same surface, by depth and normal. A marcher that promises one lookup (GLINT_ONE_TEXEL_A_HIT) takes the
/// texel.
vec3 currentRadiance(vec2 px, vec3 originVS, vec3 hitVS, inout uint lookups) {
    ivec2 at = floorToInt(px);
    Surface met = unpackSurface(texelFetch(metSurface, at, 0).xy);
    vec3 nearest = shownRadiance(at, met.perceptualRoughness);
#ifdef GLINT_ONE_TEXEL_A_HIT
    return nearest;
#else
    vec3 normalVS = met.normalVS;
    if (!isMagnified(1.0, hitVS, normalVS, originVS)) // magnified texels would show as stairs
        return nearest;
    float z = texelFetch(metViewZ, at, 0).r;
    ++lookups;
    vec3 texelVS = viewPosition(frame.constants, (vec2(at) + 0.5) * frame.constants.invSize, z);
    const float kLike = 0.9; // 25 degrees
    float offPlane = samePlaceSlack(pixelExtent(frame.constants, frame.constants.uvToView, z), z);
    vec2 corner = floor(px - 0.5);
    vec2 share = px - 0.5 - corner;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        ivec2 texel = clamp(floorToInt(corner) + offset, ivec2(0), ivec2(frame.constants.size) - 1);
        vec2 shares = mix(1.0 - share, share, vec2(offset));
        float weight = shares.x * shares.y;
        if (texel == at) {
            sum += weight * vec4(nearest, 1.0);
            continue;
        }
        float texelZ = texelFetch(metViewZ, texel, 0).r;
        ++lookups;
        vec2 uv = (vec2(texel) + 0.5) * frame.constants.invSize;
        bool same = texelZ < kBackgroundZ && showsOneSurface(texel) &&
                    abs(dot(normalVS, viewPosition(frame.constants, uv, texelZ) - texelVS)) <= offPlane &&
                    dot(normalVS, unpackSurface(texelFetch(metSurface, texel, 0).xy).normalVS) > kLike;
        if (same)
            sum += weight * vec4(shownRadiance(texel, met.perceptualRoughness), 1.0);
    }
    return sum.rgb / sum.a; // the texel at `px` has a weight of at least a quarter
#endif
}

/// At a rim the eye sees little of a surface and the ray much of it: pixels look this much larger to the ray.
const float kRim = 2.0;

/// Linear, finite radiance of the surface that the frame shows at `px`, for a ray from `originVS` to `hitVS`. `mayTakeMean`:
/// where the pixel shows the mean of several surfaces, the ray may take that, but at a rim, where the other surfaces would
/// look as large. `cone`: the lobe around the ray. `lookups` grows by the number of depth samples read from this frame.
vec3 hitRadiance(vec2 px, bool mayTakeMean, vec3 originVS, vec3 hitVS, LobeCone cone, inout uint lookups) {
    vec3 radiance;
    float blurred =
        cone.alpha > 0.0 ? blurredShare(coneRadius(cone, hitVS, distance(originVS, hitVS))) : 0.0;
    ivec2 at = floorToInt(px);
    if (!showsOneSurface(at) && (!mayTakeMean || isMagnified(kRim, hitVS, shownPoint(at).normalVS, originVS)))
        px = placeOfSurfaceAlone(px);
    vec2 shownPX;
    vec2 shift = vec2(0.0);
    if (hasHistory(frame.constants) && previousRadiance(floorToInt(px), radiance, shownPX))
        shift = shownPX - px;
    else {
        if (hasHistory(frame.constants))
            blurred = 0.0; // the copies are of the previous frame
        radiance = currentRadiance(px, originVS, hitVS, lookups);
    }
    if (blurred <= 0.0)
        return radiance;
    vec4 lobe = coneRadiance(cone, originVS, hitVS, shift);
    return mix(radiance, lobe.rgb, blurred * lobe.a);
}

#endif
