// Implements `glint tune`: searches settings, checks them on views held back, and says what mattered.
#pragma once

#include "lab/tune/evaluation_store.hpp"
#include "lab/tune/search.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glint::tune {

/// What the user asked for, in the units of docs/tune.md; exactly one is set.
struct TuneTarget {
    std::optional<double> mostMs;     ///< milliseconds of the effect
    std::optional<double> mostFloors; ///< where costs are counted
    std::optional<double> mostShare;  ///< of the start's cost
    std::optional<double> mostError;
};

struct TunePlan {
    EvaluationPlan evaluation;
    SearchPlan search;
    TuneTarget target;
    std::string startName;
    /// Which program searches, and what the scenes' files contain, as text: a state file of others is refused.
    std::string identity;
    std::string stateFile;         ///< read if it exists, and written again and again; empty: none
    double secondsPerSave = 10;    ///< writing takes milliseconds, an evaluation up to a minute
    std::optional<double> seconds; ///< no generation begins later
    uint32_t timedFrames = 10;     ///< for the times in the result
};

struct TunePoint {
    Settings settings;
    Evaluation search;
    Evaluation held;
    Timing timing;
    std::string preset; ///< its name, if it is one
    bool chosen = false;
};

/// What one setting of the choice does: the figures with the start's value in its place, minus the choice's.
struct Sensitivity {
    std::string key;
    std::string value; ///< the choice's
    std::string start;
    Figures change;
};

struct TuneResult {
    std::string device;
    std::string driver;
    ErrorMetric metric = ErrorMetric::Flip;
    bool counted = false; ///< costs are counted floors; false: milliseconds
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t generations = 0;
    size_t tried = 0;
    Target target;                          ///< in the unit of cost
    TunePoint choice;                       ///< the start where nothing better holds up
    std::vector<TunePoint> points;          ///< by rising cost, none dominated
    std::vector<TunePoint> presets;         ///< the start first
    std::vector<Sensitivity> sensitivities; ///< the largest change of error first
    std::vector<std::string> withoutEffect;
    bool met = false;  ///< the choice meets the target
    bool held = false; ///< and holds up on the views held back
};

struct TuneHooks {
    std::function<void(const SearchProgress&)> progress;  ///< may be empty
    std::function<void(const std::string& what)> working; ///< called before long work; may be empty
};

/// Errors: those of the scenes' readers, the device and the state file.
Result<TuneResult> tuneSettings(gpu::Context& context, const TunePlan& plan, const TuneHooks& hooks);

} // namespace glint::tune
