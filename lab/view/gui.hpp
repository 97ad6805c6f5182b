// Dear ImGui's context: receives our input events; GuiRenderer draws its draw lists.
#pragma once

#include "lab/view/input_event.hpp"

#include <functional>
#include <span>
#include <string>

namespace glint::view {

/// Only one may exist at a time.
class Gui {
public:
    struct Clipboard {
        std::function<void(const std::string&)> set;
        std::function<std::string()> get;
    };
    /// `scale`  of texts and sizes, 1 on a standard-resolution screen
    Gui(float scale, Clipboard clipboard);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Starts a frame with the events since the last frame. `seconds`: time since the last frame, > 0.
    void begin(std::span<const InputEvent> events, glm::uvec2 size, double seconds);
    /// Ends the frame; ImGui::GetDrawData() then returns its draw data.
    void end();

    /// State of the previous frame: the user types into a field, or the mouse is over a panel.
    bool wantsKeys() const;
    bool wantsMouse() const;

private:
    void feed(const InputEvent& event);

    Clipboard clipboard_;
    std::string pasted_; ///< clipboard text that ImGui reads, kept while ImGui may refer to it
};

} // namespace glint::view
