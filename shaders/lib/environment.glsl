// Mappings between directions, equirectangular images and cube maps.
#ifndef GLINT_LIB_ENVIRONMENT_GLSL
#define GLINT_LIB_ENVIRONMENT_GLSL

#include "lib/math.glsl"

/// Unit direction -> UV of an equirectangular image: the centre is +X, the top row +Y, and +Z is a quarter to the
/// right.
vec2 equirectangularUV(vec3 direction) {
    return vec2(0.5 + atan(direction.z, direction.x) / (2.0 * kPi), acos(clamp(direction.y, -1.0, 1.0)) / kPi);
}

/// Direction (not normalized) through `p` in [-1, 1]^2, +Y down, of a cube's face. Vulkan 1.3, "Cube Map Face
/// Selection".
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

/// World space -> the environment's own space, which is rotated about +Y. `rotation`: (cos, sin) of the angle.
vec3 rotateToEnvironment(vec3 directionWS, vec2 rotation) {
    return vec3(rotation.x * directionWS.x - rotation.y * directionWS.z, directionWS.y,
                rotation.y * directionWS.x + rotation.x * directionWS.z);
}

/// The mip of the prefiltered cube that holds this roughness: linear in roughness, mip 0 is a mirror.
float environmentMip(float perceptualRoughness, int mips) {
    return perceptualRoughness * float(mips - 1);
}

/// The argument that a texel of the split-sum table stands for. The outermost texel centres are 0 and 1: at roughness 1
/// the integral still falls steeply, and half a texel would be 2 % of a rough metal's light.
vec2 dfgArgument(ivec2 texel, int size) {
    return vec2(texel) / float(size - 1);
}

/// UV of an argument (NoV, perceptualRoughness) in the table, for filtered fetches.
vec2 dfgUV(vec2 argument, int size) {
    return (argument * float(size - 1) + 0.5) / float(size);
}

/// The table's entry, filtered: what lib/dfg.glsl integrates.
vec2 dfgAt(sampler2D table, float NoV, float perceptualRoughness) {
    return textureLod(table, dfgUV(vec2(NoV, perceptualRoughness), textureSize(table, 0).x), 0.0).rg;
}

#endif
