// How directions, equirectangular pictures and cube maps belong together.
#ifndef GLINT_LIB_ENVIRONMENT_GLSL
#define GLINT_LIB_ENVIRONMENT_GLSL

#include "lib/math.glsl"

/// Unit direction -> UV of an equirectangular image: its centre is +X, its top row +Y, and +Z a quarter to the right.
vec2 equirectangularUV(vec3 direction) {
    return vec2(0.5 + atan(direction.z, direction.x) / (2.0 * kPi), acos(clamp(direction.y, -1.0, 1.0)) / kPi);
}

/// Direction (not normalized) through `p` in [-1, 1]^2, +Y down, of a cube's face. Vulkan 1.3, "Cube Map Face Selection".
vec3 cubeDirection(uint face, vec2 p) {
    switch (face) {
    case 0: return vec3(1.0, -p.y, -p.x);
    case 1: return vec3(-1.0, -p.y, p.x);
    case 2: return vec3(p.x, 1.0, p.y);
    case 3: return vec3(p.x, -1.0, -p.y);
    case 4: return vec3(p.x, -p.y, 1.0);
    default: return vec3(-p.x, -p.y, -1.0);
    }
}

/// World -> the environment's own space, which is turned by an angle about +Y. `rotation` = its (cos, sin).
vec3 rotateToEnvironment(vec3 directionWS, vec2 rotation) {
    return vec3(rotation.x * directionWS.x - rotation.y * directionWS.z, directionWS.y,
                rotation.y * directionWS.x + rotation.x * directionWS.z);
}

/// The mip of the prefiltered cube that holds this roughness: linear, mip 0 is a mirror.
float environmentMip(float perceptualRoughness, int mips) {
    return perceptualRoughness * float(mips - 1);
}

/// The split-sum table's outermost texel centres are 0 and 1: at roughness 1 the integral still falls steeply, and half
/// a texel would be 2 % of a rough metal's light. The argument that a texel stands for:
vec2 dfgArgument(ivec2 texel, int size) {
    return vec2(texel) / float(size - 1);
}

/// Where the table holds an argument (NoV, perceptualRoughness), for filtered lookups.
vec2 dfgUV(vec2 argument, int size) {
    return (argument * float(size - 1) + 0.5) / float(size);
}

#endif
