// A figure of each frame of a sequence, summed up.
#pragma once

#include <vector>

namespace glint::measure {

/// NaN without frames. `p95` is the value that 95 % of the frames do not exceed.
struct SeriesFigure {
    double mean = 0;
    double p95 = 0;
    double standardError = 0; ///< of the mean, as if frames were independent
};

class FrameSeries {
public:
    void add(double value) { values_.push_back(value); }
    SeriesFigure figure() const;
    /// For values that are squares, and estimates that noise may turn negative: the roots of their mean and percentile,
    /// at least 0.
    SeriesFigure root() const;

private:
    std::vector<double> values_;
};

} // namespace glint::measure
