// The images of a report, encoded so that all of them fit into one page.
#pragma once

#include "base/result.hpp"
#include "lab/cli/report/report.hpp"

namespace glint::cli {

/// The images of each config: "composite", "difference", "flip", "worst", "outcome", "source", "hits".
std::span<const std::string_view> configPictures();

struct ReportPictures {
    /// {name: {"width", "height", "src": "data:image/webp;base64,..."}}, by the names of reportJson
    nlohmann::ordered_json images;
    std::string loss; ///< "without loss", or the quality at which the images fit
};

/// Encodes as WebP, without loss if all images together have at most `mostBytes` as base64. Otherwise the frames and
/// maps of differences lose detail, in steps, until they do; images whose colours are names (outcome, source, hits)
/// never do. Errors: InvalidArgument if they do not fit, or for an image that is too large for WebP.
Result<ReportPictures> encodePictures(const std::vector<ReportScene>& scenes, size_t mostBytes);

/// The bytes as base64 (RFC 4648).
std::string base64(std::string_view bytes);

} // namespace glint::cli
