// Averages a rough pixel's signal over frames. The previous frame is looked up where the surface was, and where the
// reflection was (the ray's end's image behind the mirror, a flat one or a curved one); of these, the place that mirrored
// the ray's end best. How far it was off limits the number of frames that count. docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/changed_light.glsl"
#include "denoise/history.glsl"
#include "denoise/lobe_surface.glsl"
#include "denoise/mirror_image.glsl"
#include "denoise/surface_curvature.glsl"
#include "denoise/taken_from.glsl"
#include "lib/color.glsl"
#include "lib/half.glsl"
#include "lib/noise.glsl"
#include "lib/octahedral.glsl"
#include "lib/packed_motion.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D reused;         // weight * radiance, weight
layout(set = 0, binding = 4) uniform sampler2D reusedMeta;     // denoise/reuse.comp
layout(set = 0, binding = 5) uniform sampler2D motion;         // lib/previous_place.glsl
layout(set = 0, binding = 6) uniform sampler2D meanBefore;
layout(set = 0, binding = 7) uniform sampler2D metaBefore;
layout(set = 0, binding = 8) uniform usampler2D placeBefore;
layout(set = 0, binding = 9, rgba16f) uniform writeonly image2D mean;  // weight * radiance, weight
layout(set = 0, binding = 10, rgba16f) uniform writeonly image2D meta; // frames; luminance: mean, mean square; nearness
/// viewZ; normal, octahedral in view space. Behind a mirror: -viewZ of the surface's image; normal of the surface itself.
layout(set = 0, binding = 11, rg32ui) uniform writeonly uimage2D place;
// Luminance, the mean over few frames: kept if settings.comparesMeans.
layout(set = 0, binding = 12) uniform sampler2D fastBefore;
layout(set = 0, binding = 13, r16f) uniform writeonly image2D fast;
layout(set = 0, binding = 14) uniform sampler2D changed; // of the previous frame's tiles: change.comp
// Kept if settings.hitMotion.
layout(set = 0, binding = 15) uniform sampler2D reusedMotion; // denoise/reuse.comp
layout(set = 0, binding = 16) uniform sampler2D speedBefore;
layout(set = 0, binding = 17, r16f) uniform writeonly image2D speed; // of what the mean shows: see driftOf
layout(set = 0, binding = 18, rg16f) uniform writeonly image2D takenFrom; // kept if settings.stableFrames
layout(set = 0, binding = 19) uniform usampler2D mirroredSurface; // lib/mirrored.glsl, if settings.mirrored
layout(set = 0, binding = 20) uniform usampler2D hitMotion;       // denoise/gather.comp, if settings.hitMotion
DenoiseConstants settings = frame.settings.denoise;

#include "lib/previous_place.glsl"

#include "denoise/averaged_surface.glsl"
#include "denoise/firefly.glsl"
#include "denoise/history_texels.glsl"

/// Angle by which packed normals may be off: sixteen bits a component.
const float kNormalRounding = 1e-4;

/// What one place of the previous frame holds.
struct Candidate {
    vec2 at; // pixels
    float scaled; // what the mean was multiplied by, for light that has changed
    vec4 mean;
    vec4 meta;
    float fast;
    float speed;    // radians a frame by which what it shows turned the half vector
    float share;    // of the four texels that show this surface, [0, 1]
    float residual; // angle between the normal there and those that would mirror to the eye what rays meet: the larger
                    // one, of what this frame met and of what the history shows
};

const Candidate kNone = Candidate(vec2(0.0), 1.0, vec4(0.0), vec4(0.0), 0.0, 0.0, 0.0, 0.0);

/// Angle between this normal and the one that mirrors `end` to the eye.
float residualAt(vec3 end, vec3 position, vec3 normal) {
    vec3 toEye = -viewDirection(frame.constants, position);
    vec3 H = normalizeOr(toEye + normalizeOr(end - position, normal), normal);
    return length(H - normal * dot(H, normal));
}

/// Shortens the history where light has changed, and takes the long mean to where the short one is.
void forgetOldLight(vec2 at, inout Candidate found) {
    vec3 change = lightChange(changed, at);
    float toShort = mix(1.0, change.b, change.g);
    found.mean.rgb *= toShort;
    found.scaled = toShort;
    found.meta.yz *= vec2(toShort, square(toShort));
    found.meta.x = framesKept(found.meta.x, change);
}

