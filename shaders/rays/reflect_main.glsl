// The source `rays`: what the listed pixels reflect, by rays through the host's triangles. A ray that meets a surface
// brings its light, and goes on from there while rays.bounces lasts; the last surface reflects the environment, as the
// host's own pictures of it do. docs/techniques/rays.md.
#include "lib/camera.glsl"
#include "lib/color.glsl"
#include "lib/ray_record.glsl"
#include "lib/sampling.glsl"
#include "rays/hit_lighting.glsl"
#include "rays/ray_noise.glsl"

layout(local_size_x = 64) in; // kRaysPerGroup

layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D raysRadianceWeight;
layout(set = 0, binding = 8, rg32ui) uniform writeonly uimage2D raysRecord;
layout(set = 0, binding = 11, rgba32f) uniform image2D raysSum;  // kRaysAccumulate: over all samples so far, weighted
layout(set = 0, binding = 12, r32f) uniform image2D raysWeights; // radiance and weight of what is known; weight

/// Less is no longer followed: half of what an 8-bit picture can show.
const float kLeastThroughput = 1.0 / 512.0;

/// Below, a lobe is narrower than a pixel.
const float kMirrorRoughness = 0.001;

// ---------------------------------------------------------------- directions

struct Direction {
    vec3 ws;      // unit
    float weight; // share of the light from there that leaves the facets; 0: below the surface
};

/// One of the directions that reflect to `V`, with the density of visible normals.
Direction sampleReflection(vec3 N, vec3 V, float perceptualRoughness, vec2 noise) {
    if (isOn(kRaysMirror) || perceptualRoughness < kMirrorRoughness)
        return Direction(reflect(-V, N), 1.0);
    float alpha = square(perceptualRoughness);
    mat3 frameOfN = orthonormalBasis(N);
    vec3 wo = V * frameOfN;
    wo.z = max(wo.z, 1e-3); // a bent normal may look away
    wo = normalize(wo);
    vec3 wm = sampleGGXVisibleCap(wo, noise, alpha);
    vec3 wi = reflect(-wo, wm);
    if (wi.z <= 1e-4)
        return Direction(N, 0.0);
    return Direction(frameOfN * wi, visibleGGXWeight(wo.z, wi.z, alpha));
}

// ---------------------------------------------------------------- a path

/// A ray as wide as the pixel that it stands for. Akenine-Moller et al. 2021.
struct Cone {
    float width;  // metres, at the start
    float spread; // radians
};

struct Path {
    vec3 radiance;
    float weight;      // 0: nothing is known of where it leads
    float hitDistance; // metres, of its first ray
    vec3 hitWS;
    bool hit;  // its first ray met a surface
    uint rays; // that it took, those for shadows apart
};

Ray viewRay(vec3 originWS, vec3 directionWS) {
    return Ray(originWS, settings.tMin, directionWS, settings.tMax, settings.cullMask, viewRayFlags());
}

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

// ---------------------------------------------------------------- a pixel

/// Where a pixel's mirror ray goes, unit.
vec3 mirrorDirectionVS(ivec2 px) {
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    vec3 normalVS = unpackSurface(texelFetch(surface, px, 0).xy).normalVS;
    return reflect(viewDirection(frame.constants, viewPosition(frame.constants, uv, 1.0)), normalVS);
}

/// How far the neighbours' mirror rays part from this one: as much as the camera's do on a flat mirror, more on a bent
/// one. The smaller difference of both sides, as across an edge stands another surface. Radians, mean of both ways.
float reflectedSpread(ivec2 px) {
    ivec2 last = ivec2(frame.constants.size) - 1;
    vec3 here = mirrorDirectionVS(px);
    float sum = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        ivec2 step = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
        ivec2 before = px - step;
        ivec2 behind = px + step;
        if (any(lessThan(before, ivec2(0))))
            before = min(behind, last);
        if (any(greaterThan(behind, last)))
            behind = max(before, ivec2(0));
        sum += min(distance(mirrorDirectionVS(before), here), distance(mirrorDirectionVS(behind), here));
    }
    return 0.5 * sum;
}

Cone pixelCone(ivec2 px, float z) {
    float pixel = abs(frame.constants.uvToView.y) * frame.constants.invSize.y; // metres, at 1 m in perspective
    return Cone(isOrthographic(frame.constants) ? pixel : pixel * z, reflectedSpread(px));
}

vec2 projectedUV(vec3 positionWS) {
    vec3 positionVS = (frame.constants.worldToView * vec4(positionWS, 1.0)).xyz;
    vec4 pixelH = frame.constants.viewToPixel * vec4(positionVS, 1.0);
    return pixelH.w > 0.0 ? clamp(pixelH.xy / pixelH.w * frame.constants.invSize, 0.0, 1.0) : vec2(0.0);
}

void main() {
    uint index =
        gl_WorkGroupID.y * (kRayGroupsX * kRaysPerGroup) + gl_WorkGroupID.x * kRaysPerGroup + gl_LocalInvocationIndex;
    if (index >= rays.header.rayCount)
        return;
    ivec2 px = ivec2(rays.pixels[index] & 0xffffu, rays.pixels[index] >> 16);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    Surface origin = unpackSurface(texelFetch(surface, px, 0).xy);
    float z = texelFetch(viewZ, px, 0).r;
    vec3 positionVS = viewPosition(frame.constants, uv, z);
    mat3 toWorld = mat3(frame.constants.viewToWorld);
    vec3 V = -(toWorld * viewDirection(frame.constants, positionVS));
    vec3 N = toWorld * origin.normalVS;
    vec3 positionWS = (frame.constants.viewToWorld * vec4(positionVS, 1.0)).xyz;
    bool halfDepth = (frame.constants.flags & kInputHalfDepth) != 0u;
    float offset = settings.tMin > 0.0 ? 0.0 : depthUncertainty(positionWS, z, halfDepth);
    vec3 originWS = positionWS + N * offset;
    Cone cone = pixelCone(px, z);

    bool mirror = isOn(kRaysMirror) || origin.perceptualRoughness < kMirrorRoughness;
    uint samples = mirror && settings.bounces == 1u ? 1u : settings.samples; // all the same
    vec4 sum = vec4(0.0); // weighted radiance, weight of what is known
    float weights = 0.0;
    RayRecord record = RayRecord(uv, 0.0, 0u, kOutcomeSky);
    float hits = 0.0;
    for (uint i = 0u; i < samples; ++i) {
        uint sampleIndex = frame.constants.frameIndex * settings.samples + i;
        vec2 noise = firstBounceNoise(px, sampleIndex, frame.constants.seed);
        Direction first = sampleReflection(N, V, origin.perceptualRoughness, noise);
        if (first.weight <= 0.0 && i + 1u == samples && weights == 0.0 && !isOn(kRaysAccumulate))
            first = Direction(reflect(-V, N), 1.0); // every sample went below: the middle of the lobe stands for it
        if (first.weight <= 0.0)
            continue;
        weights += first.weight;
        Path path = followPath(originWS, first.ws, cone, px, sampleIndex);
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
        sum += imageLoad(raysSum, px);
        weights += imageLoad(raysWeights, px).r;
        imageStore(raysSum, px, sum);
        imageStore(raysWeights, px, vec4(weights));
    }
    vec4 answer = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / weights) : vec4(0.0);
    imageStore(raysRadianceWeight, px, vec4(sanitize(answer.rgb), answer.a));
    imageStore(raysRecord, px, uvec4(packRayRecord(record), 0u, 0u));
}
