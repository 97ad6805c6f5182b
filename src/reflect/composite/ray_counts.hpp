// Outcomes and costs of a frame's rays, counted on the GPU (ReflectionsDesc::statistics).
#pragma once

#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

#include <functional>

namespace glint::reflect {

class RayCounts {
public:
    static bool wanted(const PlanInputs& inputs) { return inputs.statistics; }
    static Result<std::unique_ptr<RayCounts>> create(StageContext& stages);

    /// `width` x `height`: number of traced pixels. `addMore` adds the rays of other sources to a
    /// shared::RayStatistics.
    void record(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& rayRecord, uint32_t width, uint32_t height,
                const std::function<void(gpu::Buffer&)>& addMore);
    /// Returns the counts of the newest frame that the GPU has finished.
    Statistics read() const;

private:
    RayCounts() = default;

    gpu::Pipeline pass_;
    gpu::Buffer counts_;
    gpu::Buffer readback_;
};

} // namespace glint::reflect
