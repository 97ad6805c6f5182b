// What `glint tune` says while it works: what it does, and how long it may still take.
#pragma once

#include "lab/tune/tune.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace glint::cli {

/// Where standard error is no terminal: a line a minute, so that a log says how far a long search is.
class TuneProgress {
public:
    /// `seconds`  limit of the search; absent: all generations are made
    TuneProgress(uint32_t generations, std::optional<double> seconds);

    /// Hooks that show the progress; they refer to this object.
    tune::TuneHooks hooks();
    /// Ends the line.
    void finish();

    /// "generation 3 of 20, 12 of 24, 4:10 left"; without the time as long as nothing is known.
    static std::string line(const tune::SearchProgress& progress, uint32_t generations,
                            const std::optional<double>& secondsLeft);
    /// Time left after the part [0, 1] of the generations that `passed` seconds took; at most what the limit leaves.
    static std::optional<double> left(double part, double passed, const std::optional<double>& limit);

private:
    void show(const std::string& text);
    void log(const std::string& text);

    uint32_t generations_;
    std::optional<double> seconds_;
    bool terminal_;
    size_t shown_ = 0; ///< characters of the line
    std::chrono::steady_clock::time_point created_;
    std::chrono::steady_clock::time_point logged_; ///< the last line
    std::optional<std::chrono::steady_clock::time_point> firstGeneration_;
};

} // namespace glint::cli
