// The path of light through a body: in at the surface, out somewhere behind it. The body is known at one point only, so
// it is approximated there by a sphere or a plate. Unity HDRP's refraction models; docs/techniques/refraction.md has
// the formulas and what they leave out.
#ifndef GLINT_LIB_REFRACTION_GLSL
#define GLINT_LIB_REFRACTION_GLSL

#include "lib/math.glsl"
#include "shared/refraction.h"

struct Refraction {
    vec3 exit;        // where the light leaves, relative to where it entered, metres
    vec3 insideDir;   // unit, of the last way inside
    vec3 direction;   // unit, of the light after it left
    float pathLength; // inside, metres
    bool isTotal;     // no light enters: all of it is reflected
};

/// Normal maps and interpolation may turn a normal away from the eye; the result faces the eye. All unit.
vec3 facingNormal(vec3 N, vec3 V) {
    float cosine = dot(N, V);
    return cosine < 1e-3 ? normalizeOr(N + (1e-3 - cosine) * V, V) : N;
}

/// Index of refraction for red, green and blue light. `dispersion`: 20 / Abbe number. KHR_materials_dispersion.
vec3 dispersedIor(float ior, float dispersion) {
    float halfSpread = (ior - 1.0) * 0.025 * dispersion;
    return max(ior + vec3(-halfSpread, 0.0, halfSpread), vec3(1e-3));
}

/// Follows the light to the next exit, reflected where it would have left the body. By symmetry each way inside has the
/// same length and ends at the same angle.
Refraction reflectInside(Refraction path, uint model, vec3 N, vec3 V, float ior, float thickness, float way) {
    if (model == kRefractionSphere) {
        float radius = 0.5 * thickness;
        float cosineInside = way / thickness;
        path.insideDir = normalize(reflect(path.insideDir, path.exit / radius + N));
        path.exit += path.insideDir * way;
        vec3 outward = path.exit / radius + N;
        path.direction = normalize(ior * path.insideDir + (dot(N, V) - ior * cosineInside) * outward);
    } else { // a plate: light leaves at the front and at the back in turn
        path.insideDir = reflect(path.insideDir, N);
        path.exit += path.insideDir * way;
        path.direction = reflect(path.direction, N);
    }
    path.pathLength += way;
    return path;
}

/// `N` faces the eye, `V` points to the eye; both unit. `ior` of the body relative to its surroundings; 0 (infinite)
/// and thickness 0 do not bend light. `model`: kRefraction*. `inner`: reflections inside the body before the light
/// leaves. They are never total: light that enters a sphere or a plate meets the inner surface below the critical angle.
Refraction refractThrough(uint model, vec3 N, vec3 V, float ior, float thickness, uint inner) {
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
    Refraction path;
    if (model == kRefractionSphere) {
        // A chord of the sphere that touches the surface from within. The path is symmetric about the chord's middle,
        // so the light leaves as it came. No second refraction needs computing, and rounding cannot make one total.
        float chord = -dot(N, inside) * thickness;
        path = Refraction(inside * chord, inside, 2.0 * dot(-V, inside) * inside + V, chord, false);
    } else {
        float way = thickness / max(-dot(N, inside), 1e-5);
        path = Refraction(inside * way, inside, -V, way, false); // a plate restores the direction
    }
    float way = path.pathLength;
    for (uint i = 0u; i < inner; ++i)
        path = reflectInside(path, model, N, V, ior, thickness, way);
    return path;
}

#endif
