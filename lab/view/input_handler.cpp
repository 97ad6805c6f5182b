#include "lab/view/input_handler.hpp"

#include "lab/view/canvas.hpp"
#include "lab/view/ssr_keys.hpp"
#include "lab/view/view_commands.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace glint::view {
namespace {

constexpr double kDoubleClick = 0.35; ///< seconds
/// Pixels; movement of the mouse that still counts as a click, also between two clicks.
constexpr float kClickSlack = 4;
constexpr float kLineReach = 6; ///< pixels around the dividing line
constexpr float kTurn = 3;      ///< radians for a drag over the window's height
constexpr std::string_view kFlyKeys = "WASDQE";

} // namespace

void InputHandler::handle(std::span<const InputEvent> events, ViewerState& state, const Gui& gui, glm::uvec2 window,
                          double seconds) {
    for (const InputEvent& event : events)
        switch (event.kind) {
        case InputKind::Key: key(event, state, gui.wantsKeys()); break;
        case InputKind::Move: move(event.position, state, window); break;
        case InputKind::Button: button(event, state, gui.wantsMouse(), window); break;
        case InputKind::Scroll:
            if (!gui.wantsMouse())
                scroll(event.position.y, state, window);
            break;
        case InputKind::Drop:
            for (const std::string& file : event.files)
                state.ask(Request::Kind::Open, file);
            break;
        case InputKind::Close: state.ask(Request::Kind::Close); break;
        case InputKind::Text: break;
        }
    fly(state, seconds);
    if (state.askFollows && mouse_.x >= 0 && !gui.wantsMouse())
        state.asked = glm::clamp(makeCanvas(state.zoom, window).toUV(mouse_), glm::vec2(0), glm::vec2(1));
}

void InputHandler::key(const InputEvent& event, ViewerState& state, bool typing) {
    modifiers_ = event.modifiers;
    if (!event.down) {
        held_.erase(event.key);
        return;
    }
    if (runShortcut(event, state, typing))
        return;
    if (typing || event.modifiers.control || event.modifiers.alt)
        return;
    if (event.key >= 'A' && event.key <= 'Z' && kFlyKeys.find(static_cast<char>(event.key)) != kFlyKeys.npos)
        held_.insert(event.key);
    if (event.key >= '0' && event.key <= '9')
        if (const auto said = pressSsrKey(static_cast<char>(event.key), state.settings))
            state.say(*said);
}

void InputHandler::fly(ViewerState& state, double seconds) {
    const auto held = [&](char key) { return held_.contains(key) ? 1.0f : 0.0f; };
    const glm::vec3 direction(held('D') - held('A'), held('E') - held('Q'), held('W') - held('S'));
    if (direction == glm::vec3(0))
        return;
    const float speed = scale_ * 0.15f * (modifiers_.shift ? 4.0f : 1.0f); // metres per second
    state.camera.fly(direction * (speed * static_cast<float>(seconds)));
}

void InputHandler::button(const InputEvent& event, ViewerState& state, bool overPanel, glm::uvec2 window) {
    if (event.down && !overPanel && drag_ == Drag::Nothing) {
        pressedAt_ = mouse_;
        dragged_ = false;
        const float line = state.line * static_cast<float>(window.x);
        if (event.key == 0)
            drag_ =
                state.beside != Beside::Nothing && std::abs(mouse_.x - line) <= kLineReach ? Drag::Line : Drag::Orbit;
        else
            drag_ = event.key == 1 ? Drag::Pan : Drag::Look;
    } else if (!event.down && drag_ != Drag::Nothing) {
        if (drag_ == Drag::Orbit && !dragged_)
            click(state, window);
        drag_ = Drag::Nothing;
    }
}

void InputHandler::move(glm::vec2 to, ViewerState& state, glm::uvec2 window) {
    const glm::vec2 size = glm::max(glm::vec2(window), glm::vec2(1));
    const glm::vec2 step = (to - mouse_) / size.y;
    mouse_ = to;
    if (drag_ == Drag::Nothing)
        return;
    if (drag_ == Drag::Line) {
        state.line = std::clamp(to.x / size.x, 0.0f, 1.0f);
        return;
    }
    if (!dragged_ && glm::distance(to, pressedAt_) < kClickSlack)
        return;
    dragged_ = true;
    if (state.zoom.factor > 1 && drag_ != Drag::Orbit) { // zoomed in: pan the picture itself
        state.zoom.centerUV -= step * size.y / size / state.zoom.factor;
        return;
    }
    if (drag_ == Drag::Orbit)
        state.camera.orbit(step.x * kTurn, -step.y * kTurn);
    else if (drag_ == Drag::Pan)
        state.camera.pan(-step.x, step.y);
    else
        state.camera.look(step.x * kTurn / 2, -step.y * kTurn / 2);
}

void InputHandler::click(ViewerState& state, glm::uvec2 window) {
    state.asked = glm::clamp(makeCanvas(state.zoom, window).toUV(mouse_), glm::vec2(0), glm::vec2(1));
    state.askFollows = false;
    if (state.showMaterials)
        state.materialAsked = state.asked;
    const bool again = lastClick_ >= 0 && state.now - lastClick_ < kDoubleClick;
    if (again && glm::distance(mouse_, lastClickAt_) < kClickSlack) {
        state.focusAsked = true;
        lastClick_ = -1;
    } else {
        lastClick_ = state.now;
        lastClickAt_ = mouse_;
    }
}

void InputHandler::scroll(float notches, ViewerState& state, glm::uvec2 window) {
    if (modifiers_.control)
        state.zoom = zoomed(state.zoom, window, mouse_, std::pow(2.0f, notches));
    else
        state.camera.dolly(std::pow(0.9f, notches));
}

} // namespace glint::view
