// A path of rays through the host's triangles: what it hits adds its light, and it continues from there for up to
// rays.bounces bounces. What its last surface reflects is estimated: rays/path_end.glsl. Include after the ray seam and
// rays_inputs.glsl.
#ifndef GLINT_RAYS_PATH_GLSL
#define GLINT_RAYS_PATH_GLSL

#include "rays/hit_lighting.glsl"
#include "rays/light_sampling.glsl"
#include "rays/lit_surface.glsl"
#include "rays/met_coat.glsl"
#include "rays/pixel_rays.glsl"
#include "rays/regularization.glsl"
#include "rays/transparents.glsl"
#ifndef GLINT_RAYS_TABLE_LIGHT // hits are lit from the host's table only
#include "rays/shown_surface.glsl"
#endif

/// Paths with less throughput end: half of what an 8-bit image can show.
const float kLeastThroughput = 1.0 / 512.0;

/// Where a mirror's path went on from a rough surface, which is where its noise begins (lib/mirrored.glsl).
struct Branch {
    bool exists;
    vec3 exact; // radiance found until then
    vec3 share; // throughput from there on
    vec3 normalWS;
    float perceptualRoughness;
    vec3 directionWS;
    float weight;      // of that direction, 1 on average: the path has it in its throughput, the share has not
    float meanWeight;  // meanLobeWeight
    float width;       // metres, of the cone
    float endDistance; // metres from there to what the path met next; 0: nothing
};

const Branch kNoBranch = Branch(false, vec3(0.0), vec3(1.0), vec3(0.0), 0.0, vec3(0.0), 0.0, 1.0, 0.0, 0.0);

struct Path {
    vec3 radiance;
    vec3 lights;       // that rays to lights found from the surface whose light is averaged, weighted
    float weight;      // 0: the path's radiance is unknown
    float hitDistance; // metres, of the first ray
    vec3 hitWS;
    Hit first;   // the first ray's hit, if it was traced
    bool hit;    // the first ray hit a surface
    uint rays;   // rays traced, without shadow rays
    uint reused; // hits lit from the frame's colour

    // how the path continues
    bool ended;
    bool isLastRay;   // its end is estimated: rays/path_end.glsl
    uint lastRays;
    vec3 environment; // weighted, of a last ray that meets nothing
    vec3 throughput;
    Ray ray;
    LobeVertex vertex; // where the ray starts
    float density;     // over solid angle, of the ray's direction; 0: no other ray finds the light there
    Cone cone;
    PathSpread spread;
    float regularization; // fraction of the spread by which hits are blurred
    Medium medium;
    uint transparents; // transparent surfaces that it may still pass through
    Branch branch;
    bool splits; // at its branch, for the denoiser
    bool isAveraged; // by the denoiser, what it finds from now on: lights may share shadow rays
};

uint mostTransparents() {
    return isOn(kRaysTransparents) ? settings.transparents : 0u;
}

/// Angle of the part of a surface's lobe that a direction drawn from the lobe stands for, radians; 0: a mirror. With
/// kRaysCone the mirror direction stands for all of it.
float drawnAngle(vec3 N, vec3 V, vec3 directionWS, float perceptualRoughness) {
    if (isOn(kRaysCone))
        return lobeAngle(perceptualRoughness);
    float angle = sampledAngle(sampledRoughness(perceptualRoughness), N, normalizeOr(V + directionWS, N));
    return min(angle, asin(saturate(dot(N, directionWS)))); // no part of a lobe reaches below the horizon
}

/// How a surface's curvature spreads a path. A cone stands for a whole lobe, which curvature stretches in one direction: as
/// wide in both, it would reach lights that no direction of the lobe finds.
float spreadingBend(float bend) {
    return isOn(kRaysCone) ? 0.0 : bend;
}

/// `angle`: drawnAngle of the direction.
Path startPath(vec3 originWS, vec3 directionWS, Cone cone, float angle, float regularization) {
    Path path;
    path.radiance = vec3(0.0);
    path.lights = vec3(0.0);
    path.weight = 1.0;
    path.hitDistance = 0.0;
    path.hitWS = originWS;
    path.ray = viewRay(originWS, directionWS);
    path.first = missOf(path.ray);
    path.hit = false;
    path.rays = 0u;
    path.reused = 0u;
    path.ended = false;
    path.isLastRay = false;
    path.lastRays = 0u;
    path.environment = vec3(0.0);
    path.throughput = vec3(1.0);
    path.vertex = kNoVertex;
    path.density = 0.0;
    path.cone = cone;
    path.spread = PathSpread(0.0, angle);
    path.regularization = regularization;
    path.medium = kAir;
    path.transparents = mostTransparents();
    path.branch = kNoBranch;
    path.splits = false;
    path.isAveraged = false;
    return path;
}

