#include "reflect/trace/transparents.hpp"

#include <optional>

namespace glint::reflect {

Result<std::unique_ptr<TransparentTrace>> TransparentTrace::create(StageContext& stages) {
    std::unique_ptr<TransparentTrace> trace(new TransparentTrace(stages));
    GLINT_TRY(surface, gpu::Pipeline::compute(stages.gpu, {"prepare/transparents", 0, {}}));
    GLINT_TRY(backFaces, gpu::Pipeline::compute(stages.gpu, {"prepare/back_faces", 0, {}}));
    GLINT_TRY(pyramid, DepthPyramid::create(stages));
    trace->surfacePass_ = std::move(surface);
    trace->backFacesPass_ = std::move(backFaces);
    trace->pyramid_ = std::move(pyramid);
    trace->marchers_.resize(techniques().size());
    const uint32_t w = stages.width();
    const uint32_t h = stages.height();
    GLINT_CHECK(makeImage(stages.gpu, trace->viewZ_, {"glint/transparentViewZ", VK_FORMAT_R32_SFLOAT, w, h}));
    GLINT_CHECK(makeImage(stages.gpu, trace->surface_, {"glint/transparentSurface", VK_FORMAT_R32G32_UINT, w, h}));
    GLINT_CHECK(
        makeImage(stages.gpu, trace->backViewZ_, {"glint/transparentBackViewZ", VK_FORMAT_R32_SFLOAT, w, h, kCleared}));
    return trace;
}

bool TransparentTrace::wanted(const Settings& settings) {
    const ScreenSettings& screen = settings.screen;
    return screen.enabled && screen.transparents && screen.colorSource == ColorSource::Previous;
}

Result<void> TransparentTrace::make(const Settings& settings) {
    const Technique& technique = techniqueFor(settings.screen.march);
    gpu::Pipeline& marcher = marchers_[indexOf(technique)];
    if (technique.usesPyramid)
        GLINT_CHECK(pyramid_->make());
    if (marcher)
        return {};
    constexpr uint32_t kAmongTransparents = 1; // shaders/trace/met_surface.glsl
    GLINT_TRY(made, gpu::Pipeline::compute(stages_.gpu, {technique.shader, 0, {{kAmongTransparents, 1}}}));
    marcher = std::move(made);
    return {};
}

void TransparentTrace::clear(gpu::Frame& frame) {
    pyramid_->clear(frame);
}

void TransparentTrace::record(gpu::Frame& frame, const StageInputs& stage) {
    const TraceInputs& inputs = stage.trace;
    if (!frame.rehearsing() && !(inputs.frame.host.transparentDepth && inputs.previous))
        return;
    const Technique& technique = techniqueFor(stages_.settings().screen.march);
    Inputs& host = inputs.frame.host;
    const Prepared& solid = inputs.prepared;
    const bool backFacesKnown = solid.backFacesKnown && stages_.settings().screen.backfaceTransparents;
    const Prepared seen = {viewZ_, surface_, solid.material, solid.edge, backViewZ_, backFacesKnown, false, surface_};
    std::optional<PreviousFrame> previous;
    if (inputs.previous)
        previous.emplace(
            PreviousFrame{inputs.previous->withLayers, inputs.previous->withLayers, inputs.previous->viewZ});
    const auto recordPasses = [&] {
        frame.pass(surfacePass_)
            .read("frame", inputs.frame.constants)
            .read("viewZ", solid.viewZ)
            .read("transparentDepth", host.transparentDepth, kTexels)
            .write("transparentViewZ", viewZ_)
            .write("transparentSurface", surface_)
            .dispatch(stages_.extent.x, stages_.extent.y);
        if (backFacesKnown || frame.rehearsing())
            frame.pass(backFacesPass_)
                .read("frame", inputs.frame.constants)
                .read("backDepth", host.backDepth, kTexels)
                .read("viewZ", viewZ_)
                .read("resolvedMaterial", solid.material)
                .read("edge", solid.edge)
                .write("backViewZ", backViewZ_)
                .dispatchIndirect(inputs.rays.list, offsetof(shared::RayListHeader, backFaceGroups));
        else
            frame.clear(backViewZ_, {.float32 = {shared::kBackgroundZ}});
        if (technique.usesPyramid)
            pyramid_->record(frame, inputs.frame, seen, &inputs.rays);
        recordMarch(frame, technique, marchers_[indexOf(technique)],
                    {.frame = inputs.frame,
                     .prepared = solid,
                     .met = {viewZ_, surface_, backViewZ_},
                     .rays = inputs.rays,
                     .pyramid = pyramid_->pyramid(),
                     .previous = previous,
                     .probes = inputs.probes,
                     .conePicture = nullptr},
                    stage.target);
    };
    frame.scope("trace/transparents", [&] { frame.untimed(recordPasses); });
}

} // namespace glint::reflect
