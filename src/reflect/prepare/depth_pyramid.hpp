// `prepare/pyramid`: the depth pyramid that rays step through, built if a marcher or a transparent layer needs it.
#pragma once

#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

class DepthPyramid {
public:
    /// The pass, for those who ask for its pipeline before the stage exists.
    static gpu::ComputeDesc program();
    static Result<std::unique_ptr<DepthPyramid>> create(StageContext& stages);

    /// True if rays of the screen, of an inspection or of a transparent layer step through it.
    static bool wanted(const PlanInputs& inputs);
    /// Creates its images when settings first need them. Errors: OutOfMemory.
    Result<void> make();

    void clear(gpu::Frame& frame);
    /// `rays`: the pyramid is built only if there are any. Null: it is always built, for rays that are not yet known,
    /// and its cells also store what is behind them with refraction.hizDepthBias.
    void record(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared, Rays* rays);

    /// With the levels that the frame's extent has.
    Pyramid pyramid() { return {cells_, cells_ ? levelsOf(stages_.extent) : 0}; }

private:
    explicit DepthPyramid(StageContext& stages) : stages_(stages) {}
    static uint32_t levelsOf(glm::uvec2 size);

    StageContext& stages_;
    gpu::Pipeline pass_;
    gpu::Image cells_;
    gpu::Buffer tiles_;
    gpu::Standing blank_; ///< cells_ are initialized, and the counter in tiles_ starts at 0
};

} // namespace glint::reflect
