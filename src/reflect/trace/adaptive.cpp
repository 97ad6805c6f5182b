// The `adaptive` marcher: equal steps on screen, then a binary search. docs/techniques/adaptive.md
#include "reflect/trace/technique.hpp"

namespace glint::reflect {

static void recordAdaptive(gpu::Frame& frame, const gpu::Pipeline& pipeline, TraceInputs inputs, TraceTarget out) {
    tracePass(frame, pipeline, inputs, out).dispatchIndirect(inputs.rays.list);
}

const Technique kAdaptiveTechnique = {
    "adaptive", March::Adaptive, "trace/adaptive", "equal steps on screen, then a binary search", false,
    true,       recordAdaptive};

} // namespace glint::reflect
