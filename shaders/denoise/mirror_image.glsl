// Where a mirror shows the image of a point, for an eye that moves past it.
#ifndef GLINT_DENOISE_MIRROR_IMAGE_GLSL
#define GLINT_DENOISE_MIRROR_IMAGE_GLSL

#include "lib/math.glsl"

/// A place of a mirror, and the line of sight to it.
struct MirrorPlace {
    vec3 position; // from the eye
    vec3 N;
    vec3 V;
    vec2 curvature; // in the plane of incidence and across it: 1 / metres, convex > 0
};

/// Fraction of the way behind the surface at which the middle of a lobe's image appears: a mirror's is at the ray's end, a
/// rough surface's on the surface itself. Lagarde and de Rousiers 2014, "Moving Frostbite to PBR" (fit).
float dominantFactor(float NoV, float perceptualRoughness) {
    float a = 0.298475 * log(39.4115 - 39.0029 * perceptualRoughness);
    return saturate(pow(1.0 - NoV, 10.8649) * (1.0 - a) + a);
}

/// Unit tangent across the plane of incidence.
vec3 acrossIncidence(vec3 N, vec3 V) {
    return normalizeOr(cross(N, V), orthonormalBasis(N)[0]);
}

/// The image of a point that is `distance` metres away along the mirrored line of sight. A flat mirror's is as far behind
/// it. A curved one's is seen at two distances, by how the eye moves: in the plane of incidence, or across it (Coddington's
/// equations). The image returned is at the second, and shifted so that an eye at `eyeBefore` sees it where it sees the
/// true one; right for small movements. `shownAt`: dominantFactor. `step`: displacement of the point, which the image
/// follows mirrored, and smaller by as much as it is itself.
/// False at a caustic: an image lies at the eye, or infinitely far away.
bool mirrorImage(MirrorPlace at, float distance, float shownAt, vec3 step, vec3 eyeBefore, out vec3 image) {
    const float kCaustic = 0.1;
    float NoV = clamp(dot(at.N, at.V), 0.05, 1.0);
    vec2 bent = 1.0 + 2.0 * distance * at.curvature * vec2(1.0 / NoV, NoV);
    if (any(lessThan(abs(bent), vec2(kCaustic))))
        return false;
    float toEye = length(at.position);
    vec2 behind = distance / bent;
    if (any(lessThan(toEye + behind, vec2(kCaustic * toEye))))
        return false;
    vec2 away = toEye + shownAt * behind;
    vec3 across = acrossIncidence(at.N, at.V);
    vec3 along = cross(at.V, across);
    float eyeMoved = dot(along, eyeBefore) * (1.0 - away.y / away.x);
    vec3 mirrored = reflect(step, at.N);
    vec2 pointMoved = vec2(dot(along, mirrored), dot(across, mirrored)) / bent * away.y / (toEye + behind);
    image = along * (eyeMoved + pointMoved.x) + across * pointMoved.y - at.V * away.y;
    return true;
}

#endif
