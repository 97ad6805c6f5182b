// Upsamples the traced (or blurred) image to the frame's size.
//
// Where a reflection is sharp, the rays of the four nearest traced pixels give only the ray's length; the pixel's own
// position and normal give its direction. The pixel aims its own ray that far, and takes the colour there if the frame
// shows a surface at exactly that place. Mirrors stay as sharp as the frame, for two depth lookups a pixel instead of a
// march. Where cones (trace/cone.glsl) have already blurred the answers by more than lies between traced pixels, and
// everywhere else, a pixel mixes the four, each weighted by nearness and by surface similarity (Kopf et al. 2007,
// "Joint Bilateral Upsampling"). Pixels that were not traced do not count. Where none of the four shows the pixel's
// surface, the most similar traced pixel around is used alone.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "lib/color.glsl"
#include "lib/fades.glsl"
#include "shared/resolve_constants.h"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 4) uniform sampler2D traced; // radiance, not multiplied by weight
layout(set = 0, binding = 5) uniform sampler2D source; // the same, or blurred
layout(set = 0, binding = 9) uniform usampler2D rayRecord;
layout(set = 0, binding = 10, rgba16f) uniform writeonly image2D radianceWeight;
layout(scalar, set = 0, binding = 11) readonly buffer RaysBlock {
    RayListHeader header;
}
rayList;
layout(push_constant, scalar) uniform PushBlock {
    vec2 sourceSize; // pixels
};
TraceConstants settings = frame.settings.trace;
BlurConstants blur = frame.settings.blur;

#include "resolve/blur_radius.glsl"
#include "resolve/neighbourhood.glsl"
#include "trace/hit_color.glsl" // bindings 3, 6, 7, 8, 46

/// Below this similarity a pixel shows another surface.
const float kOtherSurface = 0.01;

/// Half of a wide lobe lies farther than this off its ray's hit, in distances between traced pixels.
const float kWideLobe = 0.5;
const float kWideFar = 2.0;

/// True if rays start from pixels of this surface.
bool reflects(Place here) {
    return !here.background && here.reflectivity > settings.threshold &&
           fadeRoughness(here.perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness) > 0.0;
}

struct Tap {
    vec4 premultiplied;
    float similarity; // to the surface of the target pixel; 0: not traced
    vec2 px;          // of the frame, whose surface it is
};

/// `known`: that is a traced pixel of the image, from which a ray started.
Tap takeTap(sampler2D image, vec2 imageSize, Place here, ivec2 px, ivec2 imagePX, bool known) {
    Tap tap = Tap(vec4(0.0), 0.0, vec2(0.0));
    if (!known && (any(lessThan(imagePX, ivec2(0))) || any(greaterThanEqual(imagePX, ivec2(imageSize)))))
        return tap;
    ivec2 tracePX = gridToTracePixel(imageSize, imagePX);
    if (!known && !wasTraced(rayOf(tracePX)))
        return tap;
    ivec2 tapPX = tracePixelToFull(frame.constants, tracePX);
    tap.px = vec2(tapPX);
    tap.similarity = sameSurface(here, placeOf(tapPX), length(vec2(tapPX - px)));
    vec4 answer = texelFetch(image, imagePX, 0);
    tap.premultiplied = vec4(answer.rgb * answer.a, answer.a);
    return tap;
}

/// Top left of the four pixels of an image of this size whose places in the frame surround `px`.
ivec2 cornerOf(vec2 imageSize, ivec2 px) {
    ivec2 corner = min(floorToInt((vec2(px) + 0.5) * imageSize / frame.constants.size), ivec2(imageSize) - 1);
    ivec2 cornerPX = tracePixelToFull(frame.constants, gridToTracePixel(imageSize, corner));
    return corner - ivec2(greaterThan(cornerPX, px));
}

/// The four pixels of an image around `px`, the one at `corner` first. `known`: as for takeTap, of each.
Tap[4] takeFour(sampler2D image, vec2 imageSize, Place here, ivec2 px, ivec2 corner, bool known) {
    Tap four[4];
    for (int i = 0; i < 4; ++i)
        four[i] = takeTap(image, imageSize, here, px, corner + ivec2(i & 1, i >> 1), known);
    return four;
}

