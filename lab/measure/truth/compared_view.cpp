#include "lab/measure/truth/compared_view.hpp"

#include "lab/session/run_job.hpp"
#include "lab/session/settled_frames.hpp"
#include "lab/session/views.hpp"

namespace glint::measure {

Result<ComparedView> ComparedView::open(gpu::Context& context, const render::RenderJob& job) {
    render::RenderJob first = job;
    first.display = true;
    first.statistics = true;
    GLINT_TRY(session, render::openJob(context, first));
    GLINT_TRY(floor, FloorPass::create(context, session.inputs().width, session.inputs().height));
    ComparedView view(std::move(session), std::move(floor), job.seed);
    view.makeExactPicture();
    return view;
}

void ComparedView::makeExactPicture() {
    const render::JobInputs& inputs = session_.inputs();
    if (inputs.environment != render::EnvironmentKind::None) {
        noExact_ = "the scene has an environment, so no exact picture exists";
        return;
    }
    auto exact = exactPicture(*inputs.scene, inputs.pose, session_.view().worldToClip, width(), height());
    if (exact)
        exact_ = std::move(exact).value();
    else
        noExact_ = exact.error().message;
}

Result<ReferenceImages> ComparedView::drawReference(const ComparedConfig& reference) {
    GLINT_CHECK(session_.setSettings(reference.job.settings));
    GLINT_CHECK(useSeed(reference.job.seed));
    for (uint32_t frame = 0; frame < reference.job.frames; ++frame)
        GLINT_CHECK(session_.renderFrame(frame));
    GLINT_TRY(picture, session_.readView("composite"));
    GLINT_TRY(roughness, session_.readView("roughness"));
    GLINT_TRY(reflectivity, session_.readView("reflectivity"));
    return ReferenceImages{std::move(picture.rgb8), std::move(picture.rgba), std::move(roughness.rgba),
                           std::move(reflectivity.rgba)};
}

void ComparedView::setReference(const ReferenceImages& images) {
    reference_ = ReferencePicture(images.radiance, images.roughness, images.reflectivity);
}

Result<ConfigFigures> ComparedView::measure(const ComparedConfig& config, const Amount& amount, const Drawn& drawn) {
    ConfigFigures figures;
    figures.name = config.name;
    figures.settings = config.job.settings;
    GLINT_CHECK(session_.setSettings(config.job.settings));
    GLINT_CHECK(useSeed(config.job.seed));
    GLINT_TRY(last, timeFrames(figures.times, config.job.settings, amount.frames));
    GLINT_CHECK(takePictures(figures));
    if (drawn)
        GLINT_CHECK(drawn(session_, last));
    for (uint32_t i = 1; i < amount.seeds; ++i)
        GLINT_CHECK(addSeed(config.job.seed + i, amount.frames, figures));
    if (amount.hits)
        GLINT_CHECK(measureHits(figures));
    return figures;
}

/// After setSettings, which starts without a history too.
Result<void> ComparedView::useSeed(uint32_t seed) {
    if (seed == seed_)
        return {};
    seed_ = seed;
    return session_.restart(seed);
}

/// Draws the whole frame once, then the effect alone; finally the whole frame again, whose images are used. Returns the
/// times of that one.
Result<render::FrameTimes> ComparedView::timeFrames(EffectTimes& measured, const render::ProgramSettings& settings,
                                                    uint32_t frames) {
    render::FrameRequest effect;
    effect.draw = false;
    effect.afterOpaque = [this](gpu::Frame& frame, render::GBuffer& gbuffer) { floor_.record(frame, gbuffer); };
    uint32_t index = 0;
    GLINT_CHECK(session_.renderFrame(index++));
    for (uint32_t i = 0; i < frames; ++i) {
        GLINT_TRY(times, session_.renderFrame(index++, effect));
        measured.add(times);
    }
    for (const uint32_t settled = render::settledFrames(settings.reflections); index + 1 < settled;)
        GLINT_CHECK(session_.renderFrame(index++, effect));
    GLINT_TRY(drawn, session_.renderFrame(index));
    measured.addDrawn(drawn);
    return drawn;
}

Result<void> ComparedView::takePictures(ConfigFigures& figures) {
    GLINT_TRY(composite, session_.readView("composite"));
    figures.composite = std::move(composite.rgb8);
    if (exact_)
        figures.exact = compareMirrors(*exact_, composite.rgba);
    if (reference_)
        figures.reference = reference_->errorOf(composite.rgba);
    GLINT_TRY(outcome, session_.readView("outcome"));
    figures.outcome = render::displayBytes(render::ViewKind::Fraction, outcome.rgba);
    GLINT_TRY(source, session_.readView("source"));
    figures.source = render::displayBytes(render::ViewKind::Fraction, source.rgba);
    if (withoutReflections_.empty()) {
        GLINT_TRY(scene, session_.readView("scene"));
        withoutReflections_ = std::move(scene.rgb8);
    }
    figures.stats = session_.stats();
    figures.notes = session_.notes();
    return {};
}

Result<void> ComparedView::addSeed(uint32_t seed, uint32_t frames, ConfigFigures& figures) {
    SeedFigures again;
    again.seed = seed;
    EffectTimes times;
    GLINT_CHECK(useSeed(seed));
    GLINT_CHECK(timeFrames(times, figures.settings, frames));
    again.floorMultiple = times.floorMultiple();
    GLINT_TRY(composite, session_.readView("composite"));
    again.composite = std::move(composite.rgb8);
    if (exact_)
        again.exact = compareMirrors(*exact_, composite.rgba);
    if (reference_)
        again.reference = reference_->errorOf(composite.rgba);
    figures.seeds.push_back(std::move(again));
    return {};
}

Result<void> ComparedView::measureHits(ConfigFigures& figures) {
    GLINT_CHECK(session_.setSettings(hitSettings(figures.settings)));
    GLINT_CHECK(session_.renderFrame(0));
    render::RenderResult traced;
    traced.width = width();
    traced.height = height();
    for (const std::string& name : hitViews()) {
        GLINT_TRY(view, session_.readView(name));
        traced.views.push_back(std::move(view));
    }
    GLINT_TRY(hits, truth_.judge(session_.inputs(), session_.view(), traced, statesCertainty(figures.settings)));
    figures.hits = std::move(hits);
    return {};
}

} // namespace glint::measure
