// Plays a script (input_script.hpp): each frame, a step becomes the input events of a user.
#pragma once

#include "lab/view/input_event.hpp"
#include "lab/view/input_script.hpp"

#include <deque>
#include <functional>

namespace glint::view {

/// The actions of a script on the window and the program.
struct ScriptTarget {
    std::function<void(uint32_t, uint32_t)> resize;
    std::function<void()> minimize;
    std::function<void()> restore;
    std::function<void()> quiet;
    std::function<void(const ScriptStep&)> request; ///< Screenshot, Picture, Stats, Save
};

class ScriptPlayer {
public:
    ScriptPlayer() = default;
    explicit ScriptPlayer(std::vector<ScriptStep> steps) : steps_(std::move(steps)) {}

    bool playing() const { return !frames_.empty() || next_ < steps_.size() || waiting_ > 0; }
    /// Returns the events of the frame that begins now.
    /// `complete`  the picture is final; `busy`: a request is not yet finished
    std::vector<InputEvent> frame(const ScriptTarget& target, bool complete, bool busy);

private:
    void start(const ScriptStep& step, const ScriptTarget& target);

    std::vector<ScriptStep> steps_;
    size_t next_ = 0;
    std::deque<std::vector<InputEvent>> frames_; ///< of the current step
    int waiting_ = 0;                            ///< remaining frames to skip
    int calm_ = 0;                               ///< consecutive frames with a complete picture
};

} // namespace glint::view
