// Each rough pixel also uses the rays of its neighbours, weighed by its own lobe: the ratio estimator of Stachowiak 2015,
// "Stochastic Screen-Space Reflections", with weights bounded by pairwise mixtures of densities (balance heuristic, Veach
// 1995). Uniform light stays exactly uniform. docs/techniques/denoise.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/lobe_surface.glsl"
#include "generate/sampled_ray.glsl"
#include "lib/noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D noisy;    // weight * radiance, weight
layout(set = 0, binding = 4) uniform sampler2D nearness; // 1 / metres to the ray's end; -1: no ray
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D reused;
layout(set = 0, binding = 6, r32f) uniform writeonly image2D reusedNearness;
DenoiseConstants settings = frame.settings.denoise;

/// A pixel's ray and what it brought back.
struct Lobe {
    LobeSurface at;
    mat3 fromLocal; // columns: tangent, bitangent, normal; view space
    vec3 wo;        // local, to the eye
    float alpha;
    vec3 directionVS;
    float density; // with which the direction was drawn; 0: below the surface
    float distance; // metres to where the ray ended
    vec4 answer;
    float near;
};

Lobe lobeAt(ivec2 px, LobeSurface at) {
    Lobe lobe;
    lobe.at = at;
    lobe.fromLocal = orthonormalBasis(at.normalVS);
    lobe.wo = at.toEyeVS * lobe.fromLocal;
    lobe.wo = normalize(vec3(lobe.wo.xy, max(lobe.wo.z, 1e-3)));
    lobe.alpha = square(at.perceptualRoughness);
    Direction drawn = sampledDirection(px, at.positionVS, Surface(at.normalVS, at.perceptualRoughness, 1.0));
    lobe.directionVS = mat3(frame.constants.worldToView) * drawn.ws;
    lobe.density = drawn.weight > 0.0 ? lobeDensity(lobe.wo, lobe.directionVS * lobe.fromLocal, lobe.alpha) : 0.0;
    lobe.answer = texelFetch(noisy, px, 0);
    lobe.near = texelFetch(nearness, px, 0).r;
    lobe.distance = endDistance(lobe.near);
    return lobe;
}

/// Where `from`'s ray ended, as seen from `to`: its direction, and by how much solid angles shrink on the way.
vec3 carried(Lobe from, LobeSurface to, out float jacobian) {
    vec3 way = from.at.positionVS + from.directionVS * from.distance - to.positionVS;
    float distance2 = max(dot(way, way), 1e-12);
    jacobian = clamp(square(from.distance) / distance2, 0.25, 4.0);
    return way * inversesqrt(distance2);
}

struct Sums {
    vec4 answer;
    float near;
    float weight;
};

void add(inout Sums sums, Lobe lobe, float weight) {
    sums.answer += weight * lobe.answer;
    sums.near += weight * max(lobe.near, 0.0);
    sums.weight += weight;
}

/// Adds a neighbour's ray; returns the weight that the pixel's own ray gets in this pair.
float addPair(inout Sums sums, Lobe own, Lobe other) {
    float shrink;
    vec3 wi = carried(other, own.at, shrink) * own.fromLocal;
    float theirs = other.density / shrink;
    float weight = lobeResponse(own.wo, wi, own.alpha) / max(theirs + lobeDensity(own.wo, wi, own.alpha), 1e-20);
    add(sums, other, theirs > 0.0 ? weight : 0.0);
    if (own.density <= 0.0)
        return 0.0;
    vec3 ownLocal = own.directionVS * own.fromLocal;
    vec3 across = carried(own, other.at, shrink) * other.fromLocal;
    float asTheirs = lobeDensity(other.wo, across, other.alpha) * shrink;
    return lobeResponse(own.wo, ownLocal, own.alpha) / (asTheirs + own.density);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (!isInFrame(px))
        return;
    vec4 answer = texelFetch(noisy, px, 0);
    float near = texelFetch(nearness, px, 0).r;
    LobeSurface here = lobeSurfaceAt(px);
    if (near >= 0.0 && settings.reuseSamples > 0u && !isMirror(here.perceptualRoughness)) {
        Lobe own = lobeAt(px, here);
        Sums sums = Sums(vec4(0.0), 0.0, 0.0);
        float ownWeight = 0.0;
        float radius = clamp(0.5 * lobePixels(here.perceptualRoughness, here.viewZ, near), 1.0, settings.reuseRadius);
        mat2 disc = lobeDisc(here, radius);
        float turn = hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed).x;
        for (uint i = 0u; i < settings.reuseSamples; ++i) {
            ivec2 tap = ivec2(floor(vec2(px) + 0.5 + disc * vogelPoint(i, settings.reuseSamples, turn)));
            if (tap == px || !isInFrame(tap))
                continue;
            LobeSurface there = lobeSurfaceAt(tap);
            if (!isSameSurface(here, there) || isMirror(there.perceptualRoughness) || texelFetch(nearness, tap, 0).r < 0.0)
                continue;
            ownWeight += addPair(sums, own, lobeAt(tap, there));
        }
        if (sums.weight > 0.0) {
            add(sums, own, ownWeight);
            answer = sums.answer / sums.weight;
            near = sums.near / sums.weight;
        }
    }
    imageStore(reused, px, answer);
    imageStore(reusedNearness, px, vec4(near));
}
