#include "lab/cli/sweep/sweep_meter.hpp"

#include "lab/cli/sweep/sweep_figures.hpp"
#include "lab/measure/figures/flip.hpp"
#include "lab/tune/frame_work.hpp"

#include <unistd.h>

#include <array>
#include <chrono>

namespace glint::cli {
namespace {

std::string hostName() {
    std::array<char, 256> name = {};
    return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

} // namespace

Result<void> SweepMeter::open() {
    GLINT_TRY(context, gpu::Context::create({device_, validate_}));
    context_ = std::move(context);
    return {};
}

Result<SweepResult> SweepMeter::measure(const SweepJob& job) {
    const auto begun = std::chrono::steady_clock::now();
    auto result = measured(job);
    if (!result) {
        GLINT_CHECK(reopenIfLost(result.error()));
        return result;
    }
    result->run["host"] = hostName();
    result->run["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return result;
}

/// After an error nothing of the session is used again. A device that is lost, or full, is replaced.
Result<void> SweepMeter::reopenIfLost(const Error& error) {
    view_.reset();
    openView_.clear();
    if (error.code != ErrorCode::DeviceLost && error.code != ErrorCode::OutOfMemory && !validate_)
        return {};
    context_.reset();
    return open();
}

Result<SweepResult> SweepMeter::measured(const SweepJob& job) {
    SweepResult result;
    result.description = job.description;
    result.program = program_;
    result.device = context_->info().name;
    result.driver = context_->info().driver;
    result.figures = SweepJson::object();
    result.run = SweepJson::object();
    if (job.motion)
        GLINT_CHECK(measureMotion(job, result));
    else
        GLINT_CHECK(measureStill(job, result));
    GLINT_CHECK(checkMessages());
    return result;
}

/// Opens the job's session, unless it is open. Sessions that differ in their scene or in the renderer's settings are
/// never shared: what is made when they are opened, such as probes, depends on these.
Result<void> SweepMeter::openView(const measure::ComparedConfig& config, const std::string& view) {
    if (view_ && openView_ == view)
        return {};
    view_.reset(); // before the next one, which may need the memory
    reference_.clear();
    GLINT_TRY(opened, measure::ComparedView::open(*context_, config.job));
    view_.emplace(std::move(opened));
    openView_ = view;
    return {};
}

/// From the folder, or drawn in a session of the reference's own settings and written there.
Result<measure::ReferenceImages> SweepMeter::referenceImages(const SweepReferenceJob& reference) {
    const render::RenderJob& job = reference.config.job;
    // The size of the scene's camera is known once it has been read.
    const bool sized = job.width > 0;
    if (sized)
        if (auto kept = folder_.readReference(reference.name, job.width, job.height))
            return std::move(*kept);
    GLINT_CHECK(openView(reference.config, reference.view));
    if (!sized)
        if (auto kept = folder_.readReference(reference.name, view_->width(), view_->height()))
            return std::move(*kept);
    GLINT_TRY(drawn, view_->drawReference(reference.config));
    GLINT_CHECK(folder_.writeReference(reference.name, drawn, view_->width(), view_->height()));
    return drawn;
}

Result<bool> SweepMeter::makeReference(const SweepReferenceJob& reference) {
    if (folder_.hasReference(reference.name))
        return false;
    auto images = referenceImages(reference);
    if (!images) {
        GLINT_CHECK(reopenIfLost(images.error()));
        return std::move(images).error();
    }
    GLINT_CHECK(checkMessages());
    return true;
}

Result<void> SweepMeter::measureStill(const SweepJob& job, SweepResult& result) {
    if (job.reference && (!view_ || openView_ != job.view || reference_ != job.reference->name)) {
        GLINT_TRY(images, referenceImages(*job.reference));
        GLINT_CHECK(openView(job.config, job.view));
        view_->setReference(images);
        reference_ = job.reference->name;
        referenceDisplayed_ = std::move(images.displayed);
    }
    GLINT_CHECK(openView(job.config, job.view));
    double floors = 0;
    const auto count = [&](render::ReflectionSession& session, const render::FrameTimes& last) -> Result<void> {
        GLINT_TRY(rough, tune::roughShare(session));
        const Settings& settings = job.config.job.settings.reflections;
        floors = tune::countedFloors(tune::frameWork(settings, session, last, true, rough));
        return {};
    };
    GLINT_TRY(figures, view_->measure(job.config, {.frames = job.frames, .hits = job.hits}, count));
    result.width = view_->width();
    result.height = view_->height();
    addFigure(result.figures, "cost.floors", floors);
    if (job.reference) {
        const measure::DisplayPicture reference = {result.width, result.height, referenceDisplayed_};
        addFigure(result.figures, "error.flip",
                  measure::flip(reference, {result.width, result.height, figures.composite}).mean);
    }
    addStillFigures(figures, job.hits, result.figures);
    result.notes = std::move(figures.notes);
    result.run = timesJson(figures.times);
    return {};
}

Result<void> SweepMeter::measureMotion(const SweepJob& job, SweepResult& result) {
    view_.reset(); // a sequence has a session of its own
    openView_.clear();
    measure::SequencePlan plan = *job.motion;
    plan.configs = {job.config};
    GLINT_TRY(sequence, measure::renderSequence(*context_, plan, {}));
    result.width = sequence.width;
    result.height = sequence.height;
    measure::SequenceConfig& config = sequence.configs.front();
    addMotionFigures(config, result.figures);
    result.notes = std::move(config.notes);
    result.run = timesJson(config.times);
    return {};
}

Result<void> SweepMeter::checkMessages() const {
    if (context_->validationMessages().empty())
        return {};
    return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                     context_->validationMessages().size(), context_->validationMessages().front());
}

} // namespace glint::cli
