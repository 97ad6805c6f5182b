// The frame of the library: its stages and their recording order. Implements glint::Reflections.
#pragma once

#include "gpu/timers.hpp"
#include "reflect/check/input_check.hpp"
#include "reflect/composite/composite.hpp"
#include "reflect/composite/ray_counts.hpp"
#include "reflect/composite/views.hpp"
#include "reflect/denoise/denoiser.hpp"
#include "reflect/denoise/denoises.hpp"
#include "reflect/hierarchy/hierarchy.hpp"
#include "reflect/history.hpp"
#include "reflect/inspect/inspector.hpp"
#include "reflect/outputs.hpp"
#include "reflect/planar/planar_source.hpp"
#include "reflect/prepare/depth_pyramid.hpp"
#include "reflect/prepare/frame_block.hpp"
#include "reflect/prepare/prepare.hpp"
#include "reflect/prepare/tables.hpp"
#include "reflect/probes/probes_source.hpp"
#include "reflect/rays/rays.hpp"
#include "reflect/refraction/refraction.hpp"
#include "reflect/resolve/screen_resolve.hpp"
#include "reflect/trace/cone_picture.hpp"
#include "reflect/trace/screen_trace.hpp"
#include "reflect/trace/transparents.hpp"

namespace glint::reflect {

class FrameStages {
public:
    /// Asks for the pipelines that drivers take longest to compile, so that a CompileBatch can start with them.
    static Result<void> askForLongest(gpu::Context& context, const Settings& settings);
    static Result<std::unique_ptr<FrameStages>> create(gpu::Context& context, const ReflectionsDesc& desc);

    const ReflectionsDesc& desc() const { return stages_.desc; } ///< with the settings in force
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
    Result<void> setRays(rays::Scene& scene, SurfaceTableState& surfaces);
    Result<void> setRays(rays::Scene& scene, ShadeHits shade);
    Result<void> setPlanar(PlanarState& planar);
    Result<void> setProbes(ProbesState& probes);
    void restartAccumulation();
    /// Adds a source, which comes before all others. Returns its number.
    uint32_t addSource(Source source) { return hierarchy_->add(std::move(source)); }
    /// Inputs that every pass reads, for passes outside the frame.
    FrameInputs inputs() {
        StandIns standIns = tables_->standIns();
        return {block_->buffer(),
                block_->values(),
                host_.images,
                standIns,
                denoises() ? denoiser_->rayRates() : standIns.black,
                denoises() ? denoiser_->metaBefore() : standIns.black};
    }

    const rays::Scene* rayScene() const { return rayScene_; }
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
    /// True if layers can follow: there is a composite image, and images that their rays intersect. False for debug
    /// colours, which are not radiance.
    bool expectsLayers() const {
        return refraction_ && stages_.settings().refraction.enabled && !stages_.settings().debug.outcome &&
               hasComposite();
    }
    /// False if the host composites the reflections itself.
    bool hasComposite() const { return outputs_.hasComposite(); }
    gpu::Image& composite() { return outputs_.composite(); }

    /// Null without ReflectionsDesc::inputCheck.
    InputChecker* inputChecker() { return checker_.get(); }
    RayInspection inspection() const { return inspector_->read(*hierarchy_); }
    std::vector<gpu::PassTime> passTimes() const;
    Statistics statistics() const;

private:
    /// The image in colors_.
    static constexpr HistoryImage kViewZ = {0, "glint/viewZ", VK_FORMAT_R32_SFLOAT};

    FrameStages(gpu::Context& context, const ReflectionsDesc& desc)
        : stages_{context, desc, {}, {}, {desc.width, desc.height}}, outputs_(stages_),
          colors_(stages_, History::Kind::Turns) {}
    Result<void> createStages();
    Result<void> createDepths();
    Result<void> rememberColors();
    Result<void> setCones(const Settings& settings);
    Result<void> setTransparents(const Settings& settings);
    std::vector<Source> makeSources();
    Result<void> rehearse();
    Result<void> giveScene();
    Result<void> rehearseRays();
    Result<void> setDenoise(const Settings& settings);
    Result<void> makeClasses(const Settings& settings, const GBuffer& gbuffer);
    Result<void> makeResults();