Candidate lookUp(Was was, vec2 at) {
    Candidate found = kNone;
    found.at = at;
    vec2 corner = floor(at - 0.5);
    vec2 share = at - 0.5 - corner;
    vec3 positions = vec3(0.0);
    vec3 normals = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        vec2 shares = mix(1.0 - share, share, vec2(offset));
        float weight = shares.x * shares.y;
        ivec2 texel = floorToInt(corner) + offset;
        vec3 position;
        vec3 normal;
        if (weight < 1e-3 || !showedIt(was, texel, position, normal))
            continue;
        found.mean += weight * texelFetch(meanBefore, texel, 0);
        found.meta += weight * texelFetch(metaBefore, texel, 0);
        if (settings.comparesMeans != 0u)
            found.fast += weight * texelFetch(fastBefore, texel, 0).r;
        found.share += weight;
        positions += weight * position;
        normals += weight * normal;
    }
    if (found.share < 0.01)
        return kNone;
    found.mean /= found.share;
    found.meta /= found.share;
    found.fast /= found.share;
    if (settings.hitMotion != 0u)
        found.speed = texelFetch(speedBefore, clamp(ivec2(at), ivec2(0), ivec2(frame.constants.prevSize) - 1), 0).r;
    forgetOldLight(at, found);
    vec3 position = was.moved ? was.position : positions / found.share;
    vec3 normal = was.isMirrored ? was.normal : normalize(normals);
    // What the history shows may have been nearer or farther away than what this frame found.
    vec3 shown = was.position + normalizeOr(was.end - was.position, was.normal) * endDistance(found.meta.w);
    found.residual = max(residualAt(was.end, position, normal), residualAt(shown, position, normal));
    return found;
}

/// How the things that a pixel mirrors move.
struct HitMotion {
    vec3 stepVS;  // their mean displacement: where they were - where they are
    float speed;  // of that displacement: radians a frame by which it turns the half vector
    float spread; // standard deviation of the speed
};

HitMotion hitMotionAt(ivec2 px, float near, float perceptualRoughness) {
    if (settings.hitMotion == 0u)
        return HitMotion(vec3(0.0), 0.0, 0.0);
    vec4 motion = texelFetch(reusedMotion, px, 0);
    float turn = 0.5 * near; // radians a metre
    float most = lobeTangent(perceptualRoughness); // faster things leave the lobe at once as well
    float common2 = dot(motion.xyz, motion.xyz);
    float all2 = square(motion.w);
    float spread = turn * sqrt(max(all2 - common2, 0.0));
    // Where most of the light moves alike, the rest of it counts by its share.
    float alike = all2 > 0.0 ? common2 / all2 : 1.0;
    if (alike > 0.5)
        spread *= 2.0 * sqrt(max(alike * (1.0 - alike), 0.0));
    return HitMotion(motion.xyz, min(turn * sqrt(common2), most), min(spread, most));
}

/// Speed at which the history's picture leaves the place where this frame looks for it: parts of the lobe do not move
/// with the mean, and what was seen then may have moved otherwise than what is seen now.
float driftOf(Candidate found, HitMotion hits) {
    return hits.spread + 8.0 * max(abs(found.speed - hits.speed) - hits.spread, 0.0);
}

/// Frames of this candidate that count: those over which the reflection moves by less than the allowed part of the lobe.
float framesOf(Candidate found, HitMotion hits, float perceptualRoughness) {
    float off = max(found.residual - kNormalRounding, 0.0) + driftOf(found, hits);
    float most = off > 0.0 ? settings.lobeTrail * lobeTangent(perceptualRoughness) / off : 1e6;
    return min(found.meta.x, most) * sqrt(found.share);
}

/// True if a candidate lost frames to its place, so that another place may be better.
bool isShortened(Candidate found, float frames) {
    return found.share == 0.0 || frames < found.meta.x * sqrt(found.share);
}

/// How far behind the surface the middle of the lobe shows what the ray meets `distance` metres away.
float lobeImageDistance(LobeSurface here, float distance) {
    return distance * dominantFactor(clamp(dot(here.normalVS, here.toEyeVS), 0.0, 1.0), here.perceptualRoughness);
}

