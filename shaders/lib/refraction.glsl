// Light on its way through a body: in at the surface, out somewhere behind it. The body is known at one point only, so
// it is taken for a sphere or a plate there. Unity HDRP's refraction models; formulas and what they leave out are in
// docs/techniques/refraction.md.
#ifndef GLINT_LIB_REFRACTION_GLSL
#define GLINT_LIB_REFRACTION_GLSL

#include "lib/math.glsl"
#include "shared/refraction.h"

struct Refraction {
    vec3 exit;        // where the light leaves, from where it entered, metres
    vec3 insideDir;   // unit, between the two
    vec3 direction;   // unit, of the light that has left
    float pathLength; // inside, metres
    bool isTotal;     // none gets in: all of it is reflected
};

/// Normal maps and interpolation turn normals away from the eye; this one does not look away. All unit.
vec3 facingNormal(vec3 N, vec3 V) {
    float cosine = dot(N, V);
    return cosine < 1e-3 ? normalizeOr(N + (1e-3 - cosine) * V, V) : N;
}

/// `N` faces the eye, `V` points to it; both unit. `ior` of the body against that around it; 0 (infinite) and thickness
/// 0 bend nothing. `model`: kRefraction*.
Refraction refractThrough(uint model, vec3 N, vec3 V, float ior, float thickness) {
    Refraction straight = Refraction(vec3(0.0), -V, -V, 0.0, false);
    if (model == kRefractionThin)
        thickness = kThinWall;
    if (model == kRefractionStraight || thickness <= 0.0 || ior <= 0.0)
        return straight;
    N = facingNormal(N, V);
    vec3 inside = refract(-V, N, 1.0 / ior);
    if (dot(inside, inside) < 0.5)
        return Refraction(vec3(0.0), -V, reflect(-V, N), 0.0, true);
    inside = normalize(inside);
    if (model == kRefractionSphere) {
        // A chord of the sphere that touches the surface from within. All is symmetric about the chord's middle, so the
        // light leaves as it came: no second refraction to compute, and none that rounding could make total.
        float chord = -dot(N, inside) * thickness;
        return Refraction(inside * chord, inside, 2.0 * dot(-V, inside) * inside + V, chord, false);
    }
    float path = thickness / max(-dot(N, inside), 1e-5);
    return Refraction(inside * path, inside, -V, path, false); // a plate turns it back
}

#endif
