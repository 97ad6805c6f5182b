// Light reflected to the eye by one point: punctual lights and the environment, glTF's model (glTF 2.0, appendix B)
// with compensation for multiple scattering. The entry point provides lights, environment and tables, so the same code
// lights rasterized and ray-traced surfaces.
#ifndef GLINT_LIB_LIGHTING_GLSL
#define GLINT_LIB_LIGHTING_GLSL

#include "lib/clearcoat.glsl"
#include "lib/environment_lobe.glsl"
#include "lib/lights.glsl"
#include "lib/material.glsl"

// ---------------------------------------------------------------- defined by the entry point

uint loadLightCount();
Light loadLight(uint index);
/// So many lights share one test of visibility. 1: each light has its own.
uint loadLightsTogether();
/// Uniform in [0, 1), for the lights that share a test from number `first` on: it draws the one that is tested.
float loadLightNoise(uint first);
/// Fraction of the light that is not shadowed, [0, 1]. Asked of lights that cast shadows.
float loadLightVisibility(Light light, vec3 positionWS, vec3 geometricNormalWS, vec3 L);
/// Radiance from the environment around `directionWS`, filtered for the roughness.
vec3 loadEnvironmentRadiance(vec3 directionWS, float perceptualRoughness);
/// Irradiance from the environment / pi: the radiance of a white diffuse surface.
vec3 loadEnvironmentDiffuse(vec3 normalWS);
/// The split-sum table (lib/dfg.glsl).
vec2 loadDfg(float NoV, float perceptualRoughness);

/// What a rough surface reflects of the environment to the eye, before its own response.
vec3 loadEnvironmentLobe(vec3 N, vec3 V, float perceptualRoughness) {
    if (perceptualRoughness < kSmoothestLobe)
        return loadEnvironmentRadiance(reflect(-V, N), perceptualRoughness);
    EnvironmentLobe lobe = beginLobe(N, V, perceptualRoughness);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kLobeLookups; ++i) {
        LobeLookup at = nextLookup(i, lobe);
        sum += at.weight * loadEnvironmentRadiance(at.direction, at.perceptualRoughness);
    }
    return max(sum, vec3(0.0));
}

// ---------------------------------------------------------------- results

/// Outgoing radiance in parts. Their sum is the surface's radiance in the frame.
struct Lighting {
    vec3 diffuse;             // of all lights
    vec3 directSpecular;      // of punctual lights, clear coat included
    vec3 environmentSpecular; // the base layer's: the part that reflections replace
    vec3 coatSpecular;        // the clear coat's reflection of the environment
    vec3 emission;
};

/// Mean of D over the half vectors `H` of a light that is a disc. A light that turns by an angle turns the half vector by
/// half of it in the plane of incidence, and by 1 / (2 VoH) of it across: an ellipse, of which the disc has the area. Where
/// the disc decides the shape and not the lobe, the slopes are measured by the ellipse's axes.
float discNormals(vec3 N, vec3 V, vec3 L, vec3 H, float alpha, float angularRadius) {
    float VoH = max(dot(V, H), 0.05);
    float NoH = max(dot(N, H), 1e-3);
    float radius = 0.5 * angularRadius * inversesqrt(VoH);
    vec3 slope = H / NoH - N;
    vec3 inPlane = L - V;
    inPlane = normalizeOr(inPlane - dot(inPlane, N) * N, vec3(0.0)); // no plane: both axes are equal
    float along2 = square(dot(slope, inPlane));
    float across2 = max(dot(slope, slope) - along2, 0.0);
    float sharp = square(radius) / (square(radius) + square(alpha));
    float d2 = along2 * mix(1.0, 1.0 / VoH, sharp) + across2 * mix(1.0, VoH, sharp);
    return D_GGXOverDisc(NoH, d2, alpha, radius);
}

/// One specular lobe under a punctual light, or under one that is a disc, times NoL.
vec3 specularLobe(vec3 N, vec3 V, Incidence incidence, vec3 f0, float f90, float perceptualRoughness) {
    const float kSmoothestDisc = 1e-3; // alpha: with less the slopes' rounding shows
    vec3 L = incidence.L;
    float NoL = saturate(dot(N, L));
    if (NoL == 0.0)
        return vec3(0.0);
    bool isDisc = incidence.angularRadius > 0.0;
    float alpha = isDisc ? max(square(perceptualRoughness), kSmoothestDisc)
                         : square(max(perceptualRoughness, kMinPerceptualRoughnessDirect));
    vec3 H = normalizeOr(V + L, N);
    float NoV = clampedNoV(N, V);
    float normals = isDisc ? discNormals(N, V, L, H, alpha, incidence.angularRadius) : D_GGX(saturate(dot(N, H)), alpha);
    return normals * V_SmithGGXCorrelated(NoV, NoL, alpha) * F_Schlick(f0, f90, saturate(dot(V, H))) * NoL;
}

/// What a punctual light adds where nothing shadows it.
struct Unshadowed {
    vec3 diffuse;
    vec3 specular;
};

