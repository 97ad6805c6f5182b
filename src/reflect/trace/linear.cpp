// The `linear` marcher: one depth lookup every few pixels along the ray, but for open space. docs/techniques/linear.md
#include "reflect/trace/technique.hpp"

namespace glint::reflect {

static void recordLinear(gpu::Frame& frame, const gpu::Pipeline& pipeline, TraceInputs inputs, TraceTarget out) {
    tracePass(frame, pipeline, inputs, out).read("pyramid", inputs.pyramid.cells).dispatchIndirect(inputs.rays.list);
}

const Technique kLinearTechnique = {
    "linear", March::Linear, "trace/linear", "every pixel along the ray, one depth lookup each but in open space",
    true,     true,          recordLinear};

} // namespace glint::reflect
