// glint shares: measures what share of the screen's answers is right, by what the march knows of them, and writes the
// table that weights are taken from (shaders/trace/answer_shares.glsl).
#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/compare/certainty_text.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/measure/truth/comparison.hpp"

#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

/// Views of the built-in scenes: mirrors in rooms and outdoors; thin, round and flat things; leaves.
constexpr std::array kViews = {"exact", "exact@left", "hall", "hall@mirror", "spheres", "motion-grille", "city"};

struct SharesOptions {
    RenderOptions scene;
    std::vector<std::string> views = {kViews.begin(), kViews.end()};
    std::string config = "balanced";
    std::string output;
};

/// A table of so few answers says little: this many more are taken to be half right.
constexpr double kUnsure = 20;

double tableShare(const measure::AnswerShare& kind) {
    return (static_cast<double>(kind.right) + kUnsure / 2) / (static_cast<double>(kind.answers) + kUnsure);
}

std::string shaderTable(const measure::HitFigures& sums) {
    std::string text =
        "// Written by `glint shares --output shaders/trace/answer_shares.glsl`: share of right answers of each kind\n"
        "// (shared/answer_kinds.h) in views of the built-in scenes. Do not edit.\n"
        "#ifndef GLINT_TRACE_ANSWER_SHARES_GLSL\n#define GLINT_TRACE_ANSWER_SHARES_GLSL\n\n"
        "#include \"shared/answer_kinds.h\"\n\n"
        "const float kRightShares[kAnswerKinds] = float[kAnswerKinds](";
    for (size_t kind = 0; kind < sums.byKind.size(); ++kind) {
        const measure::AnswerShare& share = sums.byKind[kind];
        text += fmt::format("\n    {:.3f}{} // {} of {}", tableShare(share), kind + 1 < sums.byKind.size() ? "," : ");",
                            share.right, share.answers);
    }
    return text + "\n\n#endif\n";
}

Result<void> addView(gpu::Context& context, const SharesOptions& options, const std::string& view,
                     measure::HitFigures& sums) {
    const size_t at = view.find('@');
    RenderOptions scene = options.scene;
    scene.scene = "builtin:" + view.substr(0, at);
    if (at != std::string::npos)
        scene.camera = view.substr(at + 1);
    GLINT_TRY(job, makeConfigJob(scene, scene.scene, options.config));
    GLINT_TRY(comparison, measure::compareConfigs(context, {{options.config, std::move(job)}}, {}, 1));
    const measure::HitFigures& hits = comparison.configs.front().hits.all;
    for (size_t kind = 0; kind < sums.byKind.size(); ++kind)
        sums.byKind[kind].add(hits.byKind[kind]);
    for (size_t bin = 0; bin < sums.stated.size(); ++bin)
        sums.stated[bin].add(hits.stated[bin]);
    fmt::print("{}\n{}", view, statedText(hits));
    return {};
}

Result<void> measureShares(const SharesOptions& options) {
    if (!options.output.empty())
        GLINT_CHECK(checkFolder("--output", options.output));
    GLINT_TRY(context, gpu::Context::create({options.scene.device, options.scene.validate}));
    measure::HitFigures sums;
    for (const std::string& view : options.views)
        GLINT_CHECK(addView(*context, options, view, sums));
    fmt::print("all\n{}{}", statedText(sums), kindsText(sums));
    if (!options.output.empty())
        GLINT_CHECK(writeFile(options.output, shaderTable(sums)));
    return {};
}

} // namespace

void addSharesCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<SharesOptions>();
    CLI::App* const command =
        program.add_subcommand("shares", "Measure what share of the screen's answers is right, by kind of answer");
    command->add_option("VIEWS", options->views, "Built-in scenes, each with a camera if wanted: NAME or NAME@CAMERA")
        ->capture_default_str();
    command->add_option("--config", options->config, kConfigHelp)->capture_default_str();
    command->add_option("--size", options->scene.size, "Picture size, WIDTHxHEIGHT")->default_val("480x270");
    command->add_option("--output", options->output, "Write the shaders' table: shaders/trace/answer_shares.glsl");
    addDeviceOptions(*command, options->scene);
    command->callback([&chosen, options] { chosen = [options] { return measureShares(*options); }; });
}

} // namespace glint::cli
