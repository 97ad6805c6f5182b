// glTF materials in the form that shaders read.
#pragma once

#include "render/gpu_textures.hpp"
#include "shared/material.h"

namespace glint::render {

shared::Material gpuMaterial(const scene::Material& material, const GpuTextures& textures);

/// Which pass draws a material.
enum class SurfaceClass : uint8_t {
    Opaque,
    Masked,      ///< alpha-tested
    Transparent, ///< blended, or lets light through
};

/// KHR_materials_transmission: what is behind shows through, tinted.
bool transmitsLight(const scene::Material& material);

SurfaceClass surfaceClass(const scene::Material& material);

} // namespace glint::render
