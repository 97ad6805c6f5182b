// The source `rays`: lists the pixels that need a ray and traces rays through the host's triangles for them.
#pragma once

#include "glint/ray_hits.hpp"
#include "glint/settings.hpp"
#include "rays/scene.hpp"
#include "reflect/history.hpp"
#include "reflect/rays/light_table.hpp"
#include "reflect/rays/surface_table.hpp"
#include "reflect/stages.hpp"
#include "reflect/trace/ray_list.hpp"
#include "shared/hierarchy.h"
#include "shared/rays_constants.h"

#include <optional>

namespace glint::reflect {

/// Inputs from the frame.
struct RaysInputs {
    FrameInputs frame;
    Prepared prepared;
    EarlierAnswers earlier;
    gpu::Image& screenRecord; ///< outcomes of the screen's rays
    bool sameView;            ///< same view as the previous frame
    std::optional<PreviousFrame> previous;
};

/// Created when the settings first enable it.
class RaysSource {
public:
    static bool wanted(const Settings& settings) { return settings.rays.enabled; }
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<RaysSource>> create(StageContext& stages);

    /// Creates the pipeline for this scene and table, and keeps references to them. Errors: Unsupported, OutOfMemory.
    Result<void> setScene(rays::Scene& scene, SurfaceTableState& surfaces);
    /// As above, for a host that shades hits itself. Creates the hit buffer.
    Result<void> setScene(rays::Scene& scene, ShadeHits shade);
    bool hasScene() const { return scene_ != nullptr; }
    RayBackend backend() const { return scene_->backend(); }

    /// Allocates the history and compiles the pipelines that the settings need, and resets the history. Errors:
    /// OutOfMemory, Unsupported.
    Result<void> make(const Settings& settings);
    /// The host's environment is another.
    void environmentChanged();
    /// The next frame starts without history.
    void forgetFrames(HistoryReset reason) { sums_.reset(reason); }

    /// `before`: the sources that are asked before this one.
    shared::RaysConstants constants(const Inputs& host, uint32_t before) const;
    void record(gpu::Frame& frame, const RaysInputs& inputs);

    /// Follows the previous frame's sentinels and starts this frame's. Call after `record`, with
    /// FramePlan::followsPaths.
    void recordSentinels(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared,
                         const SentinelImages& images);

    /// Ends the frame: keeps its transforms for the next one.
    void end(gpu::Frame& frame);

    /// Adds the outcomes and costs of this frame's rays to a shared::RayStatistics.
    void count(gpu::Frame& frame, const FrameInputs& inputs, gpu::Buffer& statistics);

    gpu::Image& answer() { return radianceWeight_; }
    gpu::Image& rayRecord() { return record_; }

    /// True if the settings and the scene have paths that go on behind mirrors, for the denoiser to average.
    bool branches() const;
    /// True if paths store a part of their light apart, for the denoiser: behind mirrors, or the sky's.
    bool storesApart() const;
    /// Valid if `storesApart`, where rayRecord says kRaysBranched or kRaysSkyApart; else one texel each.
    MirroredImages mirrored() { return {mirroredSurface_, mirroredLight_}; }

private:
    explicit RaysSource(StageContext& stages) : stages_(stages), sums_(stages, History::Kind::InPlace) {}
    bool samplesLights() const { return stages_.settings().rays.sampleLights; }
    Result<void> makeShading();
    Result<void> makeMirrored(bool surfaces, bool skyApart);
    void recordShaded(gpu::Frame& frame, const RaysInputs& inputs);
    void recordPaths(gpu::Frame& frame, const RaysInputs& inputs, bool sampleLights);
    void recordBetween(gpu::Frame& frame, const RaysInputs& inputs);
    bool followsHits() const;
    Result<void> makeInstancesBefore(SurfaceTableState& surfaces);
    void recordHits(gpu::Frame& frame, const RaysInputs& inputs);
    Result<void> makeSentinels();
    gpu::Pass& bindShading(gpu::Pass& pass, const FrameInputs& inputs, const Prepared& prepared);

    StageContext& stages_;
    gpu::Pipeline list_;
    gpu::Pipeline interpolate_; ///< with rays.interpolate
    gpu::Pipeline reflect_;
    gpu::Pipeline followSentinels_;
    gpu::Pipeline reflectLights_;        ///< with rays.sampleLights
    std::unique_ptr<LightTable> lights_; ///< absent until settings and scene need it
    gpu::Pipeline traceHits_;
    gpu::Pipeline count_;
    rays::Scene* scene_ = nullptr;
    SurfaceTableState* surfaces_ = nullptr; ///< null: the host shades hits
    ShadeHits shade_;
    gpu::Buffer instancesBefore_; ///< shared::SurfaceInstanceRecord, as the previous frame's rays met them
    uint32_t instancesBeforeCount_ = 0;
    gpu::Buffer hits_; ///< shared::RayHitRecord; absent unless a host shades hits
    RayLister lister_;
    Rays rays_;
    gpu::Image radianceWeight_; ///< RGBA16F: radiance, weight [0, 1]; kRaysBranched: what the further ray found, weight
    gpu::Image mirroredSurface_; ///< RGBA32UI, lib/mirrored.glsl; one texel until settings need it
    gpu::Image mirroredLight_;   ///< as that
    uint32_t sumsWidth_ = 0;
    uint32_t sumsHeight_ = 0;
    History sums_;      ///< RGBA32F and R32F, one texel each unless rays.accumulate: reflect_main.glsl
    gpu::Image record_; ///< RGBA32UI, lib/ray_record.glsl: the first hit, mean distance; lookups: rays; kRaysReused...
};

} // namespace glint::reflect
