// glint compare: several settings on one view of a scene, measured against truth and against each other.
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "lab/cli/command_text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/compare/comparison_output.hpp"
#include "lab/cli/compare/reference_bounces.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/file_roles.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/cli/report/report_page.hpp"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace glint::cli {
namespace {

struct CompareOptions {
    RenderOptions scene;
    std::vector<std::string> configs;
    int64_t frames = 5; ///< to time
    std::string reference;
    int referenceFrames = 0; ///< 0: defaultReferenceFrames
    std::string report;
    std::string json;
    std::string command; ///< as the user wrote it
};

/// Checks all that can be checked before the scene is read.
Result<std::vector<measure::ComparedConfig>> makeConfigs(const CompareOptions& options) {
    std::vector<measure::ComparedConfig> configs;
    for (const std::string& text : options.configs) {
        GLINT_TRY(job, makeConfigJob(options.scene, options.scene.scene, text));
        configs.push_back({text, std::move(job)});
    }
    return configs;
}

Result<std::optional<measure::ComparedConfig>> makeReference(const CompareOptions& options,
                                                             std::span<const measure::ComparedConfig> configs) {
    if (options.reference.empty())
        return std::optional<measure::ComparedConfig>();
    GLINT_TRY(job, makeConfigJob(options.scene, options.scene.scene, options.reference));
    job.frames = options.referenceFrames > 0 ? static_cast<uint32_t>(options.referenceFrames)
                                             : defaultReferenceFrames(job.settings);
    measure::ComparedConfig reference = {options.reference, std::move(job)};
    followAsManyBounces(reference, configs);
    return std::optional<measure::ComparedConfig>(std::move(reference));
}

/// `--report` with a file's name, not a folder's.
bool isPage(const std::string& report) {
    return report.ends_with(".html");
}

Result<void> checkOptions(const CompareOptions& options) {
    if (!options.json.empty() && options.json != "-")
        GLINT_CHECK(checkFolder("--json", options.json));
    if (isPage(options.report))
        GLINT_CHECK(checkFolder("--report", options.report));
    std::error_code ignored;
    if (!options.report.empty() && !isPage(options.report) && std::filesystem::exists(options.report, ignored) &&
        !std::filesystem::is_directory(options.report, ignored))
        return invalidArgument("--report {}: this is a file, not a folder; a page's name ends in .html",
                               printable(options.report));
    if (options.frames < 1 || options.frames > 10000)
        return invalidArgument("--frames {}: expected 1 to 10000", options.frames);
    if (options.referenceFrames < 0 || options.referenceFrames > 100000)
        return invalidArgument("--reference-frames {}: expected 1 to 100000", options.referenceFrames);
    std::vector<NamedFile> inputs = inputFiles(options.scene);
    addConfigFiles(options.configs, inputs);
    addConfigFiles({options.reference}, inputs);
    const NamedFile outputs[] = {{"--json", options.json}, {"--report", isPage(options.report) ? options.report : ""}};
    return checkOutputs(inputs, outputs);
}

void showProgress(const std::string& config) {
    if (isatty(fileno(stderr)))
        fmt::print(stderr, "measuring {}\n", printable(config));
}

Result<void> writeReports(const CompareOptions& options, measure::Comparison comparison) {
    if (!isPage(options.report))
        GLINT_CHECK(writeComparisonFolder(options.report, comparison));
    std::vector<std::string> commands;
    for (const std::string& config : options.configs)
        commands.push_back(
            renderCommand(options.scene, options.scene.scene, config, comparison.width, comparison.height));
    Report report;
    report.command = options.command;
    report.scenes.push_back(reportScene(std::move(comparison), std::move(commands), options.scene.camera));
    return writeReportPage(isPage(options.report) ? options.report : options.report + "/index.html", report);
}

Result<void> compare(const CompareOptions& options) {
    GLINT_CHECK(checkOptions(options));
    GLINT_TRY(configs, makeConfigs(options));
    GLINT_TRY(reference, makeReference(options, configs));
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    GLINT_TRY(comparison, measure::compareConfigs(*context, configs, reference, static_cast<uint32_t>(options.frames),
                                                  showProgress));
    if (!context->validationMessages().empty())
        return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                         context->validationMessages().size(), context->validationMessages().front());
    const std::string text = options.json == "-" ? comparisonJson(comparison) : comparisonText(comparison);
    std::fwrite(text.data(), 1, text.size(), stdout);
    if (!options.json.empty() && options.json != "-")
        GLINT_CHECK(writeFile(options.json, comparisonJson(comparison)));
    return options.report.empty() ? Result<void>() : writeReports(options, std::move(comparison));
}

} // namespace

void addCompareCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* const command = program.add_subcommand("compare", "Measure several settings on a scene against truth");
    command->add_option("SCENE", options->scene.scene, sceneHelp())->required();
    command->add_option("--config", options->configs, kConfigHelp)->required()->allow_extra_args(false);
    command->add_option("--set", options->scene.settings.assignments, "KEY=VALUE for every config, weaker than its own")
        ->allow_extra_args(false);
    addSceneOptions(*command, options->scene);
    addSourceOptions(*command, options->scene);
    command->add_option("--size", options->scene.size,
                        "Picture size, WIDTHxHEIGHT (default: the camera's, or 1280x720)");
    command->add_option("--frames", options->frames, "Frames to time for each config")->capture_default_str();
    command->add_option("--reference", options->reference,
                        "Hold the pictures against this config's: preset reference, say");
    command->add_option("--reference-frames", options->referenceFrames,
                        "Frames of the reference (default: 1, or 16 where it averages over frames)");
    command->add_option("--report", options->report,
                        "Page to write (.html), or a folder for it, the pictures and the figures");
    command->add_option("--json", options->json, "Write the figures as JSON; - prints them instead of the text");
    command->callback([&chosen, options, command] {
        options->command = commandText(*command);
        chosen = [options] { return compare(*options); };
    });
}

} // namespace glint::cli
