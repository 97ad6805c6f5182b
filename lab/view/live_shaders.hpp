// Reloads shaders while the window is open: compiles changed files and replaces pipelines, or keeps the previous ones
// on error.
#pragma once

#include "gpu/context.hpp"
#include "lab/view/shader_reload.hpp"
#include "lab/view/viewer_state.hpp"

#include <functional>
#include <optional>

namespace glint::view {

/// Owns the compiled shaders: it must outlive every pipeline.
class LiveShaders {
public:
    /// `folder`  requested folder, checked once a second. Empty: the source folder, if the program was started from the
    ///           repository root, checked on request. Errors: InvalidArgument if it is not a shader folder.
    Result<void> follow(const std::string& folder);
    /// Requests a reload if files have changed.
    void look(ViewerState& state);
    /// Compiles changed shaders, or `all`, and rebuilds the pipelines; writes the result to `state`.
    /// `remake`  succeeds or changes nothing. Errors: NotFound if there is no folder; DeviceLost.
    Result<void> reload(bool all, gpu::Context& context, ViewerState& state,
                        const std::function<Result<void>()>& remake);

private:
    std::optional<ShaderReload> files_;
    bool byItself_ = false;
    double lookedAt_ = 0; ///< ViewerState::now
};

} // namespace glint::view
