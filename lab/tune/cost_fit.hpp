// Costs from frames that were counted and timed: what `glint bench --costs` writes.
#pragma once

#include "lab/measure/bench/floor_pass.hpp"
#include "lab/session/reflection_session.hpp"
#include "lab/tune/cost_table.hpp"

#include <map>
#include <span>

namespace glint::tune {

/// What one frame did, and what its passes took.
struct CostSample {
    std::string name;                                  ///< scene and settings
    std::map<std::string, double, std::less<>> floors; ///< by pass without back end: all its runs, median over frames
    std::vector<double> amounts;                       ///< of the table's rows, in all runs of their passes
};

struct FittedRow {
    CostRow row;
    double floors = 0; ///< the new figure, to three digits; the old one if `kept`
    std::string kept;  ///< why these frames do not tell; empty: fitted
    double error = 0;  ///< of the pass as fitted: mean relative difference from its times
};

/// Counts and times frames with the session's settings. The session needs RenderJob::libraryViews.
/// `frames`  to time, after as many as their history needs
/// Errors: OutOfMemory, DeviceLost.
Result<CostSample> measureCosts(const CostTable& table, render::ReflectionSession& session, measure::FloorPass& floor,
                                uint32_t frames);

/// For each row of the table. A pass's costs are those whose sum has the least squares of relative differences from its
/// times. They stay as they are if the pass ran in too few frames, if its units grow together, or if one would be
/// below 0.
std::vector<FittedRow> fitCosts(const CostTable& table, std::span<const CostSample> samples);

/// Passes of the samples without a row.
std::vector<std::string> passesWithoutRow(const CostTable& table, std::span<const CostSample> samples);

} // namespace glint::tune
