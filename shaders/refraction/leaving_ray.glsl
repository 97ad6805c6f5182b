// The rays of a layer: the surface's own reflection, the way across its body, and the way out of the body; with their
// changes from pixel to pixel.
#ifndef GLINT_REFRACTION_LEAVING_RAY_GLSL
#define GLINT_REFRACTION_LEAVING_RAY_GLSL

#include "lib/fades.glsl"
#include "lib/refraction.glsl"
#include "lib/transmission.glsl"
#include "refraction/layer_march.glsl"
#include "refraction/layer_surface.glsl"

/// A hit farther away than this counts as infinitely far, metres.
const float kFar = 1e4;

/// Change of a ray to that of the next pixel, view space. Igehy 1999, "Tracing Ray Differentials".
struct RayDifferential {
    vec3 origin;
    vec3 direction;
};

const RayDifferential kNoDifferential = RayDifferential(vec3(0.0), vec3(0.0));

/// A ray that leaves a surface or a body, or crosses a body, and the spread of its light.
struct Leaving {
    vec3 originVS;
    vec3 directionVS; // unit
    float reach;      // metres, of the march on screen
    float roughness;  // perceptual: of the lobe
    float travelled;  // metres over which the light has spread before
    vec3 centerWS;    // position that selects the probes
    float layerZ;     // viewZ of the surface
    ivec2 px;         // the pixel that shows the surface
    uint asks;        // kLayerScreen, kLayerProxy, kLayerProbes and kLayerSky: the sources
    bool crosses;     // inside the body, in search of objects there: the background is no answer
    bool mirrored;    // a reflection about this normal
    vec3 normalVS;
    float fade;         // of the screen's answer, [0, 1]
    bool bent;          // false: it is seen in place, up to the image's border
    RayDifferential dx; // to the pixels beside this one and below it
    RayDifferential dy;
};

/// A ray from the surface at pixel `px` that no source answers yet; who makes one sets what differs.
Leaving rayFromSurface(LayerSurface s, ivec2 px) {
    Leaving ray;
    ray.originVS = s.positionVS;
    ray.directionVS = -s.toEyeVS;
    ray.reach = kFar;
    ray.roughness = s.here.perceptualRoughness;
    ray.travelled = 0.0;
    ray.centerWS = s.centerWS;
    ray.layerZ = s.here.viewZ;
    ray.px = px;
    ray.asks = 0u;
    ray.crosses = false;
    ray.mirrored = false;
    ray.normalVS = s.here.normalVS;
    ray.fade = 1.0;
    ray.bent = false;
    ray.dx = kNoDifferential;
    ray.dy = kNoDifferential;
    return ray;
}

Leaving mirrorRay(LayerSurface s, ivec2 px) {
    Leaving ray = rayFromSurface(s, px);
    ray.directionVS = reflect(-s.toEyeVS, s.here.normalVS);
    ray.reach = settings.maxDistance;
    ray.asks = refraction.flags & (kLayerScreen | kLayerProbes | kLayerSky);
    ray.mirrored = true;
    ray.fade = fadeRoughness(s.here.perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness);
    ray.bent = true;
    return ray;
}

/// The surface's own reflection.
Leaving reflectionRay(LayerSurface s, ivec2 px) {
    Leaving ray = mirrorRay(s, px);
    if (ray.fade <= 0.0 || maxComponent(s.here.f0) <= settings.threshold)
        ray.asks &= ~kLayerScreen;
    return ray;
}

bool isBent(LayerSurface s, Refraction path) {
    return path.pathLength > 0.0 && abs(s.ior - 1.0) > 1e-4;
}

/// Roughness of the lobe that leaves the body. Each reflection inside widens it as the surface's own reflection does.
float leavingRoughness(LayerSurface s, uint inner) {
    float roughness = transmissionRoughness(s.here.perceptualRoughness, s.ior);
    if (inner == 0u)
        return roughness;
    float alpha = square(s.here.perceptualRoughness);
    return min(sqrt(length(vec2(square(roughness), alpha * sqrt(float(inner))))), 1.0);
}

/// Across the body, in search of another object that is inside it, or reaches into it.
Leaving crossingRay(LayerSurface s, ivec2 px, Refraction path) {
    Leaving ray = rayFromSurface(s, px);
    ray.directionVS = path.insideDir;
    ray.reach = path.pathLength;
    ray.roughness = leavingRoughness(s, 0u);
    ray.asks = kLayerScreen;
    ray.crosses = true;
    return ray;
}

/// Out of the body, after `inner` reflections inside it.
Leaving leavingRay(LayerSurface s, ivec2 px, Refraction path, uint inner) {
    Leaving ray = rayFromSurface(s, px);
    ray.originVS = s.positionVS + path.exit;
    ray.directionVS = path.direction;
    ray.roughness = leavingRoughness(s, inner);
    ray.travelled = path.pathLength;
    ray.asks = refraction.flags & (kLayerScreen | kLayerProxy | kLayerProbes | kLayerSky);
    ray.bent = isBent(s, path);
    return ray;
}

/// The ray that brings a pixel's light: its start, behind the body or on the surface, and its direction. `inner`:
/// reflections inside the body.
RayDifferential rayOf(LayerSurface s, bool mirrored, uint inner) {
    if (mirrored)
        return RayDifferential(s.positionVS, reflect(-s.toEyeVS, s.here.normalVS));
    Refraction path = refractThrough(s.model, s.here.normalVS, s.toEyeVS, s.ior, s.thickness, inner);
    return RayDifferential(s.positionVS + path.exit, path.direction);
}

/// Change to the ray of the next pixel along `step`. Takes the smaller difference of both sides, because across an edge
/// lies another surface. The neighbours' bodies are assumed to be this one.
RayDifferential differential(LayerSurface s, ivec2 px, ivec2 step, bool mirrored, uint inner) {
    RayDifferential here = rayOf(s, mirrored, inner);
    RayDifferential least = kNoDifferential;
    float leastTurn = 2.0;
    for (int side = -1; side <= 1; side += 2) {
        ivec2 at = px + side * step;
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(frame.constants.size))))
            continue;
        LayerSurface next = s;
        next.here.viewZ = storedViewZ(frame.constants, hostViewZ(frame.constants, texelFetch(layerDepth, at, 0).r));
        if (next.here.viewZ >= kBackgroundZ)
            continue;
        next.positionVS = viewPosition(frame.constants, (vec2(at) + 0.5) * frame.constants.invSize, next.here.viewZ);
        next.toEyeVS = -viewDirection(frame.constants, next.positionVS);
        next.here.normalVS =
            facingNormal(hostNormalVS(frame.constants, texelFetch(layerNormal, at, 0).xyz), next.toEyeVS);
        RayDifferential there = rayOf(next, mirrored, inner);
        vec3 turn = (there.direction - here.direction) * float(side);
        if (length(turn) < leastTurn) {
            leastTurn = length(turn);
            least = RayDifferential((there.origin - here.origin) * float(side), turn);
        }
    }
    return least;
}

#endif
