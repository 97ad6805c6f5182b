// Finds where reflected light changes (denoise/sentinel.glsl), by paths through the host's triangles. Each tile of pixels
// starts one sentinel a frame: a path whose radiance is kept, and which the next frame follows once more, from the same
// start with the same random numbers, in its own scene. docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/surface_table.glsl"

#include "rays/back_end.glsl"
#include "rays/rays_inputs.glsl"

#define GLINT_RAYS_TABLE_LIGHT
#include "denoise/history.glsl"
#include "denoise/sentinel.glsl"
#include "lib/half.glsl"
#include "lib/octahedral.glsl"
#include "rays/path.glsl"

#include "rays/hit_motion.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 6) uniform sampler2D raysAnswer;          // of this frame: radiance, weight
layout(set = 0, binding = 7) uniform usampler2D sentinelRayBefore;  // loadSentinel
layout(set = 0, binding = 8) uniform usampler2D sentinelPathBefore;
layout(set = 0, binding = 9, rgba32ui) uniform writeonly uimage2D sentinelRay;
layout(set = 0, binding = 11, rgba32ui) uniform writeonly uimage2D sentinelPath;
/// Of the previous frame's tiles: how much radiance changed, the larger of the two radiances, the change once more (paths
/// have no noise for its sign to tell from change). 0: unknown.
layout(set = 0, binding = 12, rgba16f) uniform writeonly image2D change;

/// A path's start, in the precision that it is kept in, and its radiance.
struct Sentinel {
    uvec4 ray;  // originWS as bits; direction, octahedral
    uvec4 path; // radiance and drawnAngle (radians), halves; the cone's width and spread, halves; state
};

// The state holds, besides: whether what it hit moved; the number of its random sequence.
const uint kMoves = 1u << 30;
const uint kSequence = 0xffffu;

const Sentinel kNoSentinel = Sentinel(uvec4(0u), uvec4(0u));

bool exists(Sentinel sentinel) {
    return (sentinel.path.w & kExists) != 0u;
}

Sentinel aged(Sentinel sentinel, uint age) {
    sentinel.path.w = withAge(sentinel.path.w, age);
    return sentinel;
}

vec3 radianceOf(Sentinel sentinel) {
    return vec3(unpackHalf2x16(sentinel.path.x), unpackHalf2x16(sentinel.path.y).x);
}

/// The sentinel after its path was followed in this frame's scene.
Sentinel followed(Sentinel sentinel, ivec2 tile) {
    vec2 cone = unpackHalf2x16(sentinel.path.z);
    float angle = unpackHalf2x16(sentinel.path.y).y;
    Path path = startPath(uintBitsToFloat(sentinel.ray.xyz), decodeOctahedral(unpackSnorm2x16(sentinel.ray.w)),
                          Cone(cone.x, cone.y), angle, regularizationOf(settings.regularization, 1.0));
    path.isAveraged = angle > 0.0;
    path.splits = !path.isAveraged;
    followPath(0u, tile, sentinel.path.w & kSequence, path);
    vec3 radiance = min(sanitize(path.radiance) * path.weight, vec3(kLargestStored)); // in the precision that is kept
    sentinel.path.xy = uvec2(packHalf2x16(radiance.rg), packHalf2x16(vec2(radiance.b, angle)));
    sentinel.path.w &= ~kMoves;
    if (hitStepWS(path.first, path.hitWS) != vec3(0.0))
        sentinel.path.w |= kMoves;
    return sentinel;
}

/// True if light differs because something moves through the path: the denoiser follows that (rays/hit_motion.glsl).
bool seesMotion(Sentinel then, Sentinel now) {
    return ((then.path.w | now.path.w) & kMoves) != 0u;
}

