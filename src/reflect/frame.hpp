// The frame of the library: its stages and their recording order. Implements glint::Reflections.
#pragma once

#include "gpu/timers.hpp"
#include "reflect/coat/coat_lobe.hpp"
#include "reflect/composite/composite.hpp"
#include "reflect/hierarchy/hierarchy.hpp"
#include "reflect/history.hpp"
#include "reflect/optional_stages.hpp"
#include "reflect/outputs.hpp"
#include "reflect/planar/planar_source.hpp"
#include "reflect/prepare/depth_pyramid.hpp"
#include "reflect/prepare/frame_block.hpp"
#include "reflect/prepare/prepare.hpp"
#include "reflect/prepare/tables.hpp"
#include "reflect/probes/probes_source.hpp"
#include "reflect/resolve/screen_resolve.hpp"
#include "reflect/trace/screen_trace.hpp"

namespace glint::reflect {

/// What the host gave to setRays: a scene with its surface table, or with a function that shades hits.
struct GivenScene {
    rays::Scene* scene = nullptr;
    SurfaceTableState* surfaces = nullptr;
    ShadeHits shade;
};

class FrameStages {
public:
    /// Asks for the pipelines that drivers take longest to compile, so that a CompileBatch can start with them.
    static Result<void> askForLongest(gpu::Context& context, const Settings& settings);
    static Result<std::unique_ptr<FrameStages>> create(gpu::Context& context, const ReflectionsDesc& desc);

    const ReflectionsDesc& desc() const { return stages_.desc; } ///< with the settings in force
    const FramePlan& plan() const { return stages_.plan; }
    std::vector<FrameDecision> decisions() const;
    gpu::Context& context() const { return stages_.gpu; }
    const Host& host() const { return host_; }
    const Outputs& outputs() const { return outputs_.stated(); }
    glm::uvec2 extent() const { return stages_.extent; }  ///< of the last recorded frame
    uint64_t frameNumber() const { return frameNumber_; } ///< the host's, of the last recorded frame

    // Inputs from the host. Errors of all: OutOfMemory, Unsupported; on error the previous values stay in force.
    Result<void> setSettings(const Settings& settings);
    Result<void> setInputs(const GBuffer& gbuffer, const EnvironmentMap& environment);
    Result<void> setOutputs(const Outputs& outputs);
    /// Takes over the scene, mirrors and probes of frames of another size, and the count of frames.
    Result<void> takeSources(FrameStages& old);
    Result<void> setRays(GivenScene given);
    Result<void> setPlanar(PlanarState& planar);
    Result<void> setProbes(ProbesState& probes);
    void restartAccumulation();
    /// Inputs that every pass reads, for passes outside the frame.
    FrameInputs inputs() {
        StandIns standIns = tables_->standIns();
        Denoiser* const denoiser = optional_.findWanted<Denoiser>();
        return {block_->buffer(),
                block_->values(),
                host_.images,
                standIns,
                denoiser ? denoiser->rayRates() : standIns.black,
                denoiser ? denoiser->metaBefore() : standIns.black};
    }

    const rays::Scene* rayScene() const { return scene_.scene; }
    bool hasProbes() const { return probesSource_ && probesSource_->hasProbes(); }

    // Recordings. Glint's images are returned ready for sampling, the host's in the layout that the host declared.
    /// Records a frame. Returns its image, or litRadiance if there is nothing to do.
    HostImage record(VkCommandBuffer commands, const View& view);
    /// Records no frame and resets all histories.
    void forget();
    /// Records a transparent layer over the last frame's image, which the host left in `layout`.
    HostImage recordLayer(VkCommandBuffer commands, const TransparentLayer& layer, VkImageLayout layout);
    gpu::Image& recordView(VkCommandBuffer commands, uint32_t view);
    /// An image that a pass of the last frame wrote: its place in `written`.
    gpu::Image& recordWritten(VkCommandBuffer commands, size_t image);
    void recordInspection(VkCommandBuffer commands, uint32_t x, uint32_t y);
    void recordInputCheck(VkCommandBuffer commands, const std::optional<KnownPlane>& plane);

    /// The images that the passes of the last frame wrote, each by the pass and the name that it has there.
    const std::vector<gpu::WrittenImage>& written() const { return written_; }

    bool recorded() const { return recorded_; } ///< a frame with the current settings has been recorded
    gpu::Image& composite() { return outputs_.composite(); }

    /// Null without ReflectionsDesc::inputCheck.
    InputChecker* inputChecker() { return optional_.find<InputChecker>(); }
    RayInspection inspection() const { return optional_.find<Inspector>()->read(*hierarchy_); }
    std::vector<gpu::PassTime> passTimes() const;
    Statistics statistics() const;

private:
    /// The image in colors_.
    static constexpr HistoryImage kViewZ = {0, "glint/viewZ", VK_FORMAT_R32_SFLOAT};

