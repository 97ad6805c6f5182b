#include "lab/view/script_player.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <filesystem>

namespace glint::view {
namespace {

using Kind = ScriptStep::Kind;

InputEvent keyEvent(const KeyStroke& stroke, bool down) {
    InputEvent event;
    event.kind = InputKind::Key;
    event.key = stroke.key;
    event.down = down;
    if (down) // modifiers are released with the key
        event.modifiers = stroke.modifiers;
    return event;
}

InputEvent moveEvent(int x, int y) {
    InputEvent event;
    event.kind = InputKind::Move;
    event.position = glm::vec2(x, y);
    return event;
}

InputEvent buttonEvent(int button, bool down) {
    InputEvent event;
    event.kind = InputKind::Button;
    event.key = button;
    event.down = down;
    return event;
}

std::vector<InputEvent> textEvents(const std::string& text) {
    std::vector<InputEvent> events;
    for (const char c : text) {
        InputEvent event;
        event.kind = InputKind::Text;
        event.character = static_cast<unsigned char>(c);
        events.push_back(event);
    }
    return events;
}

} // namespace

void ScriptPlayer::start(const ScriptStep& step, const ScriptTarget& target) {
    const std::vector<int>& n = step.numbers;
    switch (step.kind) {
    case Kind::Frame: waiting_ = n[0]; break;
    case Kind::Still: calm_ = 0; break;
    case Kind::Quiet:
        target.quiet();
        waiting_ = 2; // a panel takes a frame to close its gap
        break;
    case Kind::Key: frames_ = {{keyEvent(step.stroke, true)}, {keyEvent(step.stroke, false)}}; break;
    case Kind::Press: frames_ = {{keyEvent(step.stroke, true)}}; break;
    case Kind::Release: frames_ = {{keyEvent(step.stroke, false)}}; break;
    case Kind::Type: frames_ = {{}, {}, textEvents(step.text), {}}; break; // a field needs two frames to focus
    case Kind::Move: frames_ = {{moveEvent(n[0], n[1])}, {}}; break;
    case Kind::Click: // a panel detects the mouse one frame before the button press
        frames_ = {{moveEvent(n[0], n[1])}, {}, {buttonEvent(0, true)}, {buttonEvent(0, false)}, {}};
        break;
    case Kind::DoubleClick:
        frames_ = {{moveEvent(n[0], n[1])}, {}, {buttonEvent(0, true)}, {buttonEvent(0, false)}, {buttonEvent(0, true)},
                   {buttonEvent(0, false)}, {}};
        break;
    case Kind::Drag: {
        const int button = step.text == "right" ? 1 : step.text == "middle" ? 2 : 0;
        frames_ = {{moveEvent(n[0], n[1])}, {}, {buttonEvent(button, true)}};
        constexpr int kMoves = 5;
        for (int i = 1; i <= kMoves; ++i)
            frames_.push_back({moveEvent(n[0] + (n[2] - n[0]) * i / kMoves, n[1] + (n[3] - n[1]) * i / kMoves)});
        frames_.push_back({buttonEvent(button, false)});
        break;
    }
    case Kind::Scroll: {
        InputEvent event;
        event.kind = InputKind::Scroll;
        event.position = glm::vec2(0, n[0]);
        frames_ = {{event}};
        break;
    }
    case Kind::Resize:
        target.resize(static_cast<uint32_t>(n[0]), static_cast<uint32_t>(n[1]));
        waiting_ = 2;
        break;
    case Kind::Minimize:
        target.minimize();
        waiting_ = 2;
        break;
    case Kind::Restore:
        target.restore();
        waiting_ = 2;
        break;
    case Kind::Drop: {
        InputEvent event;
        event.kind = InputKind::Drop;
        event.files = {step.text};
        frames_ = {{event}, {}};
        break;
    }
    case Kind::Screenshot:
    case Kind::Picture:
    case Kind::Stats:
    case Kind::Save: target.request(step); break;
    case Kind::Close: {
        InputEvent event;
        event.kind = InputKind::Close;
        frames_ = {{event}};
        break;
    }
    }
}

std::vector<InputEvent> ScriptPlayer::frame(const ScriptTarget& target, bool complete, bool busy) {
    calm_ = complete ? calm_ + 1 : 0;
    if (waiting_ > 0) {
        --waiting_;
        return {};
    }
    if (frames_.empty() && !busy && next_ < steps_.size()) {
        const bool still = next_ > 0 && steps_[next_ - 1].kind == Kind::Still;
        if (still && calm_ < 3) // one to notice a change, one to render, one to show it
            return {};
        start(steps_[next_++], target);
    }
    if (frames_.empty())
        return {};
    std::vector<InputEvent> events = std::move(frames_.front());
    frames_.pop_front();
    return events;
}

} // namespace glint::view
