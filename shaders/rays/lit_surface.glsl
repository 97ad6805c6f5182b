// What a path finds where its ray has met something.
#ifndef GLINT_RAYS_LIT_SURFACE_GLSL
#define GLINT_RAYS_LIT_SURFACE_GLSL

struct LitSurface {
    vec3 positionWS;
    vec3 faceNormalWS; // unit, of the triangle, towards the side from which the ray came
    vec3 normalWS;     // unit, as it is lit
    float perceptualRoughness;
    vec3 own;                 // radiance towards where the ray came from, without what the base layer reflects
    vec3 response;            // share of reflected radiance that goes there
    vec3 environmentSpecular; // what it reflects, as long as no ray says better
};

#endif
