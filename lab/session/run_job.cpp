#include "lab/session/run_job.hpp"

#include "lab/session/scene_host.hpp"

namespace glint::render {

Result<ReflectionSession> openJob(gpu::Context& context, const RenderJob& job) {
    GLINT_TRY(loaded, loadJobInputs(job));
    auto inputs = std::make_shared<JobInputs>(std::move(loaded));
    const auto makeHost = [&](Context& library) { return SceneHost::create(context, library, inputs, job); };
    return ReflectionSession::create(context, makeHost, sessionOptions(job));
}

SessionOptions sessionOptions(const RenderJob& job) {
    return {job.settings, job.seed, job.statistics, job.libraryViews, job.inspect.has_value(), job.display};
}

namespace {

/// The first frames hold what the driver compiles: of fewer frames than this, the times say little.
constexpr uint32_t kTimedFrames = 3;

/// Replaces the times by those of frames that follow the picture's.
Result<void> timeMore(ReflectionSession& session, uint32_t index, RenderResult& result) {
    constexpr double kEnoughMs = 2000;
    session.forgetTimes();
    double spentMs = 0;
    for (uint32_t i = 0; i < kTimedFrames && spentMs < kEnoughMs; ++i) {
        GLINT_TRY(times, session.renderFrame(index + i));
        spentMs += times.wallMs;
    }
    result.stats.passes = session.stats().passes;
    return {};
}

} // namespace

Result<RenderResult> runJob(gpu::Context& context, const RenderJob& job) {
    GLINT_TRY(session, openJob(context, job));
    GLINT_TRY(result, renderFrames(session, job));
    if (job.statistics && job.frames < kTimedFrames)
        GLINT_CHECK(timeMore(session, job.frames, result));
    return result;
}

namespace {

/// True if a frame reads what was blended over the one before. Otherwise the host draws a still the same in every
/// frame, and once is enough for all but the last, whose picture counts.
bool readsBlended(const Settings& settings) {
    return settings.screen.enabled && settings.screen.colorSource == ColorSource::Previous;
}

} // namespace

Result<RenderResult> renderFrames(ReflectionSession& session, const RenderJob& job, uint32_t firstIndex) {
    const JobInputs& inputs = session.inputs();
    if (job.inspect && ((*job.inspect)[0] >= inputs.width || (*job.inspect)[1] >= inputs.height))
        return invalidArgument("pixel {},{} lies outside the picture of {}x{}", (*job.inspect)[0], (*job.inspect)[1],
                               inputs.width, inputs.height);
    for (uint32_t i = 0; i < job.frames; ++i) {
        FramePlan plan;
        const bool last = i + 1 == job.frames;
        plan.draw = i == 0 || last || readsBlended(job.settings.reflections);
        if (last)
            plan.inspect = job.inspect;
        GLINT_CHECK(session.renderFrame(firstIndex + i, plan));
        if (job.progress)
            job.progress(i + 1, job.frames);
    }
    RenderResult result;
    result.width = session.inputs().width;
    result.height = session.inputs().height;
    for (const std::string& name : job.views) {
        GLINT_TRY(view, session.readView(name));
        result.views.push_back(std::move(view));
    }
    result.stats = session.stats();
    if (job.inspect)
        result.inspection = session.inspection();
    result.notes = session.notes();
    if (!job.environment.empty() && job.environment != "none" && !job.settings.reflections.sky.enabled)
        result.notes.emplace_back("--env lights the scene, but rays that miss do not show it: sky.enabled is off");
    return result;
}

Result<RenderResult> runJob(const RenderJob& job) {
    return onOwnDevice(job, [&](gpu::Context& context) { return runJob(context, job); });
}

Result<RenderResult> onOwnDevice(const RenderJob& job, const std::function<Result<RenderResult>(gpu::Context&)>& work) {
    GLINT_TRY(context, gpu::Context::create({job.device, job.validate}));
    Result<RenderResult> result = work(*context);
    if (result && !context->validationMessages().empty())
        return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                         context->validationMessages().size(), context->validationMessages().front());
    return result;
}

} // namespace glint::render