/// True if the sentinel starts in the tile or beside it, from a surface that stands where it stood. What the frame does
/// not show counts as standing.
bool standsNear(vec3 originWS, ivec2 tile) {
    vec3 positionVS = (frame.constants.worldToView * vec4(originWS, 1.0)).xyz;
    vec4 pixelH = frame.constants.viewToPixel * vec4(positionVS, 1.0);
    if (pixelH.w <= 0.0)
        return false;
    ivec2 px = ivec2(floor(pixelH.xy / pixelH.w));
    ivec2 apart = abs(px - (tile * int(kSentinelTile) + int(kSentinelTile) / 2));
    if (max(apart.x, apart.y) > 2 * int(kSentinelTile))
        return false;
    if (any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return true;
    const float kPlane = 0.005; // of viewZ
    float z = texelFetch(viewZ, px, 0).r;
    vec3 shownVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    vec3 normalVS = unpackSurface(texelFetch(surface, px, 0).xy).normalVS;
    return z < kBackgroundZ && abs(dot(normalVS, positionVS - shownVS)) < kPlane * z;
}

/// The sentinel that the previous frame left in the slot, if it can be followed again.
Sentinel previousSentinel(ivec2 tile, int slot) {
    if (!hasDenoiserHistory())
        return kNoSentinel;
    ivec2 at = ivec2(2 * tile.x + slot, tile.y);
    Sentinel before = Sentinel(texelFetch(sentinelRayBefore, at, 0), texelFetch(sentinelPathBefore, at, 0));
    return exists(before) && standsNear(uintBitsToFloat(before.ray.xyz), tile) ? before : kNoSentinel;
}

void keep(Sentinel sentinel, ivec2 tile, int slot) {
    ivec2 at = ivec2(2 * tile.x + slot, tile.y);
    imageStore(sentinelRay, at, sentinel.ray);
    imageStore(sentinelPath, at, sentinel.path);
}

bool wantsSentinel(ivec2 px) {
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))) || texelFetch(viewZ, px, 0).r >= kBackgroundZ)
        return false;
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    return here.reflectivity > settings.threshold && here.perceptualRoughness <= settings.maxRoughness &&
           (isOn(kRaysBranches) || !isMirror(here.perceptualRoughness));
}

/// The pixel of the tile that starts its sentinel. x < 0: none.
ivec2 startPixel(ivec2 tile) {
    ivec2 corner = tile * int(kSentinelTile);
    bool brightest = takesBrightest(tile, frame.constants.frameIndex);
    uint first = uint(hashNoise(uvec2(tile), frame.constants.frameIndex, frame.constants.seed).z *
                      float(kSentinelTile * kSentinelTile));
    ivec2 found = ivec2(-1);
    float most = -1.0;
    for (uint i = 0u; i < kSentinelTile * kSentinelTile; ++i) {
        uint at = (first + i) % (kSentinelTile * kSentinelTile);
        ivec2 px = corner + ivec2(at % kSentinelTile, at / kSentinelTile);
        if (!wantsSentinel(px))
            continue;
        if (!brightest)
            return px;
        vec4 answer = texelFetch(raysAnswer, px, 0);
        float brightness = answer.a * maxComponent(answer.rgb);
        if (brightness > most) {
            most = brightness;
            found = px;
        }
    }
    return found;
}

Sentinel startSentinel(ivec2 tile) {
    ivec2 px = startPixel(tile);
    if (px.x < 0)
        return kNoSentinel;
    PixelRays from = pixelRaysAt(px);
    Direction first = samplePixel(from, 0u);
    if (first.weight <= 0.0)
        return kNoSentinel;
    float angle = drawnAngle(from.N, from.V, first.ws, from.perceptualRoughness);
    Sentinel made;
    made.ray = uvec4(floatBitsToUint(from.originWS), packSnorm2x16(encodeOctahedral(first.ws)));
    made.path = uvec4(0u, packHalf2x16(vec2(0.0, angle)), packHalf2x16(vec2(from.cone.width, from.cone.spread)),
                      kExists | (frame.constants.frameIndex & kSequence));
    return made;
}

/// How much radiance changed; the larger of the two radiances.
vec2 changeBetween(vec3 then, vec3 now) {
    return vec2(maxComponent(abs(now - then)), max(maxComponent(now), maxComponent(then)));
}

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile * int(kSentinelTile), ivec2(frame.constants.size))))
        return;
    vec2 sum = vec2(0.0);
    Sentinel witness = kNoSentinel;
    for (int i = 0; i < 3; ++i) { // a loop, so that the program holds one copy of all that follows a path
        bool starts = i == 2;
        Sentinel sentinel;
        if (starts)
            sentinel = startSentinel(tile);
        else
            sentinel = previousSentinel(tile, i == 0 ? kWitness : kFresh);
        Sentinel then = sentinel;
        if (exists(sentinel))
            sentinel = followed(sentinel, tile);
        if (starts) {
            keep(sentinel, tile, kFresh);
        } else if (exists(sentinel)) {
            bool counts = !seesMotion(then, sentinel);
            vec2 apart = changeBetween(radianceOf(then), radianceOf(sentinel));
            uint age = ageOf(sentinel.path.w);
            if (counts)
                sum += i == 0 ? apart * weightOfWitness(age) : apart;
            if (counts && isChange(apart))
                witness = aged(sentinel, 0u);
            else if (i == 0 && age < kLongestAge)
                witness = aged(sentinel, age + 1u);
        }
    }
    keep(witness, tile, kWitness);
    imageStore(change, tile, vec4(sum, sum.x, 0.0));
}
