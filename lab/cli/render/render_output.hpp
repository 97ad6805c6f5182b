// The output of `glint render`: images and figures.
#pragma once

#include "base/result.hpp"
#include "lab/job/render_job.hpp"
#include "lab/measure/truth/exact_picture.hpp"
#include "lab/measure/truth/ray_hits.hpp"
#include "lab/scene/images/image_file.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace glint::cli {

enum class PictureKind { Png, Exr };

/// Determines the kind from the file extension. Errors: InvalidArgument.
Result<PictureKind> pictureKind(std::string_view path);

/// "out.png" and "depth" become "out.depth.png".
std::string pathForView(const std::string& path, std::string_view view);

/// Returns RGB bytes for a PNG. Errors: InvalidArgument for an unknown view.
Result<std::vector<uint8_t>> displayedBytes(const render::RenderedView& view);

/// The layers of an EXR file, as writePictures writes them; they refer to the views of `result`. Errors:
/// InvalidArgument for an unknown view.
Result<std::vector<scene::ExrLayer>> pictureLayers(const render::RenderResult& result);

/// PNG: one file per view, the first at `path`, the others at pathForView. EXR: one file, the first view without a
/// layer name (R, G, B, A), the others as named layers. Errors: Io.
Result<void> writePictures(const std::string& path, const render::RenderResult& result);

/// Additional measurements, where requested.
struct Measured {
    std::optional<measure::MirrorError> exact; ///< measure.exact
    std::optional<measure::HitReport> hits;    ///< measure.hits
};

/// {"pixels", "rays", "fromScreen", "replaced", "reusedLight"}.
nlohmann::ordered_json sceneRaysJson(const Statistics::SceneRays& scene);

/// {"scene", "device": {"name", "driver", "software"}, "width", "height", "frames" (rendered),
///  ["settleError": with RenderJob::settle], "time", "seed", "gpuMs" (all passes), "passes": [{"name", "ms"}], "rays",
///  "lookupsPerRay", "lookups95",
///  ["sceneRays": sceneRaysJson], "outcomes": {name: pixels},
///  "exact": exactJson, "hits": hitReportJson, "notes": [...], "preset", "settings": {...}}; no "gpuMs" where the
///  device has no timestamps.
std::string statsJson(const render::RenderJob& job, const render::RenderResult& result, const Measured& measured = {});

} // namespace glint::cli
