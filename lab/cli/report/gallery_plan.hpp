// The pictures of a gallery (docs/report.md): what is rendered and shown on a page before anything is measured.
#pragma once

#include "base/result.hpp"
#include "lab/cli/render/render_options.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

struct GalleryEntry {
    std::string name; ///< of its file, without the ending: letters, digits, - and _; no two pictures share one
    std::string title;
    std::string config;    ///< as for --config, or empty
    RenderOptions options; ///< without size, output and device
};

struct GalleryPlan {
    std::string size = "1280x720"; ///< "WIDTHxHEIGHT"
    std::string softwareSize;      ///< on a device that runs on the CPU; empty: `size`
    std::vector<GalleryEntry> entries;
};

/// Settings have not been compared with the table yet. `name` is used in messages. Errors: InvalidInput with the place
/// in the file.
Result<GalleryPlan> readGalleryPlan(std::string_view text, const std::string& name);

} // namespace glint::cli