/// Of one of the four, by nearness and similarity; 0 if it shows another surface. `scale`: the frame's pixels to one of
/// the image.
float weightOf(Tap tap, ivec2 px, vec2 scale) {
    if (tap.similarity <= kOtherSurface)
        return 0.0;
    vec2 near = max(1.0 - abs(tap.px - vec2(px)) / scale, 0.001);
    return tap.similarity * near.x * near.y;
}

/// Premultiplied mean of the four; false if none of them shows the surface.
bool mixFour(Tap four[4], ivec2 px, vec2 scale, out vec4 mean) {
    vec4 sum = vec4(0.0);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        float weight = weightOf(four[i], px, scale);
        sum += weight * four[i].premultiplied;
        total += weight;
    }
    mean = sum / max(total, 1e-12);
    return total > 0.0;
}

/// The most similar traced pixel of the sixteen around.
vec4 mostSimilar(Place here, ivec2 px) {
    ivec2 corner = cornerOf(frame.constants.traceSize, px) - 1;
    Tap best = Tap(vec4(0.0), kOtherSurface, vec2(0.0));
    for (int i = 0; i < 16; ++i) {
        Tap tap = takeTap(traced, frame.constants.traceSize, here, px, corner + ivec2(i & 3, i >> 2), false);
        if (tap.similarity > best.similarity)
            best = tap;
    }
    return best.premultiplied;
}

// ---------------------------------------------------------------- a ray of its own

/// Follows `directionVS` for about `distance` metres to the surface that the frame shows there. False if the frame
/// shows no surface at exactly that place, or a side that the ray could not hit.
bool aim(Place here, vec3 directionVS, float distance, out vec2 hitPX) {
    const float kMeetsFront = 0.02; // cosine
    const float kSameHit = 1.5;     // the surface found may be farther by half; rays get short towards a contact
    const float kSameDepth = 0.002; // fraction of viewZ, besides half a pixel
    float along = distance;
    for (int step = 0; step < 2; ++step) {
        vec3 atVS = here.positionVS + directionVS * along;
        vec4 pixelH = frame.constants.viewToPixel * vec4(atVS, 1.0);
        if (-atVS.z <= frame.constants.nearZ || pixelH.w <= 0.0)
            return false;
        vec2 at = pixelH.xy / pixelH.w;
        if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, frame.constants.size)))
            return false;
        hitPX = at;
        Place there = placeOf(floorToInt(at));
        float approach = -dot(there.normalVS, directionVS);
        if (there.background || approach < kMeetsFront)
            return false;
        float beyond = dot(there.normalVS, atVS - there.positionVS); // metres that remain before its plane
        if (step == 1)
            return abs(beyond) <= 0.5 * there.metresPerPixel + kSameDepth * -there.positionVS.z;
        along += beyond / approach;
        if (along <= 0.0 || along > kSameHit * distance)
            return false;
    }
    return false;
}

/// A line where no traced ray starts on a rough surface: the picture was not copied then (trace/picture).
LobeCone coneOf(Place here, vec3 directionVS) {
    LobeCone cone = makeCone(directionVS, here.normalVS, here.perceptualRoughness);
    if (rayList.header.pictureGroups[0] == 0u)
        cone.alpha = 0.0;
    return cone;
}

vec4 answerAt(Place here, vec3 directionVS, vec2 hitPX, float weight) {
    uint lookups = 0u; // only rays count lookups
    vec3 hitVS = placeOf(floorToInt(hitPX)).positionVS;
    LobeCone cone = coneOf(here, directionVS);
    vec3 radiance = hitRadiance(hitPX, false, here.positionVS, hitVS, cone, lookups);
    if ((frame.constants.flags & kTraceTarget8) != 0u)
        radiance = scaledToOne(radiance);
    return vec4(radiance, 1.0) * weight;
}

/// What the four traced pixels around found. The surfaces that their rays started from are not looked at.
struct FourRays {
    vec4 weights;
    vec4 distances;
    bool traced; // all four were
    bool hit;    // all four did, and have nearly equal weights
};

