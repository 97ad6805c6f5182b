// Finds where reflected light changes, from the host's picture alone: a sentinel is a place that a tile's ray hit, and how
// bright the picture was there and around it. The next frame looks at that place again. (With rays through the host's
// triangles, rays/sentinels_main.glsl follows whole paths instead.) docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/history.glsl"
#include "denoise/lobe_surface.glsl"
#include "denoise/sentinel.glsl"
#include "lib/half.glsl"
#include "lib/input_color.glsl"
#include "lib/noise.glsl"
#include "lib/ray_record.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D litRadiance;
layout(set = 0, binding = 4) uniform sampler2D motion;         // lib/previous_place.glsl
layout(set = 0, binding = 5) uniform sampler2D screenAnswer;   // radiance, weight
layout(set = 0, binding = 6) uniform usampler2D screenRecord;
layout(set = 0, binding = 7) uniform usampler2D sentinelBefore; // unpackSentinel
layout(set = 0, binding = 8, rgba32ui) uniform writeonly uimage2D sentinel;
/// Of the previous frame's tiles: how much luminance changed, the larger of the two luminances, the change with its sign.
layout(set = 0, binding = 9, rgba16f) uniform writeonly image2D change;

#include "lib/previous_place.glsl"

/// Luminance of the picture, in the precision that is kept.
struct Shown {
    float here;
    float least; // of 3 x 3 pixels
    float most;
};

/// A place that the frame shows.
struct Sentinel {
    vec2 uv;
    float viewZ;
    Shown shown;
    uint state; // denoise/sentinel.glsl
    bool moved; // on screen, since the previous frame
};

const Sentinel kNoSentinel = Sentinel(vec2(0.0), 0.0, Shown(0.0, 0.0, 0.0), 0u, false);

bool exists(Sentinel sentinel) {
    return (sentinel.state & kExists) != 0u;
}

uvec4 packSentinel(Sentinel made) {
    return uvec4(packUnorm16(made.uv), floatBitsToUint(made.viewZ),
                 packHalf2x16(vec2(made.shown.here, made.shown.least)),
                 packHalf2x16(vec2(made.shown.most, 0.0)) | made.state);
}

Sentinel unpackSentinel(uvec4 packed) {
    vec2 hereLeast = unpackHalf2x16(packed.z);
    float most = unpackHalf2x16(packed.w & 0xffffu).x;
    return Sentinel(unpackUnorm2x16(packed.x), uintBitsToFloat(packed.y), Shown(hereLeast.x, hereLeast.y, most),
                    packed.w & 0xffff0000u, false);
}

float luminanceAt(ivec2 px) {
    bool encoded = (frame.constants.flags & kInputGamma) != 0u;
    float shown = luminance(linearColor(texelFetch(litRadiance, px, 0).rgb, encoded));
    return unpackHalf2x16(packHalf2x16(vec2(min(shown, kLargestStored), 0.0))).x;
}

Shown shownAt(ivec2 px) {
    float here = luminanceAt(px);
    Shown shown = Shown(here, here, here);
    for (int i = 0; i < 9; ++i) {
        ivec2 texel = clamp(px + ivec2(i % 3, i / 3) - 1, ivec2(0), ivec2(frame.constants.size) - 1);
        float there = i == 4 ? here : luminanceAt(texel);
        shown.least = min(shown.least, there);
        shown.most = max(shown.most, there);
    }
    return shown;
}

/// How far `value` lies outside of what was shown around, with its sign.
float beyond(float value, Shown around) {
    return value - clamp(value, around.least, around.most);
}

/// The change of light between two frames, with its sign; the larger luminance of the two. `moved`: the camera has, so
/// that the place lies between other pixels, and details of the picture differ without any change. Then what was shown
/// around it is no change, nor what is shown around it now.
vec2 changeBetween(Shown then, Shown now, bool moved) {
    float larger = max(then.most, now.most);
    if (!moved) {
        const float kRounding = 0.002; // of a half, and of a compiler's two ways to the same sum
        float change = now.most - then.most;
        return vec2(abs(change) > kRounding * larger ? change : 0.0, larger);
    }
    float to = beyond(now.here, then);
    float from = -beyond(then.here, now);
    float change = abs(to) > abs(from) ? to : from;
    larger = max(then.here, now.here);
    return vec2(isChange(vec2(abs(change), larger)) ? change : 0.0, larger);
}

/// The sentinel in this frame: its place now, and what is shown there. None if the frame does not show its surface, or if
/// that moves: the denoiser follows what moves (denoise.hitMotion).
Sentinel followed(Sentinel before) {
    const float kPlane = 0.005; // of viewZ
    const float kMoved = 0.1;   // pixels
    vec3 wasVS = previousPosition(before.uv, before.viewZ);
    mat4 toBefore = frame.constants.viewToPrevView; // rigid
    vec3 positionVS = transpose(mat3(toBefore)) * (wasVS - toBefore[3].xyz);
    vec4 pixelH = frame.constants.viewToPixel * vec4(positionVS, 1.0);
    if (pixelH.w <= 0.0)
        return kNoSentinel;
    vec2 at = pixelH.xy / pixelH.w;
    if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, frame.constants.size)))
        return kNoSentinel;
    ivec2 px = floorToInt(at);
    LobeSurface shown = lobeSurfaceAt(px);
    if (shown.viewZ >= kBackgroundZ ||
        abs(dot(shown.normalVS, positionVS - shown.positionVS)) > kPlane * shown.viewZ ||
        previousPlace(px, shown.viewZ).moved)
        return kNoSentinel;
    return Sentinel(at * frame.constants.invSize, -positionVS.z, shownAt(px), before.state,
                    distance(at, before.uv * frame.constants.prevSize) > kMoved);
}

