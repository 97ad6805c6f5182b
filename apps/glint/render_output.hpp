// What `glint render` leaves behind: pictures and figures.
#pragma once

#include "base/result.hpp"
#include "measure/exact_picture.hpp"
#include "measure/ray_hits.hpp"
#include "render/render_job.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace glint::cli {

enum class PictureKind { Png, Exr };

/// By the name's ending. Errors: InvalidArgument.
Result<PictureKind> pictureKind(std::string_view path);

/// "out.png" and "depth" make "out.depth.png".
std::string pathForView(const std::string& path, std::string_view view);

/// RGB as a PNG shows it. Errors: InvalidArgument for an unknown view.
Result<std::vector<uint8_t>> displayedBytes(const render::RenderedView& view);

/// PNG: a file a view, the first under `path` itself, the others under pathForView. EXR: one file, the first view bare
/// (R, G, B, A), the others as layers with their names. Errors: Io.
Result<void> writePictures(const std::string& path, const render::RenderResult& result);

/// What was measured beside the rendering, where it was asked for.
struct Measured {
    std::optional<measure::MirrorError> exact; ///< measure.exact
    std::optional<measure::HitReport> hits;    ///< measure.hits
};

/// {"scene", "device": {"name", "driver", "software"}, "width", "height", "frames", "time", "seed",
///  "gpuMs" (all passes), "passes": [{"name", "ms"}], "rays", "lookupsPerRay", "lookups95",
///  ["sceneRays": {glint::Statistics::SceneRays}], "outcomes": {name: pixels},
///  "exact": exactJson, "hits": hitReportJson, "notes": [...], "preset", "settings": {...}}; no "gpuMs" where the
///  device has no timestamps.
std::string statsJson(const render::RenderJob& job, const render::RenderResult& result, const Measured& measured = {});

} // namespace glint::cli
