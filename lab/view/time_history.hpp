// The times of each pass in the last frames, for a graph.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace glint::view {

class TimeHistory {
public:
    static constexpr size_t kFrames = 240;

    /// Adds the milliseconds of a frame's passes, in execution order.
    void add(const std::vector<std::pair<std::string, double>>& passes) {
        frames_.push_back(passes);
        if (frames_.size() > kFrames)
            frames_.pop_front();
    }
    void clear() { frames_.clear(); }
    size_t frames() const { return frames_.size(); }
    const std::vector<std::pair<std::string, double>>& frame(size_t i) const { return frames_[i]; }
    /// Returns the passes of the newest frame.
    std::vector<std::string> passes() const {
        std::vector<std::string> names;
        if (!frames_.empty())
            for (const auto& [name, ms] : frames_.back())
                names.push_back(name);
        return names;
    }

private:
    std::deque<std::vector<std::pair<std::string, double>>> frames_;
};

} // namespace glint::view
