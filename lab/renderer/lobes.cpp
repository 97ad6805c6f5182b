#include "lab/renderer/lobes.hpp"

#include "lab/renderer/gpu_materials.hpp"

#include <algorithm>

namespace glint::render {

/// shaders/lib/material.glsl: metals have 1, and dielectrics hardly denser than air less than the factor.
bool hasOwnF90(const scene::Material& material) {
    constexpr float kLeastCommonIor = 1.33f; // F0 0.02, edgeReflectance 1
    const bool metal = material.metallicFactor == 1 && material.metallicRoughnessTexture.texture < 0;
    const bool black = material.specularFactor == 0;
    const bool common = material.specularFactor == 1 && material.specularTexture.texture < 0 &&
                        (material.ior == 0 || material.ior >= kLeastCommonIor);
    return !material.unlit && !material.specularGlossiness && !metal && !black && !common &&
           surfaceClass(material) != SurfaceClass::Transparent;
}

bool hasCoat(const scene::Material& material) {
    return material.clearcoatFactor > 0 && !material.unlit && surfaceClass(material) != SurfaceClass::Transparent;
}

GBufferOptions withLobes(GBufferOptions options, const scene::Scene& scene) {
    options.coat = std::ranges::any_of(scene.materials, hasCoat);
    options.lobes = options.coat || std::ranges::any_of(scene.materials, hasOwnF90);
    return options;
}

} // namespace glint::render
