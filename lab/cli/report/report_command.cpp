// glint report: measures scenes with several settings and writes one page; compares the figures with earlier ones.
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "lab/cli/command_text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/compare/reference_bounces.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/cli/report/report_figures.hpp"
#include "lab/cli/report/report_gallery.hpp"
#include "lab/cli/report/report_json.hpp"
#include "lab/cli/report/report_page.hpp"
#include "lab/cli/sequence/motion_option.hpp"
#include "lab/cli/tune/curve_file.hpp"
#include "lab/scene/images/webp_writer.hpp"
#include "lab/session/run_job.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

constexpr float kFrameQuality = 82; ///< of frames in motion: they are looked at in passing
constexpr uint32_t kMostShownFrames = 48;

struct ReportOptions {
    RenderOptions scene;
    std::vector<std::string> scenes;
    std::vector<std::string> configs = {"balanced", "real-time"};
    std::string output = "report.html";
    std::string json;
    std::string reference = "reference";
    int64_t referenceFrames = 4;
    int64_t frames = 5;
    int64_t seeds = 2;
    std::string path = "pan";
    int64_t motionFrames = 24;
    std::string motionSize;
    int64_t motionSamples = 16;
    std::string pictures;
    std::string picturesSize;
    std::string curve;
    std::string against;
    double threshold = 5;
    double timeThreshold = 20;
    std::string command; ///< as the user wrote it
};

/// What is rendered of one scene.
struct ScenePlan {
    std::vector<measure::ComparedConfig> configs;
    std::optional<measure::ComparedConfig> reference;
    std::optional<measure::SequencePlan> motion;
};

Result<void> checkRange(std::string_view option, int64_t value, int64_t least, int64_t most) {
    if (value < least || value > most)
        return invalidArgument("{} {}: expected {} to {}", option, value, least, most);
    return {};
}

Result<void> checkOptions(const ReportOptions& options) {
    GLINT_CHECK(checkRange("--frames", options.frames, 1, 10000));
    GLINT_CHECK(checkRange("--seeds", options.seeds, 2, 64));
    GLINT_CHECK(checkRange("--reference-frames", options.referenceFrames, 1, 100000));
    GLINT_CHECK(checkRange("--motion-frames", options.motionFrames, 0, 10000));
    GLINT_CHECK(checkRange("--motion-samples", options.motionSamples, 0, 1 << 20));
    if (options.motionFrames == 1)
        return invalidArgument("--motion-frames 1: nothing moves in one frame; 0 leaves motion out");
    for (const auto& [option, value] :
         {std::pair("--threshold", options.threshold), std::pair("--time-threshold", options.timeThreshold)})
        if (!(value >= 0 && value <= 1e6))
            return invalidArgument("{} {:g}: expected 0 to 1e6 percent", option, value);
    if (!options.output.ends_with(".html"))
        return invalidArgument("-o {}: the name must end in .html", printable(options.output));
    GLINT_CHECK(checkFolder("-o", options.output));
    if (!options.picturesSize.empty()) {
        render::RenderJob job;
        GLINT_CHECK(readSize("--pictures-size", options.picturesSize, job));
    }
    if (!options.json.empty() && options.json != "-")
        GLINT_CHECK(checkFolder("--json", options.json));
    return {};
}

/// The options of a scene's pictures.
RenderOptions sceneOptions(const ReportOptions& options, const std::string& scene) {
    RenderOptions one = options.scene;
    one.scene = scene;
    return one;
}

bool hasReference(const ReportOptions& options) {
    return options.reference != "none";
}

/// The seeds of reference and configs differ, so that their noise does.
uint32_t referenceSeed(const ReportOptions& options) {
    return options.scene.seed + static_cast<uint32_t>(options.seeds);
}

