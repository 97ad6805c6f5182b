// glint sequence: a scene along a camera path, as frames and as figures.
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/compare/reference_bounces.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/file_roles.hpp"
#include "lab/cli/frames_option.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/cli/sequence/feed_files.hpp"
#include "lab/cli/sequence/motion_option.hpp"
#include "lab/cli/sequence/sequence_files.hpp"
#include "lab/cli/sequence/sequence_output.hpp"
#include "lab/measure/motion/sequence.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

namespace glint::cli {
namespace {

constexpr int64_t kMostFrames = 10000;
constexpr int64_t kMostSamples = 1 << 20;

struct SequenceOptions {
    RenderOptions scene;
    std::vector<std::string> configs;
    int64_t frames = 96;
    std::string path = "still";
    double speed = 2;
    int64_t stop = -1; ///< -1: never
    double fps = 60;
    std::string output;
    std::string dump;             ///< folder; empty: none
    int64_t referenceSamples = 0; ///< 0: no reference
    std::string reference = "reference";
    int64_t warmUp = -1; ///< -1: chosen by warmUpFrames
    std::string json;

    /// Figures cost a second rendering, so frames alone do without.
    bool measures() const {
        return (output.empty() && dump.empty()) || !json.empty() || referenceSamples > 0 ||
               std::ranges::any_of(configs, namesFrames);
    }
};

Result<measure::SequencePath> sequencePath(const SequenceOptions& options) {
    GLINT_TRY(path, readPath(options.path));
    path.pixelsPerFrame = options.speed;
    if (options.stop >= 0)
        path.stop = static_cast<uint32_t>(options.stop);
    return path;
}

Result<void> checkNumbers(const SequenceOptions& options) {
    if (options.frames < 1 || options.frames > kMostFrames)
        return invalidArgument("--frames {}: expected 1 to {}", options.frames, kMostFrames);
    if (!(options.fps >= 1 && options.fps <= 1000))
        return invalidArgument("--fps {}: expected 1 to 1000", options.fps);
    if (!(std::abs(options.speed) <= 1000))
        return invalidArgument("--speed {}: expected at most 1000 pixels per frame", options.speed);
    if (options.stop < -1 || options.stop > kMostFrames)
        return invalidArgument("--stop {}: expected 0 to {}", options.stop, kMostFrames);
    if (options.referenceSamples < 0 || options.referenceSamples > kMostSamples)
        return invalidArgument("--reference-samples {}: expected 1 to {}, or 0 for no reference",
                               options.referenceSamples, kMostSamples);
    if (options.warmUp < -1 || options.warmUp >= options.frames)
        return invalidArgument("--warm-up {}: expected 0 to {}, less than --frames", options.warmUp,
                               options.frames - 1);
    if (!options.json.empty() && options.json != "-")
        GLINT_CHECK(checkFolder("--json", options.json));
    return {};
}

/// A quarter of the frames, at most 32.
uint32_t warmUpFrames(const SequenceOptions& options) {
    const int64_t frames = options.warmUp >= 0 ? options.warmUp : std::min<int64_t>(options.frames / 4, 32);
    return static_cast<uint32_t>(frames);
}

/// Without --config, the settings of --preset, --settings and --set are the only configuration.
Result<std::vector<measure::ComparedConfig>> sequenceConfigs(const SequenceOptions& options) {
    std::vector<measure::ComparedConfig> configs;
    RenderOptions scene = options.scene;
    scene.frames = 1; // of each picture
    if (options.configs.empty()) {
        GLINT_TRY(job, makeRenderJob(scene));
        std::string name = job.settings.preset;
        configs.push_back({std::move(name), std::move(job)});
    }
    for (const std::string& text : options.configs) {
        // Frames from files have no settings: those of the preset `balanced` draw the surfaces.
        GLINT_TRY(job, namesFrames(text) ? makeRenderJob(scene) : makeConfigJob(scene, scene.scene, text));
        configs.push_back({text, std::move(job)});
    }
    return configs;
}

/// The configs whose frames are files, by index.
Result<std::map<size_t, measure::StoredFrames>> sequenceStored(const SequenceOptions& options) {
    std::map<size_t, measure::StoredFrames> stored;
    for (size_t i = 0; i < options.configs.size(); ++i) {
        const std::string& text = options.configs[i];
        if (!namesFrames(text))
            continue;
        GLINT_TRY(frames, openFrames(text, static_cast<uint32_t>(options.frames)));
        if (frames.seeds() == 1 && options.referenceSamples == 0)
            return invalidArgument("--config {}: frames of one seed have no figures without a reference: state "
                                   "--reference-samples, or {}A/%04d.exr:B/%04d.exr with two seeds",
                                   printable(text), kFramesPrefix);
        stored.emplace(i, std::move(frames));
    }
    return stored;
}

Result<std::optional<measure::ComparedConfig>> sequenceReference(const SequenceOptions& options,
                                                                 std::span<const measure::ComparedConfig> configs) {
    if (options.referenceSamples == 0)
        return std::optional<measure::ComparedConfig>();
    GLINT_TRY(reference, motionReference(options.scene, options.reference, options.referenceSamples));
    followAsManyBounces(reference, configs);
    return std::optional<measure::ComparedConfig>(std::move(reference));
}

/// The feed of --dump, and the views that it needs.
Result<std::optional<FeedFiles>> sequenceFeed(const SequenceOptions& options, measure::SequencePlan& plan) {
    if (options.dump.empty())
        return std::optional<FeedFiles>();
    GLINT_TRY(feed, FeedFiles::create(options.dump, plan));
    plan.views = measure::feedViews(plan.configs.front().job.settings.reflections);
    return std::optional<FeedFiles>(std::move(feed));
}

/// Writes the frames of a sequence as they come.
class FrameFiles {
public:
    /// `configs`: names; each of several has a folder of its own. Configs in `stored` are files already. Errors:
    /// NotFound if there is no folder for the frames' own.
    static Result<FrameFiles> create(const std::string& output, const std::vector<measure::ComparedConfig>& configs,
                                     const std::map<size_t, measure::StoredFrames>& stored) {
        FrameFiles files;
        if (output.empty())
            return files;
        GLINT_TRY(pattern, FramePattern::parse(output));
        GLINT_CHECK(checkFolder("-o", pattern.folder()));
        for (size_t i = 0; i < configs.size(); ++i)
            if (!stored.contains(i))
                files.patterns_.emplace(i, configs.size() == 1 ? pattern
                                                               : pattern.inFolder(configFileName(i, configs[i].name)));
        return files;
    }

