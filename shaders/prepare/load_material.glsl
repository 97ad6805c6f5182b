// Loads the host's material at a texel. Include after the images `material`, `baseColor`, `roughness`, `metallic`,
// `specular` and `f90`, with GLINT_HOST_SAMPLER defined as their type; with GLINT_COAT also after those of the coat.
#ifndef GLINT_PREPARE_LOAD_MATERIAL_GLSL
#define GLINT_PREPARE_LOAD_MATERIAL_GLSL

#include "lib/host_surface.glsl"
#ifdef GLINT_COAT
#include "lib/coat.glsl"
#include "lib/surface.glsl"
#endif

/// `index`: the sample of an image that has several, otherwise mip 0.
float loadChannel(GLINT_HOST_SAMPLER image, ivec2 px, int index, HostChannel channel) {
    return channel.scale == 0.0 ? channel.bias
                                : texelFetch(image, px, index)[channel.channel] * channel.scale + channel.bias;
}

HostMaterial loadMaterial(ivec2 px, int index) {
    HostMaterial here =
        HostMaterial(vec3(0.0), vec3(0.0), loadChannel(roughness, px, index, frame.constants.roughness), 0.0, 0.0,
                     loadChannel(f90, px, index, frame.constants.f90));
    if (frame.constants.materialKind == kHostMaterialMetallicRoughness) {
        here.baseColor = texelFetch(baseColor, px, index).rgb;
        here.metallic = loadChannel(metallic, px, index, frame.constants.metallic);
        here.specular = loadChannel(specular, px, index, frame.constants.specular);
    } else {
        here.f0 = texelFetch(material, px, index).rgb;
    }
    return here;
}

#ifdef GLINT_COAT

/// The coat as a surface of its own, in the place of the host's `here`; reflectivity 0 where there is none.
Surface loadCoat(ivec2 px, int index, HostSurface here) {
    float strength = clamp(sanitize(loadChannel(coat, px, index, frame.constants.coat)), 0.0, 1.0);
    if (strength <= 0.0 || here.viewZ >= kBackgroundZ)
        return Surface(here.normalVS, here.perceptualRoughness, 0.0);
    vec3 normalVS = here.normalVS;
    if ((frame.constants.flags & kInputCoatNormal) != 0u)
        normalVS = hostNormalVS(frame.constants, texelFetch(coatNormal, px, index).xyz);
    float stored = loadChannel(coatRoughness, px, index, frame.constants.coatRoughness);
    float roughness = perceptualOf(frame.constants, stored);
    return Surface(normalVS, roughness, kCoatF0 * strength);
}

#endif

#endif
