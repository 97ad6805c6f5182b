// Loads the host's material at a texel. Include after the images `material`, `baseColor`, `roughness`, `metallic` and
// `specular`, with GLINT_HOST_SAMPLER defined as their type.
#ifndef GLINT_PREPARE_LOAD_MATERIAL_GLSL
#define GLINT_PREPARE_LOAD_MATERIAL_GLSL

#include "lib/host_surface.glsl"

/// `index`: the sample of an image that has several, otherwise mip 0.
float loadChannel(GLINT_HOST_SAMPLER image, ivec2 px, int index, HostChannel channel) {
    return channel.scale == 0.0 ? channel.bias
                                : texelFetch(image, px, index)[channel.channel] * channel.scale + channel.bias;
}

HostMaterial loadMaterial(ivec2 px, int index) {
    HostMaterial here =
        HostMaterial(vec3(0.0), vec3(0.0), loadChannel(roughness, px, index, frame.constants.roughness), 0.0, 0.0);
    if (frame.constants.materialKind == kHostMaterialMetallicRoughness) {
        here.baseColor = texelFetch(baseColor, px, index).rgb;
        here.metallic = loadChannel(metallic, px, index, frame.constants.metallic);
        here.specular = loadChannel(specular, px, index, frame.constants.specular);
    } else {
        here.f0 = texelFetch(material, px, index).rgb;
    }
    return here;
}

#endif
