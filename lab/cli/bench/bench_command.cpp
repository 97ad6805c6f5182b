// glint bench: measures the cost of the reflections, pass by pass, over image sizes and over the fraction of the image
// that reflects; or the cost of rays; or that of creating the library's objects.
#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/bench/bench_base.hpp"
#include "lab/cli/bench/bench_costs.hpp"
#include "lab/cli/bench/bench_output.hpp"
#include "lab/cli/bench/create_bench_output.hpp"
#include "lab/cli/bench/ray_bench_options.hpp"
#include "lab/cli/bench/ray_bench_output.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/file_roles.hpp"
#include "lab/cli/render/render_options.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

struct BenchOptions {
    RenderOptions scene;
    std::vector<std::string> scenes;
    std::vector<std::string> configs = {"balanced"};
    std::vector<std::string> sizes;
    std::vector<std::string> shares = {"0", "25", "50", "100"};
    int64_t frames = 30;
    int64_t warmUp = 10;
    double budget = 20;
    std::string json;
    std::string check;
    std::string costs;
    double tolerance = 50; ///< percent
    RayBenchOptions rays;
    bool create = false;
};

/// Percentages, or the one word "none".
Result<std::vector<float>> readShares(const std::vector<std::string>& texts) {
    std::vector<float> shares;
    if (texts == std::vector<std::string>{"none"})
        return shares;
    for (const std::string& text : texts) {
        double percent = -1;
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, percent);
        if (error != std::errc() || rest != end || !(percent >= 0 && percent <= 100))
            return invalidArgument("--shares {}: expected percentages from 0 to 100, or none", printable(text));
        shares.push_back(static_cast<float>(percent / 100));
    }
    return shares;
}

Result<measure::BenchPlan> makePlan(const BenchOptions& options) {
    measure::BenchPlan plan;
    for (const std::string& size : options.sizes) {
        render::RenderJob job;
        auto read = readSize("--sizes", size, job);
        GLINT_CHECK(read);
        plan.sizes.emplace_back(job.width, job.height);
    }
    GLINT_TRY(shares, readShares(options.shares));
    plan.shares = std::move(shares);
    if (options.frames < 1 || options.frames > 100000)
        return invalidArgument("--frames {}: expected 1 to 100000", options.frames);
    if (options.warmUp < 0 || options.warmUp > 100000)
        return invalidArgument("--warm-up {}: expected 0 to 100000", options.warmUp);
    if (!(options.budget >= 0 && options.budget <= 1e6))
        return invalidArgument("--budget {:g}: expected 0 to 1e6 seconds", options.budget);
    plan.frames = static_cast<uint32_t>(options.frames);
    plan.warmUp = static_cast<uint32_t>(options.warmUp);
    plan.budgetSeconds = options.budget;
    return plan;
}

/// Checks all that can be checked before any scene is read.
Result<measure::BenchScene> makeScene(const BenchOptions& options, const std::string& name, bool shares) {
    measure::BenchScene scene;
    for (const std::string& text : options.configs) {
        GLINT_TRY(job, makeConfigJob(options.scene, name, text));
        if (shares && job.settings.render.display.antialias == render::Antialias::Msaa4)
            return invalidArgument("--config {}: shares of mirrors need one sample a pixel: leave out "
                                   "display.antialias=msaa4 or give --shares none",
                                   printable(text));
        scene.configs.push_back({text, job.settings});
        scene.job = std::move(job);
    }
    return scene;
}

void showPoint(const std::string& point) {
    if (isatty(fileno(stderr)))
        fmt::print(stderr, "measuring {}\n", printable(point));
}

Result<void> checkOutput(const BenchOptions& options, const char* option = "--json") {
    const std::string& file = std::string_view(option) == "--costs" ? options.costs : options.json;
    if (file.empty() || file == "-")
        return {};
    GLINT_CHECK(checkFolder(option, file));
    std::vector<NamedFile> inputs = inputFiles(options.scene);
    for (const std::string& scene : options.scenes)
        inputs.push_back({"SCENE", scene});
    addConfigFiles(options.configs, inputs);
    const NamedFile outputs[] = {{option, file}};
    return checkOutputs(inputs, outputs);
}

/// Shows no figures if the validation layer reports messages.
Result<void> show(const BenchOptions& options, const gpu::Context& context, const std::string& text,
                  const std::string& json) {
    if (!context.validationMessages().empty())
        return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                         context.validationMessages().size(), context.validationMessages().front());
    const std::string& shown = options.json == "-" ? json : text;
    std::fwrite(shown.data(), 1, shown.size(), stdout);
    if (options.json.empty() || options.json == "-")
        return {};
    return writeFile(options.json, json);
}

