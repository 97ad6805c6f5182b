#include "render/trace_job.hpp"

#include "base/text.hpp"
#include "render/file_host.hpp"
#include "render/run_job.hpp"

#include <algorithm>
#include <cmath>

namespace glint::render {
namespace {

struct MappedLayers {
    scene::GBufferMapping mapping;
    scene::GBufferLayers layers;
};

/// Reads with the preset whose required layers the file has.
Result<MappedLayers> readWithFittingPreset(const scene::ExrChannels& surfaces, const scene::ExrChannels& colors) {
    std::string misses;
    for (const std::string_view name : scene::mappingPresets()) {
        GLINT_TRY(mapping, scene::readMapping(std::string(name)));
        auto layers = scene::readLayers(surfaces, colors, mapping);
        if (layers)
            return MappedLayers{std::move(mapping), *std::move(layers)};
        misses = layers.error().message;
    }
    std::vector<std::string> names;
    for (const std::string_view name : scene::mappingPresets())
        names.emplace_back(name);
    return invalidInput("{}: its layers are those of neither preset ({}): write a mapping file and name it with "
                        "--mapping (docs/trace.md); the last preset misses: {}",
                        surfaces.name(), listText(names, " and "), misses);
}

Result<MappedLayers> readMapped(const std::string& asked, const scene::ExrChannels& surfaces,
                                const scene::ExrChannels& colors) {
    if (asked.empty())
        return readWithFittingPreset(surfaces, colors);
    GLINT_TRY(mapping, scene::readMapping(asked));
    GLINT_TRY(layers, scene::readLayers(surfaces, colors, mapping));
    return MappedLayers{std::move(mapping), std::move(layers)};
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

} // namespace

Result<TraceInputs> loadTraceInputs(const TraceJob& job) {
    const RenderJob& picture = job.picture;
    GLINT_TRY(camera, scene::readCameraFile(picture.camera));
    GLINT_TRY(surfaces, scene::ExrChannels::open(picture.scene));
    std::optional<scene::ExrChannels> other;
    if (!job.color.empty()) {
        GLINT_TRY(opened, scene::ExrChannels::open(job.color));
        other = std::move(opened);
    }
    const scene::ExrChannels& colors = other ? *other : surfaces;
    GLINT_TRY(mapped, readMapped(job.mapping, surfaces, colors));
    TraceInputs inputs;
    inputs.health = scene::examine(mapped.layers, mapped.mapping, camera);
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

Result<RenderResult> runTrace(gpu::Context& context, const TraceJob& job, const TraceInputs& inputs) {
    const auto makeHost = [&](Context& library) {
        return FileHost::create(context, library, inputs.frame, inputs.pixels, inputs.probes, job.picture.settings);
    };
    GLINT_TRY(session, ReflectionSession::create(context, makeHost, sessionOptions(job.picture)));
    return renderFrames(session, job.picture);
}

Result<RenderResult> runTrace(const TraceJob& job, const TraceInputs& inputs) {
    return onOwnDevice(job.picture, [&](gpu::Context& context) { return runTrace(context, job, inputs); });
}

} // namespace glint::render
