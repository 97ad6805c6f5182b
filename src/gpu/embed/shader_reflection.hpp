// What SPIR-V says of itself: bindings, workgroup, push constants. Shared by the build's packer and by the viewer,
// which compiles shaders while it runs; the library itself never reflects.
#pragma once

#include "base/result.hpp"
#include "gpu/shader.hpp"

#include <string>
#include <vector>

namespace glint::gpu {

/// Owns what an EmbeddedShader only refers to. Movable: what refers to it stays right.
struct ReflectedShader {
    std::vector<uint32_t> words;
    std::vector<std::string> names; ///< of the bindings, which refer to them
    std::vector<ShaderBinding> bindings;
    uint32_t localSize[3] = {1, 1, 1};
    uint32_t pushConstantSize = 0; ///< bytes

    ReflectedShader() = default;
    ReflectedShader(ReflectedShader&&) noexcept = default;
    ReflectedShader& operator=(ReflectedShader&&) noexcept = default;

    /// Refers to this and to `name`.
    EmbeddedShader embedded(std::string_view name) const {
        return {name, words, bindings, {localSize[0], localSize[1], localSize[2]}, pushConstantSize};
    }
};

/// `bytes` of a SPIR-V file with names in it; `file` is for messages. Errors: InvalidInput.
Result<ReflectedShader> reflectShader(std::string_view bytes, const std::string& file);

/// "trace/linear.comp" -> "trace/linear"; raster stages keep theirs: "render/gbuffer.vert".
std::string shaderName(std::string file);
/// The way back.
std::string shaderFile(std::string_view name);

} // namespace glint::gpu
