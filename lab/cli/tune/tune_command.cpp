// glint tune: searches the settings for the best trade-off between cost and error on the user's own scenes.
#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/compare/reference_bounces.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/input_files.hpp"
#include "lab/cli/program_identity.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/cli/tune/tune_output.hpp"
#include "lab/cli/tune/tune_progress.hpp"
#include "lab/tune/generation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

constexpr const char* kOwnCamera = "own";
constexpr const char* kNoPresets = "none";

struct TuneOptions {
    RenderOptions scene; ///< what all scenes share
    std::vector<std::string> scenes;
    std::vector<std::string> cameras;
    std::vector<std::string> paths = {"still"};
    std::vector<std::string> presets = {"fast", "hybrid", "balanced", "real-time", "quality"};
    std::vector<std::string> vary;
    std::optional<double> budgetMs;
    std::optional<double> budgetFloors;
    std::optional<double> budget;
    std::optional<double> maxError;
    double seconds = 0; ///< 0: no limit
    int64_t generations = 20;
    int64_t population = 24;
    std::string start = "balanced";
    std::string reference = "reference";
    int64_t referenceFrames = 8;
    std::string metric = "flip";
    std::string cost = "auto";
    std::string resume;
    std::string output;
    std::string json;
};

Result<tune::TuneTarget> tuneTarget(const TuneOptions& options) {
    const auto positive = [](const std::optional<double>& value) { return !value || (*value > 0 && *value < 1e12); };
    const int given = int(options.budgetMs.has_value()) + int(options.budgetFloors.has_value()) +
                      int(options.budget.has_value()) + int(options.maxError.has_value());
    if (given != 1)
        return invalidArgument("give exactly one of --budget-ms, --budget-floors, --budget and --max-error");
    if (!positive(options.budgetMs) || !positive(options.budgetFloors) || !positive(options.budget) ||
        !positive(options.maxError))
        return invalidArgument("--budget-ms, --budget-floors, --budget and --max-error: expected a number above 0");
    return tune::TuneTarget{options.budgetMs, options.budgetFloors, options.budget, options.maxError};
}

Result<void> checkCounts(const TuneOptions& options) {
    const auto step = static_cast<int64_t>(tune::kPopulationStep);
    if (options.generations < 0 || options.generations > 100000)
        return invalidArgument("--generations {}: expected 0 to 100000", options.generations);
    if (options.population < static_cast<int64_t>(tune::kLeastPopulation) || options.population > 1000 ||
        options.population % step != 0)
        return invalidArgument("--population {}: expected a multiple of {} from {} to 1000", options.population, step,
                               tune::kLeastPopulation);
    if (options.referenceFrames < 1 || options.referenceFrames > 10000)
        return invalidArgument("--reference-frames {}: expected 1 to 10000", options.referenceFrames);
    if (!(options.seconds >= 0 && options.seconds <= 1e9))
        return invalidArgument("--time {:g}: expected seconds, 0 for no limit", options.seconds);
    if (options.cost != "auto" && options.cost != "counted" && options.cost != "measured")
        return invalidArgument("--cost {}: expected auto, counted or measured", printable(options.cost));
    if (options.metric != "flip" && options.metric != "relativeMSE")
        return invalidArgument("--metric {}: expected flip or relativeMSE", printable(options.metric));
    return {};
}

Result<std::vector<scene::CameraMove>> tunePaths(const TuneOptions& options) {
    const auto moves = scene::cameraMoves();
    std::vector<scene::CameraMove> paths;
    for (const std::string& name : options.paths) {
        const auto move = std::ranges::find(moves, name);
        if (move == moves.end())
            return invalidArgument("--paths {}: expected {}", printable(name),
                                   joinText(std::vector<std::string>(moves.begin(), moves.end()), ", "));
        paths.push_back(static_cast<scene::CameraMove>(move - moves.begin()));
    }
    return paths;
}

/// One scene may have several cameras; of several scenes each has one.
Result<std::vector<std::pair<std::string, std::string>>> scenesAndCameras(const TuneOptions& options) {
    std::vector<std::pair<std::string, std::string>> pairs;
    const auto camera = [](const std::string& name) { return name == kOwnCamera ? std::string() : name; };
    if (options.scenes.size() == 1)
        for (const std::string& name : options.cameras)
            pairs.emplace_back(options.scenes.front(), camera(name));
    else if (!options.cameras.empty() && options.cameras.size() != options.scenes.size())
        return invalidArgument("--camera: {} cameras for {} scenes; give one for each, in order ({}: the scene's own)",
                               options.cameras.size(), options.scenes.size(), kOwnCamera);
    if (pairs.empty())
        for (size_t i = 0; i < options.scenes.size(); ++i)
            pairs.emplace_back(options.scenes[i], options.cameras.empty() ? "" : camera(options.cameras[i]));
    return pairs;
}

