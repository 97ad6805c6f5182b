// A path's hit, lit.
#ifndef GLINT_RAYS_LIT_SURFACE_GLSL
#define GLINT_RAYS_LIT_SURFACE_GLSL

struct LitSurface {
    vec3 positionWS;
    vec3 faceNormalWS; // unit, of the triangle, towards the side from which the ray came
    vec3 normalWS;     // unit, shading normal
    float perceptualRoughness;
    float lobeRoughness;      // perceptual, regularized: of the lobe in which the path continues
    float bend;               // radians that the normal turns for each metre across the path
    vec3 own;                 // radiance towards the ray's origin, without the base layer's reflection
    vec3 response;            // fraction of the reflected radiance that goes towards the ray's origin
    vec3 environmentSpecular; // the environment's reflection, the fallback where no ray replaces it
    bool reflectsApart;       // false: `own` holds the environment's reflection, as the frame does not tell it apart
};

#endif
