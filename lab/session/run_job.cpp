#include "lab/session/run_job.hpp"

#include "lab/session/frame_mean.hpp"
#include "lab/session/scene_host.hpp"
#include "lab/session/settling.hpp"

namespace glint::render {

Result<ReflectionSession> openJob(gpu::Context& context, const RenderJob& job) {
    GLINT_TRY(loaded, loadJobInputs(job));
    auto inputs = std::make_shared<JobInputs>(std::move(loaded));
    const auto makeHost = [&](Context& library) { return SceneHost::create(context, library, inputs, job); };
    return ReflectionSession::create(context, makeHost, sessionOptions(job));
}

SessionOptions sessionOptions(const RenderJob& job) {
    return {job.settings,
            job.seed,
            job.statistics,
            job.libraryViews,
            job.inspect.has_value(),
            job.display || job.settle > 0};
}

namespace {

/// The first frames hold what the driver compiles: of fewer frames than this, the times say little.
constexpr uint32_t kTimedFrames = 3;

bool timesPasses(const RenderJob& job) {
    return job.statistics && job.passTimes;
}

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
    return runJob(session, job);
}

Result<RenderResult> runJob(ReflectionSession& session, const RenderJob& job) {
    GLINT_TRY(result, renderFrames(session, job));
    const uint32_t frames = result.settled ? result.settled->frames : job.frames;
    if (timesPasses(job) && frames < kTimedFrames)
        GLINT_CHECK(timeMore(session, frames, result));
    return result;
}

namespace {

/// True if a frame reads what was blended over the one before. Otherwise most hosts draw a still the same in every
/// frame, and once is enough.
bool readsBlended(const Settings& settings) {
    return settings.screen.enabled && settings.screen.colorSource == ColorSource::Previous;
}

/// Renders frame `i` of a job. `shown`: its picture counts.
Result<void> renderOne(ReflectionSession& session, const RenderJob& job, uint32_t firstIndex, uint32_t i, bool shown,
                       const MeanStep& mean = {}) {
    FrameRequest request;
    // The host's passes have a time besides that of the first frame, in which the driver compiles.
    const bool again = shown && (timesPasses(job) || !session.drawsAlike());
    request.draw = i == 0 || again || session.drewMotion() || mean.adds || readsBlended(job.settings.reflections);
    request.blendAgain = shown;
    request.mean = mean;
    if (shown)
        request.inspect = job.inspect;
    GLINT_CHECK(session.renderFrame(firstIndex + i, request));
    return {};
}

void showProgress(const RenderJob& job, uint32_t done, uint32_t frames) {
    if (job.progress)
        job.progress(done, frames);
}

/// A frame that is looked at is drawn as a last one is, so that the picture is that of as many frames without a look.
Result<Settled> renderUntilSettled(ReflectionSession& session, const RenderJob& job, uint32_t firstIndex) {
    Settling settling(job.settle);
    for (uint32_t i = 0; i < job.frames; ++i) {
        const uint32_t frames = i + 1;
        const bool look = frames < job.frames && Settling::looksAfter(frames);
        GLINT_CHECK(renderOne(session, job, firstIndex, i, look || frames == job.frames));
        showProgress(job, frames, job.frames);
        if (!look)
            continue;
        GLINT_TRY(picture, session.readView("composite"));
        if (settling.settled(frames, std::move(picture.rgb8)))
            return Settled{frames, settling.error()};
    }
    return Settled{job.frames, settling.error()};
}

/// Adds the mean's frames to a picture that has settled.
Result<void> smoothSettled(ReflectionSession& session, const RenderJob& job, uint32_t firstIndex, Settled& settled) {
    const uint32_t frames = smoothFramesAfter(settled.frames);
    for (uint32_t i = 0; i < frames; ++i)
        GLINT_CHECK(renderOne(session, job, firstIndex, settled.frames + i, true, meanStep(job, i, frames)));
    settled.frames += frames;
    return {};
}

} // namespace

Result<RenderResult> renderFrames(ReflectionSession& session, const RenderJob& job, uint32_t firstIndex) {
    const JobInputs& inputs = session.inputs();
    if (job.inspect && ((*job.inspect)[0] >= inputs.width || (*job.inspect)[1] >= inputs.height))
        return invalidArgument("pixel {},{} lies outside the picture of {}x{}", (*job.inspect)[0], (*job.inspect)[1],
                               inputs.width, inputs.height);
    RenderResult result;
    if (job.settle > 0) {
        GLINT_TRY(settled, renderUntilSettled(session, job, firstIndex));
        if (accumulates(job))
            GLINT_CHECK(smoothSettled(session, job, firstIndex, settled));
        result.settled = settled;
    } else {
        for (uint32_t i = 0; i < job.frames; ++i) {
            const MeanStep mean = accumulates(job) ? meanStep(job, i, job.frames) : MeanStep();
            GLINT_CHECK(renderOne(session, job, firstIndex, i, i + 1 == job.frames, mean));
            showProgress(job, i + 1, job.frames);
        }
    }
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
    if (result)
        GLINT_CHECK(checkMessages(*context));
    return result;
}

Result<void> checkMessages(const gpu::Context& context) {
    if (context.validationMessages().empty())
        return {};
    return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                     context.validationMessages().size(), context.validationMessages().front());
}

} // namespace glint::render
