// glint trace: reflections for a G-buffer that another renderer wrote to OpenEXR files (docs/trace.md).
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/file_roles.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/cli/render/render_output.hpp"
#include "lab/cli/sequence/sequence_files.hpp"
#include "lab/cli/trace/trace_output.hpp"
#include "lab/session/settled_frames.hpp"
#include "lab/session/trace_job.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace glint::cli {
namespace {

/// The options as the user wrote them.
struct TraceOptions {
    RenderOptions picture;
    std::string color;
    std::string mapping;
    std::string sequence; ///< "1-24"; empty: one frame
    bool printMapping = false;
};

/// An EXR file has these layers besides those of --view.
constexpr std::string_view kLayers[] = {"composite", "reflection", "weight", "weights", "outcome"};

void addOnce(std::vector<std::string>& names, std::string_view name) {
    if (std::ranges::find(names, name) == names.end())
        names.emplace_back(name);
}

/// True if the user asked for rays by --set or a settings file, and not only for a preset that has them.
Result<bool> namesRays(const render::SettingsRequest& request, const Settings& settings) {
    if (!settings.rays.enabled)
        return false;
    if (std::ranges::any_of(request.assignments, [](const std::string& one) { return one.starts_with("rays."); }))
        return true;
    GLINT_TRY(preset, render::loadSettings({{}, request.preset, {}, {}}));
    return !preset.reflections.rays.enabled;
}

Result<render::TraceJob> makeTraceJob(const TraceOptions& options) {
    if (options.picture.scene.empty())
        return invalidArgument("GBUFFER is required: an OpenEXR file");
    if (options.picture.camera.empty())
        return invalidArgument("--camera is required: a camera file with the view that the G-buffer was rendered from");
    render::TraceJob job;
    GLINT_TRY(picture, makeRenderJob(options.picture));
    job.picture = std::move(picture);
    Settings& settings = job.picture.settings.reflections;
    GLINT_TRY(asks, namesRays(options.picture.settings, settings));
    job.asksForRays = asks;
    settings.rays.enabled = false; // presets have them, a G-buffer has no triangles
    if (!options.picture.frames)
        job.picture.frames = render::settledFrames(settings);
    job.color = options.color;
    job.mapping = options.mapping;
    GLINT_TRY(kind, pictureKind(options.picture.output));
    if (kind == PictureKind::Exr)
        for (const std::string_view name : kLayers)
            addOnce(job.picture.views, name);
    return job;
}

/// Adds the views that figures and the specular layer are computed from.
render::TraceJob withInnerViews(const render::TraceJob& job) {
    render::TraceJob more = job;
    for (const std::string_view name : {"composite", "scene", "weights", "roughness", "reflectivity"})
        addOnce(more.picture.views, name);
    return more;
}

/// The files of one frame of a sequence.
TraceOptions numbered(TraceOptions options, uint32_t frame) {
    for (std::string* path : {&options.picture.scene, &options.picture.camera, &options.color, &options.picture.output,
                              &options.picture.statsFile})
        *path = numberedPath(*path, frame);
    return options;
}

/// The first frame and the last of "1-24"; without --sequence the one frame 0.
Result<std::pair<uint32_t, uint32_t>> frameRange(const std::string& text) {
    constexpr uint32_t kMostFrames = 100000;
    if (text.empty())
        return std::pair<uint32_t, uint32_t>(0, 0);
    uint32_t first = 0, last = 0;
    const char* const end = text.data() + text.size();
    const auto [dash, noFirst] = std::from_chars(text.data(), end, first);
    const auto [rest, noLast] = std::from_chars(dash == end ? end : dash + 1, end, last);
    if (noFirst != std::errc() || noLast != std::errc() || *dash != '-' || rest != end || last < first ||
        last - first >= kMostFrames)
        return invalidArgument("--sequence {}: expected the numbers of the first frame and the last, as in 1-24",
                               printable(text));
    return std::pair(first, last);
}

/// One job per frame.
Result<std::vector<TraceOptions>> framesOf(const TraceOptions& options) {
    GLINT_TRY(range, frameRange(options.sequence));
    const auto [first, last] = range;
    std::vector<TraceOptions> frames;
    if (options.sequence.empty())
        return std::vector{options};
    for (const auto& [name, path] : {std::pair("GBUFFER", &options.picture.scene), {"-o", &options.picture.output}})
        if (numberedPath(*path, 0) == numberedPath(*path, 1))
            return invalidArgument("{} {}: --sequence needs %d or %04d in it, for the number of the frame", name,
                                   printable(*path));
    for (uint32_t frame = first; frame <= last; ++frame)
        frames.push_back(numbered(options, frame));
    return frames;
}

/// Frames are written one by one, so that an early one's output may be what a later one reads: all are compared.
Result<void> checkFiles(const std::vector<TraceOptions>& frames) {
    std::vector<NamedFile> inputs, outputs;
    for (const TraceOptions& frame : frames) {
        for (NamedFile& file : inputFiles(frame.picture))
            inputs.push_back({file.option == "SCENE" ? "GBUFFER" : std::move(file.option), std::move(file.path)});
        inputs.push_back({"--color", frame.color});
        if (!scene::mappingPresetText(frame.mapping))
            inputs.push_back({"--mapping", frame.mapping});
        for (NamedFile& file : outputFiles(frame.picture))
            outputs.push_back(std::move(file));
    }
    return checkOutputs(inputs, outputs);
}

/// Each kind of note once: those of a sequence's frames differ in numbers alone.
class Notes {
public:
    void print(const std::vector<std::string>& notes) {
        for (const std::string& note : notes) {
            std::string kind = note;
            std::erase_if(kind, [](char c) { return c >= '0' && c <= '9'; });
            if (printed_.insert(kind).second)
                log::warning("{}", note);
        }
    }

private:
    std::set<std::string> printed_;
};

Result<void> printMapping(const std::string& name) {
    GLINT_TRY(text, scene::mappingPresetText(name.empty() ? "blender" : name));
    fmt::print("{}", text);
    return {};
}

Result<void> trace(const TraceOptions& options) {
    if (options.printMapping)
        return printMapping(options.mapping);
    GLINT_TRY(frames, framesOf(options));
    std::vector<render::TraceJob> jobs, more; // as asked for, and with what figures need
    for (const TraceOptions& frame : frames) {
        GLINT_TRY(job, makeTraceJob(frame));
        jobs.push_back(job);
        more.push_back(withInnerViews(job));
    }
    GLINT_CHECK(checkFiles(frames));
    GLINT_TRY(first, render::loadTraceInputs(jobs.front()));
    Notes notes;
    const auto take = [&](size_t frame, const render::TraceInputs& inputs,
                          const render::RenderResult& result) -> Result<void> {
        notes.print(result.notes);
        const TraceFigures figures = traceFigures(jobs[frame], inputs, result);
        GLINT_CHECK(writeTraced(frames[frame].picture.output, jobs[frame], result, figures));
        const std::string& stats = frames[frame].picture.statsFile;
        return stats.empty() ? Result<void>() : writeFile(stats, traceStatsJson(jobs[frame], inputs, result, figures));
    };
    GLINT_CHECK(render::runTraces(more, first, take));
    return {};
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
    command->add_option("--sequence", options->sequence,
                        "Numbers of the first frame and the last, as 1-24; %04d in a file's name is the number");
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
