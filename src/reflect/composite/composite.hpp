// `composite`: replaces the fallback specular in the host's lit image by the reflections.
#pragma once

#include "reflect/stage.hpp"
#include "reflect/stages.hpp"
#include "shared/trace_constants.h"

namespace glint::reflect {

class Composite {
public:
    static Result<Composite> create(StageContext& stages);

    shared::CompositeConstants constants() const;
    /// Writes `composite`, RGBA16F. `rayRecord`: the outcomes of the pixels' rays, for debug colours.
    void record(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared, const Reflected& reflected,
                gpu::Image& rayRecord, gpu::Image& composite);

private:
    explicit Composite(StageContext& stages) : stages_(&stages) {}

    StageContext* stages_;
    gpu::Pipeline pass_;
};

} // namespace glint::reflect