/// The size of --motion-size, else half of the pictures', which loadJobInputs knows once the scene is read.
Result<measure::SequencePlan> makeMotion(const ReportOptions& options, const RenderOptions& scene) {
    measure::SequencePlan plan;
    GLINT_TRY(path, readPath(options.path));
    plan.path = std::move(path);
    plan.frames = static_cast<uint32_t>(options.motionFrames);
    plan.measure = true;
    plan.warmUp = plan.frames / 4;
    RenderOptions moving = scene;
    moving.size = options.motionSize;
    for (const std::string& text : options.configs) {
        GLINT_TRY(job, makeConfigJob(moving, moving.scene, text));
        plan.configs.push_back({text, std::move(job)});
    }
    if (hasReference(options) && options.motionSamples > 0) {
        GLINT_TRY(reference, motionReference(moving, options.reference, options.motionSamples));
        followAsManyBounces(reference, plan.configs);
        plan.reference = std::move(reference);
    }
    return plan;
}

/// Checks all that can be checked before the scene is read.
Result<ScenePlan> makePlan(const ReportOptions& options, const std::string& name) {
    const RenderOptions scene = sceneOptions(options, name);
    ScenePlan plan;
    for (const std::string& text : options.configs) {
        GLINT_TRY(job, makeConfigJob(scene, name, text));
        plan.configs.push_back({text, std::move(job)});
    }
    if (hasReference(options)) {
        GLINT_TRY(job, makeConfigJob(scene, name, options.reference));
        const bool accumulates = job.settings.reflections.rays.enabled && job.settings.reflections.rays.accumulate;
        job.frames = accumulates ? static_cast<uint32_t>(options.referenceFrames) : 1;
        job.seed = referenceSeed(options);
        plan.reference = measure::ComparedConfig{options.reference, std::move(job)};
        followAsManyBounces(*plan.reference, plan.configs);
    }
    if (options.motionFrames > 0) {
        GLINT_TRY(motion, makeMotion(options, scene));
        plan.motion = std::move(motion);
    }
    return plan;
}

/// What the figures depend on besides scenes, sizes that these say, and configs. Seeds and timed frames only change the
/// noise, which is known.
nlohmann::ordered_json watchedOptions(const ReportOptions& options, const ScenePlan& plan) {
    const RenderOptions& scene = options.scene;
    nlohmann::ordered_json json = {{"--camera", scene.camera},
                                   {"--env", scene.environment},
                                   {"--materials", scene.materials},
                                   {"--probes", scene.probes},
                                   {"--planar", scene.planar},
                                   {"--time", fmt::format("{}", scene.time)},
                                   {"--size", scene.size},
                                   {"--set", joinText(scene.settings.assignments, " ")},
                                   {"--reference", plan.reference ? plan.reference->name : options.reference}};
    if (hasReference(options))
        json["--reference-frames"] = std::to_string(options.referenceFrames);
    json["--motion-frames"] = std::to_string(options.motionFrames);
    if (options.motionFrames > 0) {
        json["--path"] = options.path;
        json["--motion-size"] = options.motionSize;
        json["--motion-samples"] = std::to_string(options.motionSamples);
    }
    return json;
}

void showStep(const std::string& step) {
    if (isatty(fileno(stderr)))
        fmt::print(stderr, "measuring {}\n", printable(step));
}

/// Renders the moving pictures at half of the scene's size, unless a size was asked for, and keeps those to show.
Result<void> addMotion(gpu::Context& context, const ReportOptions& options, measure::SequencePlan plan,
                       ReportScene& scene) {
    const auto half = [](uint32_t side) { return std::max(1u, side / 2); };
    const bool sized = !options.motionSize.empty();
    const auto resize = [&](render::RenderJob& job) {
        job.width = sized ? job.width : half(scene.comparison.width);
        job.height = sized ? job.height : half(scene.comparison.height);
    };
    for (measure::ComparedConfig& config : plan.configs)
        resize(config.job);
    if (plan.reference)
        resize(plan.reference->job);
    MotionFrames& shown = scene.frames;
    shown.stride = (plan.frames + kMostShownFrames - 1) / kMostShownFrames;
    shown.configs.resize(plan.configs.size());
    measure::SequenceCallbacks callbacks;
    callbacks.frame = [&](const measure::SequenceFrame& frame) -> Result<void> {
        shown.width = frame.width;
        shown.height = frame.height;
        if (frame.index % shown.stride != 0)
            return {};
        GLINT_TRY(file, scene::encodeWebp(frame.width, frame.height, frame.composite.rgb8, kFrameQuality));
        shown.configs[frame.config].push_back(std::move(file));
        return {};
    };
    GLINT_TRY(motion, measure::renderSequence(context, plan, callbacks));
    scene.motion = std::move(motion);
    scene.path = options.path;
    return {};
}