/// The image of a point on the ray in a flat mirror, as far behind the surface as the lobe's middle shows it, and moved by
/// the mirrored step. Nearer to the eye than the mirror image, the step is as much shorter.
vec3 imageOf(LobeSurface here, float distance, vec3 stepVS) {
    float shown = lobeImageDistance(here, distance);
    float toEye = isOrthographic(frame.constants) ? 0.0 : length(here.positionVS);
    float shorter = toEye > 0.0 ? (toEye + shown) / (toEye + distance) : 1.0;
    return here.positionVS - here.toEyeVS * shown + shorter * reflect(stepVS, here.normalVS);
}

vec2 imagePixelBefore(LobeSurface here, float near, vec3 stepVS) {
    return previousPixel((frame.constants.viewToPrevView * vec4(imageOf(here, endDistance(near), stepVS), 1.0)).xyz);
}

/// The pixel of the previous frame that showed the image of what the ray met, if the mirror is curved. False where that
/// cannot be told.
bool curvedImagePixelBefore(ivec2 px, LobeSurface here, float near, vec3 stepVS, out vec2 at) {
    if (isOrthographic(frame.constants))
        return false;
    MirrorPlace mirror;
    mirror.position = here.positionVS;
    mirror.N = here.normalVS;
    mirror.V = here.toEyeVS;
    vec3 across = acrossIncidence(mirror.N, mirror.V);
    SurfaceStep x = surfaceStep(px, here, ivec2(1, 0));
    SurfaceStep y = surfaceStep(px, here, ivec2(0, 1));
    if (!curvatureOf(x, y, cross(mirror.N, across), across, mirror.curvature))
        return false;
    mat4 toBefore = frame.constants.viewToPrevView;
    vec3 eyeBefore = -(transpose(mat3(toBefore)) * toBefore[3].xyz);
    float shownAt = dominantFactor(clamp(dot(mirror.N, mirror.V), 0.0, 1.0), here.perceptualRoughness);
    vec3 image;
    if (!mirrorImage(mirror, endDistance(near), shownAt, stepVS, eyeBefore, image))
        return false;
    at = previousPixel((toBefore * vec4(image, 1.0)).xyz);
    return true;
}

/// The image of what a mirror shows, as far behind it as a flat one's is.
LobeSurface imageIn(LobeSurface mirror, LobeSurface behind) {
    LobeSurface image = behind;
    image.positionVS = mirror.positionVS - mirror.toEyeVS * distance(behind.positionVS, mirror.positionVS);
    image.normalVS = behind.shownNormalVS;
    image.toEyeVS = mirror.toEyeVS;
    return image;
}

/// How what the mirror shows has moved.
vec3 mirroredStepVS(ivec2 px) {
    return settings.hitMotion != 0u ? unpackMotion(texelFetch(hitMotion, px, 0).r) : vec3(0.0);
}

/// The pixel of the previous frame that showed what lies `distance` metres behind the mirror on this line of sight.
vec2 mirroredPixelBefore(ivec2 px, LobeSurface mirror, float distance, vec3 stepVS) {
    float near = 1.0 / max(distance, 1e-6);
    vec2 at;
    if (settings.virtualMotion < kVirtualCurved || !curvedImagePixelBefore(px, mirror, near, stepVS, at))
        at = imagePixelBefore(mirror, near, stepVS);
    return at;
}

/// Where the image of what a mirror shows was. If the mirror itself has moved, that is unknown: movedOnScreen, and a pixel
/// outside the frame.
PreviousPlace previousImage(ivec2 px, LobeSurface mirror, LobeSurface image) {
    PreviousPlace before = previousPlace(px, mirror.viewZ);
    bool rests = !before.moved;
    vec3 stepVS = reflect(mirroredStepVS(px), mirror.normalVS);
    before.positionVS = (frame.constants.viewToPrevView * vec4(image.positionVS + stepVS, 1.0)).xyz;
    before.normalVS = mat3(frame.constants.viewToPrevView) * image.normalVS;
    float toImage = distance(mirror.positionVS, image.positionVS);
    before.px = rests ? mirroredPixelBefore(px, mirror, toImage, mirroredStepVS(px)) : vec2(-1e4);
    before.moved = stepVS != vec3(0.0);
    before.movedOnScreen = !rests || before.moved;
    before.knowsDepth = true;
    return before;
}

