// What is shown, as the `glint render` that makes the same picture.
#pragma once

#include "viewer_state.hpp"

#include <optional>
#include <string>

namespace glint::view {

struct SavedCamera {
    std::string path;
    scene::Camera camera; ///< as the file has it
};

/// No option of `glint render` makes the camera that is shown: it was moved, and is not the saved one.
bool cameraIsLost(const ViewerState& state, const std::optional<SavedCamera>& saved);

/// Without a camera where that is lost.
/// `job`  of the scene that is open
std::string commandLine(const ViewerState& state, const render::RenderJob& job,
                        const std::optional<SavedCamera>& saved);

} // namespace glint::view
