// A transparent surface in a path: the light that it adds, its transmittance, and where the path continues. Bodies
// (KHR_materials_volume) refract where light enters and leaves them, and absorb in between. Thin walls and blended
// surfaces do not bend light. Include after hit_lighting.glsl and surface_table.glsl.
#ifndef GLINT_RAYS_TRANSPARENTS_GLSL
#define GLINT_RAYS_TRANSPARENTS_GLSL

#include "lib/refraction.glsl"
#include "lib/sampling.glsl"
#include "lib/transmission.glsl"
#include "rays/hit_lighting.glsl"
#include "rays/regularization.glsl"

/// The medium that a path is in.
struct Medium {
    uint body;       // instance whose surface the path has entered; kNoInstance: outside of bodies
    float thickness; // metres, from the material
    vec3 attenuationColor;
    float attenuationDistance;
};

const Medium kAir = Medium(kNoInstance, 0.0, vec3(1.0), 0.0);

/// Transmittance of `distance` metres. `throughBody`: the segment ends at the body's own surface. Otherwise the mesh is
/// open or another object is inside it, and the segment counts for at most the thickness.
vec3 mediumTransmittance(Medium medium, float distance, bool throughBody) {
    if (medium.body == kNoInstance)
        return vec3(1.0);
    return volumeTransmittance(throughBody ? distance : min(distance, medium.thickness), medium.attenuationColor,
                               medium.attenuationDistance);
}

struct Passage {
    vec3 own;         // radiance towards the path's previous vertex
    vec3 through;     // transmittance for the light behind
    vec3 directionWS; // unit
    bool isReflected; // stays on the side from which the path came: total reflection in a body
    Medium medium;    // behind the surface
    float lobeRoughness;
    float power; // 1 - 1/n of the refracting surface; how much a curved surface spreads neighbouring paths
};

/// Draws a direction in which light leaves a rough interface. `eta`: index of refraction before the interface over that
/// behind it. Returns zero for total reflection.
vec3 refractRough(vec3 directionWS, vec3 N, float eta, float perceptualRoughness, vec2 noise) {
    vec3 H = N;
    if (perceptualRoughness > 0.0) {
        mat3 frameOfN = orthonormalBasis(N);
        vec3 wo = -directionWS * frameOfN;
        wo = normalize(vec3(wo.xy, max(wo.z, 1e-3)));
        H = frameOfN * sampleGGXVisibleCap(wo, noise, square(perceptualRoughness));
    }
    return refract(directionWS, H, eta);
}

/// A rough thin wall scatters transmitted light with its reflection lobe, mirrored to the other side. Khronos' glTF
/// Sample Viewer: transmission.
vec3 throughThinWall(vec3 directionWS, vec3 N, float perceptualRoughness, vec2 noise) {
    if (perceptualRoughness <= 0.0)
        return directionWS;
    mat3 frameOfN = orthonormalBasis(N);
    vec3 wo = -directionWS * frameOfN;
    wo = normalize(vec3(wo.xy, max(wo.z, 1e-3)));
    vec3 wi = reflect(-wo, sampleGGXVisibleCap(wo, noise, square(perceptualRoughness)));
    return wi.z > 1e-4 ? frameOfN * vec3(wi.xy, -wi.z) : directionWS;
}

/// Passes out of the body `medium` through its own surface.
Passage leaveBody(HitSurface met, MaterialSample m, Medium medium, vec3 directionWS, vec2 noise) {
    float roughness = transmissionRoughness(m.perceptualRoughness, met.material.ior);
    vec3 N = facingNormal(m.normalWS, -directionWS);
    float ior = max(met.material.ior, 1e-3);
    vec3 outside = refractRough(directionWS, N, ior, roughness, noise);
    bool total = dot(outside, outside) < 0.5;
    return Passage(vec3(0.0), vec3(1.0), normalize(total ? reflect(directionWS, N) : outside), total,
                   total ? medium : kAir, roughness, 1.0 - 1.0 / ior);
}

/// Passes a surface hit from outside, or within another body. Fresnel's factor is applied once, at the front.
/// `ownRoughness`: of `m` before regularization.
Passage passSurface(HitSurface met, MaterialSample m, float ownRoughness, Lighting lighting, uint instance,
                    Medium medium, vec3 directionWS, vec2 noise) {
    float roughness = transmissionRoughness(ownRoughness, met.material.ior);
    vec3 response = specularResponse(m.f0, m.f90, loadDfg(clampedNoV(m.normalWS, -directionWS), m.perceptualRoughness));
    float present = saturate(m.opacity * 20.0); // as the renderer's layers: no sheen where a texture cuts out a shape

    Passage p;
    p.own = (lighting.diffuse + lighting.emission) * m.opacity +
            (lighting.directSpecular + lighting.coatSpecular + lighting.environmentSpecular) * present;
    p.through =
        vec3(1.0 - m.opacity) + m.baseColor * (m.transmission * m.opacity * (1.0 - saturate(maxComponent(response))));
    p.directionWS = directionWS;
    p.isReflected = false;
    p.medium = medium;
    p.lobeRoughness = 0.0;
    p.power = 0.0;
    if (m.transmission <= 0.0 || medium.body != kNoInstance)
        return p;
    p.lobeRoughness = roughness;
    float ior = met.material.ior;
    if (m.thickness <= 0.0 || ior <= 0.0 || !met.point.frontFacing) {
        p.directionWS = throughThinWall(directionWS, m.normalWS, roughness, noise);
        return p;
    }
    vec3 N = facingNormal(m.normalWS, -directionWS);
    vec3 inside = refractRough(directionWS, N, 1.0 / ior, roughness, noise);
    p.isReflected = dot(inside, inside) < 0.5; // a bubble
    p.directionWS = normalize(p.isReflected ? reflect(directionWS, N) : inside);
    p.power = 1.0 - 1.0 / max(ior, 1e-3);
    if (!p.isReflected)
        p.medium =
            Medium(instance, m.thickness * met.scale, met.material.attenuationColor, met.material.attenuationDistance);
    return p;
}

#endif
