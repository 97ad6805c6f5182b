// The host's colours as every later pass reads them: linear and finite.
#ifndef GLINT_LIB_INPUT_COLOR_GLSL
#define GLINT_LIB_INPUT_COLOR_GLSL

#include "lib/color.glsl"
#include "lib/sanitize.glsl"

/// `encoded`: stored as sRGB. A large encoded value decodes to more than a half can hold, so it is clamped twice.
vec3 linearColor(vec3 stored, bool encoded) {
    vec3 finite = sanitize(stored);
    return encoded ? sanitize(decodeSrgb(finite)) : finite;
}

#endif
