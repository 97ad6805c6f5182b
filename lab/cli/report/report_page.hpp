// Writes a report as one HTML file that needs nothing else (docs/report.md).
#pragma once

#include "base/result.hpp"
#include "lab/cli/report/report.hpp"

#include <string>

namespace glint::cli {

/// The largest page that is written.
constexpr size_t kMostPageBytes = 15000000;

/// The template (lab/cli/report/page) with the values of the report and all of its images in one block of JSON. Errors:
/// as encodePictures.
Result<std::string> reportPage(const Report& report);

/// Writes reportPage to a file. Errors: Io; as reportPage.
Result<void> writeReportPage(const std::string& file, const Report& report);

} // namespace glint::cli
