// The source `planar`: for each pixel on a mirror with an image, the radiance along the pixel's reflected ray in that
// image. The image shows the world behind the mirror from the frame's own camera, so the ray is marched in it as a
// screen-space ray is in the frame: a perfect mirror's ray stays at the pixel itself, a bumpy mirror's moves some way
// off. Roughness samples coarser mips. docs/techniques/planar.md.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "generate/pixel_ray.glsl"
#include "hierarchy/answers.glsl"
#include "lib/camera.glsl"
#include "lib/fades.glsl"
#include "lib/lobe_shape.glsl"
#include "lib/math.glsl"
#include "lib/nearness.glsl"
#include "lib/sanitize.glsl"
#include "lib/surface.glsl"
#include "shared/planar.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 9) readonly buffer PlanarBlock {
    PlanarRecord list[];
}
mirrors;
layout(set = 0, binding = 8, rgba16f) uniform writeonly image2D planarAnswer; // radiance, weight
layout(set = 1, binding = 0) uniform sampler2D pictures[];
layout(push_constant, scalar) uniform PushBlock {
    uint mirrorCount;
};
PlanarConstants settings = frame.settings.planar;

const float kMirrorLean = 0.8; // cosine: a normal farther off the mirror's is another surface's

bool liesOn(PlanarRecord mirror, vec3 positionVS, vec3 normalVS) {
    vec3 off = positionVS - mirror.centerVS;
    float slack = mirror.tolerance + 1e-4 * length(positionVS);
    return abs(dot(off, mirror.normalVS)) <= slack && abs(dot(off, mirror.tangentVS)) <= mirror.halfWidth + slack &&
           abs(dot(off, mirror.bitangentVS)) <= mirror.halfHeight + slack &&
           dot(normalVS, mirror.normalVS) > kMirrorLean;
}

float pictureZ(PlanarRecord mirror, vec2 framePx) {
    vec2 px = clamp(framePx * frame.constants.invSize * mirror.size, vec2(0.0), mirror.size - 1.0);
    return texelFetch(pictures[nonuniformEXT(2u * mirror.picture + 1u)], ivec2(px), 0).r;
}

/// A ray's path over the image: pixels of the frame and nearness, both linear from 0 to 1.
struct Way {
    vec2 fromPx;
    vec2 toPx;
    float fromNearness;
    float toNearness;
    bool leaves; // the path ends at the image's border, or on its way back to the eye: what lies beyond is unknown
};

/// The part of the segment from `from` to `to` that lies between 0 and `size`.
float insidePart(float from, float to, float size) {
    float along = to - from;
    return along > 0.0 ? (size - from) / along : along < 0.0 ? from / -along : 1.0;
}

Way wayOver(vec3 startVS, vec3 directionVS, vec2 startPx) {
    const float kFar = 1.0e6; // metres: end of a ray without length
    bool orthographic = isOrthographic(frame.constants);
    bool returns = directionVS.z > 0.0 && !orthographic;
    float reach = returns ? -0.9 * startVS.z / directionVS.z : kFar; // short of the eye's plane
    vec4 endH = frame.constants.viewToPixel * vec4(startVS + directionVS * reach, 1.0);
    Way way;
    way.fromPx = startPx;
    way.toPx = endH.xy / endH.w;
    way.fromNearness = nearnessOf(orthographic, -startVS.z);
    way.toNearness = nearnessOf(orthographic, -(startVS.z + directionVS.z * reach));
    float part = min(insidePart(way.fromPx.x, way.toPx.x, frame.constants.size.x),
                     insidePart(way.fromPx.y, way.toPx.y, frame.constants.size.y));
    way.leaves = part < 1.0 || returns;
    part = clamp(part, 0.0, 1.0);
    way.toPx = mix(way.fromPx, way.toPx, part);
    way.toNearness = mix(way.fromNearness, way.toNearness, part);
    return way;
}

/// How far the ray is behind the image's surface there, metres; the background is never hit.
float behindBy(PlanarRecord mirror, Way way, float t) {
    float z = pictureZ(mirror, mix(way.fromPx, way.toPx, t));
    return z < kBackgroundZ ? viewZOf(frame.constants, mix(way.fromNearness, way.toNearness, t)) - z : -1.0;
}

