// Undo and redo of states changed by the user.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace glint::view {

template <class State>
class UndoStack {
public:
    /// Maximum number of stored states.
    static constexpr size_t kMost = 200;

    /// Stores `before`, the state before the coming change. Undone states are discarded.
    void push(State before) {
        undone_.clear();
        if (done_.size() >= kMost)
            done_.erase(done_.begin());
        done_.push_back(std::move(before));
    }
    bool canUndo() const { return !done_.empty(); }
    bool canRedo() const { return !undone_.empty(); }
    /// Applies a change to every stored state.
    template <class Change>
    void forEach(const Change& change) {
        for (State& state : done_)
            change(state);
        for (State& state : undone_)
            change(state);
    }
    /// Exchanges `now` with the previous state; does nothing if there is none.
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
