// Times of the reflections over many frames: each pass, their sum, and the floor that the sum is a multiple of.
#pragma once

#include "render/run_job.hpp"

#include <string>
#include <vector>

namespace glint::measure {

/// Of many measurements, in milliseconds.
struct Spread {
    double median = 0;
    double p95 = 0; ///< 95th percentile

    static Spread of(std::vector<double> values);
};

struct PassSpread {
    std::string name;
    Spread ms;
};

/// What the passes of `passes` are together, without counting (composite/statistics) and tables made once.
double effectSum(const std::vector<std::pair<std::string, double>>& passes);

/// Gathers frames whose plan has a FloorPass among its passes.
class EffectTimes {
public:
    void add(const render::FrameTimes& times);
    /// A frame without the effect: its floor counts too, as a pass so short needs more samples.
    void addFloor(const render::FrameTimes& times);
    /// A frame that was drawn: takes what the host draws for the reflections alone (back-face depth), which counts too.
    void addDrawn(const render::FrameTimes& times);
    size_t frames() const { return totals_.size(); }
    std::vector<PassSpread> passes() const; ///< in the order in which they run
    Spread total() const;
    Spread floor() const { return Spread::of(floors_); }
    /// Median of the effect over median of the floor; 0 without a floor.
    double floorMultiple() const;
    double hostMs() const; ///< medians of what addDrawn took; part of `total`

private:
    std::vector<std::pair<std::string, std::vector<double>>> passes_;
    std::vector<std::pair<std::string, std::vector<double>>> hostPasses_;
    std::vector<double> totals_;
    std::vector<double> floors_;
};

} // namespace glint::measure
