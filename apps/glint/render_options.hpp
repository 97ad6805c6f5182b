// The options of `glint render`, and the job that they ask for.
#pragma once

#include "base/result.hpp"
#include "render/render_job.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace glint::cli {

/// As they were written; makeRenderJob checks them.
struct RenderOptions {
    std::string scene;
    std::string output = "out.png";
    std::string camera;
    std::string environment;
    std::string probes;
    std::string planar = "none";
    std::string size;
    double time = 0;
    int64_t frames = 1;
    uint32_t seed = 0;
    std::vector<std::string> views;
    std::string statsFile;
    std::string device;
    bool validate = false;
    render::SettingsRequest settings;
};

void addRenderOptions(CLI::App& command, RenderOptions& options);
/// Those of a command that renders one picture: the scene and its options, size, frames, settings.
void addPictureOptions(CLI::App& command, RenderOptions& options);
/// Those of every command that renders a scene: camera, environment, time, seed, device.
void addSceneOptions(CLI::App& command, RenderOptions& options);
/// What reflections may be taken from besides the screen: probes, planar mirrors.
void addSourceOptions(CLI::App& command, RenderOptions& options);
/// What SCENE may be.
std::string sceneHelp();

/// "1280x720" into the job. Errors: InvalidArgument names the option.
Result<void> readSize(std::string_view option, const std::string& text, render::RenderJob& job);

/// Errors: NotFound if the folder that `file` is to be written to is not there.
Result<void> checkFolder(std::string_view option, const std::string& file);

/// The settings that are asked for, with what suits the scene under them.
render::SettingsRequest settingsRequest(const RenderOptions& options);

/// Without what is written: views, files, figures. Errors: InvalidArgument, InvalidInput or NotFound, each naming its
/// option.
Result<render::RenderJob> makePictureJob(const RenderOptions& options);

/// Errors: InvalidArgument, InvalidInput or NotFound, each naming its option. All that can be known before the scene is
/// read is checked here, so that a long job does not fail at its end for a misspelt name.
Result<render::RenderJob> makeRenderJob(const RenderOptions& options);

} // namespace glint::cli
