// How a path ends that is cut: the one estimate of what its last surface reflects. A last ray in that surface's mirror
// direction (rays.environmentOcclusion), whatever its roughness, so that it brings no noise, tells what is there:
//
//   nothing                            the environment, as in the host's own frames
//   what the previous frame shows      its radiance there, which has reflections in it: frames add bounces
//   something else                     its own light, and a guess at what it reflects (unfollowed)
//
// A mirror that brings much light looks to the ray as it does not to the eye: from there, another last ray goes on. Nothing
// is black for want of bounces, and nothing shines through what hides it. Included by path.glsl.
#ifndef GLINT_RAYS_PATH_END_GLSL
#define GLINT_RAYS_PATH_END_GLSL

/// What a surface reflects in a direction that no ray follows, at the end of a path all of whose `rays` have met something.
/// That none left makes it likely that the next meets something too: one in rays + 2 leaves (the rule of succession;
/// Laplace 1774). What leaves brings the environment around the mirror direction, but no more than its mean over the
/// hemisphere, so that no sun shines through what may hide it. What does not brings what the previous frame shows near
/// there; without such a frame, what reflects alike, and so on: a geometric series. White surfaces lose nothing.
vec3 unfollowed(LitSurface met, vec3 directionWS, uint rays) {
    const float kLeastRoughness = 0.5;
    float open = 1.0 / (float(rays) + 2.0);
    vec3 mirroredWS = reflect(directionWS, met.normalWS);
    vec3 around = min(loadEnvironmentRadiance(mirroredWS, max(met.lobeRoughness, kLeastRoughness)),
                      loadEnvironmentRadiance(mirroredWS, 1.0));
#ifndef GLINT_RAYS_TABLE_LIGHT
    vec3 near;
    if (shownNearest(met.positionWS, near))
        return met.response * mix(near, around, open);
#endif
    return met.response * around * open / (1.0 - (1.0 - open) * min(met.response, vec3(1.0)));
}

/// As many last rays has a path, and less throughput has none after the first: most of what is left is known by then.
const uint kMostLastRays = 8u;
const float kLeastToGoOn = 1.0 / 32.0;

/// True if another last ray goes on from a surface. `response`: its own, as far as known.
bool goesOn(Path path, vec3 response, float perceptualRoughness) {
    return path.lastRays < kMostLastRays && perceptualRoughness < settings.reuseRoughness &&
           maxComponent(path.throughput * response) >= kLeastToGoOn;
}

void sendLastRay(LitSurface met, inout Path path) {
    path.ended = false;
    path.isLastRay = true;
    ++path.lastRays;
    path.environment = path.throughput * met.environmentSpecular;
    path.throughput *= met.response;
    path.density = 0.0;
    path.medium = kAir; // transparent surfaces hide nothing
    path.transparents = 0u;
    continueFrom(met, reflect(path.ray.directionWS, met.normalWS), path);
}

/// Ends a path at its last surface. Without the last ray, and where that would bring less than can be seen, the environment
/// counts as it is.
void endPath(LitSurface met, inout Path path) {
    float most = maxComponent(path.throughput * max(met.response, met.environmentSpecular));
    if (isOn(kRaysEnvironmentOcclusion) && most >= kLeastThroughput && met.reflectsApart)
        sendLastRay(met, path);
    else
        path.radiance += path.throughput * met.environmentSpecular;
}

/// Ends a last ray at what it has met.
void endAt(LitSurface met, inout Path path) {
    path.radiance += path.throughput * met.own;
    path.isLastRay = false;
    path.ended = true;
    if (!met.reflectsApart)
        return;
    if (goesOn(path, met.response, met.perceptualRoughness))
        sendLastRay(met, path);
    else
        path.radiance += path.throughput * unfollowed(met, path.ray.directionWS, path.rays);
}

/// Russian roulette of a path that has little throughput left, where a mean over frames is the truth: it goes on, with
/// more weight, or ends without a light. The mean stays the same. Arvo and Kirk 1990, "Particle Transport and Image
/// Synthesis".
bool survives(LitSurface met, ivec2 px, uint sampleIndex, uint bounce, inout Path path) {
    const uint kRouletteSeed = 0x3c6ef372u; // apart from those of the path's other draws
    float chance = maxComponent(path.throughput * met.response) / kLeastThroughput;
    float noise = laterBounceNoise(px, sampleIndex, bounce, frame.constants.seed ^ kRouletteSeed).x;
    path.ended = noise >= chance;
    if (!path.ended)
        path.throughput /= chance;
    return !path.ended;
}

#endif