/// By two gathers, which start at the bottom left and go counter-clockwise.
FourRays gatherRays(ivec2 corner) {
    const float kAlike = 0.05;
    FourRays rays = FourRays(vec4(0.0), vec4(0.0), false, false);
    if (any(lessThan(corner, ivec2(0))) || any(greaterThanEqual(corner + 1, ivec2(frame.constants.traceSize))))
        return rays;
    rays.weights = textureGather(traced, vec2(corner + 1) / vec2(textureSize(traced, 0)), 3);
    uvec4 words = textureGather(rayRecord, vec2(corner + 1) / vec2(textureSize(rayRecord, 0)), 1);
    rays.traced = true;
    rays.hit = true;
    for (int i = 0; i < 4; ++i) {
        RayRecord ray = unpackRayRecord(uvec2(0u, words[i]));
        rays.traced = rays.traced && wasTraced(ray);
        rays.hit = rays.hit && ray.outcome == kOutcomeHit && abs(rays.weights[i] - rays.weights.x) <= kAlike;
        rays.distances[i] = ray.hitDistance;
    }
    return rays;
}

/// Where a pixel's own ray ends.
struct Aimed {
    uint found; // one of the three below
    vec2 hitPX;
    float weight; // of the answer
};

const uint kAimedAtHit = 0u;
const uint kAimedAtMiss = 1u;
const uint kNotAimed = 2u; // mix the four

/// The usual case: four rays that hit. Not aimed if the frame does not show what they met.
Aimed aimAmongHits(Place here, vec3 directionVS, ivec2 px, ivec2 corner, FourRays rays) {
    vec2 low = vec2(tracePixelToFull(frame.constants, corner));
    vec2 high = vec2(tracePixelToFull(frame.constants, corner + 1));
    vec2 share = clamp((vec2(px) - low) / (high - low), 0.0, 1.0);
    vec4 shares = vec4((1.0 - share.x) * share.y, share.x * share.y, share.x * (1.0 - share.y),
                       (1.0 - share.x) * (1.0 - share.y));
    vec2 hitPX;
    bool found = aim(here, directionVS, dot(rays.distances, shares), hitPX);
    return Aimed(found ? kAimedAtHit : kNotAimed, hitPX, dot(rays.weights, shares));
}

/// Where those of the four that show the pixel's surface give its ray's length.
Aimed aimOwnRay(Place here, vec3 directionVS, ivec2 px, ivec2 corner, Tap four[4]) {
    const Aimed kNot = Aimed(kNotAimed, vec2(0.0), 0.0);
    float distances[4];
    float hits = 0.0;
    float misses = 0.0;
    float alpha = 0.0;
    float meanDistance = 0.0;
    for (int i = 0; i < 4; ++i) {
        distances[i] = 0.0;
        float weight = weightOf(four[i], px, frame.constants.traceScale);
        if (weight <= 0.0)
            continue;
        RayRecord ray = rayOf(corner + ivec2(i & 1, i >> 1));
        if (isAnswered(ray.outcome) && ray.outcome != kOutcomeHit) // the answer has no place to aim at
            return kNot;
        if (ray.outcome != kOutcomeHit) {
            misses += weight;
            continue;
        }
        distances[i] = ray.hitDistance;
        hits += weight;
        alpha += weight * four[i].premultiplied.a;
        meanDistance += weight * ray.hitDistance;
    }
    if (hits <= 0.0)
        return kNot;
    vec2 hitPX;
    bool found = aim(here, directionVS, meanDistance / hits, hitPX);
    for (int i = 0; i < 4 && !found; ++i) // across an edge in the hits, a single one may be right
        found = distances[i] > 0.0 && aim(here, directionVS, distances[i], hitPX);
    if (!found && misses <= 0.0)
        return kNot;
    // Beside a miss, and no surface found: a miss itself.
    return Aimed(found ? kAimedAtHit : kAimedAtMiss, hitPX, alpha / hits);
}

// ---------------------------------------------------------------- sharp or blurred

/// Weight of the unblurred answer: 1 without a blur, and the remaining weight where the blur is narrower than a pixel
/// of its image.
float sharpShare(Place here, ivec2 px) {
    if (blur.strength <= 0.0)
        return 1.0;
    RayRecord ray = rayOf(fullToTracePixel(frame.constants, px));
    if (!wasTraced(ray))
        return 0.0;
    float rayPX = length(ray.hitUV * frame.constants.size - (vec2(px) + 0.5));
    float reach = blurReach(here.perceptualRoughness, rayPX, blur.strength, blur.roughnessFactor);
    return 1.0 - clamp(reach * sourceSize.y / frame.constants.size.y, 0.0, 1.0);
}

