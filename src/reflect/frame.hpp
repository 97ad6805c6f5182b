// The frame of the library: its pipelines, its images, and the passes in order.
#pragma once

#include "glint/reflections.hpp"
#include "gpu/pass.hpp"
#include "gpu/timers.hpp"
#include "reflect/denoise.hpp"
#include "reflect/hierarchy.hpp"
#include "reflect/inspector.hpp"
#include "reflect/planar/planar_source.hpp"
#include "reflect/probes/probes_source.hpp"
#include "reflect/rays/rays.hpp"
#include "reflect/refraction/refraction.hpp"
#include "reflect/stages.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/frame_constants.h"

namespace glint::reflect {

struct Pipelines {
    gpu::Pipeline surface;
    gpu::Pipeline surfaceSamples; ///< of hosts with several samples a pixel
    gpu::Pipeline backFaces;
    gpu::Pipeline dfg;
    gpu::Pipeline classify;
    gpu::Pipeline pyramid;
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
    bool environmentFlipY = false;
    uint32_t environmentMips = 1;
    Conventions conventions;
    bool inputsSet = false;
    bool hasBackFaces = false; ///< the host's backDepth is there and asked for

    gpu::Buffer frameConstants;
    Prepared prepared;
    Rays rays;
    Pyramid pyramid;
    Traced traced;
    Denoised denoised;
    std::unique_ptr<RaysSource> raysSource; ///< absent until settings ask for it
    rays::Scene* rayScene = nullptr;        ///< the host's, with its surfaces
    SurfaceTableState* raySurfaces = nullptr;
    ShadeHits shadeHits;                        ///< or the host's own shading
    std::unique_ptr<PlanarSource> planarSource; ///< absent until the host hands planar mirrors over
    std::unique_ptr<ProbesSource> probesSource; ///< absent until the host hands probes over
    std::unique_ptr<Refraction> refraction;     ///< ReflectionsDesc::transparentLayers
    History history;
    Reflected reflected;
    gpu::Image lastBackViewZ; ///< the one before prepared.backViewZ: frames in flight may still read it
    gpu::Image lastEdge;
    gpu::Image composite;
    gpu::Image dfg;
    gpu::Image viewImage;
    gpu::Image black;     ///< stands in for an absent image
    gpu::Image blackCube; ///< stands in for an absent environment
    gpu::Buffer noProbes; ///< stands in for the lists of absent probes: zeros, a grid without a cell
    gpu::Buffer statistics;
    gpu::Buffer statisticsReadback;
    std::unique_ptr<Inspector> inspector; ///< ReflectionsDesc::inspection
    bool tablesMade = false;              ///< dfg and the stand-ins hold their content
    bool noBackFaces = false;             ///< prepared.backViewZ is cleared
    View lastView;
    bool upToDate = false;                 ///< the images belong to lastView; false if its frame had nothing to do
    bool untraced = false;                 ///< `traced` says that no ray was traced
    shared::FrameConstants lastFrame = {}; ///< of lastView
    bool historyHeld =
        false; ///< `composite` and `prepared` hold the last frame's picture, for hits to take colours from
    bool historyGamma = false; ///< and that picture is sRGB-encoded
    bool usesHistory = false;  ///< this frame's hits do
    bool sameView = false;     ///< the camera stands where it did in the frame before
    bool ranPasses = false;    ///< by the last record()
    bool recorded = false;     ///< a frame with the settings in force
    std::unique_ptr<gpu::Timers> timers;

    static Result<std::unique_ptr<FrameState>> create(gpu::Context& context, const ReflectionsDesc& desc);

    /// Makes what `settings` ask for and the state does not have yet.
    Result<void> setSettings(const Settings& settings);
    bool anySource() const;
    /// The source `rays` takes part.
    bool usesRays() const;
    /// So does the source `planar`, ...
    bool usesPlanar() const;
    /// ... and the source `probes`.
    bool usesProbes() const;
    /// Some ray was traced, on the screen or through the scene: there are outcomes to count.
    bool tracesRays() const { return desc.settings.screen.enabled || usesRays(); }
    /// Layers may follow: there has to be a picture to lay them over, and what their rays go through.
    /// Not over debug colours, which are no light.
    bool expectsLayers() const {
        return refraction && desc.settings.refraction.enabled && !desc.settings.debug.outcome;
    }
    void restartAccumulation();
    /// Errors: Unsupported, OutOfMemory.
    Result<void> setRays(rays::Scene& scene, SurfaceTableState& surfaces);
    Result<void> setRays(rays::Scene& scene, ShadeHits shade);
    /// Errors: OutOfMemory.
    Result<void> setPlanar(PlanarState& planar);
    /// Errors: OutOfMemory.
    Result<void> setProbes(ProbesState& probes);
    /// Makes room for back faces of this size; 0: there are none. Errors: OutOfMemory.
    Result<void> expectBackFaces(uint32_t width, uint32_t height);
    /// Makes room for what hosts with several samples a pixel need. Errors: OutOfMemory.
    Result<void> expectSamples(uint32_t samples);
    /// The frame, top to bottom.
    void record(gpu::Frame& frame, const View& view);
    /// Lays a transparent layer over the last frame's picture.
    void recordLayer(gpu::Frame& frame, LayerImages& layer);
    /// Prepares first what the last frame did not need.
    void recordView(gpu::Frame& frame, uint32_t view);
    /// Traces one pixel's ray once more, and writes down what it does. Prepares first, as above.
    void recordInspection(gpu::Frame& frame, uint32_t x, uint32_t y);

private:
    Result<void> createImages();
    Result<void> createRays();
    Result<void> createPyramid();
    TraceInputs traceInputs(Rays& list);
    Result<void> rehearse();
    void rehearseLayer(gpu::Frame& frame);
    void makeTables(gpu::Frame& frame);
    void turnHistory();
    void prepare(gpu::Frame& frame, const View& view);
    Result<void> makeImagesFor(const Settings& settings);
    bool resolvesMaterial() const;
    void prepareSurface(gpu::Frame& frame, bool manySamples);
    void prepareBackFaces(gpu::Frame& frame);
    void classify(gpu::Frame& frame);
    void makePyramid(gpu::Frame& frame);
    void trace(gpu::Frame& frame);
    void denoise(gpu::Frame& frame);
    void traceScene(gpu::Frame& frame);
    Result<void> giveScene();
    void askLaterSources(gpu::Frame& frame);
    void lookUpMirrors(gpu::Frame& frame);
    void lookUpProbes(gpu::Frame& frame);
    uint32_t takingPart() const;
    EarlierAnswers answersBefore(uint32_t source);
    EarlierAnswers noAnswersBefore();
    gpu::Image& rayRecord();
    void forgetTrace(gpu::Frame& frame);
    void combine(gpu::Frame& frame);
    gpu::Pass combinePass(gpu::Frame& frame, const gpu::Pipeline& pipeline);
    void bringUpToDate(gpu::Frame& frame);
    void inspect(gpu::Frame& frame, uint32_t x, uint32_t y, const Technique& technique);
    void compose(gpu::Frame& frame);
    void countOutcomes(gpu::Frame& frame);
};

} // namespace glint::reflect