/// The settings of a `--config` text on the first scene; scenes differ in the renderer's settings alone.
Result<render::ProgramSettings> settingsOf(const TuneOptions& options, const std::string& scene,
                                           const std::string& config, std::string_view option) {
    auto job = makeConfigJob(options.scene, scene, config);
    if (!job) {
        std::string message = job.error().message;
        if (message.starts_with("--config "))
            message.replace(0, std::string_view("--config").size(), option);
        return makeError(job.error().code, "{}", message);
    }
    return job->settings;
}

/// The program, and a hash of each file that the scenes are made of.
Result<std::string> tuneIdentity(const std::vector<render::RenderJob>& jobs) {
    std::string text = programIdentity();
    InputFiles files;
    for (const render::RenderJob& job : jobs) {
        GLINT_TRY(hashes, files.of(job));
        for (const auto& [file, hash] : hashes)
            text += fmt::format("\n{} {}", hash, file);
    }
    return text;
}

/// Of what the search may try.
int mostBounces(const tune::SearchPlan& search, const tune::SearchSpace& space) {
    int most = bouncesOf(search.start);
    for (const auto& [name, settings] : search.presets)
        most = std::max(most, bouncesOf(settings));
    bool mayTrace = search.start.rays.enabled;
    int varied = 0;
    for (size_t i = 0; i < space.size(); ++i) {
        mayTrace = mayTrace || space[i].info->key == "rays.enabled";
        if (space[i].info->key == "rays.bounces")
            varied = static_cast<int>(space[i].max);
    }
    return mayTrace ? std::max(most, varied) : most;
}

Result<tune::TunePlan> tunePlan(const TuneOptions& options) {
    GLINT_CHECK(checkCounts(options));
    tune::TunePlan plan;
    GLINT_TRY(target, tuneTarget(options));
    plan.target = target;
    GLINT_TRY(paths, tunePaths(options));
    plan.evaluation.paths = std::move(paths);
    GLINT_TRY(pairs, scenesAndCameras(options));
    for (const auto& [scene, camera] : pairs) {
        TuneOptions one = options;
        one.scene.camera = camera;
        GLINT_TRY(settings, settingsOf(one, scene, options.start, "--start"));
        one.scene.scene = scene;
        GLINT_TRY(job, makePictureJob(one.scene));
        job.settings = std::move(settings);
        plan.evaluation.jobs.push_back(std::move(job));
    }
    const std::string& first = pairs.front().first;
    GLINT_TRY(reference, settingsOf(options, first, options.reference, "--reference"));
    const RaysSettings& rays = reference.reflections.rays;
    if (options.referenceFrames > 1 && !(rays.enabled && rays.accumulate))
        return invalidArgument("--reference {}: {} frames need rays.enabled and rays.accumulate; give "
                               "--reference-frames 1",
                               printable(options.reference), options.referenceFrames);
    plan.evaluation.referenceFrames = static_cast<uint32_t>(options.referenceFrames);
    plan.evaluation.metric = options.metric == "flip" ? tune::ErrorMetric::Flip : tune::ErrorMetric::RelativeMse;
    plan.search.start = plan.evaluation.jobs.front().settings.reflections;
    for (const std::string& preset : options.presets) {
        if (preset == kNoPresets || preset == options.start)
            continue;
        GLINT_TRY(settings, settingsOf(options, first, preset, "--presets"));
        plan.search.presets.push_back({preset, settings.reflections});
    }
    plan.search.vary = options.vary;
    plan.search.motion = std::ranges::any_of(plan.evaluation.paths,
                                             [](scene::CameraMove move) { return move != scene::CameraMove::Still; });
    plan.search.probes = !options.scene.probes.empty();
    GLINT_TRY(space,
              tune::SearchSpace::create(plan.search.start, plan.search.vary, plan.search.motion, plan.search.probes));
    followAsManyBounces(reference.reflections, mostBounces(plan.search, space));
    plan.evaluation.reference = std::move(reference);
    plan.search.population = static_cast<uint32_t>(options.population);
    plan.search.generations = static_cast<uint32_t>(options.generations);
    plan.search.seed = options.scene.seed;
    plan.startName = options.start;
    plan.stateFile = options.resume;
    if (!plan.stateFile.empty()) {
        GLINT_TRY(identity, tuneIdentity(plan.evaluation.jobs));
        plan.identity = std::move(identity);
    }
    if (options.seconds > 0)
        plan.seconds = options.seconds;
    return plan;
}

Result<void> checkFiles(const TuneOptions& options) {
    GLINT_CHECK(checkFolder("-o", options.output));
    GLINT_CHECK(checkFolder("--resume", options.resume));
    if (!options.json.empty() && options.json != "-")
        GLINT_CHECK(checkFolder("--json", options.json));
    return {};
}

