// Surfaces that the host's frame shows, or the previous frame's picture, for rays that hit them: their light need not be
// computed again.
#ifndef GLINT_RAYS_SHOWN_SURFACE_GLSL
#define GLINT_RAYS_SHOWN_SURFACE_GLSL

#include "lib/brdf.glsl"
#include "lib/input_color.glsl"
#include "lib/ray_start.glsl"
#include "lib/resolved_material.glsl"
#include "rays/hit_lighting.glsl"
#include "rays/lit_surface.glsl"
#include "frame/lobe_surfaces.glsl"
#include "rays/met_coat.glsl"
#include "rays/pixel_rays.glsl"
#include "rays/regularization.glsl"
#include "rays/shown_pixel.glsl"

layout(set = 0, binding = 13) uniform sampler2D material;
layout(set = 0, binding = 14) uniform sampler2D litRadiance;
layout(set = 0, binding = 15) uniform sampler2D fallbackSpecular;
layout(set = 0, binding = 30) uniform sampler2D previousImages[3]; // one binding, of the few that a pass has
#define prevColor previousImages[0] // the previous frame's picture
#define prevViewZ previousImages[1]
#define motion previousImages[2]    // lib/previous_place.glsl

#include "lib/previous_radiance.glsl"
#undef prevColor
#undef prevViewZ
#undef motion

/// Least cosine between the normals of a hit and of the pixel that shows it, for both to be one surface. Normal maps
/// bend normals by less; the two sides of an edge differ by more.
const float kSameNormal = 0.7;

/// The pixel that shows the point `hitWS` of a surface. `faceNormalWS` points to the ray's side. Returns (-1, -1) if no
/// pixel shows the point, or if a pixel looks larger to the ray than to the eye.
ivec2 pixelThatShows(vec3 hitWS, vec3 faceNormalWS, vec3 directionWS, float coneWidthWS) {
    vec3 hitVS = (frame.constants.worldToView * vec4(hitWS, 1.0)).xyz;
    vec4 pixelH = frame.constants.viewToPixel * vec4(hitVS, 1.0);
    vec2 at = pixelH.xy / pixelH.w;
    if (pixelH.w <= 0.0 || any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, frame.constants.size)))
        return ivec2(-1);
    vec3 normalVS = mat3(frame.constants.worldToView) * faceNormalWS;
    float toEye = dot(normalVS, -viewDirection(frame.constants, hitVS));
    float extent = pixelExtent(frame.constants, frame.constants.uvToView, -hitVS.z).y;
    if (toEye <= 0.0 || coneWidthWS * toEye < extent * -dot(faceNormalWS, directionWS))
        return ivec2(-1);
    ivec2 px = ivec2(at);
    float z = texelFetch(viewZ, px, 0).r;
    if (z >= kBackgroundZ || resolvedMaterial(frame.constants, texelFetch(material, px, 0)).a < 1.0)
        return ivec2(-1);
    Surface here = shownAt(px);
    vec3 shownVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    bool same = abs(dot(normalVS, shownVS - hitVS)) <= samePlaceSlack(z) &&
                dot(here.normalVS, normalVS) > kSameNormal && looksAlike(here) && !isAtEdge(at);
    return same ? px : ivec2(-1);
}

/// The surface at `px` as the frame shows it, for a ray that came along `directionWS`. Highlights are those that the
/// eye sees. `share`, `spread`: of regularized().
LitSurface shownSurface(ivec2 px, vec3 positionWS, vec3 faceNormalWS, vec3 directionWS, float share, float spread) {
    bool encoded = (frame.constants.flags & kInputGamma) != 0u;
    Surface here = shownAt(px);
    vec4 texel = texelFetch(material, px, 0);
    vec3 f0 = here.reflectivity > 0.0 ? resolvedMaterial(frame.constants, texel).rgb : vec3(0.0);
    LitSurface shown;
    shown.positionWS = positionWS;
    shown.faceNormalWS = faceNormalWS;
    shown.normalWS = mat3(frame.constants.viewToWorld) * here.normalVS;
    shown.perceptualRoughness = here.perceptualRoughness;
    shown.lobeRoughness = regularized(here.perceptualRoughness, share, spread);
    shown.bend = 0.0;
    shown.response = vec3(0.0);
    if (maxComponent(f0) > 0.0)
        shown.response =
            specularResponse(f0, resolvedF90(frame.constants, texel),
                             loadDfg(clampedNoV(shown.normalWS, -directionWS), here.perceptualRoughness));
    shown.own = linearColor(texelFetch(litRadiance, px, 0).rgb, encoded);
    shown.environmentSpecular = vec3(0.0);
    shown.reflectsApart = (frame.constants.flags & kInputFallback) != 0u;
    if (shown.reflectsApart) {
        vec3 reflected = linearColor(texelFetch(fallbackSpecular, px, 0).rgb, encoded);
        shown.own = max(shown.own - reflected, vec3(0.0));
        shown.environmentSpecular =
            shown.response * loadEnvironmentLobe(shown.normalWS, -directionWS, shown.lobeRoughness);
    }
    return shown;
}

