// Steps back and forth between states that a person has made.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace glint::view {

template <class State>
class UndoStack {
public:
    /// States that are kept.
    static constexpr size_t kMost = 200;

    /// Remembers `before`, what was there before the change that comes now. What was undone is gone.
    void push(State before) {
        undone_.clear();
        if (done_.size() >= kMost)
            done_.erase(done_.begin());
        done_.push_back(std::move(before));
    }
    bool canUndo() const { return !done_.empty(); }
    bool canRedo() const { return !undone_.empty(); }
    /// Changes every state that is kept.
    template <class Change>
    void forEach(const Change& change) {
        for (State& state : done_)
            change(state);
        for (State& state : undone_)
            change(state);
    }
    /// Exchanges `now` for the state before; does nothing where there is none.
    bool undo(State& now) { return move(done_, undone_, now); }
    bool redo(State& now) { return move(undone_, done_, now); }

private:
    static bool move(std::vector<State>& from, std::vector<State>& to, State& now) {
        if (from.empty())
            return false;
        to.push_back(std::exchange(now, std::move(from.back())));
        from.pop_back();
        return true;
    }

    std::vector<State> done_;
    std::vector<State> undone_;
};

} // namespace glint::view
