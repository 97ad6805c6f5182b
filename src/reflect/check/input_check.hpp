// The check of the host's declarations (ReflectionsDesc::inputCheck): a pass that copies samples of the host's images,
// and their comparison with each other and with the matrices, once the GPU has finished.
#pragma once

#include "glint/input_check.hpp"
#include "reflect/check/host_evidence.hpp"
#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

/// What was declared about the frame that samples are of.
struct DeclaredFrame {
    FrameCamera camera;
    std::optional<FrameCamera> previous; ///< of the frame before; absent after a cut
    Conventions conventions;
    std::optional<MaterialChannel> roughness; ///< absent: no image has it
    bool hasMotion = false;
    std::optional<KnownPlane> plane;
    SampleGrid grid;
};

/// `samples`: of the frame's grid.
InputCheck compareInputs(const DeclaredFrame& frame, std::span<const shared::InputSample> samples);

class InputChecker {
public:
    static bool wanted(const PlanInputs& inputs) { return inputs.inputCheck; }
    static Result<std::unique_ptr<InputChecker>> create(StageContext& stages);

    void rehearse(gpu::Frame& frame, const FrameInputs& inputs);
    /// The host declared something else: the next frames are checked again.
    void restart();
    /// Notes the frame's camera, for `record`. Call it for each frame of the host.
    void begin(const View& view, uint64_t frameNumber);
    /// Forgets the previous frame's camera.
    void forget() { now_.reset(); }
    /// True if the frame should be checked without being asked. That is the first frame, then ever rarer ones, until
    /// one has shown enough surfaces and, with an image of motion, a camera that moves: on screen and, if motion tells
    /// of it, in depth. A finding ends it, too.
    bool isDue() const;
    /// Samples the frame that was begun last. Ends with a mark: it must be a recording of its own, or its last part.
    void record(gpu::Frame& frame, const FrameInputs& inputs, const GBuffer& gbuffer,
                const std::optional<KnownPlane>& plane = {});
    /// Evaluates samples that the GPU has finished. Returns true if there were any.
    bool evaluate();
    const InputCheck& result() const { return result_; }

private:
    explicit InputChecker(StageContext& stages) : stages_(stages) {}
    void copySamples(gpu::Frame& frame, const FrameInputs& inputs, const SampleGrid& grid, bool manySamples);

    StageContext& stages_;
    gpu::Pipeline pass_;
    gpu::Pipeline manySamplesPass_;
    gpu::Buffer samples_;
    gpu::Buffer readback_;
    gpu::Progress progress_;
    std::optional<FrameCamera> before_, now_;
    uint64_t frameNumber_ = 0;
    bool manyViews_ = false; ///< a frame had several: the recording before is not the view's previous frame
    DeclaredFrame sampled_;  ///< whose samples `readback_` will hold
    bool pending_ = false;
    uint64_t pendingFrame_ = 0;
    InputCheck result_;
    // Of checks that were not asked for.
    bool settled_ = false;
    uint32_t attempts_ = 0;
    uint64_t nextAttempt_ = 0; ///< frame number
};

} // namespace glint::reflect