/// Moves the image to where the mirror showed it. The way of the light is as long as to a flat mirror's image: it is
/// stationary (Fermat), so it depends on the movement of the eye alone.
void moveImage(vec2 at, inout Was was) {
    vec3 moved = previousPosition(at * frame.constants.prevInvSize, -was.position.z);
    was.end += moved - was.position;
    was.position = moved;
}

/// The pixel of the previous frame that showed the image of what the lobe of `here` shows.
vec2 lobeImagePixelBefore(ivec2 px, LobeSurface mirror, LobeSurface here, float near, vec3 stepVS) {
    if (!here.isMirrored)
        return imagePixelBefore(here, near, stepVS);
    float toImage = distance(here.positionVS, mirror.positionVS);
    return mirroredPixelBefore(px, mirror, toImage + lobeImageDistance(here, endDistance(near)), stepVS);
}

/// How far beside its own plane the image of a surface goes on, at most, one pixel away. Curved mirrors bend the images of
/// planes.
float bendOfImage(ivec2 px, LobeSurface behind, LobeSurface image) {
    float most = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 tap = px + (i < 2 ? ivec2(2 * i - 1, 0) : ivec2(0, 2 * i - 5));
        if (!isInFrame(tap))
            continue;
        LobeSurface there = averagedSurfaceAt(tap);
        if (there.isMirrored && isSameSurface(behind, there))
            most = max(most, abs(dot(image.normalVS, imageIn(lobeSurfaceAt(tap), there).positionVS - image.positionVS)));
    }
    return most;
}

/// Two nearnesses weighed by the light that they stand for.
float joined(float near, float light, float near2, float light2) {
    return light + light2 > 0.0 ? (near * light + near2 * light2) / (light + light2) : near;
}

