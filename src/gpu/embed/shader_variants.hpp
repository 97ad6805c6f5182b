// shaders/variants.txt: the shaders that are built from one source with different macros. The build reads the file in
// cmake/GlintShaders.cmake; the viewer, which compiles shaders at run time, reads it here.
#pragma once

#include "base/result.hpp"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::gpu {

/// The source file and macros that a shader is compiled from.
struct ShaderSource {
    std::string file; ///< path in the shader folder
    std::vector<std::string> macros;
};

/// By variant name, as in EmbeddedShader::name.
using ShaderVariants = std::map<std::string, ShaderSource, std::less<>>;

/// The file's path in the shader folder.
constexpr const char* kShaderVariantsFile = "variants.txt";

/// `text`: the file's content. `files`: the paths in the shader folder, for lines with a *. Errors: InvalidInput with
/// the line that is not a variant, or that names a variant for the second time.
Result<ShaderVariants> parseShaderVariants(std::string_view text, std::span<const std::string> files = {});

/// Returns the source of the shader `name`: its line in `variants`, or else the file of that name.
ShaderSource shaderSource(const ShaderVariants& variants, std::string_view name);

} // namespace glint::gpu
