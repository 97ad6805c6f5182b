// What the user's settings reflect.* make of a surface's specular response.
#ifndef GLINT_LIB_USER_RESPONSE_GLSL
#define GLINT_LIB_USER_RESPONSE_GLSL

#include "lib/brdf.glsl"
#include "lib/math.glsl"
#include "shared/trace_constants.h"

/// Reflectance under the user's settings: strength first, then the exponent over both.
vec3 falloff(CompositeConstants settings, vec3 reflectance) {
    vec3 response = reflectance * settings.strength;
    return settings.falloffExponent == 1.0 ? response : pow(response, vec3(settings.falloffExponent));
}

struct Response {
    vec3 value; // fraction of reflected light that is added
    vec3 taken; // fraction of the host's fallback that it replaces
};

/// What the user's settings leave of the full response, they leave of the fallback, too: less of both, down to the
/// host's own picture, and never more of the fallback than there is.
Response userResponse(CompositeConstants settings, vec3 full) {
    if (settings.strength == 1.0 && settings.falloffExponent == 1.0)
        return Response(full, vec3(1.0));
    vec3 given = falloff(settings, full);
    return Response(given, min(given / max(full, vec3(1e-6)), vec3(1.0)));
}

/// The surface with its reflection by composite.model lerp, as Babylon.js: by reflectance between what the surface shows
/// without (`lit`) and the reflected radiance. `reflection`: weighted radiance, total weight; the remaining weight takes
/// `lit`.
vec3 lerpedReflection(CompositeConstants settings, vec3 lit, vec4 reflection, vec3 f0, float f90, float NoV) {
    vec3 fresnel = F_Schlick(f0, f90, NoV);
    vec3 m = clamp(falloff(settings, settings.fresnel != 0u ? fresnel : f0), 0.0, 1.0);
    vec3 color = reflection.rgb;
    if (settings.fresnel == 0u) // without it in the factor, the colour itself takes the Fresnel term
        color *= fresnel;
    color = clamp(color, 0.0, 1000.0) + (1.0 - reflection.a) * lit;
    return lit * (1.0 - m) + color * m;
}

#endif
