// Averages a rough pixel's signal over frames. The previous frame is looked up where the surface was, and where the
// reflection was (the point behind the mirror that the ray's end makes); of the two, the place that mirrored the ray's
// end better. How far it was off limits the number of frames that count. docs/techniques/denoise.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/lobe_surface.glsl"
#include "lib/color.glsl"
#include "lib/half.glsl"
#include "lib/noise.glsl"
#include "lib/octahedral.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D reused;         // weight * radiance, weight
layout(set = 0, binding = 4) uniform sampler2D reusedMeta;     // denoise/reuse.comp
layout(set = 0, binding = 5) uniform sampler2D motion;         // previous UV - current UV, after scaling
layout(set = 0, binding = 6) uniform sampler2D meanBefore;
layout(set = 0, binding = 7) uniform sampler2D metaBefore;
layout(set = 0, binding = 8) uniform usampler2D placeBefore;
layout(set = 0, binding = 9, rgba16f) uniform writeonly image2D mean;  // weight * radiance, weight
layout(set = 0, binding = 10, rgba16f) uniform writeonly image2D meta; // frames; luminance: mean, mean square; nearness
layout(set = 0, binding = 11, rg32ui) uniform writeonly uimage2D place; // viewZ; normal, octahedral in view space
// Luminance, the mean over few frames: kept if settings.comparesMeans.
layout(set = 0, binding = 12) uniform sampler2D fastBefore;
layout(set = 0, binding = 13, r16f) uniform writeonly image2D fast;
layout(set = 0, binding = 14) uniform sampler2D changed; // of the previous frame's tiles: change.comp
// Kept if settings.hitMotion.
layout(set = 0, binding = 15) uniform sampler2D reusedMotion; // denoise/reuse.comp
layout(set = 0, binding = 16) uniform sampler2D speedBefore;
layout(set = 0, binding = 17, r16f) uniform writeonly image2D speed; // of what the mean shows: see driftOf
DenoiseConstants settings = frame.settings.denoise;

#include "lib/previous_place.glsl"

/// Angle by which packed normals may be off: sixteen bits a component.
const float kNormalRounding = 1e-4;

/// Lobes narrower than this on screen, in pixels, suffer from a linear mix of texels: see sharpMean.
const float kSharpBelow = 16.0;

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

/// This pixel's surface and its ray's end, in the previous frame's view space.
struct Was {
    vec3 position;
    vec3 normal;
    vec3 end;
    bool moved; // by motion: its depth is known roughly
};

/// Angle between this normal and the one that mirrors `end` to the eye.
float residualAt(vec3 end, vec3 position, vec3 normal) {
    vec3 toEye = -viewDirection(frame.constants, position);
    vec3 H = normalizeOr(toEye + normalizeOr(end - position, normal), normal);
    return length(H - normal * dot(H, normal));
}

/// Shortens the history where light has changed, and takes the long mean to where the short one is.
void forgetOldLight(vec2 at, inout Candidate found) {
    const float kPower = 10.0; // with a tenth changed a third of the frames count
    const float kTile = float(kSentinelTile);
    vec2 last = (ceil(frame.constants.prevSize / kTile) - 0.5) * kTile; // no tile lies beyond
    vec3 change = textureLod(changed, min(at, last) / (vec2(textureSize(changed, 0)) * kTile), 0.0).rgb;
    found.meta.x *= pow(1.0 - change.r, kPower);
    float lag = change.g;
    float toShort = mix(1.0, change.b, lag);
    found.mean.rgb *= toShort;
    found.scaled = toShort;
    found.meta.yz *= vec2(toShort, square(toShort));
    found.meta.x = mix(found.meta.x, min(found.meta.x, settings.fastFrames), lag);
}

/// True where the previous frame showed this pixel's surface at `texel`.
bool showedIt(Was was, ivec2 texel, out vec3 position, out vec3 normal) {
    if (!wasInFrame(texel))
        return false;
    uvec2 packed = texelFetch(placeBefore, texel, 0).xy;
    float z = uintBitsToFloat(packed.x);
    if (z <= 0.0 || z >= kBackgroundZ)
        return false; // no ray there
    normal = decodeOctahedral(unpackSnorm2x16(packed.y));
    position = previousPosition((vec2(texel) + 0.5) * frame.constants.prevInvSize, z);
    float off = abs(dot(was.normal, position - was.position));
    float allowed = (was.moved ? 0.1 : settings.disocclusion) * -was.position.z;
    return off <= allowed && dot(normal, was.normal) >= 0.7;
}

/// Catmull and Rom's weights of four texels in a row, `share` of the way from the second to the third.
vec4 cubicWeights(float share) {
    float s2 = share * share;
    float s3 = s2 * share;
    return 0.5 * vec4(-s3 + 2.0 * s2 - share, 3.0 * s3 - 5.0 * s2 + 2.0, -3.0 * s3 + 4.0 * s2 + share, s3 - s2);
}

