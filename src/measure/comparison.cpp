#include "measure/comparison.hpp"

#include "measure/floor_pass.hpp"
#include "measure/job_hits.hpp"
#include "render/run_job.hpp"
#include "render/settled_frames.hpp"
#include "render/views.hpp"

namespace glint::measure {
namespace {

/// Implements compareConfigs, config by config, on one session.
class Comparer {
public:
    Comparer(gpu::Context& context, render::ReflectionSession session, const std::vector<ComparedConfig>& configs,
             const std::optional<ComparedConfig>& reference, uint32_t frames, uint32_t seeds)
        : context_(context), session_(std::move(session)), configs_(configs), reference_(reference), frames_(frames),
          seeds_(seeds) {}

    Result<Comparison> run(const std::function<void(const std::string&)>& progress) {
        result_.scene = configs_.front().job.scene;
        result_.width = session_.inputs().width;
        result_.height = session_.inputs().height;
        result_.device = context_.info().name;
        result_.driver = context_.info().driver;
        result_.software = context_.info().software;
        makeExactPicture();
        GLINT_TRY(floor, FloorPass::create(context_, result_.width, result_.height));
        floor_ = std::move(floor);
        if (reference_) {
            if (progress)
                progress(reference_->name);
            GLINT_CHECK(drawReference());
        }
        for (const ComparedConfig& config : configs_) {
            if (progress)
                progress(config.name);
            ConfigFigures figures;
            figures.name = config.name;
            figures.settings = config.job.settings;
            GLINT_CHECK(session_.setSettings(config.job.settings));
            GLINT_CHECK(useSeed(config.job.seed));
            GLINT_CHECK(timeFrames(figures.times, config.job.settings));
            GLINT_CHECK(takePictures(figures));
            for (uint32_t i = 1; i < seeds_; ++i)
                GLINT_CHECK(addSeed(config.job.seed + i, figures));
            GLINT_CHECK(measureHits(figures));
            result_.configs.push_back(std::move(figures));
        }
        return std::move(result_);
    }

private:
    void makeExactPicture() {
        const render::JobInputs& inputs = session_.inputs();
        if (inputs.environment != render::EnvironmentKind::None) {
            result_.noExact = "the scene has an environment, so no exact picture exists";
            return;
        }
        auto exact =
            exactPicture(*inputs.scene, inputs.pose, session_.view().worldToClip, result_.width, result_.height);
        if (exact)
            exact_ = std::move(exact).value();
        else
            result_.noExact = exact.error().message;
    }

    Result<void> drawReference() {
        result_.reference = reference_->name;
        GLINT_CHECK(session_.setSettings(reference_->job.settings));
        GLINT_CHECK(useSeed(reference_->job.seed));
        for (uint32_t frame = 0; frame < reference_->job.frames; ++frame)
            GLINT_CHECK(session_.renderFrame(frame));
        GLINT_TRY(picture, session_.readView("composite"));
        GLINT_TRY(roughness, session_.readView("roughness"));
        GLINT_TRY(reflectivity, session_.readView("reflectivity"));
        result_.referencePicture = std::move(picture.rgb8);
        referencePicture_ = ReferencePicture(std::move(picture.rgba), roughness.rgba, reflectivity.rgba);
        return {};
    }

    /// After setSettings, which starts without a history too.
    Result<void> useSeed(uint32_t seed) {
        if (seed == seed_)
            return {};
        seed_ = seed;
        return session_.restart(seed);
    }

    /// Draws the whole frame once, then the effect alone; finally the whole frame again, whose images are used.
    Result<void> timeFrames(EffectTimes& measured, const render::ProgramSettings& settings) {
        render::FramePlan effect;
        effect.draw = false;
        effect.afterOpaque = [this](gpu::Frame& frame, render::GBuffer& gbuffer) { floor_.record(frame, gbuffer); };
        uint32_t index = 0;
        GLINT_CHECK(session_.renderFrame(index++));
        for (uint32_t i = 0; i < frames_; ++i) {
            GLINT_TRY(times, session_.renderFrame(index++, effect));
            measured.add(times);
        }
        for (const uint32_t settled = render::settledFrames(settings.reflections); index + 1 < settled;)
            GLINT_CHECK(session_.renderFrame(index++, effect));
        GLINT_TRY(drawn, session_.renderFrame(index));
        measured.addDrawn(drawn);
        return {};
    }

    Result<void> takePictures(ConfigFigures& figures) {
        GLINT_TRY(composite, session_.readView("composite"));
        figures.composite = std::move(composite.rgb8);
        if (exact_)
            figures.exact = compareMirrors(*exact_, composite.rgba);
        if (reference_)
            figures.reference = referencePicture_.errorOf(composite.rgba);
        GLINT_TRY(outcome, session_.readView("outcome"));
        figures.outcome = render::displayBytes(render::ViewKind::Fraction, outcome.rgba);
        GLINT_TRY(source, session_.readView("source"));
        figures.source = render::displayBytes(render::ViewKind::Fraction, source.rgba);
        if (result_.withoutReflections.empty()) {
            GLINT_TRY(scene, session_.readView("scene"));
            result_.withoutReflections = std::move(scene.rgb8);
        }
        figures.stats = session_.stats();
        figures.notes = session_.notes();
        return {};
    }

    Result<void> addSeed(uint32_t seed, ConfigFigures& figures) {
        SeedFigures again;
        again.seed = seed;
        EffectTimes times;
        GLINT_CHECK(useSeed(seed));
        GLINT_CHECK(timeFrames(times, figures.settings));
        again.floorMultiple = times.floorMultiple();
        GLINT_TRY(composite, session_.readView("composite"));
        again.composite = std::move(composite.rgb8);
        if (exact_)
            again.exact = compareMirrors(*exact_, composite.rgba);
        if (reference_)
            again.reference = referencePicture_.errorOf(composite.rgba);
        figures.seeds.push_back(std::move(again));
        return {};
    }

    Result<void> measureHits(ConfigFigures& figures) {
        GLINT_CHECK(session_.setSettings(hitSettings(figures.settings)));
        GLINT_CHECK(session_.renderFrame(0));
        render::RenderResult traced;
        traced.width = result_.width;
        traced.height = result_.height;
        for (const std::string& name : hitViews()) {
            GLINT_TRY(view, session_.readView(name));
            traced.views.push_back(std::move(view));
        }
        GLINT_TRY(hits, truth_.judge(session_.inputs(), session_.view(), traced));
        figures.hits = std::move(hits);
        return {};
    }

    gpu::Context& context_;
    render::ReflectionSession session_;
    const std::vector<ComparedConfig>& configs_;
    const std::optional<ComparedConfig>& reference_;
    uint32_t frames_;
    uint32_t seeds_;
    uint32_t seed_ = configs_.front().job.seed; ///< of the session
    FloorPass floor_;
    std::optional<ExactPicture> exact_;
    TruthKeeper truth_;
    ReferencePicture referencePicture_;
    Comparison result_;
};

} // namespace

Result<Comparison> compareConfigs(gpu::Context& context, const std::vector<ComparedConfig>& configs,
                                  const std::optional<ComparedConfig>& reference, uint32_t frames,
                                  const std::function<void(const std::string&)>& progress, uint32_t seeds) {
    render::RenderJob first = configs.front().job;
    first.display = true;
    first.statistics = true;
    GLINT_TRY(session, render::openJob(context, first));
    return Comparer(context, std::move(session), configs, reference, frames, seeds).run(progress);
}

} // namespace glint::measure
