// The values of a report as JSON: what the page shows and what `glint report --json` writes (docs/report.md).
#pragma once

#include "lab/cli/report/report.hpp"

namespace glint::cli {

constexpr std::string_view kReportFormat = "glint report 1";

/// {"format", "glint", "command", "options": Report::options, "machine": machineJson, "device", "clock",
///  "legends": {"outcome", "source", "hits": [{"name", "color", "meaning"}]},
///  "gallery": galleryJson,
///  "scenes": [comparisonJson and "title", "pictures": {name: picture}; in "configs" also "command", "seeds", "flip"
///  and
///             "pictures"; "motion": sequenceJson and "path", "strips": [{"frame", "pictures": [by config]}]}],
///  "curve": readCurve, "figures": figuresJson, "changes": changesJson}
/// A picture's name is its key among the images of the page (ReportPictures); `gallery`, `motion`, `curve` and
/// `changes` may be absent.
nlohmann::ordered_json reportJson(const Report& report);

/// reportJson as the text of a file.
std::string reportText(const Report& report);

/// The names of the pictures, as reportJson refers to them.
std::string scenePictureName(size_t scene, std::string_view picture);
std::string configPictureName(size_t scene, size_t config, std::string_view picture);
std::string framePictureName(size_t scene, size_t config, size_t frame);

} // namespace glint::cli
