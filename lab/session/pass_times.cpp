#include "lab/session/pass_times.hpp"

#include <algorithm>

namespace glint::render {

void PassTimes::add(const std::string& name, double milliseconds) {
    if (times_.find(name) == times_.end())
        order_.push_back(name);
    std::vector<double>& all = times_[name];
    if (all.size() >= kMostFrames)
        all.erase(all.begin(), all.begin() + kMostFrames / 2);
    all.push_back(milliseconds);
}

std::vector<std::pair<std::string, double>> PassTimes::medians() const {
    std::vector<std::pair<std::string, double>> result;
    for (const std::string& name : order_) {
        std::vector<double> all = times_.at(name);
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        std::nth_element(all.begin(), middle, all.end());
        result.emplace_back(name, *middle);
    }
    return result;
}

} // namespace glint::render