Result<ReportScene> measureScene(gpu::Context& context, const ReportOptions& options, const std::string& name,
                                 ScenePlan& plan) {
    GLINT_TRY(comparison, measure::compareConfigs(
                              context, plan.configs, plan.reference, static_cast<uint32_t>(options.frames),
                              [&](const std::string& config) { showStep(fmt::format("{}, {}", name, config)); },
                              static_cast<uint32_t>(options.seeds)));
    std::vector<std::string> commands;
    for (const std::string& config : options.configs)
        commands.push_back(renderCommand(options.scene, name, config, comparison.width, comparison.height));
    ReportScene scene = reportScene(std::move(comparison), std::move(commands), options.scene.camera);
    if (plan.motion) {
        showStep(name + ", motion");
        GLINT_CHECK(addMotion(context, options, std::move(*plan.motion), scene));
    }
    return scene;
}

/// A threshold was passed, or figures are gone, which may have become worse: for scripts, an error.
Result<void> checkChanges(const ReportChanges& changes) {
    const auto fails = [&](const measure::FigureChange& change) { return changes.fails(change); };
    std::vector<std::string> reasons;
    if (const auto count = std::ranges::count_if(changes.figures.changes, fails); count > 0) {
        const auto first = std::ranges::find_if(changes.figures.changes, fails);
        reasons.push_back(fmt::format("{} worse than in {} by more than the threshold; the first: {}, {}: {}",
                                      count == 1 ? std::string("1 figure is") : fmt::format("{} figures are", count),
                                      changes.file, first->now.scene, first->now.config, first->now.name));
    }
    if (const std::vector<measure::Figure>& gone = changes.figures.removed; !gone.empty())
        reasons.push_back(fmt::format(
            "{} of {} no longer measured; the first: {}, {}: {}",
            gone.size() == 1 ? std::string("1 figure") : fmt::format("{} figures", gone.size()),
            changes.file + (gone.size() == 1 ? " is" : " are"), gone[0].scene, gone[0].config, gone[0].name));
    if (reasons.empty())
        return {};
    return makeError(ErrorCode::Unsupported, "{}", printable(joinText(reasons, "; "), 1000));
}

