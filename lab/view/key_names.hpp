// Key names: "V", "Ctrl+P", "F12", "Home".
#pragma once

#include "base/result.hpp"
#include "lab/view/input_event.hpp"

#include <string_view>

namespace glint::view {

struct KeyStroke {
    int key = 0; ///< GLFW's number
    Modifiers modifiers;
};

/// Errors: InvalidArgument for an unknown name.
Result<KeyStroke> readKeyStroke(std::string_view text);

} // namespace glint::view
