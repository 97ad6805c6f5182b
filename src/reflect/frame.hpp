// The frame of the library: its pipelines, its images, and the passes in order.
#pragma once

#include "glint/reflections.hpp"
#include "gpu/pass.hpp"
#include "gpu/timers.hpp"
#include "reflect/denoise.hpp"
#include "reflect/stages.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/frame_constants.h"

namespace glint::reflect {

struct Pipelines {
    gpu::Pipeline surface;
    gpu::Pipeline dfg;
    std::vector<gpu::Pipeline> trace; ///< in the order of techniques()
    DenoisePipelines denoise;
    gpu::Pipeline combine;
    gpu::Pipeline composite;
    gpu::Pipeline view;
    gpu::Pipeline statistics;

    static Result<Pipelines> create(gpu::Context& context);
};

/// Everything that record() touches; made at creation, so that recording allocates nothing.
struct FrameState {
    gpu::Context* context = nullptr;
    ReflectionsDesc desc;
    Pipelines pipelines;
    Inputs inputs;
    float environmentStrength = 1;
    float environmentRotation = 0;
    uint32_t environmentMips = 1;
    Conventions conventions;
    bool inputsSet = false;

    gpu::Buffer frameConstants;
    Prepared prepared;
    Traced traced;
    Denoised denoised;
    History history;
    Reflected reflected;
    gpu::Image composite;
    gpu::Image dfg;
    gpu::Image viewImage;
    gpu::Image black;     ///< stands in for an absent image
    gpu::Image blackCube; ///< stands in for an absent environment
    gpu::Buffer statistics;
    gpu::Buffer statisticsReadback;
    bool tablesMade = false; ///< dfg and the stand-ins hold their content
    View lastView;
    bool upToDate = false;                 ///< the images belong to lastView; false if its frame had nothing to do
    bool untraced = false;                 ///< `traced` says that no ray was traced
    shared::FrameConstants lastFrame = {}; ///< of lastView
    bool historyHeld =
        false; ///< `composite` and `prepared` hold the last frame's picture, for hits to take colours from
    bool historyGamma = false; ///< and that picture is sRGB-encoded
    bool usesHistory = false;  ///< this frame's hits do
    bool ranPasses = false;    ///< by the last record()
    std::unique_ptr<gpu::Timers> timers;

    static Result<std::unique_ptr<FrameState>> create(gpu::Context& context, const ReflectionsDesc& desc);

    bool anySource() const;
    /// Makes what these settings need and is not there yet. Errors: OutOfMemory.
    Result<void> makeImagesFor(const Settings& settings);
    /// The frame, top to bottom.
    void record(gpu::Frame& frame, const View& view);
    /// Prepares first what the last frame did not need.
    void recordView(gpu::Frame& frame, uint32_t view);

private:
    Result<void> createImages();
    Result<void> rehearse();
    void makeTables(gpu::Frame& frame);
    void turnHistory();
    void prepare(gpu::Frame& frame, const View& view);
    TraceInputs traceInputs();
    void trace(gpu::Frame& frame);
    void denoise(gpu::Frame& frame);
    void forgetTrace(gpu::Frame& frame);
    void combine(gpu::Frame& frame);
    void compose(gpu::Frame& frame);
    void countOutcomes(gpu::Frame& frame);
};

} // namespace glint::reflect
