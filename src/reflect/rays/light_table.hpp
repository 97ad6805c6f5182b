// The lights that paths of the source `rays` sample directly (rays.sampleLights): cells of the environment and emissive
// triangles, each kind in a tree of sums (shared/light_tree.h). The trees only steer samples: where they are out of
// date, the mean stays right and noise grows.
#pragma once

#include "rays/scene.hpp"
#include "reflect/rays/surface_table.hpp"
#include "reflect/stage.hpp"
#include "reflect/stages.hpp"
#include "shared/light_tree.h"

namespace glint::reflect {

class LightTable {
public:
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<LightTable>> create(StageContext& stages);

    /// Prepares for the emitters of this table, which must outlive the frames that use it. Errors: OutOfMemory.
    Result<void> setScene(SurfaceTableState& surfaces);
    /// The next frame reads the environment again.
    void environmentChanged() { environment_.ask(); }

    /// Lists the instances of `scene` that emit light and fills the trees. Allocates nothing.
    void record(gpu::Frame& frame, const FrameInputs& inputs, const rays::Scene& scene);
    /// Binds trees and list, as shaders/rays/light_sampling.glsl declares them.
    gpu::Pass& bind(gpu::Pass& pass) { return pass.read("lightTree", tree_).read("emitters", emitters_); }

private:
    explicit LightTable(StageContext& stages) : stages_(stages) {}
    shared::EmittersHeader listEmitters(const rays::Scene& scene);
    void addUp(gpu::Frame& frame, const shared::LightTreeConstants& tree);

    StageContext& stages_;
    SurfaceTableState* surfaces_ = nullptr;
    gpu::Pipeline environmentLeaves_;
    gpu::Pipeline emitterLeaves_;
    gpu::Pipeline sums_;
    gpu::Buffer tree_;
    gpu::Buffer emitters_;
    std::vector<uint32_t> list_; ///< the content of emitters_
    gpu::Standing environment_;
};

} // namespace glint::reflect
