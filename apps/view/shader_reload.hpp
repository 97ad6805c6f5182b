// The program's shaders as files that somebody is just editing: notices changes and compiles what they touch. For
// developers of Glint.
#pragma once

#include "base/result.hpp"
#include "gpu/embed/shader_reflection.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace glint::view {

/// The files as they are at creation count as those that the program was built from.
class ShaderReload {
public:
    /// `folder`  like shaders/ of the sources. Errors: InvalidArgument where it is not.
    static Result<ShaderReload> create(const std::string& folder);
    /// Is this a folder of Glint's shaders?
    static bool isShaderFolder(const std::string& folder);

    /// Looks whether files have changed since the last look; cheap enough for once a second.
    bool look();
    /// Every shader, changed or not: for a folder that was changed before the program started.
    void markAll();

    struct Compiled {
        gpu::ShaderReplacements shaders; ///< all so far, not only those of now; alive as long as this object
        size_t count = 0;                ///< how many were compiled now; 0: nothing to do
    };
    /// What has changed, through `glslc` with the build's own options. Errors: NotFound without glslc; InvalidInput
    /// with the compiler's first lines; the same shaders are compiled again next time.
    Result<Compiled> compile();
    /// The device took them.
    void take(const Compiled& compiled);

private:
    explicit ShaderReload(std::string folder) : folder_(std::move(folder)) {}
    using Stamp = std::pair<std::filesystem::file_time_type, uintmax_t>;
    std::map<std::string, Stamp> stamps() const;
    std::set<std::string> filesOf(const std::string& file) const;
    Result<gpu::ReflectedShader> compileOne(const std::string& name) const;

    struct Version {
        std::string name;
        gpu::ReflectedShader reflected;
        gpu::EmbeddedShader shader; ///< refers to the two
    };
    std::string folder_;
    std::map<std::string, Stamp> seen_; ///< by path in the folder
    std::set<std::string> waiting_;     ///< names of shaders to compile
    gpu::ShaderReplacements taken_;
    std::vector<std::unique_ptr<Version>> versions_; ///< kept for good: pipelines refer to them
};

} // namespace glint::view
