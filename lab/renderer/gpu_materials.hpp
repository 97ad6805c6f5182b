// glTF materials in the form that shaders read.
#pragma once

#include "lab/renderer/gpu_textures.hpp"
#include "shared/material.h"

namespace glint::render {

shared::Material gpuMaterial(const scene::Material& material, const GpuTextures& textures);

/// The pass that draws a material.
enum class SurfaceClass : uint8_t {
    Opaque,
    Masked,      ///< alpha-tested
    Transparent, ///< blended or transmissive
};

/// True for KHR_materials_transmission: the background is visible through the surface, tinted.
bool transmitsLight(const scene::Material& material);

SurfaceClass surfaceClass(const scene::Material& material);

} // namespace glint::render
