// The rays of a listed pixel: their starts, directions and widths.
#ifndef GLINT_RAYS_PIXEL_RAYS_GLSL
#define GLINT_RAYS_PIXEL_RAYS_GLSL

#include "lib/ray_record.glsl"
#include "lib/ray_start.glsl"
#include "lib/sampling.glsl"
#include "rays/ray_noise.glsl"
#include "rays/rays_inputs.glsl"

/// Below this roughness a lobe is narrower than a pixel.
const float kMirrorRoughness = 0.001;

// ---------------------------------------------------------------- directions

struct Direction {
    vec3 ws;      // unit
    float weight; // fraction of the light from there that leaves the facets; 0: below the surface
};

/// Roughness of the lobe that directions are drawn from; 0 is a mirror.
float sampledRoughness(float perceptualRoughness) {
    return isOn(kRaysMirror) || perceptualRoughness < kMirrorRoughness ? 0.0 : perceptualRoughness;
}

/// Draws a direction that reflects to `V`, with the density of visible normals.
Direction sampleReflection(vec3 N, vec3 V, float perceptualRoughness, vec2 noise) {
    if (sampledRoughness(perceptualRoughness) == 0.0)
        return Direction(reflect(-V, N), 1.0);
    float alpha = square(perceptualRoughness);
    mat3 frameOfN = orthonormalBasis(N);
    vec3 wo = V * frameOfN;
    wo.z = max(wo.z, 1e-3); // a bent normal may face away
    wo = normalize(wo);
    vec3 wm = sampleGGXVisibleCap(wo, noise, alpha);
    vec3 wi = reflect(-wo, wm);
    if (wi.z <= 1e-4)
        return Direction(N, 0.0);
    return Direction(frameOfN * wi, visibleGGXWeight(wo.z, wi.z, alpha));
}

// ---------------------------------------------------------------- width

/// A ray cone as wide as its pixel. Akenine-Moller et al. 2021.
struct Cone {
    float width;  // metres, at the start
    float spread; // radians
};

/// Direction of a pixel's mirror ray, unit.
vec3 mirrorDirectionVS(ivec2 px) {
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    vec3 normalVS = unpackSurface(texelFetch(surface, px, 0).xy).normalVS;
    return reflect(viewDirection(frame.constants, viewPosition(frame.constants, uv, 1.0)), normalVS);
}

/// Angle by which the neighbours' mirror rays diverge from this one: the camera rays' angle on a flat mirror, more on a
/// curved one. Takes the smaller difference of both sides, since another surface lies across an edge. Radians, mean of
/// both axes.
float reflectedSpread(ivec2 px) {
    ivec2 last = ivec2(frame.constants.size) - 1;
    vec3 here = mirrorDirectionVS(px);
    float sum = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        ivec2 step = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
        ivec2 before = px - step;
        ivec2 behind = px + step;
        if (any(lessThan(before, ivec2(0))))
            before = min(behind, last);
        if (any(greaterThan(behind, last)))
            behind = max(before, ivec2(0));
        sum += min(distance(mirrorDirectionVS(before), here), distance(mirrorDirectionVS(behind), here));
    }
    return 0.5 * sum;
}

Cone pixelCone(ivec2 px, float z) {
    return Cone(pixelExtent(frame.constants, frame.constants.uvToView, z).y, reflectedSpread(px));
}

// ---------------------------------------------------------------- a pixel

struct PixelRays {
    ivec2 px;
    vec2 uv;
    vec3 originWS; // moved off the surface
    vec3 N;        // unit, world space
    vec3 V;        // unit, towards the eye
    float perceptualRoughness;
    Cone cone;
};

/// This invocation's index in the list.
uint listedRay() {
    return gl_WorkGroupID.y * (kRayGroupsX * kRaysPerGroup) + gl_WorkGroupID.x * kRaysPerGroup +
           gl_LocalInvocationIndex;
}

PixelRays loadPixelRays(uint index) {
    PixelRays from;
    from.px = ivec2(rays.pixels[index] & 0xffffu, rays.pixels[index] >> 16);
    from.uv = (vec2(from.px) + 0.5) * frame.constants.invSize;
    Surface origin = unpackSurface(texelFetch(surface, from.px, 0).xy);
    float z = texelFetch(viewZ, from.px, 0).r;
    vec3 positionVS = viewPosition(frame.constants, from.uv, z);
    mat3 toWorld = mat3(frame.constants.viewToWorld);
    from.V = -(toWorld * viewDirection(frame.constants, positionVS));
    from.N = toWorld * origin.normalVS;
    from.perceptualRoughness = origin.perceptualRoughness;
    vec3 positionWS = (frame.constants.viewToWorld * vec4(positionVS, 1.0)).xyz;
    bool halfDepth = (frame.constants.flags & kInputHalfDepth) != 0u;
    float offset = settings.tMin > 0.0 ? 0.0 : depthUncertainty(positionWS, z, halfDepth);
    from.originWS = positionWS + from.N * offset;
    from.cone = pixelCone(from.px, z);
    return from;
}

/// Number of sample `i` of this frame, counted across frames.
uint sampleNumber(uint i) {
    return frame.constants.frameIndex * settings.samples + i;
}

Direction samplePixel(PixelRays from, uint i) {
    vec2 noise = firstBounceNoise(from.px, sampleNumber(i), frame.constants.seed);
    return sampleReflection(from.N, from.V, from.perceptualRoughness, noise);
}

Ray viewRay(vec3 originWS, vec3 directionWS) {
    return Ray(originWS, settings.tMin, directionWS, settings.tMax, settings.cullMask, viewRayFlags());
}

vec2 projectedUV(vec3 positionWS) {
    vec3 positionVS = (frame.constants.worldToView * vec4(positionWS, 1.0)).xyz;
    vec4 pixelH = frame.constants.viewToPixel * vec4(positionVS, 1.0);
    return pixelH.w > 0.0 ? clamp(pixelH.xy / pixelH.w * frame.constants.invSize, 0.0, 1.0) : vec2(0.0);
}

#endif
