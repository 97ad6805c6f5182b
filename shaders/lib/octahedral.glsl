// Unit vectors as two numbers. Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit
// Vectors", JCGT 3(2): the octahedron's upper half is the diamond |x| + |y| <= 1; the lower half is folded over it.
#ifndef GLINT_LIB_OCTAHEDRAL_GLSL
#define GLINT_LIB_OCTAHEDRAL_GLSL

/// sign() that is never 0, so that points on the fold stay on it.
vec2 signNotZero(vec2 v) {
    return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0);
}

/// Unit vector -> [-1, 1]^2. As snorm16 the angular error stays below 0.004 degrees.
vec2 encodeOctahedral(vec3 direction) {
    vec2 p = direction.xy / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    return direction.z >= 0.0 ? p : (1.0 - abs(p.yx)) * signNotZero(p);
}

/// [-1, 1]^2 -> unit vector.
vec3 decodeOctahedral(vec2 p) {
    vec3 direction = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (direction.z < 0.0)
        direction.xy = (1.0 - abs(direction.yx)) * signNotZero(direction.xy);
    return normalize(direction);
}

#endif