/// `ownRoughness`: before regularization. `emissionWeight`: fraction of the emission that the path counts.
LitSurface litSurface(HitSurface met, MaterialSample m, float ownRoughness, Lighting lighting, vec3 V,
                      float emissionWeight) {
    LitSurface lit;
    lit.positionWS = met.point.positionWS;
    lit.faceNormalWS = met.faceNormalWS;
    lit.normalWS = m.normalWS;
    lit.perceptualRoughness = ownRoughness;
    lit.lobeRoughness = m.perceptualRoughness;
    lit.bend = met.bend;
    lit.own = lighting.diffuse + lighting.directSpecular + emissionWeight * lighting.emission;
    float coat = m.clearcoat > 0.0 ? coatReflectance(m, V) : 0.0;
    lit.response =
        specularResponse(m.f0, m.f90, loadDfg(clampedNoV(m.normalWS, V), m.perceptualRoughness)) * (1.0 - coat);
    lit.environmentSpecular = lighting.environmentSpecular;
    lit.reflectsApart = true;
    return lit;
}

/// Draws the lobe from which a path goes on where it meets a clear coat.
float coatNoise(ivec2 px, uint sampleIndex, uint bounce) {
    return laterBounceNoise(px, sampleIndex, bounce, frame.constants.seed ^ 0x51ed270bu).x;
}

/// The same surface with its clear coat, if it has one: one lobe of the two. `ownRoughness`: the coat's, before
/// regularization.
LitSurface coatedSurface(LitSurface lit, MaterialSample m, float ownRoughness, Lighting lighting, vec3 V, float noise) {
    if (m.clearcoat <= 0.0)
        return lit;
    MetCoat coat = MetCoat(m.clearcoatNormalWS, ownRoughness, m.clearcoatPerceptualRoughness, coatReflectance(m, V),
                           lighting.coatSpecular);
    return oneLobe(lit, coat, !isOn(kRaysMirror), noise);
}

/// Sends a ray from a surface that the path has met.
void continueFrom(LitSurface met, vec3 directionWS, inout Path path) {
    float offset = settings.tMin > 0.0 ? 0.0 : hitUncertainty(met.positionWS);
    path.ray = viewRay(met.positionWS + met.faceNormalWS * offset, aboveSurface(directionWS, met.faceNormalWS));
    if (path.medium.body != kNoInstance && path.transparents > 0u)
        path.ray.flags &= ~kRayCullBackFaces;
}

#include "rays/path_end.glsl"

/// True if a frame shows the hit and its light there may be taken: `shown`. `spread`: of regularized(). `noise`: for
/// clear coats.
bool isShown(Hit hit, HitSurface met, float spread, float noise, inout Path path, out LitSurface shown) {
#ifndef GLINT_RAYS_TABLE_LIGHT
    vec3 before;
    Surface there;
    if (path.isLastRay && wasShown(met.point.positionWS, met.faceNormalWS, there, before) &&
        !goesOn(path, vec3(there.reflectivity), there.perceptualRoughness)) {
        ++path.reused;
        shown = knownSurface(before);
        return true;
    }
    if (isOn(kRaysReuseLight) && !isSampledEmitter(hit.instance, path.density)) {
        ivec2 px = pixelThatShows(met.point.positionWS, met.faceNormalWS, path.ray.directionWS, path.cone.width);
        if (px.x >= 0) {
            ++path.reused;
            shown = shownSurface(px, met.point.positionWS, met.faceNormalWS, path.ray.directionWS, path.regularization,
                                 spread);
            shown.bend = met.bend;
            shown = shownCoated(shown, px, path.ray.directionWS, path.regularization, spread, noise);
            return true;
        }
    }
#endif
    return false;
}

/// Mean of sampleLobe's weights over the lobe: the part of a surface's response that its facets leave. A path multiplies by
/// the response, and by a direction's weight over this mean, so that directions which facets hinder count for less.
float meanLobeWeight(vec3 N, vec3 V, float perceptualRoughness) {
    vec2 dfg = loadDfg(clampedNoV(N, V), perceptualRoughness);
    return max(dfg.x + dfg.y, 1e-3);
}

