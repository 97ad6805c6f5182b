// The `linear` marcher: one depth lookup every few pixels along the ray. docs/techniques/linear.md
#include "reflect/trace/technique.hpp"

namespace glint::reflect {
namespace {

void record(gpu::Frame& frame, const gpu::Pipeline& pipeline, const Settings& settings, TraceInputs inputs,
            Traced& out) {
    gpu::Pass pass = frame.pass(pipeline);
    pass.read("frame", inputs.frameConstants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface);
    readHitColor(pass, inputs);
    writeTraced(pass, out);
    pass.push(traceConstants(settings)).dispatch(out.width, out.height);
}

} // namespace

const Technique kLinearTechnique = {"linear",
                                    March::Linear,
                                    "trace/linear",
                                    "every pixel along the ray, one depth lookup each",
                                    sizeof(shared::TraceConstants),
                                    record};

} // namespace glint::reflect
