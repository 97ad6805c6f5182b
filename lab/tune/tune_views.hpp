// The views that settings are judged on: the scene's own cameras, at rest and in motion, and views that are held back
// from the search.
#pragma once

#include "lab/job/render_job.hpp"
#include "lab/scene/camera_path.hpp"
#include "lab/scene/scene.hpp"

#include <string>
#include <vector>

namespace glint::tune {

enum class ViewSet {
    Search, ///< what candidates are compared on
    Held,   ///< other places of the camera, other noise: what the search never sees
};

/// Frames of a moving view, and those of them that are measured: late ones, when histories have filled.
constexpr uint32_t kMovingFrames = 16;
constexpr uint32_t kMeasuredEvery = 4;
constexpr uint32_t kFirstMeasured = 7;

/// One camera, at rest or along a path.
struct TuneView {
    std::string name; ///< "builtin:hall", "builtin:hall pan", "builtin:hall held 1"
    scene::CameraMove move = scene::CameraMove::Still;
    scene::CameraPath path;
    uint32_t seed = 0;
};

/// The views of one scene and camera, a view for each path; held back: for each of them several places of the camera.
std::vector<TuneView> makeViews(ViewSet set, const render::RenderJob& job, const scene::Camera& camera,
                                const scene::Bounds& bounds, uint32_t height,
                                const std::vector<scene::CameraMove>& paths);

} // namespace glint::tune
