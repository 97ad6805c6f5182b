// The source `rays`: the pixels that need it, listed, and what rays through the host's triangles find for them.
#pragma once

#include "glint/ray_hits.hpp"
#include "glint/settings.hpp"
#include "rays/scene.hpp"
#include "reflect/rays/surface_table.hpp"
#include "reflect/stages.hpp"
#include "shared/hierarchy.h"
#include "shared/rays_constants.h"

namespace glint::reflect {

/// What the source reads of the frame.
struct RaysInputs {
    gpu::Buffer& frameConstants;
    Prepared& prepared;
    EarlierAnswers earlier;
    gpu::Image& screenRecord; ///< how the screen's rays ended
    gpu::Image& material;     ///< F0: lib/resolved_material.glsl
    gpu::Image& litRadiance;
    gpu::Image& fallbackSpecular; ///< or black
    bool hasEnvironment;
    gpu::Image& environment; ///< or a black cube
    bool hasEnvironmentDiffuse;
    gpu::Image& environmentDiffuse; ///< or a black cube
    gpu::Image& dfg;
    bool sameView; ///< as in the frame before
};

/// Made when the settings first ask for it.
class RaysSource {
public:
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<RaysSource>> create(gpu::Context& context, uint32_t width, uint32_t height);

    /// Makes the pipeline for this scene and table, which are kept. Errors: Unsupported, OutOfMemory.
    Result<void> setScene(rays::Scene& scene, SurfaceTableState& surfaces);
    /// The same for a host that shades hits itself. Makes the buffer for them.
    Result<void> setScene(rays::Scene& scene, ShadeHits shade);
    bool hasScene() const { return scene_ != nullptr; }
    RayBackend backend() const { return scene_->backend(); }

    /// Makes room for the frames before, if the settings ask for them, and forgets them. Errors: OutOfMemory.
    Result<void> setSettings(const Settings& settings);
    /// The next frame starts anew.
    void forgetFrames() { framesHeld_ = false; }

    void record(gpu::Frame& frame, const Settings& settings, const RaysInputs& inputs);

    /// Adds what this frame's rays did to a shared::RayStatistics.
    void count(gpu::Frame& frame, gpu::Buffer& statistics);

    gpu::Image& answer() { return radianceWeight_; }
    gpu::Image& rayRecord() { return record_; }

private:
    explicit RaysSource(gpu::Context& context) : context_(context) {}
    void recordHits(gpu::Frame& frame, const RaysInputs& inputs, const shared::RaysConstants& constants);
    shared::RaysConstants constants(const Settings& settings, const RaysInputs& inputs) const;

    gpu::Context& context_;
    gpu::Pipeline list_;
    gpu::Pipeline reflect_;
    gpu::Pipeline traceHits_;
    gpu::Pipeline count_;
    rays::Scene* scene_ = nullptr;
    SurfaceTableState* surfaces_ = nullptr; ///< null: the host shades
    ShadeHits shade_;
    gpu::Buffer hits_; ///< shared::RayHitRecord; absent until a host shades
    Rays rays_;
    gpu::Image radianceWeight_; ///< RGBA16F: radiance, weight [0, 1]
    gpu::Image sum_;            ///< RGBA32F, 1x1 unless rays.accumulate: reflect_main.glsl
    gpu::Image weights_;        ///< R32F, of the same size
    bool framesHeld_ = false;   ///< they hold the frames before
    gpu::Image record_; ///< RGBA32UI, lib/ray_record.glsl: the first hit, mean distance; lookups: rays; kRaysReused...
    gpu::Buffer blueNoise_;
    bool noiseHeld_ = false;
};

} // namespace glint::reflect
