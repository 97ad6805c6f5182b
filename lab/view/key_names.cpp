#include "lab/view/key_names.hpp"

#include "base/text.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <charconv>

namespace glint::view {
namespace {

constexpr std::pair<std::string_view, int> kNames[] = {
    {"Space", GLFW_KEY_SPACE},
    {"Enter", GLFW_KEY_ENTER},
    {"Escape", GLFW_KEY_ESCAPE},
    {"Tab", GLFW_KEY_TAB},
    {"Backspace", GLFW_KEY_BACKSPACE},
    {"Delete", GLFW_KEY_DELETE},
    {"Home", GLFW_KEY_HOME},
    {"End", GLFW_KEY_END},
    {"PageUp", GLFW_KEY_PAGE_UP},
    {"PageDown", GLFW_KEY_PAGE_DOWN},
    {"Left", GLFW_KEY_LEFT},
    {"Right", GLFW_KEY_RIGHT},
    {"Up", GLFW_KEY_UP},
    {"Down", GLFW_KEY_DOWN},
    {"Minus", GLFW_KEY_MINUS},
    {"Plus", GLFW_KEY_EQUAL},
};

int keyNumber(std::string_view name) {
    if (name.size() == 1) {
        const char c = name[0] >= 'a' && name[0] <= 'z' ? static_cast<char>(name[0] - 'a' + 'A') : name[0];
        if ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))
            return c; // GLFW numbers letters and digits as ASCII does
    }
    for (const auto& [known, number] : kNames)
        if (known == name)
            return number;
    int f = 0;
    if (name.size() >= 2 && name[0] == 'F')
        if (const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), f);
            error == std::errc() && end == name.data() + name.size() && f >= 1 && f <= 12)
            return GLFW_KEY_F1 + f - 1;
    return GLFW_KEY_UNKNOWN;
}

} // namespace

Result<KeyStroke> readKeyStroke(std::string_view text) {
    KeyStroke stroke;
    std::string_view rest = text;
    for (size_t plus = rest.find('+'); plus != rest.npos && plus > 0; plus = rest.find('+')) {
        const std::string_view modifier = rest.substr(0, plus);
        if (modifier == "Ctrl")
            stroke.modifiers.control = true;
        else if (modifier == "Shift")
            stroke.modifiers.shift = true;
        else if (modifier == "Alt")
            stroke.modifiers.alt = true;
        else
            return invalidArgument("'{}' is no key: before a + stands Ctrl, Shift or Alt", printable(text));
        rest.remove_prefix(plus + 1);
    }
    stroke.key = keyNumber(rest);
    if (stroke.key == GLFW_KEY_UNKNOWN)
        return invalidArgument("'{}' is no key: A to Z, 0 to 9, F1 to F12, Space, Enter, Escape, Tab, Home, End, Left, "
                               "Right, Up, Down, PageUp, PageDown, Backspace, Delete, Plus, Minus",
                               printable(text));
    return stroke;
}

} // namespace glint::view
