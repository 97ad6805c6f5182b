// Traces one ray of the list: its start, the marcher's walk, and the weight of its end. A marcher is a file of
// trace/march: it includes trace/ray_inputs.glsl, defines `March march(Ray)`, and includes this file at its end.
#include "generate/sampled_ray.glsl"
#include "lib/fades.glsl"
#include "lib/noise.glsl"
#include "lib/trace_pixel.glsl"
#include "trace/behind_hidden.glsl"
#include "trace/hit_color.glsl"
#include "trace/infer_border.glsl"
#include "trace/certainty.glsl"
#define GLINT_READ_TRACED
#include "trace/traced.glsl"

layout(local_size_x = 64) in; // kRaysPerGroup

layout(scalar, set = 0, binding = 10) readonly buffer RaysBlock {
    RayListHeader header;
    uint pixels[]; // of the traced image
}
rays;

float hitWeight(March end, vec2 hitUV, float hitDistance, Ray ray, float perceptualRoughness, float VoR) {
    float weight = logFade(kLoggedRoughness,
                           fadeRoughness(perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness));
    if (isOn(kFadeBorderSmooth))
        weight *= logFade(kLoggedBorderSmooth, fadeBorderSmooth(hitUV));
    if (isOn(kFadeBorderLinear))
        weight *= logFade(kLoggedBorderLinear, fadeBorderLinear(hitUV, settings.borderWidth));
    if (isOn(kFadeDistance))
        weight *= logFade(kLoggedDistance, fadeDistance(hitDistance, settings.maxDistance));
    if (isOn(kFadeIterations))
        weight *= logFade(kLoggedIterations, fadeIterations(float(end.iterations), float(settings.maxSteps)));
    if (isOn(kFadeFacingCamera))
        weight *= logFade(kLoggedFacingCamera, fadeFacingCamera(VoR));
    if (end.outcome == kOutcomeInferred)
        weight *= logFade(kLoggedInferred, settings.inferredWeight * end.evidence);
    if (isOn(kFadeBackface)) {
        vec3 hitNormalVS = loadSceneNormalVS(ivec2(end.hitPX));
        weight *= logFade(kLoggedBackface, fadeBackface(dot(hitNormalVS, -ray.directionVS)));
    }
    return weight;
}

vec3 jitter(vec3 directionVS, ivec2 px, Surface origin) {
    vec3 noise = hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed) - 0.5;
    vec3 jittered = normalize(directionVS + noise * origin.perceptualRoughness * settings.roughnessFactor);
    return dot(jittered, origin.normalVS) > 0.0 ? jittered : directionVS;
}

/// The picture does not show where a ray enters an unseen side of a transparent body. So much of the answer is what the
/// picture shows beside, the rest what lies behind the body. More would go around in circles where a pane meets a
/// mirror: the pane shows the mirror, which shows the pane.
const float kUnseenSide = 0.5;

/// True if a hit on a transparent surface comes before what the ray met among the frame's surfaces, and the previous
/// frame showed it. Adds to `record` that march's lookups.
bool meetsFirst(ivec2 tracePX, inout RayRecord record, inout March end, out vec3 radiance) {
    RayRecord solid = unpackRayRecord(imageLoad(rayRecord, tracePX).xy);
    end.lookups += solid.lookups;
    record.uncertain = record.uncertain || solid.uncertain;
    radiance = vec3(0.0);
    vec2 shownPX;
    bool nearer = !isAnswered(solid.outcome) || record.hitDistance < solid.hitDistance;
    return nearer && hasHistory(frame.constants) && previousRadiance(floorToInt(end.hitPX), radiance, shownPX);
}

