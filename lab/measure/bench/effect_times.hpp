// Times of the reflections over many frames: each pass, their sum, and the floor that the sum is compared with.
#pragma once

#include "lab/session/run_job.hpp"

#include <string>
#include <vector>

namespace glint::measure {

/// Statistics of many measurements, in milliseconds.
struct Spread {
    double median = 0;
    double p95 = 0; ///< 95th percentile

    static Spread of(std::vector<double> values);
};

struct PassSpread {
    std::string name;
    Spread ms;
};

/// Returns the sum of `passes`, without counting (composite/statistics) and tables that are made once.
double effectSum(const std::vector<std::pair<std::string, double>>& passes);

/// Collects frames whose plan contains a FloorPass.
class EffectTimes {
public:
    void add(const render::FrameTimes& times);
    /// Adds a frame without the effect. Its floor is counted too, as such a short pass needs more samples.
    void addFloor(const render::FrameTimes& times);
    /// Adds a frame that was drawn. The host's work for the reflections alone (back-face depth) is counted too.
    void addDrawn(const render::FrameTimes& times);
    size_t frames() const { return totals_.size(); }
    std::vector<PassSpread> passes() const; ///< in execution order
    Spread total() const;
    Spread floor() const { return Spread::of(floors_); }
    /// Returns the median of the effect divided by the median of the floor; 0 without a floor.
    double floorMultiple() const;
    double hostMs() const; ///< sum of the medians of the host's passes from addDrawn; part of `total`

private:
    std::vector<std::pair<std::string, std::vector<double>>> passes_;
    std::vector<std::pair<std::string, std::vector<double>>> hostPasses_;
    std::vector<double> totals_;
    std::vector<double> floors_;
};

} // namespace glint::measure
