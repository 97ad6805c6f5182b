// The inputs that a job names: the posed scene, the camera, the image size, the environment.
#pragma once

#include "base/result.hpp"
#include "render/render_job.hpp"
#include "scene/camera.hpp"
#include "scene/hdr_image.hpp"
#include "scene/pose.hpp"
#include "scene/scene.hpp"

#include <memory>

namespace glint::render {

enum class EnvironmentKind { None, Sky, Image };

struct JobInputs {
    std::unique_ptr<scene::Scene> scene; ///< has a stable address, as `pose` refers to it
    scene::Pose pose;
    scene::Camera camera;
    uint32_t width = 0;
    uint32_t height = 0;
    EnvironmentKind environment = EnvironmentKind::None;
    scene::HdrImage environmentImage; ///< for EnvironmentKind::Image
};

/// Reads the scene and the environment and resolves the camera: a name in the scene, then an index, then a file.
/// Errors: those of the readers; InvalidArgument lists the cameras of the scene.
Result<JobInputs> loadJobInputs(const RenderJob& job);

} // namespace glint::render