/// The same surface with its clear coat, if it has one: one lobe of the two. `noise`: of oneLobe.
LitSurface shownCoated(LitSurface shown, ivec2 px, vec3 directionWS, float share, float spread, float noise) {
    if (!hasCoats())
        return shown;
    Surface film = coatAt(px);
    if (film.reflectivity <= 0.0)
        return shown;
    MetCoat coat;
    coat.normalWS = mat3(frame.constants.viewToWorld) * film.normalVS;
    coat.perceptualRoughness = film.perceptualRoughness;
    coat.lobeRoughness = regularized(film.perceptualRoughness, share, spread);
    coat.reflectance = coatReflectance(film.reflectivity, clampedNoV(coat.normalWS, -directionWS));
    coat.environmentSpecular = vec3(0.0);
    if ((frame.constants.flags & kInputFallback) != 0u)
        coat.environmentSpecular =
            coat.reflectance * loadEnvironmentRadiance(reflect(directionWS, coat.normalWS), coat.lobeRoughness);
    shown.response *= 1.0 - coat.reflectance;
    shown.environmentSpecular *= 1.0 - coat.reflectance;
    return oneLobe(shown, coat, !isOn(kRaysMirror), noise);
}

/// True if both frames show this point of a surface, from the side to which `faceNormalWS` points: `here`. `radiance`: as
/// the previous frame shows it, with reflections, to the eye.
bool wasShown(vec3 positionWS, vec3 faceNormalWS, out Surface here, out vec3 radiance) {
    radiance = vec3(0.0);
    if (!isOn(kRaysPreviousEnds) || !hasPrevious(frame.constants))
        return false;
    vec3 positionVS = (frame.constants.worldToView * vec4(positionWS, 1.0)).xyz;
    vec4 pixelH = frame.constants.viewToPixel * vec4(positionVS, 1.0);
    vec2 at = pixelH.xy / pixelH.w;
    if (pixelH.w <= 0.0 || any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, frame.constants.size)))
        return false;
    vec3 normalVS = mat3(frame.constants.worldToView) * faceNormalWS;
    ivec2 px = ivec2(at);
    float z = texelFetch(viewZ, px, 0).r;
    if (z >= kBackgroundZ || dot(normalVS, -viewDirection(frame.constants, positionVS)) <= 0.0)
        return false;
    vec3 shownVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    here = unpackSurface(texelFetch(surface, px, 0).xy);
    return abs(dot(normalVS, shownVS - positionVS)) <= samePlaceSlack(z) && dot(here.normalVS, normalVS) > 0.0 &&
           radianceBefore(previousPlace(px, z, here.normalVS, true), false, radiance);
}

/// What the previous frame shows nearest to a point on the screen, whatever it is. False without such a frame.
bool shownNearest(vec3 positionWS, out vec3 radiance) {
    radiance = vec3(0.0);
    if (!isOn(kRaysPreviousEnds) || !hasPrevious(frame.constants))
        return false;
    vec3 positionVS = (frame.constants.worldToView * vec4(positionWS, 1.0)).xyz;
    vec4 pixelH = frame.constants.prevViewToPixel * (frame.constants.viewToPrevView * vec4(positionVS, 1.0));
    vec2 at = pixelH.w > 0.0 ? pixelH.xy / pixelH.w : 0.5 * frame.constants.prevSize;
    ivec2 px = ivec2(clamp(at, vec2(0.0), frame.constants.prevSize - 1.0));
    radiance = linearColor(texelFetch(previousImages[0], px, 0).rgb, (frame.constants.flags & kHistoryGamma) != 0u);
    return true;
}

/// A surface of which nothing is known but its radiance towards the ray's origin, which is all of it.
LitSurface knownSurface(vec3 radiance) {
    LitSurface lit;
    lit.positionWS = lit.faceNormalWS = lit.normalWS = vec3(0.0);
    lit.perceptualRoughness = lit.lobeRoughness = 1.0;
    lit.bend = 0.0;
    lit.own = radiance;
    lit.response = lit.environmentSpecular = vec3(0.0);
    lit.reflectsApart = false;
    return lit;
}

#endif
