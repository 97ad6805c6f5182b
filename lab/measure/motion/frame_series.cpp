#include "lab/measure/motion/frame_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint::measure {

SeriesFigure FrameSeries::figure() const {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (values_.empty() || std::ranges::any_of(values_, [](double value) { return std::isnan(value); }))
        return {kNone, kNone, kNone};
    const auto count = static_cast<double>(values_.size());
    double sum = 0, squares = 0;
    for (const double value : values_)
        sum += value;
    const double mean = sum / count;
    for (const double value : values_)
        squares += (value - mean) * (value - mean);
    std::vector<double> sorted = values_;
    std::ranges::sort(sorted);
    const auto at = static_cast<size_t>(std::ceil(0.95 * count)) - 1;
    return {mean, sorted[at], values_.size() > 1 ? std::sqrt(squares / (count - 1) / count) : 0};
}

SeriesFigure FrameSeries::root() const {
    const SeriesFigure square = figure();
    const double mean = std::sqrt(std::max(square.mean, 0.0));
    const double error = mean > 0 ? square.standardError / (2 * mean) : std::sqrt(square.standardError);
    // std::max drops NaN
    return std::isnan(square.mean) ? square : SeriesFigure{mean, std::sqrt(std::max(square.p95, 0.0)), error};
}

} // namespace glint::measure
