// The host's colours are not trusted: one NaN or Inf would spread through every later filter.
#ifndef GLINT_LIB_SANITIZE_GLSL
#define GLINT_LIB_SANITIZE_GLSL

/// Finite and in [0, 65504], the largest half; NaN and negatives become 0. By comparison only: a NaN fails it.
float sanitize(float value) {
    return value > 0.0 ? min(value, 65504.0) : 0.0;
}

vec3 sanitize(vec3 color) {
    return vec3(sanitize(color.r), sanitize(color.g), sanitize(color.b));
}

#endif
