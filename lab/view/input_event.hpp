// User input as one list of events. The window system and scripts (input_script.hpp) both write it, and all input
// handling reads it, so that a script acts exactly like a user.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace glint::view {

enum class InputKind : uint8_t { Key, Text, Move, Button, Scroll, Drop, Close };

struct Modifiers {
    bool control = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const Modifiers&) const = default;
};

struct InputEvent {
    InputKind kind = InputKind::Key;
    int key = 0; ///< Key: GLFW key number; Button: 0 left, 1 right, 2 middle
    bool down = false;
    bool repeated = false; ///< Key: repeated because the key is held
    Modifiers modifiers;
    uint32_t character = 0;              ///< Text: a code point
    glm::vec2 position = glm::vec2(0);   ///< Move: pixels from the top left; Scroll: notches, +y away from the user
    std::vector<std::string> files = {}; ///< Drop
};

} // namespace glint::view
