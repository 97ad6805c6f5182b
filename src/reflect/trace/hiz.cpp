// The `hiz` marcher: cell by cell through the depth pyramid. docs/techniques/hiz.md
#include "reflect/trace/technique.hpp"

namespace glint::reflect {

static void recordHiz(gpu::Frame& frame, const gpu::Pipeline& pipeline, TraceInputs inputs, TraceTarget out) {
    tracePass(frame, pipeline, inputs, out).read("pyramid", inputs.pyramid.cells).dispatchIndirect(inputs.rays.list);
}

const Technique kHizTechnique = {
    "hiz", March::Hiz, "trace/hiz", "large steps through a depth pyramid, small ones near surfaces",
    true,  true,       recordHiz};

} // namespace glint::reflect
