// The `proxy` marcher: one lookup, at the hit that the pixel's probe volume predicts. docs/techniques/proxy.md
#include "reflect/trace/technique.hpp"

namespace glint::reflect {

/// Binds what shaders/probes/probe_lists.glsl declares. An empty grid does not read the other two buffers.
static gpu::Pass& bindLists(gpu::Pass& pass, TraceInputs& inputs) {
    if (inputs.probes)
        return inputs.probes->bindLists(pass);
    gpu::Buffer& none = inputs.frame.standIns.noProbes;
    return pass.read("probes", none).read("probeCells", none).read("probeLists", none);
}

static void recordProxy(gpu::Frame& frame, const gpu::Pipeline& pipeline, TraceInputs inputs, TraceTarget out) {
    gpu::Pass pass = tracePass(frame, pipeline, inputs, out);
    bindLists(pass, inputs).dispatchIndirect(inputs.rays.list);
}

const Technique kProxyTechnique = {
    "proxy", March::Proxy, "trace/proxy", "one lookup, where the pixel's probe volume says", false, false, recordProxy};

} // namespace glint::reflect
