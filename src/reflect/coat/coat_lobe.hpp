// The clear coats that a host states: a second lobe over the surfaces', with rays, answers and means of its own. The
// same passes run once more, from the coats' surfaces (shaders/lib/coat.glsl), and meet the same scene. Absent until a
// host states a coat.
#pragma once

#include "reflect/denoise/denoiser.hpp"
#include "reflect/hierarchy/hierarchy.hpp"
#include "reflect/planar/planar_source.hpp"
#include "reflect/prepare/frame_block.hpp"
#include "reflect/probes/probes_source.hpp"
#include "reflect/rays/rays.hpp"
#include "reflect/resolve/screen_resolve.hpp"
#include "reflect/stage_list.hpp"
#include "reflect/trace/screen_trace.hpp"

namespace glint::reflect {

/// What the host gave for sources; null: absent.
struct CoatSources {
    rays::Scene* scene = nullptr;
    SurfaceTableState* surfaces = nullptr; ///< null: the host shades hits, by `shade`
    ShadeHits shade;
    PlanarState* planar = nullptr;
    ProbesState* probes = nullptr;
};

/// What the frame has made for the surfaces below.
struct CoatInputs {
    TraceInputs below; ///< of the surfaces' own rays
    const FrameBlock& block;
    History& colors; ///< the previous frame's
    uint64_t frameNumber;
    double seconds; ///< since the previous frame
    /// Records the stages that follow a march (Moment::AfterMarch).
    std::function<void(const StageInputs& inputs)> afterMarch;
};

class CoatLobe {
public:
    /// `frame`: of the surfaces below; its plan and settings hold for the coats too. Errors: OutOfMemory.
    static Result<std::unique_ptr<CoatLobe>> create(StageContext& frame);

    /// Creates what plan, settings and sources need. `again`: the settings are others, and histories start again.
    /// Errors: OutOfMemory, Unsupported.
    Result<void> make(const CoatSources& sources, bool again);
    /// The next frame starts without history.
    void forgetFrames(HistoryReset reason);
    /// The scene is another: the sums of rays.accumulate start again.
    void restartAccumulation();
    void environmentChanged();

    /// Records all passes. Returns RGBA16F: weighted radiance, total weight.
    gpu::Image& record(gpu::Frame& frame, const CoatInputs& inputs);

private:
    explicit CoatLobe(StageContext& frame)
        : frame_(frame), stages_{frame.gpu, frame.desc, {}, {}, {frame.desc.width, frame.desc.height}} {}
    void follow();
    Result<void> makeRays(const CoatSources& sources, bool again);
    std::vector<Source> makeSources();
    void begin(gpu::Frame& frame, const CoatInputs& inputs);
    void trace(gpu::Frame& frame, const CoatInputs& inputs);
    void end(gpu::Frame& frame);
    gpu::Image& denoise(gpu::Frame& frame);

    Denoiser* denoiser() const { return stages_.plan.denoise ? denoiser_.get() : nullptr; }
    FrameInputs inputs();
    Prepared prepared();
    TraceInputs traceInputs();
    HierarchyInputs hierarchyInputs();

    StageContext& frame_;
    StageContext stages_;
    gpu::Buffer block_; ///< FrameBlockValues
    FrameBlockValues values_;
    std::unique_ptr<ScreenTrace> trace_;
    std::unique_ptr<ScreenResolve> resolve_;
    std::unique_ptr<RaysSource> rays_; ///< these as the frame's own
    std::unique_ptr<PlanarSource> planar_;
    std::unique_ptr<ProbesSource> probes_;
    std::unique_ptr<Denoiser> denoiser_;
    std::unique_ptr<Hierarchy> hierarchy_;
    CoatSources sources_;
    const CoatInputs* given_ = nullptr; ///< while recording
};

} // namespace glint::reflect