/// Adds the light of the surface that bounce number `bounce` hit, and continues from there while bounces remain.
void leaveSurface(LitSurface met, uint bounce, ivec2 px, uint sampleIndex, inout Path path) {
    vec3 V = -path.ray.directionWS;
    path.radiance += path.throughput * met.own;
    bool last = bounce + 1u >= settings.bounces || met.perceptualRoughness > settings.maxRoughness;
    if (!last && maxComponent(path.throughput * met.response) < kLeastThroughput) {
        if (isOn(kRaysAccumulate) && !survives(met, px, sampleIndex, bounce, path))
            return;
        last = !isOn(kRaysAccumulate);
    }
    if (last) {
        path.ended = true;
        endPath(met, path);
        return;
    }
    float roughness = sampledRoughness(met.lobeRoughness);
    Direction next =
        sampleLobe(met.normalWS, V, roughness, laterBounceNoise(px, sampleIndex, bounce, frame.constants.seed));
    bool isBelow = next.weight <= 0.0; // the surface; neighbours take nothing from there
    vec3 onwardWS = isBelow ? -met.normalWS : next.ws;
    float meanWeight = roughness > 0.0 ? meanLobeWeight(met.normalWS, V, met.lobeRoughness) : 1.0;
    float weight = next.weight / meanWeight;
    path.throughput *= met.response;
    bool branches = bounce == 0u && path.transparents == mostTransparents() && roughness > 0.0;
    if (branches) {
        path.branch = kNoBranch;
        path.branch.exists = true;
        path.branch.exact = path.radiance;
        path.branch.share = path.throughput;
        path.branch.normalWS = met.normalWS;
        path.branch.perceptualRoughness = met.lobeRoughness;
        path.branch.directionWS = onwardWS;
        path.branch.weight = weight;
        path.branch.meanWeight = meanWeight;
        path.branch.width = path.cone.width;
    }
    path.isAveraged = path.isAveraged || (path.splits && branches);
    path.density = 0.0;
    bool skyApart = path.splits && branches && samplesSky(met.lobeRoughness);
    if ((skyApart || samplesLights(met.lobeRoughness)) && path.medium.body == kNoInstance) {
        LobeFrame lobe = makeLobeFrame(met.normalWS, V, met.lobeRoughness);
        path.vertex = LobeVertex(true, lobe, met.faceNormalWS, kLeastCosine, skyApart, path.throughput / meanWeight);
        if (dot(next.ws, met.faceNormalWS) >= kLeastCosine)
            path.density = lobeDensity(lobe.wo, next.ws * lobe.axes, lobe.alpha);
    }
    path.ended = isBelow;
    path.throughput *= weight;
    path.spread =
        reflected(path.spread, spreadingBend(met.bend), drawnAngle(met.normalWS, V, next.ws, met.lobeRoughness));
    continueFrom(met, next.ws, path);
}

/// Fraction of a path's spread by which the environment is blurred where the path ends: as the part of the lobe shrinks
/// that one of the averaged samples stands for, of which the denoiser's neighbours bring some in each frame. The cube's
/// kernels have long tails, by which more blur would bring light from far outside of that part. A cone stands for its whole
/// lobe in every sample.
float missBlur(float regularization) {
    if (isOn(kRaysCone))
        return regularization;
    float first = max(settings.regularization, 1e-6);
    float alone = regularization * square(regularization / first); // count^(-1/6), cubed
    return alone * inversesqrt(1.0 + float(frame.settings.denoise.reuseSamples));
}

/// The roughness at which the cube is looked up, for a blur of this one. Between a mirror and the first mip the mip's share
/// is by the square of alpha: in proportion to the roughness its long tail would be in every lookup.
float missRoughness(float perceptualRoughness) {
    float first = 1.0 / max(frame.constants.environmentMips - 1.0, 1.0);
    float part = perceptualRoughness / first;
    return part < 1.0 ? first * square(square(part)) : perceptualRoughness;
}

void leaveScene(uint bounce, inout Path path) {
    path.ended = true;
    if (path.isLastRay) {
        path.radiance += path.environment;
        return;
    }
    float spread = path.density > 0.0 ? 0.0 : 0.5 * path.spread.angle; // sampled well: no fireflies
    if (isOn(kRaysEnvironment))
        path.radiance +=
            path.throughput * environmentShare(path.ray.directionWS, path.density) *
            loadEnvironmentRadiance(path.ray.directionWS,
                                    missRoughness(regularized(0.0, missBlur(path.regularization), spread)));
    else if (!path.hit)
        path.weight = 0.0;
}

void meetFirst(vec3 hitWS, Hit hit, inout Path path) {
    path.hit = true;
    path.first = hit;
    path.hitDistance = hit.distance;
    path.hitWS = hitWS;
}

/// Adds the light of a transparent surface and continues behind it.
void passTransparent(Hit hit, HitSurface met, Passage p, inout Path path) {
    if (!path.hit)
        meetFirst(met.point.positionWS, hit, path);
    path.radiance += path.throughput * p.own;
    path.throughput *= p.through;
    path.ended = maxComponent(path.throughput) < kLeastThroughput;
    path.medium = p.medium;
    path.density = 0.0; // rays to lights stop at transparent surfaces
    --path.transparents;
    path.cone.spread += p.power * met.bend * path.cone.width;
    path.spread.angle =
        length(vec2(path.spread.angle + p.power * met.bend * path.spread.width, p.power * lobeAngle(p.lobeRoughness)));
    float offset = hitUncertainty(met.point.positionWS);
    path.ray = viewRay(met.point.positionWS + met.faceNormalWS * (p.isReflected ? offset : -offset), p.directionWS);
    if (path.medium.body != kNoInstance && path.transparents > 0u)
        path.ray.flags &= ~kRayCullBackFaces; // to hit the body's far side
}

