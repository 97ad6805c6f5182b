// Next-event estimation with multiple importance sampling, for the paths of the source `rays` (rays.sampleLights).
// Wherever a path continues in a random direction of a rough lobe, one ray goes to a bright part of the environment and
// one to an emissive triangle. Light that both these rays and the path itself can find is weighted by the balance
// heuristic: Veach and Guibas 1995, "Optimally Combining Sampling Techniques for Monte Carlo Rendering". Light that only
// the path can find (through transparent surfaces, by mirrors) counts in full. Include after rays/hit_lighting.glsl.
//
// Without GLINT_SAMPLE_LIGHTS the same functions leave all light to the path.
#ifndef GLINT_RAYS_LIGHT_SAMPLING_GLSL
#define GLINT_RAYS_LIGHT_SAMPLING_GLSL

#include "generate/lobe.glsl"
#include "rays/hit_lighting.glsl"
#include "rays/pixel_rays.glsl"

/// A rough lobe in which a path continues in a random direction.
struct LobeVertex {
    bool sendsRays; // to lights; false: all else is undefined
    LobeFrame lobe;
    vec3 faceNormalWS; // unit
    float leastCosine; // with that normal: the path draws no direction below, or turns it
    bool isAveraged;   // the pixel's own surface, or the one that its mirror shows
    vec3 throughput;   // of light that the facets let pass
};

const LobeVertex kNoVertex = LobeVertex(false, LobeFrame(mat3(1.0), vec3(0.0), 1.0), vec3(0.0), 0.0, false, vec3(1.0));

#ifdef GLINT_SAMPLE_LIGHTS

#include "lib/color.glsl"
#include "lib/environment_cells.glsl"
#include "rays/emitters.glsl"
#include "rays/light_tree.glsl"

// Seeds of the draws at a vertex, apart from those of laterBounceNoise.
const uint kEnvironmentSeed = 0x5bd1e995u;
const uint kEmitterSeed = 0x68e31da4u;
const uint kPointSeed = 8u; // after the seeds of drawLight

bool samplesLights(float perceptualRoughness) {
    return isOn(kRaysSampleLights) && perceptualRoughness >= kSmoothestSampled;
}

/// True if the denoiser averages this surface, and it sends a ray to the environment.
bool samplesSky(float perceptualRoughness) {
    return isOn(kRaysSampleSky) && perceptualRoughness >= kSmoothestSampled;
}

// ---------------------------------------------------------------- densities over solid angle

float environmentDensity(vec3 directionWS) {
    CubePoint at = cubePoint(toEnvironment(directionWS));
    return lightProbability(0u, kEnvironmentDepth, environmentLeaf(at)) / cellSolidAngle(at);
}

/// Of a triangle that was drawn with `probability`, seen from `distance` metres.
float triangleDensity(float probability, float area, vec3 faceNormalWS, vec3 directionWS, float distance) {
    return probability * square(distance) / max(area * abs(dot(faceNormalWS, directionWS)), 1e-30);
}

float emitterDensity(Hit hit, HitSurface met, vec3 directionWS) {
    uint first = emitterLeaf(hit.instance);
    if (first == kNoEmitter)
        return 0.0;
    float probability = lightProbability(kEnvironmentGroups, emitters.header.depth, first + hit.primitive);
    return triangleDensity(probability, met.area, met.faceNormalWS, directionWS, hit.distance);
}

// ---------------------------------------------------------------- light that the path finds

/// Weight of the environment where the path finds it. `density`: with which the path drew its direction; 0: no other
/// ray can find the same light.
float environmentShare(vec3 directionWS, float density) {
    return density > 0.0 ? density / (density + environmentDensity(directionWS)) : 1.0;
}

/// Weight of a hit's emission.
float emissionShare(Hit hit, HitSurface met, vec3 directionWS, float density) {
    bool found = density > 0.0 && !isOn(kRaysSampleSky); // by rays to lights, too
    return found ? density / (density + emitterDensity(hit, met, directionWS)) : 1.0;
}

/// True if the path must tell this hit's emission from its other light.
bool isSampledEmitter(uint instance, float density) {
    return density > 0.0 && !isOn(kRaysSampleSky) && emitterLeaf(instance) != kNoEmitter;
}

// ---------------------------------------------------------------- light that rays to lights find

/// Fraction of the light from there that is reflected, over the sum of both densities.
float reflectedShare(LobeVertex at, vec3 directionWS, float density) {
    if (dot(directionWS, at.faceNormalWS) < at.leastCosine)
        return 0.0;
    vec3 wi = directionWS * at.lobe.axes;
    float reflected = lobeResponse(at.lobe.wo, wi, at.lobe.alpha);
    return reflected > 0.0 ? reflected / (lobeDensity(at.lobe.wo, wi, at.lobe.alpha) + density) : 0.0;
}

/// A direction to a light.
struct ToLight {
    vec3 directionWS;
    float density;  // 0: no light
    float distance; // the ray's end, metres
    uint instance;  // of the emissive triangle; kNoInstance: the environment
    uint primitive;
};

const ToLight kNoLight = ToLight(vec3(0.0), 0.0, 0.0, kNoInstance, 0u);

