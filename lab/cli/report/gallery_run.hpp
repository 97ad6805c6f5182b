// Renders the pictures of a gallery beside a page that is written again after each.
#pragma once

#include "gpu/context.hpp"
#include "lab/cli/report/gallery.hpp"
#include "lab/cli/report/gallery_plan.hpp"

#include <functional>

namespace glint::cli {

/// A gallery and its jobs, in the same order.
struct GalleryWork {
    Gallery gallery;
    std::vector<render::RenderJob> jobs;
};

/// `size`  of every picture, or empty: the plan's
/// Errors: those of makeRenderJob.
Result<GalleryWork> planGallery(const GalleryPlan& plan, const gpu::DeviceInfo& device, const std::string& size,
                                const RenderOptions& common);

/// Renders the jobs and writes each to FOLDER/NAME.png; `show` is called at the beginning and after each, never by two
/// threads at once. Jobs of one scene share a session. On a device that runs on the CPU two sessions are rendered at
/// the same time, since pipelines compile on one thread; then there are no times. Errors: those of the first job that
/// fails, of writing and of `show`.
Result<void> renderGallery(GalleryWork& work, const std::string& folder,
                           const std::function<Result<void>(const Gallery&)>& show);

} // namespace glint::cli
