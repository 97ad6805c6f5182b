// A screen-space marcher behind the one interface: same inputs, outputs, outcomes and settings.
#pragma once

#include "glint/settings.hpp"
#include "reflect/stages.hpp"
#include "shared/trace_constants.h"

#include <span>
#include <string_view>

namespace glint::reflect {

struct TraceInputs {
    gpu::Buffer& frameConstants;
    Inputs& host;
    Prepared& prepared;
};

struct Technique {
    std::string_view name; ///< as `screen.march` says it
    March march;
    std::string_view shader;
    std::string_view summary; ///< one line for lists
    size_t pushSize;
    void (*record)(gpu::Frame& frame, const gpu::Pipeline& pipeline, const Settings& settings, TraceInputs inputs,
                   Traced& out);
};

/// Every marcher that there is. A new one is a line here, a shader and a file beside this one.
std::span<const Technique> techniques();

/// The settings that all marchers share.
shared::TraceConstants traceConstants(const Settings& settings);

extern const Technique kLinearTechnique;

} // namespace glint::reflect
