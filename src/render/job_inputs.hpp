// What a job's words stand for: the scene at its moment, the camera, the picture's size, the environment.
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
    std::unique_ptr<scene::Scene> scene; ///< stays where it is: `pose` refers into it
    scene::Pose pose;
    scene::Camera camera;
    uint32_t width = 0;
    uint32_t height = 0;
    EnvironmentKind environment = EnvironmentKind::None;
    scene::HdrImage environmentImage; ///< of EnvironmentKind::Image
};

/// Reads the scene and the environment and finds the camera: a name in the scene, else an index, else a file.
/// Errors: as the readers give them; InvalidArgument lists the cameras of the scene.
Result<JobInputs> loadJobInputs(const RenderJob& job);

} // namespace glint::render