    Result<void> makeFolders() const {
        for (const auto& [config, pattern] : patterns_) {
            std::error_code error;
            if (!pattern.folder().empty())
                std::filesystem::create_directories(pattern.folder(), error);
            if (error)
                return makeError(ErrorCode::Io, "-o {}: {}", printable(pattern.folder()), error.message());
        }
        return {};
    }

    void addPaths(uint32_t frames, std::vector<NamedFile>& files) const {
        for (const auto& [config, pattern] : patterns_)
            for (uint32_t frame = 0; frame < frames; ++frame)
                files.push_back({"-o", pattern.path(frame)});
    }

    Result<void> write(const measure::SequenceFrame& frame) const {
        if (patterns_.empty())
            return {};
        const FramePattern& pattern = patterns_.at(frame.config);
        return writeFrame(pattern.path(frame.index), pattern.kind(), frame);
    }

    /// A missing ffmpeg is not an error: the frames are the result, the video a convenience.
    void makeVideos(double fps) const {
        for (const auto& [config, pattern] : patterns_) {
            if (pattern.kind() != PictureKind::Png)
                continue;
            const auto made = writeVideo(pattern, fps);
            if (!made && made.error().code == ErrorCode::NotFound)
                log::warning("no video: ffmpeg is not installed; the frames are complete");
            else if (!made)
                log::warning("no video: {}", made.error().message);
        }
    }

private:
    std::map<size_t, FramePattern> patterns_; ///< by index of the config
};

Result<void> checkFiles(const SequenceOptions& options, const FrameFiles& frames) {
    std::vector<NamedFile> inputs = inputFiles(options.scene);
    inputs.push_back({"--path", options.path});
    addConfigFiles(options.configs, inputs);
    addConfigFiles({options.reference}, inputs);
    std::vector<NamedFile> outputs = {{"--json", options.json}};
    frames.addPaths(static_cast<uint32_t>(options.frames), outputs);
    return checkOutputs(inputs, outputs);
}

void showSequenceProgress(const std::string& what, uint32_t done, uint32_t frames) {
    if (isatty(fileno(stderr)))
        fmt::print(stderr, "\r{}: frame {} of {}{}", printable(what), done, frames, done == frames ? "\n" : "");
}

Result<void> runSequence(const SequenceOptions& options) {
    GLINT_CHECK(checkNumbers(options));
    GLINT_TRY(path, sequencePath(options));
    measure::SequencePlan plan;
    plan.path = std::move(path);
    plan.frames = static_cast<uint32_t>(options.frames);
    plan.fps = options.fps;
    GLINT_TRY(configs, sequenceConfigs(options));
    plan.configs = std::move(configs);
    plan.measure = options.measures();
    plan.warmUp = warmUpFrames(options);
    GLINT_TRY(reference, sequenceReference(options, plan.configs));
    plan.reference = std::move(reference);
    GLINT_TRY(stored, sequenceStored(options));
    plan.stored = std::move(stored);
    GLINT_TRY(feed, sequenceFeed(options, plan));
    GLINT_TRY(files, FrameFiles::create(options.output, plan.configs, plan.stored));
    GLINT_CHECK(checkFiles(options, files));
    GLINT_CHECK(files.makeFolders());
    if (feed)
        GLINT_CHECK(feed->makeFolders());
    measure::SequenceCallbacks callbacks;
    callbacks.frame = [&](const measure::SequenceFrame& frame) { return files.write(frame); };
    if (feed)
        callbacks.views = [&](const measure::SequenceViews& views) { return feed->write(views); };
    callbacks.progress = showSequenceProgress;
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    GLINT_TRY(sequence, measure::renderSequence(*context, plan, callbacks));
    if (!context->validationMessages().empty())
        return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                         context->validationMessages().size(), context->validationMessages().front());
    if (feed)
        GLINT_CHECK(feed->writeDescriptions(sequence));
    files.makeVideos(options.fps);
    if (!plan.measure) {
        for (const measure::SequenceConfig& config : sequence.configs)
            for (const std::string& note : config.notes)
                log::warning("{}: {}", config.name, note);
        return {};
    }
    const std::string text = options.json == "-" ? sequenceJson(sequence) : sequenceText(sequence);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return options.json.empty() || options.json == "-" ? Result<void>()
                                                       : writeFile(options.json, sequenceJson(sequence));
}

} // namespace

void addSequenceCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<SequenceOptions>();
    CLI::App* const command = program.add_subcommand("sequence", "Render and measure moving pictures");
    command->add_option("SCENE", options->scene.scene, sceneHelp())->required();
    command->add_option("--path", options->path, pathHelp())->capture_default_str();
    command
        ->add_option("--speed", options->speed,
                     "Pixels per frame by which a movement shifts what is at the centre of the scene")
        ->capture_default_str();
    command->add_option("--stop", options->stop, "The camera stands still from this frame on");
    command->add_option("--frames", options->frames, "Frames to render")->capture_default_str();
    command->add_option("--fps", options->fps, "Frames per second of the scene's clock")->capture_default_str();
    CLI::Option* const config =
        command->add_option("--config", options->configs, fmt::format("{}; or {}", kConfigHelp, kFramesHelp))
            ->allow_extra_args(false);
    addSceneOptions(*command, options->scene);
    addSourceOptions(*command, options->scene);
    command->add_option("--size", options->scene.size,
                        "Picture size, WIDTHxHEIGHT (default: the camera's, or 1280x720)");
    command->add_option("--preset", options->scene.settings.preset, "Settings of the only config")->excludes(config);
    command->add_option("--settings", options->scene.settings.file, "Settings file (JSON) of the only config")
        ->excludes(config);
    command->add_option("--set", options->scene.settings.assignments, "KEY=VALUE for every config, weaker than its own")
        ->allow_extra_args(false);
    command->add_option("--reference-samples", options->referenceSamples,
                        "Measure against a reference with so many samples per pixel, frame and seed (64 suffice)");
    command->add_option("--reference", options->reference, "Settings of the reference, as for --config")
        ->capture_default_str();
    command->add_option("--warm-up", options->warmUp,
                        "First frames that count for no mean (default: a quarter, at most 32)");
    command->add_option("--json", options->json, "Write the figures as JSON; - prints them instead of the text");
    command->add_option("-o,--output", options->output,
                        "Frames to write, as DIR/frame_%04d.png (and a video, with ffmpeg) or .exr; several configs "
                        "have a folder each");
    command->add_option("--dump", options->dump,
                        "Folder for what a denoiser reads of every frame: DIR/seed-N/0000.exr and so on, and "
                        "sequence.json; of the only config, with both seeds if there are figures");
    command->callback([&chosen, options] { chosen = [options] { return runSequence(*options); }; });
}

} // namespace glint::cli
