// A comparison as text, as JSON and as a page with pictures.
#pragma once

#include "comparison.hpp"

namespace glint::cli {

/// A block of lines a config, for people.
std::string comparisonText(const Comparison& comparison);

/// {"scene", "width", "height", "device": {"name", "driver", "software"}, "clock", "configs": [{"name", "preset",
///  "hits": hitReportJson, "exact": exactJson, "effectMs", "effectMs95", "floorMs", "floorMultiple", "frames",
///  "passes": [{"name", "ms", "ms95"}], "rays", "lookupsPerRay", "lookups95", "outcomes", "notes", "settings"}]}
/// "exact" is absent where no exact picture exists, and "noExact" says why.
std::string comparisonJson(const Comparison& comparison);

/// Writes the pictures of each config (composite, outcome, hits: measure::classColors) and index.html with the figures
/// into `folder`, which is made if it is not there. Errors: Io.
Result<void> writeReport(const std::string& folder, const Comparison& comparison);

/// What the times of a device mean, in words.
std::string clockWords(bool software);

} // namespace glint::cli
