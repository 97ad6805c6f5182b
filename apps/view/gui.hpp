// Dear ImGui's one context: fed with our input events, its draw lists taken by GuiRenderer.
#pragma once

#include "input_event.hpp"

#include <functional>
#include <span>
#include <string>

namespace glint::view {

/// One at a time.
class Gui {
public:
    struct Clipboard {
        std::function<void(const std::string&)> set;
        std::function<std::string()> get;
    };
    /// `scale`  of texts and sizes, 1 on an ordinary screen
    Gui(float scale, Clipboard clipboard);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Starts a frame with what happened since the last one.
    /// `seconds` since then, > 0
    void begin(std::span<const InputEvent> events, glm::uvec2 size, double seconds);
    /// Ends the frame: ImGui::GetDrawData() has it.
    void end();

    /// In the frame before: the person types into a field, or points at a panel.
    bool wantsKeys() const;
    bool wantsMouse() const;

private:
    void feed(const InputEvent& event);

    Clipboard clipboard_;
    std::string pasted_; ///< what ImGui reads from the clipboard, as long as it may look at it
};

} // namespace glint::view
