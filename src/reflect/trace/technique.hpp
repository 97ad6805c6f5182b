// A screen-space marcher. All marchers have the same inputs, outputs, outcomes and settings.
#pragma once

#include "glint/settings.hpp"
#include "reflect/probes/probes.hpp"
#include "reflect/stages.hpp"
#include "shared/trace_constants.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glint::reflect {

struct TraceInputs {
    FrameInputs frame;
    Prepared prepared;
    Met met; ///< what the rays may meet
    Rays& rays;
    Pyramid pyramid;                       ///< present if Technique::usesPyramid
    std::optional<PreviousFrame> previous; ///< absent: hits fetch this frame's radiance
    ProbesState* probes;                   ///< the host's; null: there are none
    gpu::Image* conePicture;               ///< null without ConePicture
    gpu::Buffer* log = nullptr;            ///< shared::RayLogHeader and samples, for the pipelines that write them
};

/// The images that marchers write. A frame writes one of the first two; the other is a single texel.
struct TraceTarget {
    gpu::Image& radianceWeight;  ///< RGBA16F
    gpu::Image& radianceWeight8; ///< RGBA8
    gpu::Image& rayRecord;
};

struct Technique {
    std::string_view name; ///< the value of `screen.march`
    March march;
    std::string_view shader;
    std::string_view summary; ///< one line for lists
    bool usesPyramid;
    /// True if the marcher samples depths along the whole ray. Otherwise it samples only the end that the host's probe
    /// volumes predict: the result is as accurate as those, and settings of the march (steps, thickness) have no
    /// effect.
    bool walks;
    void (*record)(gpu::Frame& frame, const gpu::Pipeline& pipeline, TraceInputs inputs, TraceTarget out);
};

/// All marchers. A new one is a line here, a shader and a file beside this one.
std::span<const Technique> techniques();

const Technique& techniqueFor(March march);

/// Returns the shader of the same marcher that logs its steps: shaders/trace/log.
std::string logShader(const Technique& technique);

/// Returns settings in the form that the tracing shaders read.
shared::TraceConstants traceConstants(const Settings& settings, bool backFacesKnown);

/// Binds what shaders/trace/hit_color.glsl reads.
gpu::Pass& readHitColor(gpu::Pass& pass, const TraceInputs& inputs);
/// Binds what shaders/trace/traced.glsl writes: all of the images.
gpu::Pass& writeTraced(gpu::Pass& pass, TraceTarget out);

/// Begins the pass of any marcher over the listed rays, without the bindings that only one marcher reads.
gpu::Pass tracePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, TraceInputs& inputs, TraceTarget out);

extern const Technique kLinearTechnique;
extern const Technique kAdaptiveTechnique;
extern const Technique kHizTechnique;
extern const Technique kProxyTechnique;

} // namespace glint::reflect
