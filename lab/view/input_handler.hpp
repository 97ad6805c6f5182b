// Applies key and mouse input that no panel uses to the viewer's state.
#pragma once

#include "lab/view/gui.hpp"
#include "lab/view/viewer_state.hpp"

#include <set>

namespace glint::view {

class InputHandler {
public:
    /// `metres`  size of the scene, which determines the speed of flying
    void setScale(float metres) { scale_ = metres; }
    void handle(std::span<const InputEvent> events, ViewerState& state, const Gui& gui, glm::uvec2 window,
                double seconds);
    /// True if keys or buttons that move something are held.
    bool holding() const { return !held_.empty() || drag_ != Drag::Nothing; }

private:
    enum class Drag { Nothing, Line, Orbit, Pan, Look };

    void key(const InputEvent& event, ViewerState& state, bool typing);
    void button(const InputEvent& event, ViewerState& state, bool overPanel, glm::uvec2 window);
    void move(glm::vec2 to, ViewerState& state, glm::uvec2 window);
    void click(ViewerState& state, glm::uvec2 window);
    void scroll(float notches, ViewerState& state, glm::uvec2 window);
    void fly(ViewerState& state, double seconds);

    std::set<int> held_; ///< keys
    Modifiers modifiers_;
    glm::vec2 mouse_ = glm::vec2(-1);
    glm::vec2 pressedAt_ = glm::vec2(0);
    Drag drag_ = Drag::Nothing;
    bool dragged_ = false;  ///< moved since the button was pressed, so that it is not a click
    double lastClick_ = -1; ///< seconds; -1: the next click is the first of two
    glm::vec2 lastClickAt_ = glm::vec2(0);
    float scale_ = 1;
};

} // namespace glint::view
