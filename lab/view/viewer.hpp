// The main loop of `glint view`: reads input, renders the scene if something has changed, draws panels over it, and
// presents.
#pragma once

#include "base/result.hpp"
#include "lab/view/view_options.hpp"

namespace glint::view {

/// Runs until the window is closed. Errors: NotFound if there is no display; those of the scene's readers, the device
/// and the settings; with `--validate` also the first message of the validation layer.
Result<void> runViewer(const ViewOptions& options);

} // namespace glint::view