const uint kMeetsNothing = 0u; // ends in the background
const uint kMeets = 1u;
const uint kUnknown = 2u; // leaves the image, or continues behind a surface

/// Where along its path the ray hits a surface. One step for each pixel, at most settings.steps, then halvings down to
/// an eighth of a pixel. A ray that is still far behind after the halvings passed behind an edge, and continues.
uint meets(PlanarRecord mirror, Way way, out float t) {
    float lengthPx = distance(way.fromPx, way.toPx);
    uint steps = uint(clamp(ceil(lengthPx), 1.0, float(settings.steps)));
    float before = 0.0;
    bool hidden = false;
    for (uint i = 1u; i <= steps; ++i) {
        t = float(i) / float(steps);
        bool behind = behindBy(mirror, way, t) > 0.0;
        if (!behind || hidden) {
            hidden = behind;
            before = t;
            continue;
        }
        float after = t;
        for (float stepPx = lengthPx / float(steps); stepPx > 0.125; stepPx *= 0.5) {
            float middle = 0.5 * (before + after);
            if (behindBy(mirror, way, middle) > 0.0)
                after = middle;
            else
                before = middle;
        }
        // At a surface that the ray hits, the ray is behind it by what its last step adds, and a little.
        float farZ = viewZOf(frame.constants, mix(way.fromNearness, way.toNearness, after));
        float nearZ = viewZOf(frame.constants, mix(way.fromNearness, way.toNearness, before));
        if (lengthPx < 1.0 || behindBy(mirror, way, after) <= 2.0 * abs(farZ - nearZ) + 0.01 * farZ) {
            t = after;
            return kMeets;
        }
        hidden = true;
        before = t;
    }
    t = 1.0;
    return way.leaves || hidden ? kUnknown : kMeetsNothing;
}

/// 1 inside; falls to 0 at the border, except for rays that deviate little.
float fadeBorder(vec2 px, vec2 startPx) {
    vec2 toBorder = min(px, frame.constants.size - px) * frame.constants.invSize;
    float aside = length((px - startPx) * frame.constants.invSize);
    float width = max(min(settings.borderWidth, aside), 1e-6);
    vec2 inside = clamp(toBorder / width, 0.0, 1.0);
    return inside.x * inside.y;
}

/// Turn of the direction to what the image shows from pixel to pixel of the image, if that is infinitely far; what is
/// near turns by more, from a place on the mirror: over the part of the way that comes after the mirror.
mat2 pictureTurns(PlanarRecord mirror, LobeAxes axes, vec3 hitVS) {
    vec2 pixel = frame.constants.uvToView.xy / mirror.size / (isOrthographic(frame.constants) ? 1.0 : length(hitVS));
    float scale = isOrthographic(frame.constants) ? 1.0 : -hitVS.z;
    return mat2(alongAxes(axes, vec3(pixel.x * scale, 0.0, 0.0)), alongAxes(axes, vec3(0.0, pixel.y * scale, 0.0)));
}

/// The part of the way from the eye that comes after the mirror, of what is bright in a texel. All pixels of the mirror
/// see it at the end of a way of one length; this pixel's surface is `before` metres from the eye.
float partBehind(vec4 texel, float before) {
    float bright = meanComponent(texel.rgb);
    if (bright <= 1e-6 || isOrthographic(frame.constants))
        return 1.0;
    return clamp(1.0 - before * texel.a / bright, 0.02, 1.0);
}

/// What a pixel of the mirror sees of the image.
struct Sight {
    vec2 px;       // of the image
    float before;  // metres from the eye to the mirror
    LobeAxes axes; // of the lobe around the ray that continues through the mirror
    mat2 turns;    // pictureTurns
};

/// Adds one of the Gaussians that make the lobe, whose `ellipse` was made for `part`: what of it lies on the image.
void addPart(inout vec4 sum, PlanarRecord mirror, Sight sight, float share, LobeEllipse ellipse, float part) {
    const int kMostToSide = 6;
    LobeTaps taps = lobeTaps(ellipse, kMostToSide, mirror.lastMip);
    vec4 light = vec4(0.0);
    float whole = 0.0;
    for (int i = -taps.side; i <= taps.side; ++i) {
        vec2 offset = float(i) * taps.spacing * ellipse.along;
        float weight = tapWeight(taps, i) * facetVisible(sight.axes, (sight.turns * offset).x / part);
        whole += weight;
        vec2 at = sight.px + offset;
        if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, mirror.size)))
            continue;
        vec4 texel = textureLod(pictures[nonuniformEXT(2u * mirror.picture)], at / mirror.size, taps.mip);
        float away = float(i) * taps.spacing / max(ellipse.longPX, 1e-3);
        light +=
            weight * narrowerLobe(ellipse, taps, away, partBehind(texel, sight.before) / part) * vec4(texel.rgb, 1.0);
    }
    sum += whole > 0.0 ? share / whole * light : vec4(0.0);
}