/// True if a ray at `rayZ` is seen to both sides of what hides it at `px`, no farther off than it is behind that: a
/// body is taken to be as thick as it is wide.
bool passesThin(ivec2 px, float hidingZ, float rayZ) {
    float behind = (rayZ - hidingZ) / pixelExtent(frame.constants, frame.constants.uvToView, hidingZ).y;
    float most = min(max(behind, 2.0), 0.25 * frame.constants.size.y);
    for (float reach = 2.0; reach <= most; reach *= 2.0)
        for (int axis = 0; axis < 2; ++axis) {
            ivec2 offset = axis == 0 ? ivec2(int(reach), 0) : ivec2(0, int(reach));
            ivec2 low = px - offset;
            ivec2 high = px + offset;
            if (all(greaterThanEqual(low, ivec2(0))) && all(lessThan(high, ivec2(frame.constants.size))) &&
                texelFetch(metViewZ, low, 0).r >= rayZ && texelFetch(metViewZ, high, 0).r >= rayZ)
                return true;
        }
    return false;
}

/// Weight of an answer by what the ray passed behind before.
float behindHidden(Ray ray, March end, vec3 radiance) {
    float weight = 1.0;
#ifndef GLINT_ONE_TEXEL_A_HIT
    if (!end.passedBehind || end.firstBehind >= end.share || isOn(kTraceBackDepth))
        return weight;
    const int kPlaces = 6;
    for (int i = 0; i < kPlaces; ++i) {
        float share = mix(end.firstBehind, end.share, float(i) / float(kPlaces));
        ivec2 px = floorToInt(ray.screen.startPX + ray.screen.deltaPX * share);
        float hidingZ = texelFetch(metViewZ, px, 0).r;
        float rayZ = rayViewZ(ray.screen, share);
        if (hidingZ >= rayZ || passesThin(px, hidingZ, rayZ))
            continue;
        float roughness = unpackSurface(texelFetch(metSurface, px, 0).xy).perceptualRoughness;
        weight = min(weight, weightBehind(meanComponent(radiance), meanComponent(shownRadiance(px, roughness))));
    }
#endif
    return weight;
}

/// What a marcher's end leaves open: which surface covers a hit's place beside a crease, and what a ray without an answer
/// may have crossed unseen. The marcher `proxy` does not march.
void refineEnd(Ray ray, inout March end) {
#ifndef GLINT_ONE_TEXEL_A_HIT
    if (end.outcome == kOutcomeHit)
        moveOverCrease(ray, end);
    if (kAmongTransparents || settings.inferredWeight <= 0.0)
        return;
    if (!isAnswered(end.outcome) && end.firstBehind < end.share)
        inferCrossing(ray, end);
    bool fadesAtBorder = isOn(kFadeBorderSmooth) || isOn(kFadeBorderLinear); // to nothing
    if (end.outcome == kOutcomeOffScreen && !fadesAtBorder)
        inferBeyondBorder(ray, end);
#endif
}

/// True if the answer's weight follows from how certain it is. The marcher `proxy` does not march.
bool judgesAnswers() {
#ifdef GLINT_ONE_TEXEL_A_HIT
    return false;
#else
    return !kAmongTransparents && (isOn(kTraceUncertain) || isOn(kTraceCertainty));
#endif
}

/// Lets the weight of an answer follow from how certain it is. `record`: rays through the scene may take its place.
void weighAnswer(Ray ray, Surface origin, LobeCone cone, inout March end, inout RayRecord record, inout vec4 answer) {
    // Over many rays of a lobe, in a cone's mean or in a blur, hits that are wrong by a pixel make up for each other. Nor does
    // the mean depend on other answers that may be wrong by less than the cone's width.
    bool anyAverage = isOn(kTraceLobe) || frame.settings.blur.strength > 0.0;
    bool averaged = anyAverage && !isMirror(origin.perceptualRoughness);
    vec3 hitVS = ray.originVS + ray.directionVS * record.hitDistance;
    float radius = cone.alpha > 0.0 ? coneRadius(cone, hitVS, record.hitDistance) : 0.0;
    Certainty certainty = certaintyOf(ray, end, answer.rgb, averaged || blurredShare(radius) >= 1.0);
    float weight = certainWeight(ray, certainty, answer.rgb, origin.perceptualRoughness);
    if (averaged && end.outcome == kOutcomeHit)
        weight = 1.0;
    weight = mix(weight, 1.0, blurredShare(radius / max(certainty.reach, 1.0)));
    if (isOn(kTraceUncertain)) {
        answer.a *= logFade(kLoggedUncertain, weight);
        record.uncertain = record.uncertain || (certainty.known && certainty.right < kCertain);
    }
    if (isOn(kTraceCertainty))
        answer = vec4(float(certainty.kind), certainty.right, weight, 1.0);
}

