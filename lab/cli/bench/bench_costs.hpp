// glint bench --costs: the table of costs that `glint tune` counts by, from frames of scenes and settings.
#pragma once

#include "lab/measure/bench/bench.hpp"
#include "lab/tune/cost_fit.hpp"

namespace glint::cli {

struct CostsBench {
    tune::CostTable table; ///< with the new figures
    std::vector<tune::FittedRow> rows;
    std::vector<std::string> withoutRow; ///< passes that ran and have no row
    size_t frames = 0;                   ///< that were compared: scenes times settings
};

/// Errors: those of the scenes' readers and the device; InvalidArgument for a device without a floor.
Result<CostsBench> measureCostTable(gpu::Context& context, const std::vector<measure::BenchScene>& scenes,
                                    const measure::BenchPlan& plan,
                                    const std::function<void(const std::string&)>& progress);

/// Every row: its old figure and its new one, or why it stays.
std::string costsBenchText(const CostsBench& result);

} // namespace glint::cli
