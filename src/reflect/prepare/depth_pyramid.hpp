// `prepare/pyramid`: the depth pyramid that rays step through, built if a marcher or a transparent layer needs it.
#pragma once

#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

class DepthPyramid {
public:
    static Result<std::unique_ptr<DepthPyramid>> create(StageContext& stages);

    /// Creates its images when settings first need them. Errors: OutOfMemory.
    Result<void> make();

    void clear(gpu::Frame& frame);
    /// `rays`: the pyramid is built only if there are any. Null: it is always built, for rays that are not yet known,
    /// and its cells also store what is behind them with refraction.hizDepthBias.
    void record(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared, Rays* rays);

    Pyramid pyramid() { return {cells_, levels_}; }

private:
    explicit DepthPyramid(StageContext& stages) : stages_(stages) {}

    StageContext& stages_;
    gpu::Pipeline pass_;
    gpu::Image cells_;
    gpu::Buffer tiles_;
    gpu::Standing blank_; ///< cells_ are initialized, and the counter in tiles_ starts at 0
    uint32_t levels_ = 0;
};

} // namespace glint::reflect
