// The figures of a report that are compared with those of an earlier one.
#pragma once

#include "base/result.hpp"
#include "lab/cli/report/report.hpp"

namespace glint::cli {

/// All figures whose noise is known: those of hits, which have none; those of images, where each config was rendered
/// with several seeds; those of motion.
std::vector<measure::Figure> reportFigures(const std::vector<ReportScene>& scenes);

/// [{"scene", "config", "name", "kind", "value", "standardError", "freedom"}]
nlohmann::ordered_json figuresJson(const std::vector<measure::Figure>& figures);

/// Reads what figuresJson wrote. Errors: InvalidInput names the figure and what is wrong with it.
Result<std::vector<measure::Figure>> readFigures(const nlohmann::ordered_json& json);

/// An earlier report, as far as it is compared with.
struct EarlierReport {
    std::string file;
    std::string glint; ///< version
    std::string device;
    std::string driver;
    nlohmann::ordered_json options; ///< Report::options, all of them texts
    std::vector<measure::Figure> figures;
};

/// Reads what `glint report --json` wrote. Errors: NotFound, Io; InvalidInput if it is no report of this format; all
/// name `--against` and the file.
Result<EarlierReport> readEarlierReport(const std::string& file);

/// Errors: InvalidInput names the options that differ, which make figures incomparable.
Result<void> checkSameOptions(const EarlierReport& earlier, const nlohmann::ordered_json& options);

/// Compares the figures of `scenes` with earlier ones; the thresholds remain to be set. Errors: InvalidInput if they
/// have none in common.
Result<ReportChanges> changesSince(const EarlierReport& earlier, const std::vector<ReportScene>& scenes);

/// Text for the terminal: a line for each figure that is better or worse, and how many are neither.
std::string changesText(const ReportChanges& changes);

/// {"file", "glint", "device", "threshold", "timeThreshold", "otherDevice", "changes": [{"scene", "config", "name",
///  "kind", "before", "now", "worse", "low", "high", "verdict", "fails"}], "added": [...], "removed": [...]}
/// An infinite change is null.
nlohmann::ordered_json changesJson(const ReportChanges& changes);

} // namespace glint::cli
