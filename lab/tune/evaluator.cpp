#include "lab/tune/evaluator.hpp"

#include "lab/measure/bench/floor_pass.hpp"
#include "lab/measure/figures/flip.hpp"
#include "lab/measure/figures/image_error.hpp"
#include "lab/session/settled_frames.hpp"
#include "lab/tune/frame_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace glint::tune {
namespace {

/// An error of 0 would make the geometric mean 0, whatever the other views show.
constexpr double kLeastError = 1e-6;

bool isMeasured(const TuneView& view, uint32_t frame, uint32_t frames) {
    if (view.move == scene::CameraMove::Still)
        return frame + 1 == frames;
    return frame >= kFirstMeasured && (frame - kFirstMeasured) % kMeasuredEvery == 0;
}

} // namespace

/// One scene and camera: its session, its views and their references.
class Stage {
public:
    Stage(render::ReflectionSession session, render::RenderJob job, const EvaluationPlan& plan,
          measure::FloorPass floor)
        : session_(std::move(session)), job_(std::move(job)), plan_(plan), floor_(std::move(floor)) {
        const render::JobInputs& inputs = session_.inputs();
        for (const ViewSet set : {ViewSet::Search, ViewSet::Held})
            views_[index(set)] = makeViews(set, job_, inputs.camera, inputs.pose.boundsWS, inputs.height, plan_.paths);
    }

    const render::JobInputs& inputs() const { return session_.inputs(); }

    Result<void> makeReferences(ViewSet set, const Evaluator::Progress& progress) {
        std::vector<std::vector<render::RenderedView>>& references = references_[index(set)];
        if (!references.empty())
            return {};
        render::ProgramSettings settings = plan_.reference;
        settings.render = job_.settings.render;
        GLINT_CHECK(session_.setSettings(settings));
        for (const TuneView& view : views_[index(set)]) {
            if (progress)
                progress("reference of " + view.name);
            GLINT_TRY(pictures, referenceOf(view));
            references.push_back(std::move(pictures));
            GLINT_TRY(rough, roughShare(session_));
            rough_[index(set)].add(rough, 1 / static_cast<double>(views_[index(set)].size()));
        }
        return {};
    }

    size_t viewCount(ViewSet set) const { return views_[index(set)].size(); }

    /// Adds a figure for each view, and takes its cost from `left`, what the sum over views may still cost. Returns
    /// false if the candidate costs more and was given up.
    Result<bool> evaluate(const Settings& settings, ViewSet set, double& left, std::vector<ViewFigures>& figures) {
        render::ProgramSettings program = job_.settings;
        program.reflections = settings;
        GLINT_CHECK(session_.setSettings(program));
        for (size_t i = 0; i < views_[index(set)].size(); ++i) {
            const TuneView& view = views_[index(set)][i];
            if (i == 0)
                session_.restartAccumulation(view.seed); // new settings have no history
            else
                GLINT_CHECK(session_.restart(view.seed));
            GLINT_TRY(judged, judge(settings, set, view, references_[index(set)][i], left));
            if (!judged)
                return false;
            left -= judged->cost;
            figures.push_back({view.name, *judged});
        }
        return true;
    }

    /// The effect alone, drawn again and again over one G-buffer.
    Result<Timing> time(const Settings& settings, uint32_t frames) {
        render::ProgramSettings program = job_.settings;
        program.reflections = settings;
        GLINT_CHECK(session_.setSettings(program));
        const TuneView& view = views_[index(ViewSet::Search)].front();
        GLINT_CHECK(moveTo(view, kMovingFrames / 2));
        measure::EffectTimes times;
        GLINT_TRY(drawn, session_.renderFrame(0));
        times.addDrawn(drawn);
        render::FrameRequest effect;
        effect.draw = false;
        effect.afterOpaque = [this](gpu::Frame& frame, render::GBuffer& gbuffer) { floor_.record(frame, gbuffer); };
        for (uint32_t i = 0; i < frames; ++i) {
            GLINT_TRY(timed, session_.renderFrame(i + 1, effect));
            times.add(timed);
        }
        return Timing{times.floorMultiple(), times.total().median};
    }

private:
    static size_t index(ViewSet set) { return static_cast<size_t>(set); }

    Result<void> moveTo(const TuneView& view, uint32_t frame) {
        const bool still = view.move == scene::CameraMove::Still;
        const double seconds = frame / render::kFramesPerSecond;
        if (!session_.inputs().scene->animations.empty())
            GLINT_CHECK(session_.setTime(job_.time + (still ? 0 : seconds)));
        return session_.setCamera(view.path.at(seconds));
    }

    /// A picture for each measured frame of the view.
    Result<std::vector<render::RenderedView>> referenceOf(const TuneView& view) {
        constexpr uint32_t kOtherNoise = 0x9e37; // the reference shares no noise with candidates
        const bool still = view.move == scene::CameraMove::Still;
        const uint32_t frames = still ? 1 : kMovingFrames;
        std::vector<render::RenderedView> pictures;
        for (uint32_t frame = 0; frame < frames; ++frame) {
            if (!isMeasured(view, frame, frames))
                continue;
            GLINT_CHECK(moveTo(view, frame));
            session_.restartAccumulation(view.seed + kOtherNoise);
            for (uint32_t i = 0; i < plan_.referenceFrames; ++i) {
                render::FrameRequest plan;
                plan.draw = i == 0 || i + 1 == plan_.referenceFrames; // transparent surfaces belong over the last one
                GLINT_CHECK(session_.renderFrame(frame * plan_.referenceFrames + i, plan));
            }
            GLINT_TRY(picture, session_.readView("composite"));
            pictures.push_back(std::move(picture));
        }
        return pictures;
    }

