// glint trace: reflections for a G-buffer that another renderer wrote to OpenEXR files (docs/trace.md).
#include "base/file.hpp"
#include "base/log.hpp"
#include "commands.hpp"
#include "render/trace_job.hpp"
#include "render_options.hpp"
#include "render_output.hpp"
#include "trace_output.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

/// The options as the user wrote them.
struct TraceOptions {
    RenderOptions picture;
    std::string color;
    std::string mapping;
    bool printMapping = false;
};

/// An EXR file has these layers besides those of --view.
constexpr std::string_view kLayers[] = {"composite", "reflection", "weight", "weights", "outcome"};

void addOnce(std::vector<std::string>& names, std::string_view name) {
    if (std::ranges::find(names, name) == names.end())
        names.emplace_back(name);
}

Result<render::TraceJob> makeTraceJob(const TraceOptions& options) {
    if (options.picture.scene.empty())
        return invalidArgument("GBUFFER is required: an OpenEXR file");
    if (options.picture.camera.empty())
        return invalidArgument("--camera is required: a camera file with the view that the G-buffer was rendered from");
    render::TraceJob job;
    GLINT_TRY(picture, makeRenderJob(options.picture));
    job.picture = std::move(picture);
    job.color = options.color;
    job.mapping = options.mapping;
    GLINT_TRY(kind, pictureKind(options.picture.output));
    if (kind == PictureKind::Exr)
        for (const std::string_view name : kLayers)
            addOnce(job.picture.views, name);
    return job;
}

/// Returns the job with the views that figures and the specular layer are computed from.
render::TraceJob withInnerViews(const render::TraceJob& job) {
    render::TraceJob more = job;
    for (const std::string_view name : {"composite", "scene", "weights", "roughness", "reflectivity"})
        addOnce(more.picture.views, name);
    return more;
}

Result<void> printMapping(const std::string& name) {
    GLINT_TRY(text, scene::mappingPresetText(name.empty() ? "blender" : name));
    fmt::print("{}", text);
    return {};
}

Result<void> trace(const TraceOptions& options) {
    if (options.printMapping)
        return printMapping(options.mapping);
    GLINT_TRY(job, makeTraceJob(options));
    GLINT_TRY(inputs, render::loadTraceInputs(job));
    GLINT_TRY(result, render::runTrace(withInnerViews(job), inputs));
    for (const std::string& note : result.notes)
        log::warning("{}", note);
    const TraceFigures figures = traceFigures(job, inputs, result);
    GLINT_CHECK(writeTraced(options.picture.output, job, result, figures));
    if (options.picture.statsFile.empty())
        return {};
    return writeFile(options.picture.statsFile, traceStatsJson(job, inputs, result, figures));
}

} // namespace

void addTraceCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<TraceOptions>();
    CLI::App* const command = program.add_subcommand("trace", "Reflections for a G-buffer in OpenEXR files");
    command->add_option("GBUFFER", options->picture.scene, "OpenEXR file with depth, normals and materials");
    command->add_option("--color", options->color, "OpenEXR file of the lit picture (default: layers of GBUFFER)");
    command->add_option("--camera", options->picture.camera, "Camera file: the view of the G-buffer");
    command->add_option("--mapping", options->mapping,
                        "What the layers are called and mean: a JSON file, blender or glint (default: what fits)");
    command->add_flag("--print-mapping", options->printMapping, "Print the mapping preset of --mapping and exit");
    command->add_option("--env", options->picture.environment,
                        "Environment that rays which leave the screen show: an .hdr or .exr file, sky or none");
    command->add_option("--probes", options->picture.probes, "Reflection probes: a file of glint bake");
    addFrameOptions(*command, options->picture);
    addOutputOptions(*command, options->picture);
    addDeviceOptions(*command, options->picture);
    command->callback([&chosen, options] { chosen = [options] { return trace(*options); }; });
}

} // namespace glint::cli
