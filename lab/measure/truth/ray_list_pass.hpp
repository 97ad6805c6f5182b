// Traces a list of rays through a RayScene for their nearest hits, and measures the time by two clocks.
#pragma once

#include "gpu/pass.hpp"
#include "lab/measure/bench/timed_submit.hpp"
#include "lab/measure/truth/ray_list.hpp"

namespace glint::measure {

struct ListTimes {
    double gpuMs = 0;  ///< from timestamps; 0 without them
    double wallMs = 0; ///< submitting and waiting
};

class RayListPass {
public:
    /// For scenes of this back end, Query or Bvh. Requires that `context` has gpu::shaders::render() registered.
    /// Errors: OutOfMemory, Unsupported.
    static Result<RayListPass> create(gpu::Context& context, RayBackend backend);

    Result<void> setRays(const std::vector<ListedRay>& rays); ///< must not be empty. Errors: OutOfMemory, DeviceLost
    Result<ListTimes> trace(RayScene& scene);                 ///< Errors: DeviceLost
    Result<std::vector<ListedHit>> hits();                    ///< of the last trace. Errors: OutOfMemory, DeviceLost

private:
    explicit RayListPass(gpu::Context& context) : context_(&context) {}

    gpu::Context* context_;
    gpu::Pipeline pipeline_;
    std::unique_ptr<gpu::Timers> timers_;
    gpu::Buffer rays_, hits_;
    uint32_t count_ = 0;
};

} // namespace glint::measure
