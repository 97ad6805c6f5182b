#include "lab/cli/render/render_options.hpp"

#include "base/text.hpp"
#include "lab/cli/render/render_output.hpp"
#include "lab/scene/builtin/builtin.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/session/frame_mean.hpp"
#include "lab/session/settled_frames.hpp"
#include "lab/session/views.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace glint::cli {
namespace {

constexpr std::string_view kBuiltinPrefix = "builtin:";
constexpr int64_t kMaxFrames = 1000000;

std::string viewNames() {
    std::vector<std::string> names;
    for (const render::ViewInfo& view : render::viewList())
        names.emplace_back(view.name);
    return joinText(names, ", ");
}

std::string presetList() {
    const auto names = presetNames();
    return joinText(std::vector<std::string>(names.begin(), names.end()), ", ");
}

std::string sceneList() {
    std::vector<std::string> names;
    for (const scene::BuiltinInfo& info : scene::builtinScenes())
        names.push_back(info.largest == 1
                            ? fmt::format("{}{}", kBuiltinPrefix, info.name)
                            : fmt::format("{0}{1} ({0}{1}-2 to {0}{1}-{2})", kBuiltinPrefix, info.name, info.largest));
    return joinText(names, ", ");
}

/// An EXR file always has the frame itself as its main layer; PNG files show only the requested views.
Result<std::vector<std::string>> chooseViews(const RenderOptions& options, PictureKind kind) {
    std::vector<std::string> views;
    if (kind == PictureKind::Exr || options.views.empty())
        views.emplace_back(render::viewList().front().name);
    for (const std::string& name : options.views) {
        auto view = render::findView(name);
        if (!view)
            return makeError(view.error().code, "--view: {}", view.error().message);
        if (std::ranges::find(views, name) == views.end())
            views.push_back(name);
    }
    return views;
}

/// Settings of a built-in scene that override the table's defaults.
std::vector<std::string> sceneDefaults(std::string_view scene) {
    if (!scene.starts_with(kBuiltinPrefix))
        return {};
    if (const scene::BuiltinInfo* const info = scene::findBuiltin(scene.substr(kBuiltinPrefix.size())))
        return {fmt::format("environment.strength={}", info->environmentStrength)};
    return {};
}

Result<render::MirrorSearch> mirrorSearch(const std::string& text) {
    const auto found = std::ranges::find(render::kMirrorSearchNames, text);
    if (found != render::kMirrorSearchNames.end())
        return static_cast<render::MirrorSearch>(found - render::kMirrorSearchNames.begin());
    return invalidArgument("--planar {}: none, named or auto", printable(text));
}

} // namespace

Result<void> readSize(std::string_view option, const std::string& text, render::RenderJob& job) {
    const char* const end = text.data() + text.size();
    uint64_t width = 0, height = 0;
    const auto [x, widthError] = std::from_chars(text.data(), end, width);
    if (widthError != std::errc() || x == end || *x != 'x')
        return invalidArgument("{} {}: expected WIDTHxHEIGHT, as in 1280x720", option, printable(text));
    const auto [rest, heightError] = std::from_chars(x + 1, end, height);
    if (heightError != std::errc() || rest != end)
        return invalidArgument("{} {}: expected WIDTHxHEIGHT, as in 1280x720", option, printable(text));
    const uint64_t largest = scene::kMaxImageSide;
    if (width < 1 || height < 1 || width > largest || height > largest)
        return invalidArgument("{} {}: each side must be 1 to {} pixels", option, printable(text), largest);
    job.width = static_cast<uint32_t>(width);
    job.height = static_cast<uint32_t>(height);
    return {};
}

Result<void> checkFolder(std::string_view option, const std::string& file) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    std::error_code error;
    if (folder.empty() || std::filesystem::is_directory(folder, error))
        return {};
    return makeError(ErrorCode::NotFound, "{} {}: there is no folder {}", option, printable(file), folder.string());
}

void addSceneOptions(CLI::App& command, RenderOptions& options) {
    command.add_option("--camera", options.camera, "Camera: a file, a name in the scene or an index");
    command.add_option("--env", options.environment, "Environment: an .hdr or .exr file, sky or none");
    command.add_option("--materials", options.materials,
                       "Material overrides: a JSON file, or none (default: SCENE.materials.json, if there is one)");
    command.add_option("--time", options.time, "Seconds into the scene's animations")->capture_default_str();
    addDeviceOptions(command, options);
}

void addDeviceOptions(CLI::App& command, RenderOptions& options) {
    command.add_option("--seed", options.seed, "Seed of the rays' noise")->capture_default_str();
    command.add_option("--device", options.device, "Part of a device's name, or an index (glint devices)");
    command.add_flag("--validate", options.validate, "Fail on any message of the Vulkan validation layer");
}

std::string sceneHelp() {
    return "A .gltf or .glb file, or " + sceneList();
}

