// The options of `glint render`, and the job that they describe.
#pragma once

#include "base/result.hpp"
#include "lab/job/render_job.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

/// The options as the user wrote them; makeRenderJob checks them.
struct RenderOptions {
    std::string scene;
    std::string output = "out.png";
    std::string camera;
    std::string environment;
    std::string materials;
    std::string probes;
    std::string planar = "none";
    std::string size;
    double time = 0;
    std::optional<int64_t> frames; ///< default: render::settledFrames
    double settle = 0;             ///< RenderJob::settle
    uint32_t seed = 0;
    std::vector<std::string> views;
    std::string statsFile;
    std::string device;
    bool validate = false;
    render::SettingsRequest settings;
};

void addRenderOptions(CLI::App& command, RenderOptions& options);
/// Adds the options of a command that renders one image: the scene and its options, size, frames, settings.
void addPictureOptions(CLI::App& command, RenderOptions& options);
/// Adds the options of every command that renders a scene: camera, environment, time, seed, device.
void addSceneOptions(CLI::App& command, RenderOptions& options);
/// Adds the options of reflection sources besides the screen: probes, planar mirrors.
void addSourceOptions(CLI::App& command, RenderOptions& options);
// Parts of the above, for commands without a scene.
/// Adds seed, device and validation.
void addDeviceOptions(CLI::App& command, RenderOptions& options);
/// Adds frames and settings.
void addFrameOptions(CLI::App& command, RenderOptions& options);
/// Adds output, views and statistics.
void addOutputOptions(CLI::App& command, RenderOptions& options);

/// Returns the help text of the SCENE argument.
std::string sceneHelp();

/// Parses "1280x720" into the job. Errors: InvalidArgument names the option.
Result<void> readSize(std::string_view option, const std::string& text, render::RenderJob& job);

/// Errors: NotFound if the folder of the output file `file` does not exist.
Result<void> checkFolder(std::string_view option, const std::string& file);

/// Returns the requested settings, with the scene's defaults below them.
render::SettingsRequest settingsRequest(const RenderOptions& options);

/// Without outputs: views, files, figures. Errors: InvalidArgument, InvalidInput or NotFound, each naming its option.
Result<render::RenderJob> makePictureJob(const RenderOptions& options);

/// Checks everything that can be checked before the scene is read, so that a long job does not fail at its end because
/// of a misspelt name. Errors: InvalidArgument, InvalidInput or NotFound, each naming its option.
Result<render::RenderJob> makeRenderJob(const RenderOptions& options);
/// For an image that people look at: a PNG of the composite alone, of which nothing is measured, is antialiased if
/// display.antialias is auto. With accumulate, too, the job renders enough frames unless the options say how many.
void lookAt(render::RenderJob& job, const RenderOptions& options);

} // namespace glint::cli
