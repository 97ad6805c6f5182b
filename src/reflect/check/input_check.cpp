#include "reflect/check/input_check.hpp"

#include "reflect/check/known_plane.hpp"
#include "reflect/gbuffer_images.hpp"

namespace glint::reflect {
namespace {

/// Checks that are not asked for: frames 1, 2, 4, 8, ... after the declaration, the last one a minute later.
constexpr uint32_t kMostAttempts = 12;

} // namespace

InputCheck compareInputs(const DeclaredFrame& frame, std::span<const shared::InputSample> samples) {
    const HostEvidence evidence(frame.camera, frame.conventions, frame.grid, samples);
    InputCheck out;
    out.tested = evidence.samples();
    if (out.tested < check::kFewestSamples)
        return out;
    const auto add = [&](const check::Finding& finding) {
        if (finding)
            out.findings.push_back(*finding);
    };
    const check::Comparison compared = check::compareNormals(evidence);
    out.normalsAgree = compared.agree;
    add(compared.finding);
    add(check::findOddLengths(evidence, compared.best));
    add(check::findAverted(evidence, compared.best));
    add(check::findOutOfRange(evidence, compared.best));
    if (frame.plane)
        add(findPlaneElsewhere(evidence, compared.best, *frame.plane, frame.conventions));
    if (frame.roughness)
        add(check::findRoughnessOutside(evidence.roughness(*frame.roughness)));
    if (frame.hasMotion && frame.previous) {
        const glm::uvec2 extent = frame.camera.extent;
        const check::MotionUnit declared = {{frame.conventions.motionScale[0], frame.conventions.motionScale[1]},
                                            false};
        const check::MotionCheck motion =
            check::compareMotion(evidence.motions(compared.best, *frame.previous), glm::vec2(extent), declared,
                                 [&](const check::MotionUnit& unit) { return nameOfMotion(unit, extent); });
        out.motionCompared = motion.compared;
        add(motion.finding);
        if (frame.conventions.motionDepthScale != 0) {
            const check::MotionCheck inDepth = check::compareDepthMotion(
                evidence.depthMotions(compared.best, *frame.previous), frame.conventions.motionDepthScale);
            out.motionCompared = motion.compared && inDepth.compared;
            add(inDepth.finding);
        }
    }
    return out;
}

Result<std::unique_ptr<InputChecker>> InputChecker::create(StageContext& stages) {
    using gpu::Buffer, gpu::Pipeline;
    std::unique_ptr<InputChecker> checker(new InputChecker(stages));
    const uint32_t constants = sizeof(shared::InputSampleConstants);
    GLINT_TRY(pass, Pipeline::compute(stages.gpu, {"check/samples", constants, {}}));
    GLINT_TRY(manySamples, Pipeline::compute(stages.gpu, {"check/samples_many", constants, {}}));
    checker->pass_ = std::move(pass);
    checker->manySamplesPass_ = std::move(manySamples);
    const VkDeviceSize bytes = shared::kMostInputSamples * sizeof(shared::InputSample);
    GLINT_TRY(samples,
              Buffer::create(stages.gpu, {"glint/inputSamples", bytes,
                                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                          gpu::BufferHome::Device}));
    GLINT_TRY(readback, Buffer::create(stages.gpu, {"glint/inputSamplesReadback", bytes,
                                                    VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferHome::Readback}));
    GLINT_TRY(progress, gpu::Progress::create(stages.gpu, "glint/inputCheckProgress"));
    checker->samples_ = std::move(samples);
    checker->readback_ = std::move(readback);
    checker->progress_ = std::move(progress);
    return checker;
}

void InputChecker::rehearse(gpu::Frame& frame, const FrameInputs& inputs) {
    const SampleGrid grid = SampleGrid::over(stages_.extent);
    copySamples(frame, inputs, grid, false);
    copySamples(frame, inputs, grid, true);
}

void InputChecker::restart() {
    result_ = {};
    pending_ = settled_ = false;
    attempts_ = 0;
    nextAttempt_ = 0;
}

void InputChecker::begin(const View& view, uint64_t frameNumber) {
    manyViews_ = manyViews_ || (now_ && frameNumber == frameNumber_);
    before_ = view.cut || manyViews_ ? std::nullopt : now_;
    now_ = {view, stages_.extent};
    frameNumber_ = frameNumber;
}

bool InputChecker::isDue() const {
    if (settled_ || attempts_ >= kMostAttempts || frameNumber_ < nextAttempt_)
        return false;
    // Samples are not overwritten before they are evaluated, unless their command buffer was never executed.
    return !pending_ ||
           (frameNumber_ > pendingFrame_ + stages_.desc.framesInFlight && !progress_.isExecuted(progress_.recording()));
}

void InputChecker::record(gpu::Frame& frame, const FrameInputs& inputs, const GBuffer& gbuffer,
                          const std::optional<KnownPlane>& plane) {
    sampled_ = {*now_,
                before_,
                gbuffer.conventions,
                {},
                static_cast<bool>(gbuffer.motion),
                plane,
                SampleGrid::over(now_->extent)};
    if (kMaterialScalars[Inputs::Roughness].isRead(gbuffer))
        sampled_.roughness = gbuffer.roughness;
    progress_.begin();
    copySamples(frame, inputs, sampled_.grid, gbuffer.depth.samples > 1);
    frame.copyBuffer(samples_, readback_);
    progress_.end(frame);
    pending_ = true;
    pendingFrame_ = frameNumber_;
    nextAttempt_ = frameNumber_ + (uint64_t{1} << attempts_);
    attempts_ = std::min(attempts_ + 1, kMostAttempts);
}

void InputChecker::copySamples(gpu::Frame& frame, const FrameInputs& inputs, const SampleGrid& grid, bool manySamples) {
    Inputs& host = inputs.host;
    frame.pass(manySamples ? manySamplesPass_ : pass_)
        .read("depth", host.depth, kTexels)
        .read("normal", host.normal, kTexels)
        .read("roughness", host.scalar(Inputs::Roughness, host.normal), kTexels)
        .read("motion", host.motion ? host.motion : inputs.standIns.black, kTexels)
        .write("samples", samples_)
        .push(shared::InputSampleConstants{grid.count, grid.stride})
        .dispatch(std::max(grid.count.x, 1u), std::max(grid.count.y, 1u));
}

bool InputChecker::evaluate() {
    if (!pending_ || !progress_.isExecuted(progress_.recording()))
        return false;
    pending_ = false;
    const auto* samples = static_cast<const shared::InputSample*>(readback_.mapped());
    result_ = compareInputs(sampled_, {samples, sampled_.grid.samples()});
    settled_ = result_.tested >= check::kFewestSamples &&
               (!sampled_.hasMotion || result_.motionCompared || !result_.findings.empty());
    return true;
}

} // namespace glint::reflect
