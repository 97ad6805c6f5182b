// Shaders that change while the window is open: from files to pipelines, or back to those of before.
#pragma once

#include "gpu/context.hpp"
#include "shader_reload.hpp"
#include "viewer_state.hpp"

#include <functional>
#include <optional>

namespace glint::view {

/// What it compiled lives as long as it does: it must outlive every pipeline.
class LiveShaders {
public:
    /// `folder`  that was asked for, looked at once a second; empty: that of the sources where the program was started
    /// from their root, looked at when asked. Errors: InvalidArgument where it is no folder of shaders.
    Result<void> follow(const std::string& folder);
    /// Asks for a reload as soon as files have changed.
    void look(ViewerState& state);
    /// Compiles what has changed, or `all`, and has the pipelines made anew; what came of it is in `state`.
    /// `remake`  all or nothing. Errors: NotFound where there is no folder; DeviceLost.
    Result<void> reload(bool all, gpu::Context& context, ViewerState& state,
                        const std::function<Result<void>()>& remake);

private:
    std::optional<ShaderReload> files_;
    bool byItself_ = false;
    double lookedAt_ = 0; ///< ViewerState::now
};

} // namespace glint::view