    // Record the frame, top to bottom, and its additions.
    void recordFrame(gpu::Frame& frame, const View& view);
    void recordComposite(gpu::Frame& frame);
    void prepare(gpu::Frame& frame, const View& view);
    shared::SettingsConstants resolveSettings(const View& view);
    gpu::Image& denoise(gpu::Frame& frame);
    bool averagesMirrored() const;
    void clear(gpu::Frame& frame);
    void bringUpToDate(gpu::Frame& frame);
    void countRays(gpu::Frame& frame);
    /// The next frame has no history: this one was not light.
    void forgetFrames(HistoryReset reason);
    void recordLayer(gpu::Frame& frame, LayerImages& layer);

    /// True if an image of the reflections alone is needed: by the host, by views, or by pixels that show several
    /// surfaces.
    bool readsReflected() const {
        return stages_.desc.views || stages_.desc.inspection || outputs_.stated().reflection || host_.hasManySamples();
    }
    bool usesRays() const { return stages_.settings().rays.enabled && raysSource_ && raysSource_->hasScene(); }
    /// True if prepare/classified does the work of trace/classify.
    bool classifiesEarly(const Settings& settings, const GBuffer& gbuffer) const {
        return trace_->classifiesAlone(settings) && gbuffer.depth.samples == 1;
    }
    bool classifiesEarly() const { return classifiesEarly(stages_.settings(), host_.gbuffer); }
    /// True if only composite/combined reads the screen's answers, which looks at the ray list first: pixels off the
    /// list need none.
    bool storesListedOnly() const {
        constexpr uint32_t kNotReaders = 1u << shared::kSourceScreen | 1u << shared::kSourceSky;
        return classifiesEarly() && !trace_->keepsRecord(stages_.settings()) && !readsReflected() &&
               (hierarchy_->constants().sources & ~kNotReaders) == 0;
    }
    bool tracesRays() const { return stages_.settings().screen.enabled || usesRays(); }
    bool wantsHistory() const;
    bool blursHits() const { return conePicture_ && ConePicture::isWanted(stages_.settings()); }
    bool meetsTransparents() const;
    bool followsSentinels() const { return usesRays() && raysSource_->followsSentinels(); }
    bool denoises() const { return denoiser_ && reflect::denoises(stages_.settings()); }
    ProbesState* probes() const { return probesSource_ ? probesSource_->probes() : nullptr; }

    // Outputs of stages that other stages read.
    Prepared prepared() { return prepare_->prepared(host_, colors_.now(kViewZ)); }
    Met met() { return {prepared().viewZ, prepared().surface, prepared().backViewZ}; }
    TraceInputs traceInputs();
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
    std::unique_ptr<ConePicture> conePicture_; ///< absent until settings need it
    std::unique_ptr<ScreenTrace> trace_;
    std::unique_ptr<TransparentTrace> transparentTrace_; ///< absent until settings need it
    std::unique_ptr<ScreenResolve> resolve_;
    std::unique_ptr<Denoiser> denoiser_;     ///< absent until settings need it
    std::unique_ptr<RaysSource> raysSource_; ///< absent until settings need it
    rays::Scene* rayScene_ = nullptr;        ///< the host's, with its surface table
    SurfaceTableState* raySurfaces_ = nullptr;
    ShadeHits shadeHits_;                        ///< used instead, if the host shades hits
    std::unique_ptr<PlanarSource> planarSource_; ///< absent until the host provides planar mirrors
    std::unique_ptr<ProbesSource> probesSource_; ///< absent until the host provides probes
    std::unique_ptr<Hierarchy> hierarchy_;
    std::optional<Composite> composite_;
    std::unique_ptr<Refraction> refraction_; ///< ReflectionsDesc::transparentLayers
    LayerImages layer_;                      ///< of the layer recorded last
    std::unique_ptr<RayCounts> counts_;      ///< ReflectionsDesc::statistics
    std::unique_ptr<Views> views_;           ///< ReflectionsDesc::views
    std::unique_ptr<Inspector> inspector_;   ///< ReflectionsDesc::inspection
    std::unique_ptr<InputChecker> checker_;  ///< ReflectionsDesc::inputCheck
    std::unique_ptr<gpu::Timers> timers_;    ///< ReflectionsDesc::timers

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