/// The next surface that the path meets, transparent ones included while the path may pass through more of them.
Hit traceSegment(inout Path path, out bool transparent) {
    rayMeetsTransparents = path.transparents > 0u;
    Hit hit = traceRay(path.ray);
    ++path.rays;
    bool met = isHit(hit);
    transparent = met && rayMeetsTransparents && isTransparent(instanceMaterial(hit.instance));
    rayMeetsTransparents = false;
    path.throughput *= mediumTransmittance(path.medium, hit.distance, met && hit.instance == path.medium.body);
    if (met) {
        path.cone.width += path.cone.spread * hit.distance;
        path.spread = travelled(path.spread, hit.distance);
    }
    return hit;
}

/// Sends rays to lights from the path's vertex.
void addLights(uint bounce, ivec2 px, uint sampleIndex, inout Path path) {
    vec3 found = sampleLights(path.vertex, path.ray, path.cone, path.transparents > 0u, px, sampleIndex, bounce);
    if (path.vertex.isAveraged)
        path.lights += found;
    else
        path.radiance += path.vertex.throughput * found;
    path.vertex.sendsRays = false;
}

/// Lights the surface that a ray has hit. True if the path has passed through it; otherwise `lit` is what it left.
/// Opaque and transparent surfaces share one copy of the code that samples materials and lights: it is most of the
/// program, and drivers inline every call.
bool meetSurface(Hit hit, bool transparent, uint bounce, ivec2 px, uint sampleIndex, inout Path path,
                 out LitSurface lit) {
    vec3 directionWS = path.ray.directionWS;
    HitSurface met =
        hitSurface(hit.instance, hit.primitive, hit.barycentrics, hit.frontFace, directionWS, path.cone.width);
    float spread = halfVectorSpread(path.spread, spreadingBend(met.bend));
    float lobeNoise = coatNoise(px, sampleIndex, bounce);
    if (!transparent && isShown(hit, met, spread, lobeNoise, path, lit))
        return false;
    MaterialSample m = sampleMaterial(met.material, met.point);
    float ownRoughness = m.perceptualRoughness;
    float coatRoughness = m.clearcoatPerceptualRoughness;
    vec2 noise = laterBounceNoise(px, sampleIndex, bounce, ~frame.constants.seed - path.transparents);
    if (transparent && path.medium.body == hit.instance && !hit.frontFace) {
        passTransparent(hit, met, leaveBody(met, m, path.medium, directionWS, noise), path);
        return true;
    }
    m.perceptualRoughness = regularized(ownRoughness, path.regularization, spread);
    m.clearcoatPerceptualRoughness = regularized(m.clearcoatPerceptualRoughness, path.regularization, spread);
    litFaceNormalWS = met.faceNormalWS;
    lightDraw = LightDraw(path.isAveraged ? settings.lightsTogether : 1u, px, sampleIndex * 8u + bounce);
    Lighting lighting = lightSurface(m, met.point, -directionWS);
    if (transparent) {
        passTransparent(
            hit, met, passSurface(met, m, ownRoughness, lighting, hit.instance, path.medium, directionWS, noise), path);
        return true;
    }
    lit = litSurface(met, m, ownRoughness, lighting, -directionWS, emissionShare(hit, met, directionWS, path.density));
    lit = coatedSurface(lit, m, coatRoughness, lighting, -directionWS, lobeNoise);
    return false;
}

/// `bounce`: number of surfaces that the path has hit already, without those that it passed through.
void followPath(uint bounce, ivec2 px, uint sampleIndex, inout Path path) {
    while (bounce < settings.bounces || path.isLastRay) {
        if (path.vertex.sendsRays)
            addLights(bounce, px, sampleIndex, path);
        if (path.ended)
            return;
        bool transparent;
        Hit hit = traceSegment(path, transparent);
        if (!isHit(hit)) {
            leaveScene(bounce, path);
            return;
        }
        if (bounce == 1u && path.branch.endDistance == 0.0)
            path.branch.endDistance = hit.distance;
        LitSurface met;
        if (meetSurface(hit, transparent, bounce, px, sampleIndex, path, met))
            continue;
        if (path.isLastRay) {
            endAt(met, path);
            continue;
        }
        if (!path.hit)
            meetFirst(met.positionWS, hit, path);
        leaveSurface(met, bounce, px, sampleIndex, path);
        ++bounce;
    }
}

#endif
