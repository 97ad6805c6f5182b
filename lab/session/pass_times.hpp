// Milliseconds of each pass over many frames.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace glint::render {

class PassTimes {
public:
    void clear() { *this = {}; }
    void add(const std::string& name, double milliseconds);
    /// Returns the median of each pass, in the order in which passes were first added. For an even number of frames it
    /// is the upper median.
    std::vector<std::pair<std::string, double>> medians() const;

    static constexpr size_t kMostFrames =
        4096; ///< the older half is dropped at this count, as a window may stay open for days

private:
    std::vector<std::string> order_;
    std::map<std::string, std::vector<double>> times_;
};

} // namespace glint::render
