// `glint report --pictures`: a page that opens with its first picture and fills up.
#pragma once

#include "gpu/context.hpp"
#include "lab/cli/report/gallery_plan.hpp"
#include "lab/cli/report/report.hpp"

#include <cstdio>

namespace glint::cli {

/// Reads a plan whose pictures will lie beside the page. Errors: NotFound, Io; as readGalleryPlan; InvalidArgument if a
/// picture or the page would replace a file that is read.
Result<GalleryPlan> openGallery(const std::string& file, const std::string& page);

/// Renders the pictures, and writes the page at the beginning and after each of them. `console` gets the page's name
/// once there is something to see.
/// `common`  device, seed and validation;  `size`  of every picture, or empty: the plan's
/// Errors: as planGallery and renderGallery.
Result<void> renderGalleryPage(const GalleryPlan& plan, const gpu::Context& context, const RenderOptions& common,
                               const std::string& size, const std::string& page, std::FILE* console, Report& report);

} // namespace glint::cli
