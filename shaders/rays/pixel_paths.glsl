// The paths of a pixel: how each starts.
#ifndef GLINT_RAYS_PIXEL_PATHS_GLSL
#define GLINT_RAYS_PIXEL_PATHS_GLSL

#include "rays/path.glsl"
#include "rays/pixel_plan.glsl"

/// A path whose first hit is the hit of the screen's ray.
Path pathFromScreen(PixelRays from, PixelPlan plan, uint i, float regularization) {
    RayRecord screen = plan.screen;
    Path path = startPath(from.originWS, reflect(-from.V, from.N), from.cone,
                          isOn(kRaysCone) ? lobeAngle(from.perceptualRoughness) : 0.0, regularization);
    path.splits = plan.splits;
    ivec2 px = hitPixel(screen);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    vec3 shownVS = viewPosition(frame.constants, uv, texelFetch(viewZ, px, 0).r);
    vec3 shownWS = (frame.constants.viewToWorld * vec4(shownVS, 1.0)).xyz;
    vec3 normalWS = mat3(frame.constants.viewToWorld) * shownAt(px).normalVS;
    // The record's distance has eleven bits. The pixel's plane gives a more exact one, unless the ray runs along the
    // plane.
    float distance = dot(shownWS - from.originWS, normalWS) / min(dot(path.ray.directionWS, normalWS), -1e-3);
    if (abs(distance - screen.hitDistance) > 0.05 * screen.hitDistance)
        distance = screen.hitDistance;
    vec3 hitWS = from.originWS + path.ray.directionWS * distance;
    path.hit = true;
    path.hitDistance = distance;
    path.hitWS = hitWS;
    path.cone.width += path.cone.spread * distance;
    ++path.reused;
    LitSurface met = shownSurface(px, hitWS, normalWS, path.ray.directionWS, 0.0, 0.0);
    met = shownCoated(met, px, path.ray.directionWS, 0.0, 0.0, coatNoise(from.px, sampleNumber(i), 0u));
    bool halfDepth = (frame.constants.flags & kInputHalfDepth) != 0u;
    met.positionWS += normalWS * depthUncertainty(hitWS, -shownVS.z, halfDepth);
    leaveSurface(met, 0u, from.px, sampleNumber(i), path);
    return path;
}

/// A path in direction `first` of the pixel's lobe, or from the screen's hit. `middle`: that direction stands for the
/// whole lobe, so no ray to a light is weighed against it.
Path startOfSample(PixelRays from, PixelPlan plan, uint i, Direction first, bool middle, float regularization) {
    Path path;
    if (plan.fromScreen)
        path = pathFromScreen(from, plan, i, regularization);
    else
        path = startPath(from.originWS, first.ws, from.cone,
                         drawnAngle(from.N, from.V, first.ws, from.perceptualRoughness), regularization);
    path.splits = plan.splits;
    path.isAveraged = path.isAveraged || !plan.mirror;
    path.ended = path.ended || first.weight <= 0.0 || plan.lightsOnly;
    if (plan.lights && !middle) {
        path.vertex = LobeVertex(true, plan.lobe, from.N, kLeastLobeCosine, true, vec3(1.0));
        path.density = lobeDensity(plan.lobe.wo, first.ws * plan.lobe.axes, plan.lobe.alpha);
    }
    return path;
}

#endif
