// Formats a comparison as text, as JSON and as a folder with images. report_page.hpp makes a page of it.
#pragma once

#include "lab/measure/truth/comparison.hpp"

namespace glint::cli {

/// Returns text for the terminal: a block of lines per config.
std::string comparisonText(const measure::Comparison& comparison);

/// {"scene", "width", "height", "device": {"name", "driver", "software"}, "clock", "configs": [{"name", "preset",
///  "hits": hitReportJson, "exact": exactJson, "effectMs", "effectMs95", "floorMs", "floorMultiple", "frames",
///  "passes": [{"name", "ms", "ms95"}], "rays", "lookupsPerRay", "lookups95", "outcomes", "notes", "settings"}]}
/// "exact" is absent where no exact picture exists, and "noExact" says why.
std::string comparisonJson(const measure::Comparison& comparison);

/// Writes the images of each config (composite, outcome, hits: measure::classColors) as PNG and figures.json into
/// `folder`, which is created if necessary. Errors: Io.
Result<void> writeComparisonFolder(const std::string& folder, const measure::Comparison& comparison);

/// Returns a sentence about the meaning of a device's times.
std::string clockWords(bool software);

} // namespace glint::cli
