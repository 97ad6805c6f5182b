// Reflection of SPIR-V: bindings, workgroup size, push constants. Used by the build's shader packer and by the viewer,
// which compiles shaders at run time; the library itself never reflects.
#pragma once

#include "base/result.hpp"
#include "gpu/shader.hpp"

#include <string>
#include <vector>

namespace glint::gpu {

/// Owns the data that an EmbeddedShader refers to. Moving it keeps those references valid.
struct ReflectedShader {
    std::vector<uint32_t> words;
    std::vector<std::string> names; ///< names that the bindings refer to
    std::vector<ShaderBinding> bindings;
    uint32_t localSize[3] = {1, 1, 1};
    uint32_t pushConstantSize = 0; ///< bytes

    ReflectedShader() = default;
    ReflectedShader(ReflectedShader&&) noexcept = default;
    ReflectedShader& operator=(ReflectedShader&&) noexcept = default;

    /// The result refers to this object and to `name`.
    EmbeddedShader embedded(std::string_view name) const {
        return {name, words, bindings, {localSize[0], localSize[1], localSize[2]}, pushConstantSize};
    }
};

/// `bytes`: a SPIR-V file that contains names; `file`: for messages. Errors: InvalidInput.
Result<ReflectedShader> reflectShader(std::string_view bytes, const std::string& file);

/// "trace/classify.comp" -> "trace/classify"; raster stages keep their extension: "render/surface.vert".
std::string shaderName(std::string file);
/// The inverse of shaderName.
std::string shaderFile(std::string_view name);

} // namespace glint::gpu