/// The sentinel of the previous frame's tile; none if that frame left none.
Sentinel previousSentinel(ivec2 tile, int slot) {
    if (!hasDenoiserHistory() || !wasInFrame(tile * int(kSentinelTile)))
        return kNoSentinel;
    Sentinel before = unpackSentinel(texelFetch(sentinelBefore, ivec2(2 * tile.x + slot, tile.y), 0));
    return exists(before) ? before : kNoSentinel;
}

void keep(Sentinel kept, ivec2 tile, int slot) {
    imageStore(sentinel, ivec2(2 * tile.x + slot, tile.y), packSentinel(kept));
}

/// The previous frame's tile that showed what this tile's middle shows.
ivec2 tileBefore(ivec2 tile) {
    ivec2 middle = min(tile * int(kSentinelTile) + int(kSentinelTile) / 2, ivec2(frame.constants.size) - 1);
    float z = texelFetch(viewZ, middle, 0).r;
    if (z >= kBackgroundZ)
        return tile;
    ivec2 before = floorToInt(previousPlace(middle, z).px);
    return wasInFrame(before) ? before / int(kSentinelTile) : tile;
}

/// True if the pixel's ray met a surface that the picture shows at its end.
bool wantsSentinel(ivec2 px, out RayRecord ray) {
    ray = unpackRayRecord(texelFetch(screenRecord, px, 0).xy);
    if (ray.outcome != kOutcomeHit && ray.outcome != kOutcomeSide)
        return false;
    return !isMirror(unpackSurface(texelFetch(surface, px, 0).xy).perceptualRoughness);
}

/// Where the ray of one of the tile's pixels ended.
Sentinel startSentinel(ivec2 tile) {
    const uint kPixels = kSentinelTile * kSentinelTile;
    ivec2 corner = tile * int(kSentinelTile);
    bool brightest = takesBrightest(tile, frame.constants.frameIndex);
    uint first = uint(hashNoise(uvec2(tile), frame.constants.frameIndex, frame.constants.seed).z * float(kPixels));
    vec2 hitUV = vec2(-1.0);
    float most = -1.0;
    for (uint i = 0u; i < kPixels; ++i) {
        uint at = (first + i) % kPixels;
        ivec2 px = corner + ivec2(at % kSentinelTile, at / kSentinelTile);
        RayRecord ray;
        if (!isInFrame(px) || !wantsSentinel(px, ray))
            continue;
        vec4 answer = brightest ? texelFetch(screenAnswer, px, 0) : vec4(0.0);
        float brightness = answer.a * maxComponent(answer.rgb);
        if (brightness > most) {
            most = brightness;
            hitUV = ray.hitUV;
        }
        if (!brightest)
            break;
    }
    if (hitUV.x < 0.0)
        return kNoSentinel;
    ivec2 px = min(ivec2(hitUV * frame.constants.size), ivec2(frame.constants.size) - 1);
    float z = texelFetch(viewZ, px, 0).r;
    if (z >= kBackgroundZ)
        return kNoSentinel;
    return Sentinel(middleUV(px), z, shownAt(px), kExists, false);
}

/// True if the sentinel saw a change that makes a witness.
bool sawChange(Sentinel then, Sentinel now) {
    vec2 change = changeBetween(then.shown, now.shown, now.moved);
    return exists(now) && isChange(vec2(abs(change.x), change.y));
}

/// The sentinel that stays a tile's witness, of its two and what they became; none if neither saw a change.
Sentinel witnessOf(Sentinel fresh, Sentinel freshNow, Sentinel witness, Sentinel witnessNow) {
    if (sawChange(fresh, freshNow)) {
        freshNow.state = withAge(freshNow.state, 0u);
        return freshNow;
    }
    uint age = ageOf(witness.state);
    bool changed = sawChange(witness, witnessNow);
    witnessNow.state = withAge(witnessNow.state, changed ? 0u : age + 1u);
    return changed || age < kLongestAge ? witnessNow : kNoSentinel;
}

/// What the image `change` holds of one sentinel.
vec3 changeOf(Sentinel then, Sentinel now) {
    vec2 change = exists(now) ? changeBetween(then.shown, now.shown, now.moved) : vec2(0.0);
    return vec3(abs(change.x), change.y, change.x);
}

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile * int(kSentinelTile), ivec2(frame.constants.size))))
        return;
    ivec2 before = tileBefore(tile);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 2; ++i) { // what the tile's sentinels see; whose witness this frame's tile takes over
        bool takesOver = i == 1;
        ivec2 from = takesOver ? before : tile;
        Sentinel fresh = previousSentinel(from, kFresh);
        Sentinel witness = previousSentinel(from, kWitness);
        Sentinel freshNow = kNoSentinel;
        Sentinel witnessNow = kNoSentinel;
        if (exists(fresh))
            freshNow = followed(fresh);
        if (exists(witness))
            witnessNow = followed(witness);
        if (takesOver) {
            keep(witnessOf(fresh, freshNow, witness, witnessNow), tile, kWitness);
            continue;
        }
        sum += changeOf(fresh, freshNow);
        sum += changeOf(witness, witnessNow) * weightOfWitness(ageOf(witness.state));
    }
    keep(startSentinel(tile), tile, kFresh);
    imageStore(change, tile, vec4(sum, 0.0));
}
