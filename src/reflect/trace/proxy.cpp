// The `proxy` marcher: one lookup, where the pixel's probe volume says. docs/techniques/proxy.md
#include "reflect/trace/technique.hpp"

namespace glint::reflect {

/// As shaders/probes/probe_lists.glsl declares them. An empty grid reads nothing of the other two.
static gpu::Pass& bindLists(gpu::Pass& pass, TraceInputs& inputs) {
    if (inputs.probes)
        return inputs.probes->bindLists(pass);
    return pass.read("probes", inputs.noProbes).read("probeCells", inputs.noProbes).read("probeLists", inputs.noProbes);
}

static void record(gpu::Frame& frame, const gpu::Pipeline& pipeline, const Settings& settings, TraceInputs inputs,
                   Traced& out) {
    gpu::Pass pass = tracePass(frame, pipeline, settings, inputs, out);
    bindLists(pass, inputs).dispatchIndirect(inputs.rays.list);
}

const Technique kProxyTechnique = {
    "proxy", March::Proxy, "trace/proxy", "one lookup, where the pixel's probe volume says", false, false, record};

} // namespace glint::reflect