/// True where the answers of the four are means over lobes (resolve/lobe, cones) so wide that a mixture of them is as
/// good as the answer of the pixel's own ray, at any of the places that they hit. Rays that miss hinder nothing: their
/// answers are means of what is beside them, and fade.
bool lobesOverlap(Place here, vec3 directionVS, ivec2 corner) {
    LobeCone cone = coneOf(here, directionVS);
    if (cone.alpha <= 0.0)
        return false;
    for (int i = 0; i < 4; ++i) {
        ivec2 tracePX = corner + ivec2(i & 1, i >> 1);
        if (!isTracePixel(frame.constants, tracePX))
            continue;
        RayRecord ray = rayOf(tracePX);
        if (!isAnswered(ray.outcome))
            continue;
        vec3 hitVS = here.positionVS + directionVS * ray.hitDistance;
        if (coneRadius(cone, hitVS, ray.hitDistance) < kWideLobe * frame.constants.traceScale.y)
            return false;
    }
    return true;
}

/// The unblurred answer, premultiplied.
vec4 sharpAnswer(Place here, ivec2 px) {
    ivec2 corner = cornerOf(frame.constants.traceSize, px);
    FourRays rays = gatherRays(corner);
    if (rays.traced && all(equal(rays.weights, vec4(0.0))))
        return vec4(0.0); // nothing that rays from here may meet is shown
    vec3 directionVS = reflect(viewDirection(frame.constants, here.positionVS), here.normalVS);
    bool aims = settings.roughnessFactor <= 0.0 && any(lessThan(frame.constants.traceSize, frame.constants.size));
    // Of what is far, lobes so wide overlap: misses beside it have means of it, too.
    bool isMean = aims && coneOf(here, directionVS).alpha > 0.0 &&
                  lobePixels(here.perceptualRoughness, 0.0, 0.0) >= kWideFar * frame.constants.traceScale.y;
    bool overlap = aims && lobesOverlap(here, directionVS, corner);
    Aimed aimed = Aimed(kNotAimed, vec2(0.0), 0.0);
    if (aims && rays.hit && !overlap)
        aimed = aimAmongHits(here, directionVS, px, corner, rays);
    if (aimed.found == kNotAimed) {
        vec4 mean;
        Tap four[4] = takeFour(traced, frame.constants.traceSize, here, px, corner, rays.traced);
        bool mixed = mixFour(four, px, frame.constants.traceScale, mean);
        if (mixed && (overlap || isMean))
            return mean;
        if (overlap && rays.hit) // a thin thing, from which none of the four rays started
            aimed = aimAmongHits(here, directionVS, px, corner, rays);
        else if (aims)
            aimed = aimOwnRay(here, directionVS, px, corner, four);
        if (aimed.found == kNotAimed)
            return mixed ? mean : mostSimilar(here, px);
    }
    // Pixels that came here on either way read the picture together.
    return aimed.found == kAimedAtHit ? answerAt(here, directionVS, aimed.hitPX, aimed.weight) : vec4(0.0);
}

/// The blurred answer, premultiplied; false where none of the four around shows this surface.
bool blurredAnswer(Place here, ivec2 px, out vec4 answer) {
    Tap four[4] = takeFour(source, sourceSize, here, px, cornerOf(sourceSize, px), false);
    return mixFour(four, px, frame.constants.size / sourceSize, answer);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    Place here = placeOf(px);
    if (!reflects(here)) {
        imageStore(radianceWeight, px, vec4(0.0));
        return;
    }
    vec4 answer = vec4(0.0);
    float sharp = sharpShare(here, px);
    bool found = sharp < 1.0 && blurredAnswer(here, px, answer);
    if (!found || sharp > 0.0) {
        vec4 unblurred = sharpAnswer(here, px);
        answer = found ? mix(answer, unblurred, sharp) : unblurred;
    }
    imageStore(radianceWeight, px, vec4(answer.a > 0.0 ? answer.rgb / answer.a : vec3(0.0), answer.a));
}
