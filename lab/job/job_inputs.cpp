#include "lab/job/job_inputs.hpp"

#include "base/text.hpp"
#include "lab/scene/builtin/builtin.hpp"
#include "lab/scene/gltf/gltf.hpp"
#include "lab/scene/images/image_file.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace glint::render {
namespace {

constexpr std::string_view kBuiltinPrefix = "builtin:";
constexpr uint32_t kDefaultWidth = 1280, kDefaultHeight = 720; ///< pixels

bool isBuiltin(std::string_view scene) {
    return scene.starts_with(kBuiltinPrefix);
}

Result<scene::Scene> loadScene(const std::string& name) {
    if (isBuiltin(name))
        return scene::builtinScene(std::string_view(name).substr(kBuiltinPrefix.size()));
    return scene::readGltf(name);
}

Error unknownCamera(const std::string& asked, const std::vector<scene::Camera>& cameras) {
    std::vector<std::string> known;
    for (size_t i = 0; i < cameras.size(); ++i)
        known.push_back(fmt::format("{} '{}'", i, printable(cameras[i].name)));
    const std::string has = known.empty() ? "no cameras" : listText(known, " and ");
    return invalidArgument("--camera {}: no such camera and no such file; the scene has {}", printable(asked), has);
}

/// `aspectRatio`  of the image if its size is known, for the view of the whole scene if the scene has no camera
Result<scene::Camera> chooseCamera(const std::string& asked, const scene::Pose& pose, float aspectRatio) {
    if (asked.empty())
        return pose.cameras.empty() ? scene::frameBounds(pose.boundsWS, aspectRatio) : pose.cameras.front();
    const auto named = std::ranges::find(pose.cameras, asked, &scene::Camera::name);
    if (named != pose.cameras.end())
        return *named;
    size_t index = 0;
    const auto [end, error] = std::from_chars(asked.data(), asked.data() + asked.size(), index);
    if (error == std::errc() && end == asked.data() + asked.size() && index < pose.cameras.size())
        return pose.cameras[index];
    std::error_code ignored;
    if (std::filesystem::exists(asked, ignored))
        return scene::readCameraFile(asked);
    return unknownCamera(asked, pose.cameras);
}

/// Returns the environment that a built-in scene is made for; scenes from files get the sky.
std::string defaultEnvironment(std::string_view scene) {
    const scene::BuiltinInfo* const info =
        isBuiltin(scene) ? scene::findBuiltin(scene.substr(kBuiltinPrefix.size())) : nullptr;
    return info ? std::string(info->environment) : "sky";
}

/// Returns the file to read; empty: none.
std::string materialFile(const RenderJob& job) {
    if (!job.materials.empty())
        return job.materials == kNoMaterials ? std::string() : job.materials;
    const std::string beside = materialFileFor(job.scene);
    std::error_code ignored;
    return std::filesystem::is_regular_file(beside, ignored) ? beside : std::string();
}

Result<void> loadMaterials(const RenderJob& job, JobInputs& inputs) {
    inputs.fileMaterials = inputs.scene->materials;
    const std::string file = materialFile(job);
    if (file.empty())
        return {};
    GLINT_TRY(overrides, scene::readMaterialFile(file, *inputs.scene));
    GLINT_CHECK(scene::loadTextures(overrides, *inputs.scene));
    setMaterials(inputs, overrides);
    inputs.notes.push_back(fmt::format("{} of the scene's {} materials are from {}", overrides.size(),
                                       inputs.fileMaterials.size(), printable(file)));
    return {};
}

} // namespace

std::string materialFileFor(const std::string& scene) {
    return (isBuiltin(scene) ? scene.substr(kBuiltinPrefix.size()) : scene) + ".materials.json";
}

void setMaterials(JobInputs& inputs, const scene::MaterialOverrides& overrides) {
    inputs.overrides = overrides;
    inputs.scene->materials = inputs.fileMaterials;
    for (const auto& [index, override] : overrides)
        inputs.scene->materials[index] = scene::overridden(inputs.fileMaterials[index], override);
}

Result<void> loadEnvironment(const std::string& environment, JobInputs& inputs) {
    if (environment == "sky") {
        inputs.environment = EnvironmentKind::Sky;
    } else if (environment != "none") {
        GLINT_TRY(image, scene::readHdrImage(environment));
        inputs.environment = EnvironmentKind::Image;
        inputs.environmentImage = std::move(image);
    }
    return {};
}

Result<JobInputs> loadJobInputs(const RenderJob& job) {
    JobInputs inputs;
    Result<scene::Scene> scene = loadScene(job.scene);
    if (!scene) // a file with a required extension that Glint does not support is bad input, not a run-time failure
        return Error{scene.error().code == ErrorCode::Unsupported ? ErrorCode::InvalidInput : scene.error().code,
                     scene.error().message};
    inputs.scene = std::make_unique<scene::Scene>(std::move(scene).value());
    GLINT_CHECK(loadMaterials(job, inputs));
    GLINT_TRY(pose, scene::pose(*inputs.scene, job.time));
    inputs.pose = std::move(pose);

    inputs.width = job.width > 0 ? job.width : kDefaultWidth;
    inputs.height = job.height > 0 ? job.height : kDefaultHeight;
    const float aspectRatio = static_cast<float>(inputs.width) / static_cast<float>(inputs.height);
    GLINT_TRY(camera, chooseCamera(job.camera, inputs.pose, aspectRatio));
    inputs.camera = std::move(camera);
    if (job.width == 0 && inputs.camera.width > 0 && inputs.camera.height > 0) {
        inputs.width = static_cast<uint32_t>(inputs.camera.width);
        inputs.height = static_cast<uint32_t>(inputs.camera.height);
    }

    GLINT_CHECK(loadEnvironment(job.environment.empty() ? defaultEnvironment(job.scene) : job.environment, inputs));
    return inputs;
}

} // namespace glint::render
