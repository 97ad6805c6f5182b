#include "lab/session/trace_job.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "lab/session/file_host.hpp"
#include "lab/session/run_job.hpp"

#include <algorithm>
#include <cmath>

namespace glint::render {
namespace {

struct MappedLayers {
    scene::GBufferMapping mapping;
    scene::GBufferLayers layers;
};

/// `motion`: read it too.
Result<MappedLayers> readWith(scene::GBufferMapping mapping, const scene::ExrChannels& surfaces,
                              const scene::ExrChannels& colors, bool motion) {
    if (!motion)
        mapping.motion.clear();
    GLINT_TRY(layers, scene::readLayers(surfaces, colors, mapping));
    return MappedLayers{std::move(mapping), std::move(layers)};
}

/// Reads with the preset whose required layers the file has. What is wrong with the layers themselves is an error of
/// the file: another preset would not read them better.
Result<MappedLayers> readWithFittingPreset(const scene::ExrChannels& surfaces, const scene::ExrChannels& colors,
                                           bool motion) {
    std::string misses;
    for (const std::string_view name : scene::mappingPresets()) {
        GLINT_TRY(mapping, scene::readMapping(std::string(name)));
        const Result<void> found = scene::findLayers(surfaces, colors, mapping);
        if (found)
            return readWith(std::move(mapping), surfaces, colors, motion);
        misses = found.error().message;
    }
    std::vector<std::string> names;
    for (const std::string_view name : scene::mappingPresets())
        names.emplace_back(name);
    return invalidInput("{}: its layers are those of neither preset ({}): write a mapping file and name it with "
                        "--mapping (docs/trace.md); the last preset misses: {}",
                        surfaces.name(), listText(names, " and "), misses);
}

Result<MappedLayers> readMapped(const std::string& asked, const scene::ExrChannels& surfaces,
                                const scene::ExrChannels& colors, bool motion) {
    if (asked.empty())
        return readWithFittingPreset(surfaces, colors, motion);
    GLINT_TRY(mapping, scene::readMapping(asked));
    return readWith(std::move(mapping), surfaces, colors, motion);
}

Result<void> checkAspect(const scene::Camera& camera, const scene::GBufferPixels& pixels, const RenderJob& job) {
    const float aspect = static_cast<float>(pixels.width) / static_cast<float>(pixels.height);
    constexpr float kTolerance = 0.01f;
    if (camera.aspectRatio > 0 && std::abs(camera.aspectRatio / aspect - 1) > kTolerance)
        return invalidInput("{}: the camera is made for {}x{} pixels, but {} has {}x{}: correct width and height, or "
                            "leave them out",
                            printable(job.camera), camera.width, camera.height, printable(job.scene), pixels.width,
                            pixels.height);
    return {};
}

Result<void> checkSize(const TraceJob& job, const JobInputs& inputs, const JobInputs& first) {
    if (inputs.width == first.width && inputs.height == first.height)
        return {};
    return invalidInput("{}: has {}x{} pixels, but the first frame has {}x{}: the frames of a sequence have one size",
                        printable(job.picture.scene), inputs.width, inputs.height, first.width, first.height);
}

} // namespace

Result<TraceInputs> loadTraceInputs(const TraceJob& job, const scene::Camera* previous) {
    const RenderJob& picture = job.picture;
    GLINT_TRY(camera, scene::readCameraFile(picture.camera));
    GLINT_TRY(surfaces, scene::ExrChannels::open(picture.scene));
    std::optional<scene::ExrChannels> other;
    if (!job.color.empty()) {
        GLINT_TRY(opened, scene::ExrChannels::open(job.color));
        other = std::move(opened);
    }
    const scene::ExrChannels& colors = other ? *other : surfaces;
    GLINT_TRY(mapped, readMapped(job.mapping, surfaces, colors, previous != nullptr));
    TraceInputs inputs;
    inputs.health = scene::examine(mapped.layers, mapped.mapping, camera, previous);
    auto decoded = scene::decodeLayers(mapped.layers, mapped.mapping, camera, surfaces.name());
    if (!decoded) // the cause may be known
        return invalidInput("{}{}", decoded.error().message,
                            inputs.health.findings.empty() ? "" : "; " + inputs.health.findings.front());
    auto pixels = std::make_shared<scene::GBufferPixels>(*std::move(decoded));
    GLINT_CHECK(checkAspect(camera, *pixels, picture));

    inputs.frame = std::make_shared<JobInputs>();
    inputs.frame->camera = camera;
    inputs.frame->width = pixels->width;
    inputs.frame->height = pixels->height;
    for (const std::string& finding : inputs.health.findings)
        inputs.frame->notes.push_back(fmt::format("{}: {}", surfaces.name(), finding));
    inputs.frame->notes.insert(inputs.frame->notes.end(), pixels->notes.begin(), pixels->notes.end());
    if (job.asksForRays)
        inputs.frame->notes.emplace_back("a G-buffer has no triangles: rays take no part, whatever the settings of "
                                         "rays say");
    if (!picture.environment.empty())
        GLINT_CHECK(loadEnvironment(picture.environment, *inputs.frame));
    if (!picture.probes.empty()) {
        GLINT_TRY(probes, readProbes(picture.probes));
        inputs.frame->notes.push_back(fmt::format("the probes of {} were baked from {}; whether they fit this G-buffer "
                                                  "is not checked",
                                                  printable(picture.probes), printable(probes.scene)));
        inputs.probes = std::make_shared<ProbeSet>(std::move(probes));
    }
    inputs.pixels = std::move(pixels);
    return inputs;
}

Result<RenderResult> runTraces(gpu::Context& context, std::span<const TraceJob> jobs, const TraceInputs& first,
                               const TakeTraced& take) {
    GLINT_ASSERT(!jobs.empty(), "no frames");
    FileHost* host = nullptr;
    const auto makeHost = [&](Context& library) -> Result<std::unique_ptr<HostFrame>> {
        GLINT_TRY(made, FileHost::create(context, library, first.frame, first.pixels, first.probes,
                                         jobs.front().picture.settings));
        host = made.get();
        return std::unique_ptr<HostFrame>(std::move(made));
    };
    GLINT_TRY(session, ReflectionSession::create(context, makeHost, sessionOptions(jobs.front().picture)));
    TraceInputs inputs = first;
    Result<RenderResult> last = renderFrames(session, jobs.front().picture);
    if (!last)
        return last;
    GLINT_CHECK(take(0, inputs, *last));
    for (size_t frame = 1; frame < jobs.size(); ++frame) {
        const scene::Camera previous = inputs.frame->camera;
        GLINT_TRY(next, loadTraceInputs(jobs[frame], &previous));
        GLINT_CHECK(checkSize(jobs[frame], *next.frame, *first.frame));
        inputs = std::move(next);
        GLINT_CHECK(host->setFrame(inputs.frame, inputs.pixels));
        RenderJob once = jobs[frame].picture;
        once.frames = 1;
        last = renderFrames(session, once, jobs.front().picture.frames + static_cast<uint32_t>(frame) - 1);
        if (!last)
            return last;
        GLINT_CHECK(take(frame, inputs, *last));
    }
    return last;
}

Result<RenderResult> runTraces(std::span<const TraceJob> jobs, const TraceInputs& first, const TakeTraced& take) {
    return onOwnDevice(jobs.front().picture,
                       [&](gpu::Context& context) { return runTraces(context, jobs, first, take); });
}

} // namespace glint::render