ToLight toEnvironmentCell(DrawnLight drawn, vec2 u) {
    CubePoint there = environmentPoint(drawn.leaf, u);
    vec3 directionWS = normalize(cubeDirection(there.face, there.p)) * mat3(frame.constants.worldToEnvironment);
    return ToLight(directionWS, drawn.probability / cellSolidAngle(there), settings.tMax, kNoInstance, 0u);
}

/// A point of a triangle, uniformly: weights of its sides. Osada et al. 2002, "Shape Distributions", TOG 21(4).
vec2 pointOfTriangle(vec2 u) {
    float root = sqrt(u.x);
    return vec2(root * (1.0 - u.y), root * u.y);
}

ToLight toEmitter(DrawnLight drawn, vec3 originWS, vec2 u) {
    EmitterTriangle emitter = emitterTriangle(drawn.leaf);
    SurfaceInstanceRecord placed = surfaceInstances.item[emitter.instance];
    SurfaceMeshRecord mesh = surfaceMeshes.item[placed.mesh];
    TriangleWS sides = triangleWS(placed, mesh, loadTriangle(mesh, emitter.primitive));
    vec2 weights = pointOfTriangle(u);
    vec3 toPoint = sides.a + sides.u * weights.x + sides.v * weights.y - originWS;
    vec3 areaNormalWS = cross(sides.u, sides.v); // its length is twice the area
    float distance = length(toPoint);
    float area2 = length(areaNormalWS);
    if (!(distance > 0.0 && area2 > 0.0))
        return kNoLight;
    const float kPast = 1.0 + exp2(-10.0); // the triangle must lie well before the ray's end
    vec3 directionWS = toPoint / distance;
    float density = triangleDensity(drawn.probability, 0.5 * area2, areaNormalWS / area2, directionWS, distance);
    return ToLight(directionWS, density, min(distance * kPast, settings.tMax), emitter.instance, emitter.primitive);
}

ToLight drawToLight(bool environment, vec3 originWS, LightNoise noise) {
    if (environment ? !isOn(kRaysEnvironment) : emitters.header.leaves == 0u)
        return kNoLight;
    DrawnLight drawn = drawLight(environment ? 0u : kEnvironmentGroups,
                                 environment ? kEnvironmentDepth : emitters.header.depth, noise);
    if (drawn.probability <= 0.0)
        return kNoLight;
    vec2 u = hashNoise(noise.px, noise.index, noise.seed + kPointSeed).xy;
    if (environment)
        return toEnvironmentCell(drawn, u);
    return toEmitter(drawn, originWS, u);
}

/// Emission of a hit towards the ray's origin.
vec3 emissionOf(Hit hit, vec3 directionWS, Cone cone) {
    HitSurface met = hitSurface(hit.instance, hit.primitive, hit.barycentrics, hit.frontFace, directionWS,
                                cone.width + cone.spread * hit.distance);
    MaterialSample m = sampleMaterial(met.material, met.point);
    float coat = m.clearcoat > 0.0 ? coatReflectance(m, -directionWS) : 0.0;
    return (1.0 - coat) * m.emission;
}

/// The light of the environment and of emissive triangles that the vertex reflects. `ray`, `cone`: as the path
/// continues, but for the direction. `meetsTransparents`: the path stops at transparent surfaces.
vec3 sampleLights(LobeVertex at, Ray ray, Cone cone, bool meetsTransparents, ivec2 px, uint sampleIndex, uint bounce) {
    vec3 sum = vec3(0.0);
    uint kinds = isOn(kRaysSampleSky) ? 1u : 2u;
    for (uint kind = 0u; kind < kinds; ++kind) { // a loop, so that the program holds one copy of the ray
        bool environment = kind == 0u;
        uint seed = frame.constants.seed + (environment ? kEnvironmentSeed : kEmitterSeed);
        ToLight light =
            drawToLight(environment, ray.originWS, LightNoise(uvec2(px), sampleIndex * 8u + bounce, seed));
        float share = light.density > 0.0 ? reflectedShare(at, light.directionWS, light.density) : 0.0;
        if (share <= 0.0)
            continue;
        ray.directionWS = light.directionWS;
        ray.tMax = light.distance;
        // The nearest hit and not any occluder: holes and back faces of an emitter count as they do for the path.
        rayMeetsTransparents = meetsTransparents;
        Hit hit = traceRay(ray);
        rayMeetsTransparents = false;
        if (hit.instance != light.instance || hit.primitive != light.primitive)
            continue;
        sum += share * (environment ? loadEnvironmentRadiance(light.directionWS, 0.0)
                                    : emissionOf(hit, light.directionWS, cone));
    }
    return sum;
}

#else

bool samplesLights(float perceptualRoughness) {
    return false;
}

bool samplesSky(float perceptualRoughness) {
    return false;
}

float environmentShare(vec3 directionWS, float density) {
    return 1.0;
}

float emissionShare(Hit hit, HitSurface met, vec3 directionWS, float density) {
    return 1.0;
}

bool isSampledEmitter(uint instance, float density) {
    return false;
}

vec3 sampleLights(LobeVertex at, Ray ray, Cone cone, bool meetsTransparents, ivec2 px, uint sampleIndex, uint bounce) {
    return vec3(0.0);
}

#endif
#endif