/// Looks for the history of `averaged`, and says how many of its frames count.
Candidate best(ivec2 px, LobeSurface averaged, float light, float near, HitMotion hits, out float frames) {
    bool isMirrored = averaged.isMirrored;
    LobeSurface mirror = lobeSurfaceAt(px); // if it is one
    LobeSurface here = isMirrored ? imageIn(mirror, averaged) : averaged;
    vec3 mirrored = reflect(-here.toEyeVS, here.normalVS);
    mat4 toBefore = frame.constants.viewToPrevView;
    PreviousPlace before = isMirrored ? previousImage(px, mirror, here) : previousPlace(px, here.viewZ);
    // A sample may miss what the mean shows, such as a small lamp before a wall: the history knows its distance.
    float tracked = near;
    bool inMirrorToo = settings.virtualMotion >= kVirtualFlat && !before.movedOnScreen;
    if (inMirrorToo) {
        ivec2 about = floorToInt(lobeImagePixelBefore(px, mirror, here, near, hits.stepVS));
        if (wasInFrame(about)) {
            vec4 there = texelFetch(metaBefore, about, 0);
            tracked = joined(near, light, there.w, there.x * there.y);
        }
    }
    Was was;
    was.position = before.positionVS;
    was.normal = before.normalVS;
    was.keptNormal = isMirrored ? mat3(toBefore) * averaged.normalVS : before.normalVS;
    was.isMirrored = isMirrored;
    was.end = (toBefore * vec4(here.positionVS + mirrored * endDistance(tracked) + hits.stepVS, 1.0)).xyz;
    was.moved = before.moved;
    was.allowed = (before.knowsDepth ? settings.disocclusion : 0.1) * -was.position.z;
    if (isMirrored)
        was.allowed += 1.5 * bendOfImage(px, averaged, here); // the farthest of four texels is that far away
    Candidate found = kNone;
    frames = 0.0;
    vec2 at = before.px;
    if (isMirrored && wasInFrame(floorToInt(at)))
        moveImage(at, was);
    for (uint place = kVirtualSurface; place <= kVirtualCurved; ++place) { // a loop: one copy of lookUp
        Candidate there = lookUp(was, at);
        float theirs = framesOf(there, hits, here.perceptualRoughness);
        if (theirs > frames) {
            found = there;
            frames = theirs;
        }
        if (!inMirrorToo || place >= settings.virtualMotion)
            break;
        if (place == kVirtualSurface)
            at = lobeImagePixelBefore(px, mirror, here, tracked, hits.stepVS);
        else if (isMirrored || !isShortened(there, theirs) ||
                 !curvedImagePixelBefore(px, here, tracked, hits.stepVS, at))
            break;
    }
    vec4 sharp;
    if (frames > 0.0 && found.share > 0.99 &&
        lobePixels(here.perceptualRoughness, here.viewZ, tracked) < kSharpBelow && sharpMean(was, found.at, sharp))
        found.mean = vec4(sharp.rgb * found.scaled, sharp.a);
    return found;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (!isInFrame(px))
        return;
    vec2 nearLearnt = texelFetch(reusedMeta, px, 0).rg;
    float near = nearLearnt.x;
    float learnt = nearLearnt.y;
    if (learnt < 0.0) { // nothing else is read there
        imageStore(meta, px, vec4(0.0));
        imageStore(place, px, uvec4(0u));
        return; // stabilize.comp reads takenFrom only where a ray was sent
    }
    vec4 answer = texelFetch(reused, px, 0);
    LobeSurface here = averagedSurfaceAt(px);
    bool hasHistory = hasDenoiserHistory();
    if (learnt == 0.0 && hasHistory && wasInFrame(px))
        near = texelFetch(metaBefore, px, 0).w; // places the sample of the history that this frame keeps
    float brightness = luminance(answer.rgb);
    vec4 moments = vec4(learnt, brightness, square(brightness), near);
    float fastMean = brightness;
    HitMotion hits = HitMotion(vec3(0.0), 0.0, 0.0);
    if (hasHistory)
        hits = hitMotionAt(px, near, here.perceptualRoughness);
    float meanSpeed = hits.speed;
    vec2 from = kNoPlace;
    if (hasHistory && !isMirror(here.perceptualRoughness)) {
        float frames;
        Candidate before = best(px, here, learnt * brightness, near, hits, frames);
        frames = min(frames, settings.historyFrames - learnt);
        if (settings.firefly > 0.0 && learnt > 0.0 && brightness > 0.0) {
            float most = mostBrightness(px, here, near, answer, before.meta, frames);
            if (most < brightness) {
                answer.rgb *= most / brightness;
                brightness = most;
                moments.y = most; // its square stays: the next one as bright is no surprise
                fastMean = most;
            }
        }
        if (frames > 0.0) {
            float share = learnt / (learnt + frames);
            answer = mix(before.mean, answer, share);
            near = joined(near, learnt * brightness, before.meta.w, frames * before.meta.y);
            moments = vec4(frames + learnt, mix(before.meta.yz, moments.yz, share), near);
            float fastFrames = min(frames, settings.fastFrames - 1.0);
            fastMean = mix(before.fast, fastMean, learnt / max(learnt + fastFrames, 1e-6));
            meanSpeed = sqrt(mix(square(before.speed), square(meanSpeed), share));
            if (before.share > 0.99 && !here.isMirrored) // nothing else is mixed into what was shown there
                from = before.at - (vec2(px) + 0.5);
        }
    }
    vec3 noise = hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed);
    imageStore(mean, px, roundToHalf(min(answer, vec4(kLargestStored)), noise.x));
    imageStore(meta, px, roundToHalf(min(moments, vec4(kLargestStored)), noise.y));
    if (settings.comparesMeans != 0u)
        imageStore(fast, px, roundToHalf(vec4(min(fastMean, kLargestStored)), noise.z));
    if (settings.hitMotion != 0u)
        imageStore(speed, px, vec4(meanSpeed));
    if (settings.stableFrames > 0.0)
        imageStore(takenFrom, px, vec4(from, 0.0, 0.0));
    float kept = here.isMirrored ? imageIn(lobeSurfaceAt(px), here).positionVS.z : here.viewZ;
    imageStore(place, px, uvec4(floatBitsToUint(kept), packSnorm2x16(encodeOctahedral(here.normalVS)), 0u, 0u));
}
