// The rays of a listed pixel: their starts and widths, and their directions by generate/lobe.glsl.
#ifndef GLINT_RAYS_PIXEL_RAYS_GLSL
#define GLINT_RAYS_PIXEL_RAYS_GLSL

#include "generate/sampled_ray.glsl"
#include "lib/face_normal.glsl"
#include "lib/ray_record.glsl"
#include "lib/ray_start.glsl"
#include "rays/rays_inputs.glsl"

/// Roughness of the lobe that directions are drawn from; 0 is a mirror.
float sampledRoughness(float perceptualRoughness) {
    return isOn(kRaysMirror) || perceptualRoughness < kMirrorRoughness ? 0.0 : perceptualRoughness;
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
    vec3 faceWS;   // unit, of the surface's plane; N where normals follow it
    bool isBent;   // they do not
    float perceptualRoughness;
    Cone cone;
};

FacePoint loadFacePoint(ivec2 px) {
    float z = texelFetch(viewZ, px, 0).r;
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    return FacePoint(viewPosition(frame.constants, uv, z), unpackSurface(texelFetch(surface, px, 0).xy).normalVS,
                     z < kBackgroundZ);
}

/// This invocation's index in the list.
uint listedRay() {
    return gl_WorkGroupID.y * (kRayGroupsX * kRaysPerGroup) + gl_WorkGroupID.x * kRaysPerGroup +
           gl_LocalInvocationIndex;
}

PixelRays pixelRaysAt(ivec2 px) {
    PixelRays from;
    from.px = px;
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
    vec3 faceVS = origin.normalVS;
    from.isBent = dot(from.N, from.V) <= kSteepView &&
                  findFaceNormal(from.px, FacePoint(positionVS, origin.normalVS, true), faceVS);
    from.faceWS = from.isBent ? toWorld * faceVS : from.N;
    from.originWS = positionWS + from.faceWS * offset;
    from.cone = pixelCone(from.px, z);
    return from;
}

PixelRays loadPixelRays(uint index) {
    return pixelRaysAt(ivec2(rays.pixels[index] & 0xffffu, rays.pixels[index] >> 16));
}

Direction samplePixel(PixelRays from, uint i) {
    vec2 noise = firstBounceNoise(from.px, sampleNumber(i), frame.constants.seed);
    Direction drawn = sampleLobe(from.N, from.V, sampledRoughness(from.perceptualRoughness), noise);
    if (from.isBent && drawn.weight > 0.0)
        drawn.ws = aboveSurface(drawn.ws, from.faceWS); // below is the surface itself
    return drawn;
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
