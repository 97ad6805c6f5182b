// A screen-space marcher behind the one interface: same inputs, outputs, outcomes and settings.
#pragma once

#include "glint/settings.hpp"
#include "reflect/probes/probes.hpp"
#include "reflect/stages.hpp"
#include "shared/trace_constants.h"

#include <span>
#include <string>
#include <string_view>

namespace glint::reflect {

struct TraceInputs {
    gpu::Buffer& frameConstants;
    Inputs& host;
    Prepared& prepared;
    Rays& rays;
    Pyramid& pyramid; ///< made if Technique::usesPyramid
    bool backFacesKnown = false;
    History* history;           ///< null: hits take this frame's colour
    gpu::Image& black;          ///< stands in for what is absent
    ProbesState* probes;        ///< the host's; null: there are none
    gpu::Buffer& noProbes;      ///< stands in for their lists
    gpu::Buffer* log = nullptr; ///< shared::RayLogHeader and samples, for the pipelines that write them
};

struct Technique {
    std::string_view name; ///< as `screen.march` says it
    March march;
    std::string_view shader;
    std::string_view summary; ///< one line for lists
    bool usesPyramid;
    /// Looks at depths all along the ray. Else only at the end that the host's probe volumes predict: as right as
    /// those, and nothing that is about the way (steps, thickness) acts.
    bool walks;
    void (*record)(gpu::Frame& frame, const gpu::Pipeline& pipeline, const Settings& settings, TraceInputs inputs,
                   Traced& out);
};

/// Every marcher that there is. A new one is a line here, a shader and a file beside this one.
std::span<const Technique> techniques();

const Technique& techniqueFor(March march);

/// The same marcher that writes down what it does: shaders/trace/log.
std::string logShader(const Technique& technique);

/// Settings as the tracing shaders take them.
shared::TraceConstants traceConstants(const Settings& settings, bool backFacesKnown);

/// Binds what shaders/trace/hit_color.glsl reads.
gpu::Pass& readHitColor(gpu::Pass& pass, TraceInputs& inputs);
/// Binds what shaders/trace/traced.glsl writes; `keep`: other passes wrote the rest of it.
gpu::Pass& writeTraced(gpu::Pass& pass, Traced& out, bool keep);

/// The pass of any marcher over the listed rays, still without what only it reads.
gpu::Pass tracePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, const Settings& settings, TraceInputs& inputs,
                    Traced& out);

extern const Technique kLinearTechnique;
extern const Technique kAdaptiveTechnique;
extern const Technique kHizTechnique;
extern const Technique kProxyTechnique;

} // namespace glint::reflect