Result<void> makeReport(const ReportOptions& options) {
    GLINT_CHECK(checkOptions(options));
    const std::vector<std::string> scenes =
        options.scenes.empty() ? std::vector<std::string>{"builtin:hall"} : options.scenes;
    std::vector<ScenePlan> plans;
    for (const std::string& name : scenes) {
        GLINT_TRY(plan, makePlan(options, name));
        plans.push_back(std::move(plan));
    }
    Report report;
    report.command = options.command;
    report.options = watchedOptions(options, plans.front());
    if (!options.curve.empty()) {
        GLINT_TRY(curve, readCurve(options.curve));
        report.curve = std::move(curve);
    }
    std::optional<GalleryPlan> gallery;
    if (!options.pictures.empty()) {
        GLINT_TRY(read, openGallery(options.pictures, options.output));
        gallery = std::move(read);
    }
    std::optional<EarlierReport> earlier;
    if (!options.against.empty()) {
        GLINT_TRY(read, readEarlierReport(options.against));
        GLINT_CHECK(checkSameOptions(read, report.options));
        earlier = std::move(read);
    }
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    if (gallery)
        GLINT_CHECK(renderGalleryPage(*gallery, *context, options.scene, options.picturesSize, options.output,
                                      options.json == "-" ? stderr : stdout, report));
    for (size_t i = 0; i < scenes.size(); ++i) {
        GLINT_TRY(scene, measureScene(*context, options, scenes[i], plans[i]));
        report.scenes.push_back(std::move(scene));
    }
    GLINT_CHECK(render::checkMessages(*context));
    if (report.gallery)
        report.gallery->complete = true;
    if (earlier) {
        GLINT_TRY(changes, changesSince(*earlier, report.scenes));
        changes.threshold = options.threshold;
        changes.timeThreshold = options.timeThreshold;
        report.changes = std::move(changes);
    }
    GLINT_CHECK(writeReportPage(options.output, report));
    if (!options.json.empty())
        GLINT_CHECK(writeFile(options.json, reportText(report)));
    if (!report.changes)
        return {};
    const std::string text = changesText(*report.changes);
    std::fwrite(text.data(), 1, text.size(), options.json == "-" ? stderr : stdout);
    return checkChanges(*report.changes);
}

} // namespace

void addReportCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<ReportOptions>();
    CLI::App* const command =
        program.add_subcommand("report", "Measure settings and write one page; compare with an earlier report");
    command->add_option("SCENE", options->scenes, sceneHelp() + " (default: builtin:hall)");
    command->add_option("-o,--output", options->output, "Page to write (.html)")->capture_default_str();
    command->add_option("--json", options->json, "Write the page's values as JSON, for --against; - prints them");
    command->add_option("--config", options->configs, kConfigHelp)->allow_extra_args(false)->capture_default_str();
    command->add_option("--set", options->scene.settings.assignments, "KEY=VALUE for every config, weaker than its own")
        ->allow_extra_args(false);
    addSceneOptions(*command, options->scene);
    addSourceOptions(*command, options->scene);
    command->add_option("--size", options->scene.size,
                        "Picture size, WIDTHxHEIGHT (default: the camera's, or 1280x720)");
    command->add_option("--frames", options->frames, "Frames to time for each config and seed")->capture_default_str();
    command->add_option("--seeds", options->seeds, "Seeds to render each config with")->capture_default_str();
    command->add_option("--reference", options->reference, "Settings of the reference, as for --config; or none")
        ->capture_default_str();
    command
        ->add_option("--reference-frames", options->referenceFrames,
                     "Frames of the reference, where it averages over frames")
        ->capture_default_str();
    command->add_option("--path", options->path, pathHelp())->capture_default_str();
    command->add_option("--motion-frames", options->motionFrames, "Frames of the moving pictures; 0: none")
        ->capture_default_str();
    command->add_option("--motion-size", options->motionSize,
                        "Their size, WIDTHxHEIGHT (default: half of the pictures')");
    command
        ->add_option("--motion-samples", options->motionSamples,
                     "Samples per pixel, frame and seed of their reference; 0: none")
        ->capture_default_str();
    command->add_option("--pictures", options->pictures,
                        "Plan of pictures (JSON) that are rendered first and shown on the page, which fills up "
                        "meanwhile; they are PNG files beside it");
    command->add_option("--pictures-size", options->picturesSize, "Their size, WIDTHxHEIGHT (default: the plan's)");
    command->add_option("--curve", options->curve,
                        "Curve of cost against error, to be drawn: the file of glint tune --json");
    command->add_option("--against", options->against,
                        "JSON of an earlier report: says what is better, worse or noise; fails past the threshold, "
                        "and where figures are gone");
    command->add_option("--threshold", options->threshold, "Percent, or percentage points of shares, for --against")
        ->capture_default_str();
    command->add_option("--time-threshold", options->timeThreshold, "The same for times")->capture_default_str();
    command->callback([&chosen, options, command] {
        options->command = commandText(*command);
        chosen = [options] { return makeReport(*options); };
    });
}

} // namespace glint::cli