/// The mirror's image as a surface of `alpha` reflects it.
vec3 pictureRadiance(PlanarRecord mirror, Sight sight, float alpha) {
    const float kSharp = 0.2; // pixels
    vec2 uv = sight.px / mirror.size;
    vec3 sharp = textureLod(pictures[nonuniformEXT(2u * mirror.picture)], uv, 0.0).rgb;
    if (lobeEllipse(sight.turns, lobeWidths(sight.axes, alpha, kLobeParts - 1)).longPX <= kSharp)
        return sharp;
    vec4 sum = vec4(0.0);
    float widest = 0.0;
    for (int i = 0; i < kLobeParts; ++i) {
        LobeEllipse ellipse = lobeEllipse(sight.turns, lobeWidths(sight.axes, alpha, i));
        float mip = min(lobeMip(sqrt(ellipse.longPX * ellipse.shortPX)), mirror.lastMip);
        float part = partBehind(textureLod(pictures[nonuniformEXT(2u * mirror.picture)], uv, mip), sight.before);
        ellipse.longPX *= part;
        ellipse.shortPX *= part;
        addPart(sum, mirror, sight, kLobeShares[i], ellipse, part);
        widest = max(widest, ellipse.longPX);
    }
    return mix(sharp, sum.rgb / max(sum.a, 1e-6), sum.a > 0.0 ? smoothstep(kSharp, 3.0 * kSharp, widest) : 0.0);
}

vec4 answer(ivec2 px, float z) {
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    float weight = fadeRoughness(here.perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness);
    if (weight <= 0.0 || here.reflectivity <= 0.0 || takenBefore(settings.before, px) >= 1.0)
        return vec4(0.0);
    vec2 centerPx = vec2(px) + 0.5;
    vec3 positionVS = viewPosition(frame.constants, centerPx * frame.constants.invSize, z);
    vec3 reflectedVS = generateRay(positionVS, here).directionVS;
    for (uint i = 0u; i < mirrorCount; ++i) {
        PlanarRecord mirror = mirrors.list[i];
        float away = dot(reflectedVS, mirror.normalVS);
        if (!liesOn(mirror, positionVS, here.normalVS) || away <= 0.0)
            continue;
        vec3 directionVS = reflectedVS - 2.0 * away * mirror.normalVS; // continues through the mirror
        Way way = wayOver(positionVS, directionVS, centerPx);
        float t;
        if (meets(mirror, way, t) == kUnknown)
            return vec4(0.0);
        vec2 hitPx = mix(way.fromPx, way.toPx, t);
        // A perfect mirror's ray does not move over the image: its length comes from the image's depth.
        float hitZ = min(pictureZ(mirror, hitPx), 1.0e6);
        vec3 hitVS = viewPosition(frame.constants, hitPx * frame.constants.invSize, hitZ);
        float alpha = here.perceptualRoughness * here.perceptualRoughness;
        float metres = distance(hitVS, positionVS);
        LobeAxes axes = lobeAxes(directionVS, reflect(here.normalVS, mirror.normalVS));
        mat2 turns = pictureTurns(mirror, axes, hitVS);
        if (isOrthographic(frame.constants))
            turns /= max(metres, 1e-3);
        Sight sight = Sight(hitPx * mirror.size * frame.constants.invSize, length(positionVS), axes, turns);
        vec3 radiance = pictureRadiance(mirror, sight, alpha);
        return vec4(sanitize(radiance), weight * fadeBorder(hitPx, centerPx));
    }
    return vec4(0.0);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = texelFetch(viewZ, px, 0).r;
    imageStore(planarAnswer, px, z < kBackgroundZ ? answer(px, z) : vec4(0.0));
}
