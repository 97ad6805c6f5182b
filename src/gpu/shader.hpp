// A compiled shader embedded in the program, with the bindings that its SPIR-V declares. Generated at build time by
// src/gpu/embed/shader_pack.cpp. The shader defines its bindings; C++ only matches their names.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace glint::gpu {

enum class BindingKind : uint8_t { SampledImage, StorageImage, UniformBuffer, StorageBuffer, AccelerationStructure };

struct ShaderBinding {
    std::string_view name;
    uint32_t set = 0;
    uint32_t binding = 0;
    BindingKind kind = BindingKind::SampledImage;
    uint32_t count = 1; ///< array length; 0: unbounded (a texture table)
    bool reads = true;
    bool writes = false;
};

struct EmbeddedShader {
    std::string_view name; ///< "trace/linear", "render/surface.vert"
    std::span<const uint32_t> words;
    std::span<const ShaderBinding> bindings;
    uint32_t localSize[3] = {1, 1, 1};
    uint32_t pushConstantSize = 0; ///< bytes

    /// True if the shader traces rays through acceleration structures: its pipelines require Context::rayQuery.
    bool usesRayQuery() const {
        for (const ShaderBinding& binding : bindings)
            if (binding.kind == BindingKind::AccelerationStructure)
                return true;
        return false;
    }
};

/// Replacements for embedded shaders, by name.
using ShaderReplacements = std::map<std::string, const EmbeddedShader*, std::less<>>;

/// The shader sets that this program embeds; see glint_embed_shaders in cmake/GlintShaders.cmake.
namespace shaders {
std::span<const EmbeddedShader> reflect();
std::span<const EmbeddedShader> render();
} // namespace shaders

} // namespace glint::gpu