    /// No value: the candidate was given up.
    Result<std::optional<Figures>> judge(const Settings& settings, ViewSet set, const TuneView& view,
                                         const std::vector<render::RenderedView>& references, double mostCost) {
        const bool still = view.move == scene::CameraMove::Still;
        const uint32_t frames = still ? render::settledFrames(settings) : kMovingFrames;
        const bool readsLast = settings.screen.enabled && settings.screen.colorSource == ColorSource::Previous;
        if (!still) { // the first frame shows no motion
            GLINT_CHECK(moveTo(view, 0));
            render::FrameRequest draw;
            draw.reflect = false;
            GLINT_CHECK(session_.renderFrame(0, draw));
        }
        measure::EffectTimes times;
        double counted = 0, error = 0;
        size_t next = 0; // reference
        for (uint32_t frame = 0; frame < frames; ++frame) {
            if (!still || frame == 0)
                GLINT_CHECK(moveTo(view, frame));
            render::FrameRequest plan;
            plan.draw = !still || frame == 0 || frame + 1 == frames || readsLast;
            GLINT_TRY(drawn, session_.renderFrame(frame, plan));
            times.add(drawn);
            if (plan.draw)
                times.addDrawn(drawn);
            if (frame == 0 || frame + 1 == frames)
                counted = countedFloors(frameWork(settings, session_, drawn, plan.draw, rough_[index(set)]));
            if (frame == 0 && costOf(counted, times) > mostCost)
                return std::optional<Figures>();
            if (isMeasured(view, frame, frames)) {
                GLINT_TRY(picture, session_.readView("composite"));
                error += errorOf(references[next++], picture);
            }
        }
        error /= static_cast<double>(references.size());
        return std::optional(Figures{costOf(counted, times), std::isnan(error) ? kInfinite : error});
    }

    double errorOf(const render::RenderedView& reference, const render::RenderedView& picture) const {
        if (plan_.metric == ErrorMetric::RelativeMse)
            return measure::relativeMse(reference.rgba, picture.rgba);
        const render::JobInputs& inputs = session_.inputs();
        return measure::flip({inputs.width, inputs.height, reference.rgb8}, {inputs.width, inputs.height, picture.rgb8})
            .mean;
    }

    double costOf(double counted, const measure::EffectTimes& times) const {
        return plan_.counted ? counted : times.total().median;
    }

    render::ReflectionSession session_;
    render::RenderJob job_;
    const EvaluationPlan& plan_;
    measure::FloorPass floor_;
    std::array<std::vector<TuneView>, 2> views_; ///< by ViewSet
    std::array<std::vector<std::vector<render::RenderedView>>, 2> references_ =
        {};                           ///< by ViewSet, view and measured frame
    std::array<RoughShare, 2> rough_; ///< by ViewSet: roughShare, mean over views
};

struct Evaluator::State {
    EvaluationPlan plan;
    Progress progress;
    std::vector<Stage> stages;
};

Evaluator::Evaluator(std::unique_ptr<State> state) : state_(std::move(state)) {}
Evaluator::Evaluator(Evaluator&&) noexcept = default;
Evaluator& Evaluator::operator=(Evaluator&&) noexcept = default;
Evaluator::~Evaluator() = default;

Result<Evaluator> Evaluator::create(gpu::Context& context, EvaluationPlan plan, Progress progress) {
    auto state = std::make_unique<State>();
    state->plan = std::move(plan);
    state->progress = std::move(progress);
    state->stages.reserve(state->plan.jobs.size());
    for (const render::RenderJob& planned : state->plan.jobs) {
        render::RenderJob job = planned;
        job.statistics = true; // lookups and rays are what cost is counted by
        job.display = true;
        if (state->progress)
            state->progress("reading " + job.scene);
        GLINT_TRY(session, render::openJob(context, job));
        GLINT_TRY(floor, measure::FloorPass::create(context, session.inputs().width, session.inputs().height));
        state->stages.emplace_back(std::move(session), std::move(job), state->plan, std::move(floor));
    }
    return Evaluator(std::move(state));
}

Result<Evaluation> Evaluator::evaluate(const Settings& settings, ViewSet set, double mostCost) {
    for (Stage& stage : state_->stages)
        GLINT_CHECK(stage.makeReferences(set, state_->progress));
    Evaluation evaluation;
    double left = 0;
    for (const Stage& stage : state_->stages)
        left += mostCost * static_cast<double>(stage.viewCount(set));
    for (Stage& stage : state_->stages) {
        GLINT_TRY(judged, stage.evaluate(settings, set, left, evaluation.views));
        if (!judged)
            return Evaluation{{kInfinite, kInfinite}, {}, mostCost};
    }
    evaluation.figures = combine(evaluation.views);
    return evaluation;
}

Result<Timing> Evaluator::time(const Settings& settings, uint32_t frames) {
    Timing sum;
    for (Stage& stage : state_->stages) {
        GLINT_TRY(timing, stage.time(settings, frames));
        sum.floors += timing.floors / static_cast<double>(state_->stages.size());
        sum.ms += timing.ms / static_cast<double>(state_->stages.size());
    }
    return sum;
}

std::array<uint32_t, 2> Evaluator::size() const {
    const render::JobInputs& inputs = state_->stages.front().inputs();
    return {inputs.width, inputs.height};
}

Figures combine(const std::vector<ViewFigures>& views) {
    double cost = 0, logError = 0;
    for (const ViewFigures& view : views) {
        cost += view.figures.cost;
        logError += std::log(std::max(view.figures.error, kLeastError));
    }
    const auto count = static_cast<double>(views.size());
    return {cost / count, std::exp(logError / count)};
}

} // namespace glint::tune
