// Everything that the viewer can be told to do, by name: keys and the command palette take it from here.
#pragma once

#include "input_event.hpp"
#include "viewer_state.hpp"

#include <functional>
#include <string>
#include <vector>

namespace glint::view {

struct ViewCommand {
    std::string name;
    std::string keys; ///< "Ctrl+P", as readKeyStroke reads it; empty: in the palette only
    std::function<void(ViewerState&)> run;
    bool whileTyping = false; ///< its keys act in a text field too
};

const std::vector<ViewCommand>& viewCommands();

/// Does what the key stands for. False: it stands for nothing.
bool runShortcut(const InputEvent& event, ViewerState& state, bool typing);

} // namespace glint::view
