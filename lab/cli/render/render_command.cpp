// glint render: one scene, one camera, images and figures.
#include "base/file.hpp"
#include "base/log.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/file_roles.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/cli/render/render_output.hpp"
#include "lab/measure/truth/job_exact.hpp"
#include "lab/measure/truth/job_hits.hpp"

#include <unistd.h>

#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

/// Counts frames, only on a terminal, not into a pipe or a file.
void showProgress(uint32_t done, uint32_t frames) {
    if (frames > 1 && isatty(fileno(stderr)))
        fmt::print(stderr, "\rframe {} of {}{}", done, frames, done == frames ? "\n" : "");
}

Result<void> renderPictures(const RenderOptions& options, const render::RenderFunction& render) {
    GLINT_TRY(job, makeRenderJob(options));
    GLINT_CHECK(checkOutputs(inputFiles(options), outputFiles(options)));
    lookAt(job, options);
    job.progress = showProgress;
    GLINT_TRY(result, render(job));
    for (const std::string& note : result.notes)
        log::warning("{}", note);
    GLINT_CHECK(writePictures(options.output, result));
    std::optional<measure::MirrorError> exact;
    if (job.settings.render.measure.exact) {
        GLINT_TRY(error, measure::measureExact(job, result));
        exact = error;
    }
    if (options.statsFile.empty())
        return {};
    std::optional<measure::HitReport> hits;
    if (job.settings.render.measure.hits) {
        const render::RenderJob traced = measure::hitJob(job);
        GLINT_TRY(tracedResult, render(traced));
        GLINT_TRY(report, measure::measureHits(traced, tracedResult));
        hits = std::move(report);
    }
    return writeFile(options.statsFile, statsJson(job, result, {std::move(exact), std::move(hits)}));
}

} // namespace

void addRenderCommand(CLI::App& program, Command& chosen, const render::RenderFunction& render) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* const command = program.add_subcommand("render", "Render a scene to a picture");
    addRenderOptions(*command, *options);
    command->callback(
        [&chosen, options, render] { chosen = [options, render] { return renderPictures(*options, render); }; });
}

} // namespace glint::cli
