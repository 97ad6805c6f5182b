// The inputs that a job names: the posed scene, the camera, the image size, the environment.
#pragma once

#include "base/result.hpp"
#include "lab/job/render_job.hpp"
#include "lab/scene/camera.hpp"
#include "lab/scene/images/hdr_image.hpp"
#include "lab/scene/material_overrides.hpp"
#include "lab/scene/pose.hpp"
#include "lab/scene/scene.hpp"

#include <memory>
#include <string_view>

namespace glint::render {

/// RenderJob::materials: no file of material overrides.
inline constexpr std::string_view kNoMaterials = "none";

enum class EnvironmentKind { None, Sky, Image };

struct JobInputs {
    std::unique_ptr<scene::Scene> scene;        ///< has a stable address, as `pose` refers to it
    std::vector<scene::Material> fileMaterials; ///< of the scene's file, without `overrides`
    scene::MaterialOverrides overrides;         ///< already applied to `scene`
    scene::Pose pose;
    scene::Camera camera;
    uint32_t width = 0;
    uint32_t height = 0;
    EnvironmentKind environment = EnvironmentKind::None;
    scene::HdrImage environmentImage; ///< for EnvironmentKind::Image
    std::vector<std::string> notes;   ///< notes for the user
};

/// Returns the name of the file of material overrides that belongs to a scene: "room.glb.materials.json"; for built-in
/// scenes a file in the current folder.
std::string materialFileFor(const std::string& scene);

/// Applies `overrides` to the materials of the scene's file.
void setMaterials(JobInputs& inputs, const scene::MaterialOverrides& overrides);

/// `environment`: an .hdr or .exr path, "sky" or "none". Errors: as scene::readHdrImage.
Result<void> loadEnvironment(const std::string& environment, JobInputs& inputs);

/// Reads the scene, its material overrides and the environment and resolves the camera: a name in the scene, then an
/// index, then a file. Errors: those of the readers; InvalidArgument lists the cameras of the scene.
Result<JobInputs> loadJobInputs(const RenderJob& job);

} // namespace glint::render