Result<void> tuneScenes(const TuneOptions& options) {
    GLINT_CHECK(checkFiles(options));
    GLINT_TRY(plan, tunePlan(options));
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    plan.evaluation.counted = options.cost == "auto" ? context->info().software : options.cost == "counted";
    constexpr double kClockNoise = 0.02; // of the median of a GPU's frames
    plan.search.costNoise = plan.evaluation.counted ? 0 : kClockNoise;
    TuneProgress progress(plan.search.generations, plan.seconds);
    GLINT_TRY(result, tune::tuneSettings(*context, plan, progress.hooks()));
    progress.finish();
    if (!context->validationMessages().empty())
        return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                         context->validationMessages().size(), context->validationMessages().front());
    const render::ProgramSettings& start = plan.evaluation.jobs.front().settings;
    GLINT_TRY(preset, render::loadSettings({{}, start.preset, {}, {}}));
    const TuneNames names = {options.scenes, options.start, options.scene.seed, start, std::move(preset)};
    const std::string text = options.json == "-" ? tuneJson(result, names) : tuneText(result, names);
    std::fwrite(text.data(), 1, text.size(), stdout);
    if (!options.json.empty() && options.json != "-")
        GLINT_CHECK(writeFile(options.json, tuneJson(result, names)));
    if (!options.output.empty())
        GLINT_CHECK(writeFile(options.output, tunedSettings(result, names)));
    return result.met ? Result<void>() : missedTarget(result);
}

void addTargetOptions(CLI::App& command, TuneOptions& options) {
    command.add_option("--budget", options.budget, "Most cost, as a fraction of the start's: 0.5 is half");
    command.add_option("--budget-ms", options.budgetMs, "Most milliseconds of the effect");
    command.add_option("--budget-floors", options.budgetFloors, "Most cost in floors (docs/truth.md)");
    command.add_option("--max-error", options.maxError, "Most error (--metric): find the least cost");
}

void addSearchOptions(CLI::App& command, TuneOptions& options) {
    command.add_option("--paths", options.paths, "Paths of the camera to judge by: still,pan,dolly,truck,orbit")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    command.add_option("--start", options.start, "Settings to start from, and never to be worse than: as --config")
        ->capture_default_str();
    command.add_option("--presets", options.presets, "Presets to try too, parted by commas, or none")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    command.add_option("--vary", options.vary, "Keys or groups to vary, parted by commas (default: all that matter)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--time", options.seconds, "Seconds after which no generation begins; 0: no limit");
    command.add_option("--generations", options.generations, "Generations of the search")->capture_default_str();
    command.add_option("--population", options.population, "Settings in each generation")->capture_default_str();
    command.add_option("--reference", options.reference, "Settings of the reference")->capture_default_str();
    command.add_option("--reference-frames", options.referenceFrames, "Frames that it averages")->capture_default_str();
    command.add_option("--metric", options.metric, "Error of a picture: flip or relativeMSE")->capture_default_str();
    command
        .add_option("--cost", options.cost,
                    "measured: milliseconds; counted: floors from counters, the same on every run; auto: counted "
                    "on a software device")
        ->capture_default_str();
}

} // namespace

void addTuneCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<TuneOptions>();
    options->scene.size = "320x180";
    CLI::App* const command =
        program.add_subcommand("tune", "Search the settings that suit scenes and a budget; returns 1 if none meet it");
    command->add_option("SCENE", options->scenes, sceneHelp())->required();
    addTargetOptions(*command, *options);
    addSearchOptions(*command, *options);
    command
        ->add_option("--camera", options->cameras,
                     "Camera: a file, a name or an index; repeated: several of one scene, or one for each scene (own: "
                     "the scene's)")
        ->allow_extra_args(false);
    command->add_option("--env", options->scene.environment, "Environment: an .hdr or .exr file, sky or none");
    command->add_option("--materials", options->scene.materials, "Material overrides: a JSON file, or none");
    addSourceOptions(*command, options->scene);
    command->add_option("--size", options->scene.size, "Picture size, WIDTHxHEIGHT")->capture_default_str();
    command
        ->add_option("--set", options->scene.settings.assignments,
                     "KEY=VALUE for the start, the presets and the reference, weaker than their own")
        ->allow_extra_args(false);
    addDeviceOptions(*command, options->scene);
    command->add_option("--resume", options->resume,
                        "State file: written every few seconds; if it exists, the search goes on from it");
    command->add_option("-o,--output", options->output, "Write the chosen settings, for --settings");
    command->add_option("--json", options->json, "Write the whole curve as JSON; - prints it instead of the text");
    command->callback([&chosen, options] { chosen = [options] { return tuneScenes(*options); }; });
}

} // namespace glint::cli
