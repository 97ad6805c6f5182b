// The light that the rays of a layer's pixel bring: through its body, and reflected by its surface.
#ifndef GLINT_REFRACTION_LAYER_LIGHT_GLSL
#define GLINT_REFRACTION_LAYER_LIGHT_GLSL

#include "lib/transmission.glsl"
#include "refraction/layer_sources.glsl"

/// A body at a pixel, for one channel where it disperses light.
struct Body {
    LayerSurface s;
    bvec3 channels;
    float left; // fraction of the light that has not left the body yet
    vec3 seen;  // what the last path out of the body showed, without absorption
};

Body bodyFor(LayerSurface s, uint channel, bool disperses, vec3 straightBehind) {
    if (!disperses)
        return Body(s, bvec3(true), 1.0, straightBehind);
    s.ior = dispersedIor(s.ior, s.dispersion)[channel];
    return Body(s, equal(uvec3(channel), uvec3(0u, 1u, 2u)), 1.0, straightBehind);
}

/// What the rays of a pixel bring.
struct Light {
    vec3 transmitted; // mean, absorbed along its paths
    vec3 weights;     // of its sources: screen, probes, sky
    vec3 reflected;   // weighted
    float reflectedWeight;
};

/// `fraction` of the light leaves the body towards what has this radiance.
void leave(inout Body body, inout Light light, float fraction, vec3 radiance, vec3 weights) {
    light.transmitted = mix(light.transmitted, light.transmitted + fraction * radiance, body.channels);
    light.weights += fraction * weights / (all(body.channels) ? 1.0 : 3.0);
    body.left -= fraction;
}

vec3 absorbed(LayerSurface s, vec3 radiance, float pathLength) {
    return radiance * volumeTransmittance(pathLength, s.attenuationColor, s.attenuationDistance);
}

/// True if there is nothing to march across: then light comes from straight behind, or from inside the body.
bool skipsCrossing(inout Body body, inout Light light, ivec2 px, Refraction path) {
    if (path.isTotal)
        return true;
    if (!isBent(body.s, path) && leavingRoughness(body.s, 0u) <= 0.0) {
        float toSolid = (texelFetch(viewZ, px, 0).r - body.s.here.viewZ) / max(body.s.toEyeVS.z, 1e-4);
        float inside = min(path.pathLength, max(toSolid, 0.0));
        leave(body, light, body.left, absorbed(body.s, body.seen, inside), vec3(1.0, 0.0, 0.0));
        return true;
    }
    return path.pathLength <= 0.0 || !layerHas(kLayerScreen);
}

/// Follows the rays of a pixel: through the body, for each channel where it disperses light, and the surface's own
/// reflection. `exitReflectance`: fraction that a surface reflects back into the body. One loop over all rays: compilers
/// inline all of the walk through the sources at each call.
Light followRays(LayerSurface s, ivec2 px, float exitReflectance, bool transmits, bool reflects) {
    Light light = Light(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    bool disperses = s.dispersion > 0.0 && s.ior > 0.0;
    uint inners = exitReflectance > 0.0 ? refraction.innerReflections : 0u;
    uint stages = 2u + inners; // of a body: 0 is across it, n is out of it after n - 1 reflections inside
    uint last = transmits ? stages * (disperses ? 3u : 1u) : 0u; // the surface's own reflection
    vec3 straightBehind = pictureAt(px);
    Body body = bodyFor(s, 0u, false, straightBehind);
    for (uint i = 0u; i < last + (reflects ? 1u : 0u); ++i) {
        bool mirrors = i == last;
        uint stage = mirrors ? 0u : i % stages;
        uint inner = max(stage, 1u) - 1u;
        bool crosses = stage == 0u && !mirrors;
        if (stage == 0u)
            body = bodyFor(s, i / stages, disperses && !mirrors, straightBehind);
        Refraction path =
            refractThrough(body.s.model, s.here.normalVS, s.toEyeVS, body.s.ior, body.s.thickness, inner);
        if (body.left <= 0.0 || (crosses && skipsCrossing(body, light, px, path)))
            continue;
        Leaving ray;
        if (mirrors)
            ray = reflectionRay(s, px);
        else if (crosses)
            ray = crossingRay(body.s, px, path);
        else if (path.isTotal)
            ray = mirrorRay(s, px);
        else
            ray = leavingRay(body.s, px, path, inner);
        if (!crosses) {
            ray.dx = differential(body.s, px, ivec2(1, 0), ray.mirrored, inner);
            ray.dy = differential(body.s, px, ivec2(0, 1), ray.mirrored, inner);
        }
        Answer answer = walkSources(ray);
        float weight = answer.weights.x + answer.weights.y + answer.weights.z;
        if (mirrors) {
            light.reflected = answer.radiance;
            light.reflectedWeight = weight;
        } else if (!crosses) {
            // The remaining weight takes what the last path showed, of the first path what is straight behind.
            body.seen = answer.radiance + (1.0 - weight) * body.seen;
            bool isLast = path.isTotal || path.pathLength <= 0.0 || inner == inners;
            float fraction = isLast ? body.left : body.left * (1.0 - exitReflectance);
            vec3 seen = path.isTotal ? body.seen : absorbed(s, body.seen, path.pathLength);
            leave(body, light, fraction, seen, answer.weights);
        } else if (weight > 0.0) {
            leave(body, light, body.left, absorbed(s, answer.radiance, answer.distance), answer.weights);
        }
    }
    return light;
}

#endif
