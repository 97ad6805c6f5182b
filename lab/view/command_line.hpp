// The `glint render` command line that makes the shown picture.
#pragma once

#include "lab/view/viewer_state.hpp"

#include <optional>
#include <string>

namespace glint::view {

struct SavedCamera {
    std::string path;
    scene::Camera camera; ///< as stored in the file
};

/// True if no option of `glint render` gives the shown camera: it was moved and is not the saved one.
bool cameraIsLost(const ViewerState& state, const std::optional<SavedCamera>& saved);

/// Returns the command line, without a camera if cameraIsLost.
/// `job`  of the open scene
std::string commandLine(const ViewerState& state, const render::RenderJob& job,
                        const std::optional<SavedCamera>& saved);

} // namespace glint::view
