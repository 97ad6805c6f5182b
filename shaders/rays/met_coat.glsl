// A clear coat that a path meets: a second lobe, over that of the surface. The path goes on from one of the two, drawn by
// their energy. Where directions are not sampled, it goes on from the stronger one, and the other reflects the environment.
#ifndef GLINT_RAYS_MET_COAT_GLSL
#define GLINT_RAYS_MET_COAT_GLSL

#include "lib/math.glsl"
#include "rays/lit_surface.glsl"

struct MetCoat {
    vec3 normalWS; // unit
    float perceptualRoughness;
    float lobeRoughness; // as LitSurface has them
    float reflectance;   // fraction of the reflected radiance that goes towards the ray's origin
    vec3 environmentSpecular;
};

/// The coat's lobe in place of the surface's, whose response is known to be dimmed by the coat already.
LitSurface coatAlone(LitSurface below, MetCoat coat) {
    LitSurface lit = below;
    lit.normalWS = coat.normalWS;
    lit.perceptualRoughness = coat.perceptualRoughness;
    lit.lobeRoughness = coat.lobeRoughness;
    lit.response = vec3(coat.reflectance);
    lit.environmentSpecular = coat.environmentSpecular;
    return lit;
}

/// `noise`: uniform in [0, 1). `sampled`: directions are.
LitSurface oneLobe(LitSurface below, MetCoat coat, bool sampled, float noise) {
    float energy = maxComponent(below.response);
    float total = energy + coat.reflectance;
    if (total <= 0.0)
        return below;
    float share = coat.reflectance / total;
    LitSurface lit;
    if (!sampled) {
        bool takesCoat = share > 0.5;
        lit = below;
        if (takesCoat)
            lit = coatAlone(below, coat);
        lit.own += takesCoat ? below.environmentSpecular : coat.environmentSpecular;
        return lit;
    }
    bool takesCoat = noise < share;
    lit = below;
    if (takesCoat)
        lit = coatAlone(below, coat);
    float inverse = 1.0 / (takesCoat ? share : 1.0 - share);
    lit.response *= inverse;
    lit.environmentSpecular *= inverse;
    return lit;
}

#endif