    FrameStages(gpu::Context& context, const ReflectionsDesc& desc)
        : stages_{context, desc, {}, {}, {desc.width, desc.height}}, outputs_(stages_),
          colors_(stages_, History::Kind::Turns) {}
    Result<void> createStages();
    PlanInputs planInputs() const;
    void replan();
    void adopt(const PlanInputs& inputs);
    Result<void> change(const PlanInputs& next, bool withOptional);
    Result<void> makeFixed(const PlanInputs& inputs);
    Result<void> makePrevious();
    std::vector<Source> makeSources();
    Result<void> giveScene(RaysSource& source);
    Result<void> rehearseFixed();
    template <class Stage>
    Result<void> rehearseAlone(Stage& stage) {
        gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
        rehearse(frame, stage);
        return frame.firstError();
    }

    // Record every pass of an optional stage that its settings may need.
    template <class Stage>
    void rehearse(gpu::Frame& frame, Stage& stage) {
        stage.record(frame, stageInputs());
    }
    void rehearse(gpu::Frame& frame, RaysSource& rays);
    void rehearse(gpu::Frame& frame, PlanarSource& planar);
    void rehearse(gpu::Frame& frame, ProbesSource& probes);
    void rehearse(gpu::Frame& frame, Denoiser& denoiser);
    void rehearse(gpu::Frame& frame, Refraction& refraction);
    void rehearse(gpu::Frame& frame, RayCounts& counts);
    void rehearse(gpu::Frame& frame, Views& views);
    void rehearse(gpu::Frame& frame, Inspector& inspector);
    void rehearse(gpu::Frame& frame, InputChecker& checker);

    // Record the frame, top to bottom, and its additions.
    void recordFrame(gpu::Frame& frame, const View& view);
    void traceScreen(gpu::Frame& frame);
    void recordComposite(gpu::Frame& frame, gpu::Image* coat);
    gpu::Image* recordCoat(gpu::Frame& frame, const View& view);
    Result<void> makeCoat(bool again);
    void prepare(gpu::Frame& frame, const View& view);
    shared::SettingsConstants resolveSettings(const View& view);
    gpu::Image& denoise(gpu::Frame& frame, Denoiser& denoiser);
    void clear(gpu::Frame& frame);
    void bringUpToDate(gpu::Frame& frame);
    void countRays(gpu::Frame& frame, RayCounts& rayCounts);
    /// The next frame has no history: this one was not light.
    void forgetFrames(HistoryReset reason);
    void recordLayer(gpu::Frame& frame, LayerImages& layer);

    RaysSource* raysSource() const { return optional_.find<RaysSource>(); }
    ProbesState* probes() const { return probesSource_ ? probesSource_->probes() : nullptr; }

    // Outputs of stages that other stages read.
    Prepared prepared() { return prepare_->prepared(host_, colors_.now(kViewZ)); }
    Met met() { return {prepared().viewZ, prepared().surface, prepared().backViewZ}; }
    TraceInputs traceInputs();
    /// Nothing without a history.
    std::optional<PreviousFrame> previousFrame();
    StageInputs stageInputs();
    HierarchyInputs hierarchyInputs();
    InspectorInputs inspectorInputs();
    /// Outcomes of the pixels' rays: those of the screen, or those of `rays` if the screen traces none.
    gpu::Image& rayRecord();

    StageContext stages_;
    Host host_;
    OutputImages outputs_;
    History colors_; ///< viewZ; hits fetch their radiance by it, from OutputImages::previous
    std::optional<Tables> tables_;
    std::optional<FrameBlock> block_;
    std::unique_ptr<Prepare> prepare_;
    std::unique_ptr<DepthPyramid> pyramid_;
    std::unique_ptr<ScreenTrace> trace_;
    std::unique_ptr<ScreenResolve> resolve_;
    OptionalStages optional_;
    GivenScene scene_;                           ///< by the host, for RaysSource
    std::unique_ptr<PlanarSource> planarSource_; ///< absent until the host provides planar mirrors
    std::unique_ptr<ProbesSource> probesSource_; ///< absent until the host provides probes
    std::unique_ptr<Hierarchy> hierarchy_;
    std::optional<Composite> composite_;
    std::unique_ptr<CoatLobe> coat_;      ///< absent until a host states a clear coat
    LayerImages layer_;                   ///< of the layer recorded last
    std::unique_ptr<gpu::Timers> timers_; ///< ReflectionsDesc::timers

    uint64_t frameNumber_ = 0; ///< the host's frame number
    View lastView_;
    bool recorded_ = false;
    bool hasLayers_ = false;         ///< a layer was recorded over the last frame
    bool previousHasLayers_ = false; ///< and over the frame that OutputImages::previous shows
    std::vector<gpu::WrittenImage> written_;
    bool ranPasses_ = false; ///< the last frame had something to do
    gpu::Standing upToDate_; ///< the images belong to lastView_, whose frame recorded no passes
};

} // namespace glint::reflect