Unshadowed unshadowedLight(MaterialSample m, vec3 V, Incidence incidence, vec3 compensation, float coat) {
    vec3 L = incidence.L;
    float NoL = saturate(dot(m.normalWS, L));
    float VoH = saturate(dot(V, normalizeOr(V + L, m.normalWS)));
    float reflected = maxComponent(F_Schlick(m.dielectricF0, m.dielectricF90, VoH));
    Unshadowed result;
    result.diffuse =
        incidence.irradiance * m.diffuseColor * ((1.0 - reflected) * Fd_Lambert() * NoL * (1.0 - coat));
    result.specular = incidence.irradiance * compensation * (1.0 - coat) *
                      specularLobe(m.normalWS, V, incidence, m.f0, m.f90, m.perceptualRoughness);
    if (coat > 0.0)
        result.specular += incidence.irradiance * coat * specularLobe(m.clearcoatNormalWS, V, incidence, vec3(1.0), 1.0,
                                                                      m.clearcoatPerceptualRoughness);
    return result;
}

/// Adds the lights from `first` to before `end`. Of those that cast shadows one is drawn, by what each would add, and its
/// visibility stands for that of all. The mean is right; where all are visible or none is, only the lights' colours differ
/// from draw to draw. Talbot, Cline and Egbert 2005, "Importance Resampling for Global Illumination", with one sample.
/// Drawn while counting: Chao 1982, "A General Purpose Unequal Probability Sampling Plan".
void addPunctualLights(inout Lighting sum, MaterialSample m, SurfacePoint point, vec3 V, uint first, uint end,
                       vec3 compensation, float coat) {
    float noise = end - first > 1u ? loadLightNoise(first) : 0.0;
    float total = 0.0; // sizes of the lights so far
    float drawnSize = 0.0;
    uint drawn = first;
    vec3 drawnL = vec3(0.0);
    Unshadowed share = Unshadowed(vec3(0.0), vec3(0.0));
    for (uint i = first; i < end; ++i) {
        Light light = loadLight(i);
        Incidence incidence = lightAt(light, point.positionWS);
        float cosine = dot(m.normalWS, incidence.L);
        if (m.clearcoat > 0.0)
            cosine = max(cosine, dot(m.clearcoatNormalWS, incidence.L));
        if (cosine <= 0.0 || maxComponent(incidence.irradiance) <= 0.0)
            continue;
        Unshadowed added = unshadowedLight(m, V, incidence, compensation, coat);
        if (light.castsShadow == 0u) {
            sum.diffuse += added.diffuse;
            sum.directSpecular += added.specular;
            continue;
        }
        float size = maxComponent(added.diffuse + added.specular);
        if (size <= 0.0)
            continue;
        total += size;
        float part = size / total;
        bool take = drawnSize == 0.0 || noise < part;
        noise = take ? noise / part : (noise - part) / (1.0 - part);
        if (take) {
            drawn = i;
            drawnL = incidence.L;
            drawnSize = size;
            share = added;
        }
    }
    if (drawnSize == 0.0)
        return;
    float visible = loadLightVisibility(loadLight(drawn), point.positionWS, m.geometricNormalWS, drawnL);
    if (drawnSize < total)
        visible *= total / drawnSize;
    sum.diffuse += visible * share.diffuse;
    sum.directSpecular += visible * share.specular;
}

void addEnvironment(inout Lighting sum, MaterialSample m, vec3 V, vec2 dfg, float coat) {
    float NoV = clampedNoV(m.normalWS, V);
    float alpha = square(m.perceptualRoughness);
    float reflected = maxComponent(specularResponse(m.dielectricF0, m.dielectricF90, dfg));
    sum.diffuse += loadEnvironmentDiffuse(m.normalWS) * m.diffuseColor *
                   ((1.0 - saturate(reflected)) * m.occlusion * (1.0 - coat));
    vec3 response = specularResponse(m.f0, m.f90, dfg);
    sum.environmentSpecular = loadEnvironmentLobe(m.normalWS, V, m.perceptualRoughness) * response *
                              (specularOcclusion(NoV, m.occlusion, alpha) * (1.0 - coat));
    if (coat > 0.0) {
        float coatNoV = clampedNoV(m.clearcoatNormalWS, V);
        float coatAlpha = square(m.clearcoatPerceptualRoughness);
        sum.coatSpecular =
            loadEnvironmentLobe(m.clearcoatNormalWS, V, m.clearcoatPerceptualRoughness) *
            (coat * specularOcclusion(coatNoV, m.occlusion, coatAlpha));
    }
}

/// `V`: unit, towards the eye.
Lighting lightSurface(MaterialSample m, SurfacePoint point, vec3 V) {
    Lighting sum;
    float coat = m.clearcoat > 0.0 ? coatReflectance(m, V) : 0.0;
    sum.diffuse = sum.directSpecular = sum.environmentSpecular = sum.coatSpecular = vec3(0.0);
    sum.emission = m.emission * (1.0 - coat);
    if (maxComponent(m.diffuseColor) + maxComponent(m.f0) + m.f90 + m.clearcoat == 0.0)
        return sum; // unlit or black: no lobe to light
    vec2 dfg = loadDfg(clampedNoV(m.normalWS, V), m.perceptualRoughness);
    vec3 compensation = energyCompensation(m.f0, dfg);
    uint lights = loadLightCount();
    uint together = loadLightsTogether();
    for (uint first = 0u; first < lights; first += together)
        addPunctualLights(sum, m, point, V, first, min(first + together, lights), compensation, coat);
    addEnvironment(sum, m, V, dfg, coat);
    return sum;
}

vec3 totalRadiance(Lighting lighting) {
    return lighting.diffuse + lighting.directSpecular + lighting.environmentSpecular + lighting.coatSpecular +
           lighting.emission;
}

#endif
