// Plays a script (input_script.hpp): a step a frame becomes input events, as a person's hands would make them.
#pragma once

#include "input_event.hpp"
#include "input_script.hpp"

#include <deque>
#include <functional>

namespace glint::view {

/// What a script asks of the window and of the program itself.
struct ScriptTarget {
    std::function<void(uint32_t, uint32_t)> resize;
    std::function<void()> minimize;
    std::function<void()> restore;
    std::function<void(const ScriptStep&)> request; ///< Screenshot, Picture, Stats, Save
};

class ScriptPlayer {
public:
    ScriptPlayer() = default;
    explicit ScriptPlayer(std::vector<ScriptStep> steps) : steps_(std::move(steps)) {}

    bool playing() const { return !frames_.empty() || next_ < steps_.size() || waiting_ > 0; }
    /// The events of the frame that begins now.
    /// `complete`  the picture is as good as it gets; `busy`: a request has not been served yet
    std::vector<InputEvent> frame(const ScriptTarget& target, bool complete, bool busy);

private:
    void start(const ScriptStep& step, const ScriptTarget& target);

    std::vector<ScriptStep> steps_;
    size_t next_ = 0;
    std::deque<std::vector<InputEvent>> frames_; ///< of the step that is being played
    int waiting_ = 0;                            ///< frames to let pass
    int calm_ = 0;                               ///< frames for which the picture has been complete
};

} // namespace glint::view
