// The program's shaders as files under development: detects changes and compiles the affected shaders. For developers
// of Glint.
#pragma once

#include "base/result.hpp"
#include "gpu/embed/shader_reflection.hpp"
#include "gpu/embed/shader_variants.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace glint::view {

/// The files at creation are assumed to be those that the program was built from.
class ShaderReload {
public:
    /// `folder`  the sources' root, with shaders/ and lab/shaders/. Errors: InvalidArgument if it has none of these;
    ///           InvalidInput for a variants.txt.
    static Result<ShaderReload> create(const std::string& folder);
    /// True if this is the root of Glint's sources.
    static bool isSourceFolder(const std::string& folder);

    /// Returns true if files have changed since the last call; cheap enough to call once a second.
    bool look();
    /// Marks every shader as changed, for a folder that was changed before the program started.
    void markAll();

    struct Compiled {
        gpu::ShaderReplacements shaders; ///< all shaders compiled so far, not only now; valid as long as this object
        size_t count = 0;                ///< number of shaders compiled now; 0: nothing has changed
    };
    /// Compiles changed shaders through `glslc` with the build's own options. Errors: NotFound without glslc;
    /// InvalidInput with the compiler's first lines, or for variants.txt. After an error the same shaders are compiled
    /// again next time.
    Result<Compiled> compile();
    /// Notes that the device has accepted the shaders.
    void take(const Compiled& compiled);

private:
    explicit ShaderReload(std::string folder) : folder_(std::move(folder)) {}
    using Stamp = std::pair<std::filesystem::file_time_type, uintmax_t>;
    std::map<std::string, Stamp> stamps() const;
    Result<gpu::ShaderVariants> readVariants() const;
    gpu::ShaderSource sourceOf(const gpu::ShaderVariants& variants, std::string_view name) const;
    std::set<std::string> filesOf(const gpu::ShaderSource& source) const;
    Result<gpu::ReflectedShader> compileOne(const std::string& name, const gpu::ShaderSource& source) const;

    struct Version {
        std::string name;
        gpu::ReflectedShader reflected;
        gpu::EmbeddedShader shader; ///< refers to the two members above
    };
    std::string folder_;
    std::map<std::string, Stamp> seen_; ///< by path in the folder
    std::set<std::string> waiting_;     ///< names of shaders to compile
    gpu::ShaderReplacements taken_;
    std::vector<std::unique_ptr<Version>> versions_; ///< never freed, as pipelines refer to them
};

} // namespace glint::view
