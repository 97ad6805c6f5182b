// The loop of `glint view`: input in, the scene rendered where something changed, panels over it, into the window.
#pragma once

#include "base/result.hpp"
#include "view_options.hpp"

namespace glint::view {

/// Runs until the window is closed. Errors: NotFound where there is no display; as the scene's readers, the device and
/// the settings give them; with `--validate` also the first message of the validation layer.
Result<void> runViewer(const ViewOptions& options);

} // namespace glint::view
