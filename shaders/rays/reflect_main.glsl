// The source `rays`: what the listed pixels reflect, by rays through the host's triangles. A ray that meets a surface
// brings its light, and goes on from there while rays.bounces lasts; the last surface reflects the environment, as the
// host's own pictures of it do. docs/techniques/ray-reflections.md.
#include "rays/hit_lighting.glsl"
#include "rays/pixel_rays.glsl"

layout(local_size_x = 64) in; // kRaysPerGroup

layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D raysRadianceWeight;
layout(set = 0, binding = 8, rg32ui) uniform writeonly uimage2D raysRecord;
layout(set = 0, binding = 11, rgba32f) uniform image2D raysSum;  // kRaysAccumulate: over all samples so far, weighted
layout(set = 0, binding = 12, r32f) uniform image2D raysWeights; // radiance and weight of what is known; weight

/// Less is no longer followed: half of what an 8-bit picture can show.
const float kLeastThroughput = 1.0 / 512.0;

// ---------------------------------------------------------------- a path

struct Path {
    vec3 radiance;
    float weight;      // 0: nothing is known of where it leads
    float hitDistance; // metres, of its first ray
    vec3 hitWS;
    bool hit;  // its first ray met a surface
    uint rays; // that it took, those for shadows apart
};

Path followPath(vec3 originWS, vec3 directionWS, Cone cone, ivec2 px, uint sampleIndex) {
    Path path = Path(vec3(0.0), 1.0, 0.0, originWS, false, 0u);
    vec3 throughput = vec3(1.0);
    Ray ray = viewRay(originWS, directionWS);
    for (uint bounce = 0u; bounce < settings.bounces; ++bounce) {
        Hit hit = traceRay(ray);
        ++path.rays;
        if (!isHit(hit)) {
            if (isOn(kRaysEnvironment))
                path.radiance += throughput * loadEnvironmentRadiance(ray.directionWS, 0.0);
            else if (bounce == 0u)
                path.weight = 0.0;
            break;
        }
        cone.width += cone.spread * hit.distance;
        HitSurface met =
            hitSurface(hit.instance, hit.primitive, hit.barycentrics, hit.frontFace, ray.directionWS, cone.width);
        vec3 V = -ray.directionWS;
        MaterialSample m = sampleMaterial(met.material, met.point);
        litFaceNormalWS = met.faceNormalWS;
        Lighting lighting = lightSurface(m, met.point, V);
        if (bounce == 0u) {
            path.hit = true;
            path.hitDistance = hit.distance;
            path.hitWS = met.point.positionWS;
        }

        vec3 own = lighting.diffuse + lighting.directSpecular + lighting.coatSpecular + lighting.emission;
        float coat = m.clearcoat > 0.0 ? coatReflectance(m, V) : 0.0;
        vec3 response =
            specularResponse(m.f0, m.f90, loadDfg(clampedNoV(m.normalWS, V), m.perceptualRoughness)) * (1.0 - coat);
        bool last = bounce + 1u == settings.bounces || m.perceptualRoughness > settings.maxRoughness ||
                    maxComponent(throughput * response) < kLeastThroughput;
        Direction next = Direction(vec3(0.0), 0.0);
        if (!last)
            next = sampleReflection(m.normalWS, V, m.perceptualRoughness,
                                    laterBounceNoise(px, sampleIndex, bounce, frame.constants.seed));
        if (next.weight <= 0.0) { // nobody follows
            path.radiance += throughput * (own + lighting.environmentSpecular);
            break;
        }
        path.radiance += throughput * own;
        throughput *= response;
        float offset = settings.tMin > 0.0 ? 0.0 : hitUncertainty(met.point.positionWS);
        ray = viewRay(met.point.positionWS + met.faceNormalWS * offset, aboveSurface(next.ws, met.faceNormalWS));
    }
    path.radiance = sanitize(path.radiance);
    return path;
}

void main() {
    uint index = listedRay();
    if (index >= rays.header.rayCount)
        return;
    PixelRays from = loadPixelRays(index);
    bool mirror = isOn(kRaysMirror) || from.perceptualRoughness < kMirrorRoughness;
    uint samples = mirror && settings.bounces == 1u ? 1u : settings.samples; // all the same
    vec4 sum = vec4(0.0); // weighted radiance, weight of what is known
    float weights = 0.0;
    RayRecord record = RayRecord(from.uv, 0.0, 0u, kOutcomeSky);
    float hits = 0.0;
    for (uint i = 0u; i < samples; ++i) {
        Direction first = samplePixel(from, i);
        if (first.weight <= 0.0 && i + 1u == samples && weights == 0.0 && !isOn(kRaysAccumulate))
            first = Direction(reflect(-from.V, from.N), 1.0); // all went below: the middle of the lobe stands for it
        if (first.weight <= 0.0)
            continue;
        weights += first.weight;
        Path path = followPath(from.originWS, first.ws, from.cone, from.px, sampleNumber(i));
        sum += first.weight * path.weight * vec4(path.radiance, 1.0);
        record.lookups += path.rays;
        if (path.hit) {
            record.hitDistance += path.hitDistance;
            hits += 1.0;
            if (record.outcome != kOutcomeHit)
                record.hitUV = projectedUV(path.hitWS);
            record.outcome = kOutcomeHit;
        }
    }
    record.hitDistance /= max(hits, 1.0);
    if (isOn(kRaysAccumulate)) {
        sum += imageLoad(raysSum, from.px);
        weights += imageLoad(raysWeights, from.px).r;
        imageStore(raysSum, from.px, sum);
        imageStore(raysWeights, from.px, vec4(weights));
    }
    vec4 answer = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / weights) : vec4(0.0);
    imageStore(raysRadianceWeight, from.px, vec4(sanitize(answer.rgb), answer.a));
    imageStore(raysRecord, from.px, uvec4(packRayRecord(record), 0u, 0u));
}