void addSourceOptions(CLI::App& command, RenderOptions& options) {
    command.add_option("--probes", options.probes,
                       "Reflection probes: a file of glint bake, or auto: the file beside the scene, else baked now");
    command
        .add_option(
            "--planar", options.planar,
            "Planar mirrors: none, named (by the scene's materials), or auto: what is flat, smooth and large too")
        ->capture_default_str();
}

void addPictureOptions(CLI::App& command, RenderOptions& options) {
    command.add_option("SCENE", options.scene, sceneHelp())->required();
    addSceneOptions(command, options);
    addSourceOptions(command, options);
    command.add_option("--size", options.size, "Picture size, WIDTHxHEIGHT (default: the camera's, or 1280x720)");
    addFrameOptions(command, options);
}

void addFrameOptions(CLI::App& command, RenderOptions& options) {
    command.add_option(
        "--frames", options.frames,
        "Frames to render; the last one counts, or with display.antialias accumulate the mean of the last "
        "16 (default: until the picture has settled, as the settings ask)");
    command.add_option("--preset", options.settings.preset, "Settings to start from: " + presetList());
    command.add_option("--settings", options.settings.file, "Settings file (JSON), stronger than the preset");
    command.add_option("--set", options.settings.assignments, "KEY=VALUE, strongest; may be repeated (glint settings)")
        ->allow_extra_args(false);
}

void addRenderOptions(CLI::App& command, RenderOptions& options) {
    addPictureOptions(command, options);
    command.add_option("--settle", options.settle,
                       "Stop before --frames once n frames differ from half as many by at most this: root mean square, "
                       "in levels of 255 (0: render all)");
    addOutputOptions(command, options);
}

void addOutputOptions(CLI::App& command, RenderOptions& options) {
    command
        .add_option("-o,--output", options.output,
                    "Picture to write: .png (tone-mapped) or .exr (linear, layers); - is standard output, as PNG")
        ->capture_default_str();
    command
        .add_option("--view", options.views,
                    "What to show, several parted by commas: " + viewNames() +
                        "; or an image that a pass wrote, as trace/hiz:radianceWeight")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--stats", options.statsFile, "Write times, lookups and outcomes as JSON; - is standard output");
}

render::SettingsRequest settingsRequest(const RenderOptions& options) {
    render::SettingsRequest request = options.settings;
    request.defaults = sceneDefaults(options.scene);
    return request;
}

Result<render::RenderJob> makePictureJob(const RenderOptions& options) {
    render::RenderJob job;
    job.scene = options.scene;
    job.camera = options.camera;
    job.environment = options.environment;
    job.materials = options.materials;
    job.probes = options.probes;
    GLINT_TRY(planar, mirrorSearch(options.planar));
    job.planar = planar;
    job.device = options.device;
    job.validate = options.validate;
    job.seed = options.seed;
    if (!options.size.empty())
        GLINT_CHECK(readSize("--size", options.size, job));
    if (!std::isfinite(options.time))
        return invalidArgument("--time {}: expected a number of seconds", options.time);
    job.time = options.time;
    if (options.frames && (*options.frames < 1 || *options.frames > kMaxFrames))
        return invalidArgument("--frames {}: expected 1 to {}", *options.frames, kMaxFrames);
    GLINT_TRY(settings, render::loadSettings(settingsRequest(options)));
    job.settings = std::move(settings);
    const Settings& reflections = job.settings.reflections;
    job.frames = options.frames       ? static_cast<uint32_t>(*options.frames)
                 : options.settle > 0 ? render::mostSettlingFrames(reflections)
                                      : render::settledFrames(reflections);
    job.stillFrames = static_cast<uint32_t>(options.frames.value_or(0));
    if (!(options.settle >= 0 && options.settle <= 255))
        return invalidArgument("--settle {}: expected 0 to 255 levels", options.settle);
    job.settle = options.settle;
    return job;
}

Result<render::RenderJob> makeRenderJob(const RenderOptions& options) {
    GLINT_TRY(job, makePictureJob(options));
    GLINT_TRY(kind, pictureKind(options.output));
    GLINT_CHECK(checkFolder("-o", options.output));
    job.display = kind == PictureKind::Png;
    GLINT_TRY(views, chooseViews(options, kind));
    job.views = std::move(views);
    if (!options.statsFile.empty()) {
        GLINT_CHECK(checkFolder("--stats", options.statsFile));
        job.statistics = true;
    }
    return job;
}

void lookAt(render::RenderJob& job, const RenderOptions& options) {
    const render::MeasureSettings& measured = job.settings.render.measure;
    job.smoothStill = job.display && job.views == std::vector<std::string>{"composite"} && options.statsFile.empty() &&
                      !measured.exact && !measured.hits;
    if (!options.frames && render::accumulates(job))
        job.frames = std::max(job.frames, render::kSmoothFrames);
}

} // namespace glint::cli
