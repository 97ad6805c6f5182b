// What an image of 16-bit floats can hold, and rounding at random to it.
#ifndef GLINT_LIB_HALF_GLSL
#define GLINT_LIB_HALF_GLSL

/// Below 65504, the largest half, so that no rounding makes it infinite.
const float kLargestStored = 6.0e4;

/// `v`, rounded up or down to 11 significant bits, each as often as it is near: right on average. A mean over frames that
/// is stored in 16 bits must not be rounded always alike: rounded down it loses 0.02 % in every frame (and drivers may),
/// rounded to the nearest it stops to move once frames count for less than half a step. Values of [6.2e-5, 65000];
/// smaller ones keep what the driver makes of them. `noise`: uniform in [0, 1).
vec4 roundToHalf(vec4 v, float noise) {
    uint below = floatBitsToUint(1.0 + noise) & 0x1fffu; // the 13 bits that a half does not have
    return uintBitsToFloat((floatBitsToUint(v) + below) & ~0x1fffu);
}

#endif