void main() {
    uint index =
        gl_WorkGroupID.y * (kRayGroupsX * kRaysPerGroup) + gl_WorkGroupID.x * kRaysPerGroup + gl_LocalInvocationIndex;
    if (index >= rays.header.rayCount)
        return;
    ivec2 tracePX = ivec2(rays.pixels[index] & 0xffffu, rays.pixels[index] >> 16);
    ivec2 px = tracePixelToFull(frame.constants, tracePX);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    Surface origin = unpackSurface(texelFetch(surface, px, 0).xy);
    PixelRay generated = generateRay(uv, texelFetch(viewZ, px, 0).r, origin);

    Ray ray;
    ray.px = px;
    ray.originVS = generated.originVS;
    ray.originNormalVS = origin.normalVS;
    ray.directionVS = generated.directionVS;
    if (isOn(kTraceLobe) && !isMirror(origin.perceptualRoughness)) {
        Direction sampled = sampledDirection(px, ray.originVS, origin);
        if (sampled.weight > 0.0)
            ray.directionVS = normalize(mat3(frame.constants.worldToView) * sampled.ws);
    } else if (settings.roughnessFactor > 0.0)
        ray.directionVS = jitter(ray.directionVS, px, origin);
    ray.screen = makeScreenRay(frame.constants, ray.originVS, ray.directionVS, settings.maxDistance);
    March end = march(ray);
    refineEnd(ray, end);

    bool hit = isAnswered(end.outcome);
    vec2 endPX = hit ? end.hitPX : ray.screen.startPX + ray.screen.deltaPX * end.share;
    RayRecord record;
    record.hitUV = clamp(endPX * frame.constants.invSize, vec2(0.0), vec2(1.0));
    record.hitDistance = rayDistance(ray.screen, end.share);
    record.outcome = end.outcome;
    record.uncertain = end.passedBehind;

    vec4 answer = vec4(0.0);
    if (kAmongTransparents && !(hit && meetsFirst(tracePX, record, end, answer.rgb)))
        return; // the answer of the march among the frame's surfaces remains
    if (hit) {
        float VoR = dot(-viewDirection(frame.constants, ray.originVS), ray.directionVS);
        float trust = 1.0;
        LobeCone cone = makeCone(ray.directionVS, origin.normalVS, origin.perceptualRoughness);
        if (!kAmongTransparents) {
            // Many rays of a wide lobe meet one pixel: its mean has all of their light, thin lamps' too. A mirror shows each
            // pixel by itself, and a ray from beside meets a part of the surface that the eye does not see.
            bool mayTakeMean = end.outcome == kOutcomeHit && !isMirror(origin.perceptualRoughness);
            vec3 hitVS = ray.originVS + ray.directionVS * record.hitDistance;
            bool blursLater = cone.alpha > 0.0 && !isOn(kTraceConesAtHits); // resolve/lobe
            LobeCone atHit = cone;
            atHit.alpha = blursLater ? 0.0 : cone.alpha;
            answer.rgb = hitRadiance(end.hitPX, mayTakeMean, ray.originVS, hitVS, atHit, end.lookups);
            if (blursLater)
                trust = behindHidden(ray, end, answer.rgb);
        }
        answer.a = trust * hitWeight(end, record.hitUV, record.hitDistance, ray, origin.perceptualRoughness, VoR);
        if (judgesAnswers())
            weighAnswer(ray, origin, cone, end, record, answer);
    }
    if (kAmongTransparents && end.outcome == kOutcomeSide)
        answer = mix(loadTraced(tracePX), answer, kUnseenSide);
    record.lookups = end.lookups;
    storeTraced(tracePX, answer.rgb, answer.a, record);
    logRay(ray, end, endPX, record, hit, answer);
}
