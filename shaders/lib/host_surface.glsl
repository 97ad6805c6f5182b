// Converts a host's G-buffer texels to Glint's own conventions (include/glint/gbuffer.hpp lists what a host may
// declare). Pure functions: the passes of prepare read the images, with one sample a pixel or several.
#ifndef GLINT_LIB_HOST_SURFACE_GLSL
#define GLINT_LIB_HOST_SURFACE_GLSL

#include "lib/camera.glsl"
#include "lib/octahedral.glsl"
#include "lib/sanitize.glsl"

/// The surface that a host's texel declares.
struct HostSurface {
    float viewZ;    // metres; kBackgroundZ: no surface
    vec3 normalVS;  // unit
    vec3 f0;        // [0, 1]
    float f90;      // [0, 1]
    float perceptualRoughness;
};

/// Metres along the view axis; NaN depth counts as background.
float hostViewZ(FrameConstants frame, float depth) {
    float z = viewZFromDepth(frame, depth);
    return z > 0.0 ? z : kBackgroundZ;
}

/// viewZ as rays read it: with gbuffer.depthFormat half no finer than sixteen bits hold a distance. Rounded to the
/// nearest half, ties to even, by hand: a compiler may treat packing and unpacking as a no-op and remove both.
float storedViewZ(FrameConstants frame, float z) {
    const float kLargestHalf = 65504.0;
    if ((frame.flags & kInputHalfDepth) == 0u || z >= kBackgroundZ)
        return z;
    uint bits = floatBitsToUint(min(z, kLargestHalf));
    bits += 0xfffu + ((bits >> 13) & 1u);
    return uintBitsToFloat(bits & ~0x1fffu); // ten bits of mantissa are left
}

vec3 hostNormalVS(FrameConstants frame, vec3 stored) {
    if ((frame.flags & kInputNormalUnorm) != 0u)
        stored = stored * 2.0 - 1.0;
    vec3 decoded = (frame.flags & kInputNormalOctahedral) != 0u ? decodeOctahedral(stored.xy) : stored;
    if ((frame.flags & kInputNormalView) != 0u) {
        if ((frame.flags & kInputLeftHanded) != 0u)
            decoded.z = -decoded.z;
    } else {
        decoded = mat3(frame.worldToView) * decoded;
    }
    // Replace a cleared or broken normal by one that faces the camera, which keeps reflections plausible and spreads no
    // NaN.
    float squaredLength = dot(decoded, decoded);
    return squaredLength > 1e-12 && squaredLength < 1e12 ? decoded * inversesqrt(squaredLength) : vec3(0.0, 0.0, 1.0);
}

/// The host's material at one texel, its scalars scaled and biased (HostChannel) but not yet clamped.
struct HostMaterial {
    vec3 f0;        // of the material image
    vec3 baseColor; // of the base colour image, where the material kind has one
    float roughness;
    float metallic;
    float specular;
    float f90;
};

/// F0 of dielectrics at full specular, as Burley 2012, "Physically-Based Shading at Disney", and most engines since
/// have it. The default specular of 0.5 is the 4 % of glTF 2.0, B.2.
const float kDielectricF0 = 0.08;

vec3 hostF0(FrameConstants frame, HostMaterial material) {
    vec3 f0 = material.f0;
    if (frame.materialKind == kHostMaterialMetallicRoughness)
        f0 = mix(vec3(kDielectricF0 * sanitize(material.specular)), sanitize(material.baseColor),
                 clamp(sanitize(material.metallic), 0.0, 1.0));
    else if ((frame.flags & kInputMaterial) == 0u)
        f0 = vec3(1.0);
    return clamp(sanitize(f0), 0.0, 1.0);
}

/// Metals reflect all light at grazing angles.
float hostF90(FrameConstants frame, HostMaterial material) {
    if ((frame.flags & kInputF90) == 0u)
        return 1.0;
    float f90 = clamp(sanitize(material.f90), 0.0, 1.0);
    return frame.materialKind == kHostMaterialMetallicRoughness
               ? mix(f90, 1.0, clamp(sanitize(material.metallic), 0.0, 1.0))
               : f90;
}

/// Perceptual roughness, of a value as the host stores it.
float perceptualOf(FrameConstants frame, float value) {
    if ((frame.flags & kInputSmoothness) != 0u)
        value = 1.0 - value;
    value = clamp(sanitize(value), 0.0, 1.0);
    return (frame.flags & kInputAlpha) != 0u ? sqrt(value) : value;
}

float hostRoughness(FrameConstants frame, float value) {
    return frame.materialKind == kHostMaterialStandard ? 0.0 : perceptualOf(frame, value);
}

HostSurface hostSurface(FrameConstants frame, float depth, vec3 normal, HostMaterial material) {
    return HostSurface(hostViewZ(frame, depth), hostNormalVS(frame, normal), hostF0(frame, material),
                       hostF90(frame, material), hostRoughness(frame, material.roughness));
}

#endif
