// Small constants and functions that every shader needs.
#ifndef GLINT_LIB_MATH_GLSL
#define GLINT_LIB_MATH_GLSL

const float kPi = 3.14159265358979;

float saturate(float x) {
    return clamp(x, 0.0, 1.0);
}

float square(float x) {
    return x * x;
}

float pow5(float x) {
    const float x2 = x * x;
    return x2 * x2 * x;
}

/// The whole number below or at `x`, for |x| < 2^22, by adding the float whose last bit counts ones. Converting to an
/// integer runs at a quarter of the rate or less on GPUs, and lane by lane on the software driver.
int floorToInt(float x) {
    return floatBitsToInt(floor(x) + 12582912.0) - 0x4b400000;
}

ivec2 floorToInt(vec2 x) {
    return floatBitsToInt(floor(x) + 12582912.0) - 0x4b400000;
}

/// packUnorm2x16, by the same means: here the addition itself rounds to the nearest.
uint packUnorm16(vec2 v) {
    ivec2 steps = floatBitsToInt(clamp(v, vec2(0.0), vec2(1.0)) * 65535.0 + 12582912.0) - 0x4b400000;
    return (uint(steps.x) & 0xffffu) | (uint(steps.y) << 16);
}

float meanComponent(vec3 v) {
    return (v.x + v.y + v.z) / 3.0;
}

float maxComponent(vec3 v) {
    return max(v.x, max(v.y, v.z));
}

/// normalize() that returns `fallback` for a zero vector.
vec3 normalizeOr(vec3 v, vec3 fallback) {
    const float length2 = dot(v, v);
    return length2 > 1e-20 ? v * inversesqrt(length2) : fallback;
}

/// Two unit vectors that form a right-handed frame (x, y, n) with the unit vector `n`. Duff et al. 2017, "Building an
/// Orthonormal Basis, Revisited", JCGT 6(1), listing 3.
mat3 orthonormalBasis(vec3 n) {
    const float s = n.z >= 0.0 ? 1.0 : -1.0;
    const float a = -1.0 / (s + n.z);
    const float b = n.x * n.y * a;
    return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

#endif