/// The mean between four texels that show this pixel's surface, by a cubic: a linear mix blurs a little in each frame of
/// a movement, and thirty frames of it as wide as many a smooth lobe. False where one of the texels shows another
/// surface, or is so much darker than another that the cubic would fall below 0: to cut that off would add light.
bool sharpMean(Was was, vec2 at, out vec4 mean) {
    vec2 corner = floor(at - 0.5);
    vec2 share = at - 0.5 - corner;
    vec4 wx = cubicWeights(share.x);
    vec4 wy = cubicWeights(share.y);
    vec4 sum = vec4(0.0);
    vec4 least = vec4(1e30);
    vec4 most = vec4(0.0);
    float total = 0.0;
    for (int i = 0; i < 16; ++i) {
        ivec2 offset = ivec2(i & 3, i >> 2);
        bool outerX = offset.x == 0 || offset.x == 3;
        bool outerY = offset.y == 0 || offset.y == 3;
        if (outerX && outerY)
            continue; // the corners hardly count
        ivec2 texel = floorToInt(corner) + offset - 1;
        vec3 position;
        vec3 normal;
        if ((outerX || outerY) && !showedIt(was, texel, position, normal))
            return false;
        vec4 there = texelFetch(meanBefore, texel, 0);
        float weight = wx[offset.x] * wy[offset.y];
        sum += weight * there;
        total += weight;
        least = min(least, there);
        most = max(most, there);
    }
    mean = max(sum / total, vec4(0.0));
    const float kDark = 0.03;
    return all(greaterThanEqual(least, kDark * most));
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
    vec3 normal = normalize(normals);
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

/// Fraction of the way behind the surface at which the middle of the lobe's image appears: a mirror's is at the ray's
/// end, a rough surface's on the surface itself. Lagarde and de Rousiers 2014, "Moving Frostbite to PBR" (fit).
float dominantFactor(float NoV, float perceptualRoughness) {
    float a = 0.298475 * log(39.4115 - 39.0029 * perceptualRoughness);
    return saturate(pow(1.0 - NoV, 10.8649) * (1.0 - a) + a);
}

/// The mirror image of a point on the ray, as far behind the surface as the lobe's middle shows it, and moved by the
/// mirrored step. Nearer to the eye than the mirror image, the step is as much shorter.
vec3 imageOf(LobeSurface here, float distance, vec3 stepVS) {
    float NoV = clamp(dot(here.normalVS, here.toEyeVS), 0.0, 1.0);
    float shown = distance * dominantFactor(NoV, here.perceptualRoughness);
    float toEye = isOrthographic(frame.constants) ? 0.0 : length(here.positionVS);
    float shorter = toEye > 0.0 ? (toEye + shown) / (toEye + distance) : 1.0;
    return here.positionVS - here.toEyeVS * shown + shorter * reflect(stepVS, here.normalVS);
}

vec2 imagePixelBefore(LobeSurface here, float near, vec3 stepVS) {
    return previousPixel((frame.constants.viewToPrevView * vec4(imageOf(here, endDistance(near), stepVS), 1.0)).xyz);
}

/// Two nearnesses weighed by the light that they stand for.
float joined(float near, float light, float near2, float light2) {
    return light + light2 > 0.0 ? (near * light + near2 * light2) / (light + light2) : near;
}

Candidate best(ivec2 px, LobeSurface here, float light, float near, HitMotion hits, out float frames) {
    vec3 mirrored = reflect(-here.toEyeVS, here.normalVS);
    mat4 toBefore = frame.constants.viewToPrevView;
    PreviousPlace before = previousPlace(px, here.viewZ);
    // A sample may miss what the mean shows, such as a small lamp before a wall: the history knows its distance.
    ivec2 about = floorToInt(imagePixelBefore(here, near, hits.stepVS));
    float tracked = near;
    if (!before.moved && wasInFrame(about)) {
        vec4 there = texelFetch(metaBefore, about, 0);
        tracked = joined(near, light, there.w, there.x * there.y);
    }
    Was was;
    was.position = before.positionVS;
    was.normal = before.normalVS;
    was.end = (toBefore * vec4(here.positionVS + mirrored * endDistance(tracked) + hits.stepVS, 1.0)).xyz;
    was.moved = before.moved;
    Candidate found = lookUp(was, before.px);
    frames = framesOf(found, hits, here.perceptualRoughness);
    if (!was.moved) {
        Candidate inMirror = lookUp(was, imagePixelBefore(here, tracked, hits.stepVS));
        float mirrorFrames = framesOf(inMirror, hits, here.perceptualRoughness);
        if (mirrorFrames > frames) {
            found = inMirror;
            frames = mirrorFrames;
        }
    }
    vec2 fromTexel = abs(fract(found.at) - 0.5);
    bool narrow = lobePixels(here.perceptualRoughness, here.viewZ, tracked) < kSharpBelow;
    vec4 mean;
    if (narrow && frames > 0.0 && found.share > 0.99 && max(fromTexel.x, fromTexel.y) > 0.03 &&
        sharpMean(was, found.at, mean))
        found.mean = vec4(mean.rgb * found.scaled, mean.a);
    return found;
}

/// Luminance that this frame's answer may have: some times that of the history, what the history's scatter explains, or
/// some times that of the pixels around. Those that share rays with this one are no witnesses.
float mostBrightness(ivec2 px, LobeSurface here, float near, vec4 answer, Candidate before, float frames) {
    const float kKnown = 4.0;      // frames that tell of the scatter
    const float kWideLobe = 4.0;   // pixels: narrower ones may show what one pixel alone shows
    const float kDeviations = 0.5; // of the scatter, for each time of the mean
    float brightness = luminance(answer.rgb);
    float lobe = lobePixels(here.perceptualRoughness, here.viewZ, near);
    if (frames < kKnown && lobe < kWideLobe)
        return brightness;
    float scatter = sqrt(max(before.meta.z - square(before.meta.y), 0.0));
    float usual = max(settings.firefly * before.meta.y, before.meta.y + kDeviations * settings.firefly * scatter);
    float most = frames < kKnown ? 0.0 : usual;
    if (brightness <= most)
        return brightness;
    float radius = 1.0 + 1.5 * clamp(0.5 * lobe, 1.0, settings.reuseRadius);
    mat2 disc = lobeDisc(here, radius);
    Spiral spiral = beginSpiral(1u, hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed).y);
    vec4 around = vec4(0.0);
    for (uint i = 0u; i < 8u; ++i) {
        nextPoint(spiral, i);
        ivec2 tap = floorToInt(vec2(px) + 0.5 + disc * spiral.direction);
        if (isInFrame(tap) && texelFetch(reusedMeta, tap, 0).g > 0.0 && isSameSurface(here, lobeSurfaceAt(tap)))
            around += texelFetch(reused, tap, 0);
    }
    return around.a > 0.0 ? max(most, settings.firefly * luminance(around.rgb) * answer.a / around.a) : brightness;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (!isInFrame(px))
        return;
    vec4 answer = texelFetch(reused, px, 0);
    vec2 nearLearnt = texelFetch(reusedMeta, px, 0).rg;
    float near = nearLearnt.x;
    float learnt = nearLearnt.y;
    LobeSurface here = lobeSurfaceAt(px);
    bool hasHistory = settings.historyExpected != 0u && settings.historyTag == settings.historyExpected;
    if (learnt < 0.0) {
        imageStore(mean, px, vec4(0.0));
        imageStore(meta, px, vec4(0.0));
        if (settings.comparesMeans != 0u)
            imageStore(fast, px, vec4(0.0));
        if (settings.hitMotion != 0u)
            imageStore(speed, px, vec4(0.0));
        imageStore(place, px, uvec4(0u));
        return;
    }
    if (learnt == 0.0 && hasHistory && wasInFrame(px))
        near = texelFetch(metaBefore, px, 0).w; // places the sample of the history that this frame keeps
    float brightness = luminance(answer.rgb);
    vec4 moments = vec4(learnt, brightness, square(brightness), near);
    float fastMean = brightness;
    HitMotion hits = HitMotion(vec3(0.0), 0.0, 0.0);
    if (hasHistory)
        hits = hitMotionAt(px, near, here.perceptualRoughness);
    float meanSpeed = hits.speed;
    if (hasHistory && !isMirror(here.perceptualRoughness)) {
        float frames;
        Candidate before = best(px, here, learnt * brightness, near, hits, frames);
        frames = min(frames, settings.historyFrames - learnt);
        if (settings.firefly > 0.0 && learnt > 0.0 && brightness > 0.0) {
            float most = mostBrightness(px, here, near, answer, before, frames);
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
        }
    }
    const float kLargestHalf = 6.0e4;
    vec3 noise = hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed);
    imageStore(mean, px, roundToHalf(min(answer, vec4(kLargestHalf)), noise.x));
    imageStore(meta, px, roundToHalf(min(moments, vec4(kLargestHalf)), noise.y));
    if (settings.comparesMeans != 0u)
        imageStore(fast, px, roundToHalf(vec4(min(fastMean, kLargestHalf)), noise.z));
    if (settings.hitMotion != 0u)
        imageStore(speed, px, vec4(meanSpeed));
    imageStore(place, px, uvec4(floatBitsToUint(here.viewZ), packSnorm2x16(encodeOctahedral(here.normalVS)), 0u, 0u));
}
