// All commands of the viewer by name; keys and the command palette use this list.
#pragma once

#include "lab/view/input_event.hpp"
#include "lab/view/viewer_state.hpp"

#include <functional>
#include <string>
#include <vector>

namespace glint::view {

struct ViewCommand {
    std::string name;
    std::string keys; ///< "Ctrl+P", in the form of readKeyStroke; empty: in the palette only
    std::function<void(ViewerState&)> run;
    bool whileTyping = false; ///< its keys also act in a text field
};

const std::vector<ViewCommand>& viewCommands();

/// Runs the command of a key. Returns false if the key has no command.
bool runShortcut(const InputEvent& event, ViewerState& state, bool typing);

} // namespace glint::view