Result<void> benchRays(const BenchOptions& options) {
    GLINT_TRY(series, makeRayBenchSeries(options.rays));
    GLINT_CHECK(checkOutput(options));
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    GLINT_TRY(result, measure::runRayBench(*context, series, showPoint));
    GLINT_CHECK(show(options, *context, rayBenchText(result), rayBenchJson(result)));
    return measure::checkSameHits(result);
}

Result<void> benchCreation(const BenchOptions& options) {
    measure::CreatePlan plan;
    if (options.sizes.size() > 1)
        return invalidArgument("--create measures at one size: give one to --sizes");
    if (!options.sizes.empty()) {
        render::RenderJob size;
        GLINT_CHECK(readSize("--sizes", options.sizes.front(), size));
        plan.width = size.width;
        plan.height = size.height;
    }
    for (const std::string& text : options.configs) {
        GLINT_TRY(job, makeConfigJob(options.scene, "builtin:hall", text)); // no scene is read
        plan.configs.push_back({text, job.settings.reflections});
    }
    GLINT_CHECK(checkOutput(options));
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    GLINT_TRY(result, measure::measureCreation(*context, plan, showPoint));
    return show(options, *context, createBenchText(result), createBenchJson(result));
}

Result<std::vector<measure::BenchScene>> makeScenes(const BenchOptions& options, bool shares) {
    std::vector<measure::BenchScene> scenes;
    for (const std::string& name : options.scenes.empty() ? std::vector<std::string>{"builtin:hall"} : options.scenes) {
        GLINT_TRY(scene, makeScene(options, name, shares));
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

/// `options.configs`: several, as a pass's costs show in what differs between frames.
Result<void> benchCosts(const BenchOptions& options) {
    GLINT_TRY(plan, makePlan(options));
    if (plan.sizes.size() > 1)
        return invalidArgument("--costs measures at one size: give one to --sizes");
    GLINT_TRY(scenes, makeScenes(options, false));
    GLINT_CHECK(checkOutput(options, "--costs"));
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    GLINT_TRY(result, measureCostTable(*context, scenes, plan, showPoint));
    const std::string json = tune::costsText(result.table);
    GLINT_CHECK(show(options, *context, options.costs == "-" ? json : costsBenchText(result), json));
    return options.costs == "-" ? Result<void>() : writeFile(options.costs, json);
}

/// The device lives as long as the result is made; the result refers to nothing of it.
Result<measure::BenchResult> measureAll(const BenchOptions& options, std::unique_ptr<gpu::Context>* used = nullptr) {
    GLINT_TRY(plan, makePlan(options));
    GLINT_TRY(scenes, makeScenes(options, !plan.shares.empty()));
    GLINT_CHECK(checkOutput(options));
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    GLINT_TRY(result, measure::runBench(*context, scenes, plan, showPoint));
    if (used)
        *used = std::move(context);
    return result;
}

Result<void> bench(const BenchOptions& options) {
    std::unique_ptr<gpu::Context> context;
    GLINT_TRY(result, measureAll(options, &context));
    return show(options, *context, benchText(result), benchJson(result));
}

template <class T>
void addOnce(std::vector<T>& list, const T& value) {
    if (std::ranges::find(list, value) == list.end())
        list.push_back(value);
}

/// What the base measured: its scenes, configurations, sizes, shares and frames.
BenchOptions optionsOf(const measure::BenchBase& base, const BenchOptions& options) {
    BenchOptions all = options;
    all.configs.clear();
    all.shares.clear();
    for (const measure::BenchFigure& figure : base.figures) {
        addOnce(all.scenes, figure.scene);
        addOnce(all.configs, figure.config);
        if (figure.share)
            addOnce(all.shares, fmt::format("{:.9g}", 100.0 * static_cast<double>(*figure.share)));
        else
            addOnce(all.sizes, fmt::format("{}x{}", figure.size.x, figure.size.y));
    }
    if (all.shares.empty())
        all.shares = {"none"};
    all.frames = base.frames;
    all.warmUp = base.warmUp;
    return all;
}

/// What seems too slow is measured again: a busy moment of the machine is no regression.
Result<void> benchCheck(const BenchOptions& given) {
    constexpr int kAttempts = 3;
    constexpr size_t kLongest = 16U << 20;
    if (!(given.tolerance > 0 && given.tolerance <= 1000))
        return invalidArgument("--tolerance {:g}: expected a percentage above 0, at most 1000", given.tolerance);
    GLINT_TRY(text, readFile(given.check, kLongest));
    GLINT_TRY(base, readBenchBase(text, given.check));
    const BenchOptions options = optionsOf(base, given);
    measure::BenchTolerance tolerance;
    tolerance.floors = given.tolerance / 100;
    std::vector<measure::BenchFigure> best;
    std::vector<measure::CheckedFigure> checked;
    std::string device;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        GLINT_TRY(result, measureAll(options));
        device = result.device;
        if (best.empty())
            best = measure::figuresOf(result);
        else
            measure::keepFaster(best, measure::figuresOf(result));
        GLINT_TRY(figures, measure::checkFigures(base, best, device, tolerance));
        checked = std::move(figures);
        if (std::ranges::none_of(checked, &measure::CheckedFigure::slower))
            break;
    }
    const std::string report = benchCheckText(checked, base.device, device);
    std::fwrite(report.data(), 1, report.size(), stdout);
    const auto bad = std::ranges::count_if(checked, [](const auto& figure) { return !figure.good(); });
    if (bad > 0)
        return makeError(ErrorCode::Unsupported, "{} of {} figures are larger than those of {}", bad, checked.size(),
                         printable(given.check));
    return {};
}

} // namespace

void addBenchCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<BenchOptions>();
    CLI::App* const command =
        program.add_subcommand("bench", "Time the reflections pass by pass, or rays, or creation");
    CLI::Option* const scenes = command->add_option("SCENE", options->scenes, sceneHelp() + " (default: builtin:hall)");
    CLI::Option* const configs =
        command->add_option("--config", options->configs, kConfigHelp)->allow_extra_args(false)->capture_default_str();
    command->add_option("--set", options->scene.settings.assignments, "KEY=VALUE for every config, weaker than its own")
        ->allow_extra_args(false);
    CLI::Option* const sizes =
        command
            ->add_option("--sizes", options->sizes,
                         "WIDTHxHEIGHT,... (default: 640x360,1280x720; on a GPU also 1920x1080,3840x2160); one with "
                         "--create (default: 1280x720)")
            ->delimiter(',')
            ->allow_extra_args(false);
    CLI::Option* const shares =
        command
            ->add_option("--shares", options->shares,
                         "Percentages of the surfaces to make mirrors, one point each; none: leave these points out")
            ->delimiter(',')
            ->allow_extra_args(false)
            ->capture_default_str();
    command->add_option("--frames", options->frames, "Frames to time for each config")->capture_default_str();
    command->add_option("--warm-up", options->warmUp, "Frames before them")->capture_default_str();
    command->add_option("--budget", options->budget, "Seconds for each point, then fewer frames do; 0: no limit")
        ->capture_default_str();
    addSceneOptions(*command, options->scene);
    addSourceOptions(*command, options->scene);
    command->add_option("--json", options->json, "Write the figures as JSON; - prints them instead of the text");
    command
        ->add_option("--check", options->check,
                     "Measure what this file of --json holds, and fail if floors or lookups have grown")
        ->excludes(scenes, configs, sizes, shares);
    command
        ->add_option("--tolerance", options->tolerance,
                     "With --check: percentage by which floors may be larger than the file's")
        ->capture_default_str();
    addRayBenchOptions(*command, options->rays);
    CLI::Option* const create = command->add_flag(
        "--create", options->create, "Time what creating the library's objects costs a host, for each config, instead");
    for (const char* other :
         {"SCENE", "--shares", "--frames", "--warm-up", "--budget", "--camera", "--env", "--materials", "--time",
          "--seed", "--probes", "--planar", "--check", "--tolerance", "--rays"})
        create->excludes(command->get_option(other));
    CLI::Option* const costs =
        command->add_option("--costs", options->costs,
                            "Write the table of costs that `glint tune` counts by, as bench/costs.json, fitted to all "
                            "presets or each --config, instead; - prints it");
    for (const char* other :
         {"--shares", "--warm-up", "--budget", "--json", "--check", "--tolerance", "--rays", "--create"})
        costs->excludes(command->get_option(other));
    command->callback([&chosen, options, configs, costs] {
        if (costs->count() > 0 && configs->count() == 0) {
            const std::vector<std::string_view> presets = presetNames();
            options->configs.assign(presets.begin(), presets.end());
        }
        chosen = [options] {
            if (!options->costs.empty())
                return benchCosts(*options);
            if (options->rays.asked)
                return benchRays(*options);
            if (options->create)
                return benchCreation(*options);
            return options->check.empty() ? bench(*options) : benchCheck(*options);
        };
    });
}

} // namespace glint::cli
