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

/// What the library, its inspector and its tests know of a marcher.
struct Technique {
    std::string_view name; ///< the value of `screen.march`
    March march;
    std::string_view shader;
    bool usesPyramid = false;
    bool usesProbes = false; ///< the lists of the host's probes: shaders/probes/probe_lists.glsl
    /// True if the marcher samples depths along the whole ray. Otherwise it samples only the end that the host's probe
    /// volumes predict: the result is as accurate as those, and settings of the march (steps, thickness) have no
    /// effect.
    bool walks = true;
    /// True if a ray may use up its steps before its end: outcome `outOfSteps`. Otherwise the steps span the whole ray.
    bool canRunOut = false;
    uint32_t (*maxSteps)(const Settings& settings);
    /// Most depth lookups of a ray that finds its hit: those of its steps, and at the hit.
    uint32_t (*maxLookups)(const Settings& settings);
    /// Fraction of viewZ that the march adds to the thickness of surfaces.
    float (*depthBias)(const Settings& settings) = [](const Settings&) { return 0.0f; };
};

/// All marchers: the table in technique.cpp. A new one is a row there, a value of `March`, and a shader in
/// shaders/trace/march (docs/architecture.md).
std::span<const Technique> techniques();

const Technique& techniqueFor(March march);

/// Its place in techniques().
size_t indexOf(const Technique& technique);

/// Returns the shader of the same marcher that logs its steps: shaders/trace/log.
std::string logShader(const Technique& technique);

/// Returns settings in the form that the tracing shaders read.
shared::TraceConstants traceConstants(const Settings& settings, bool backFacesKnown);

/// Binds what shaders/trace/hit_color.glsl reads.
gpu::Pass& readHitColor(gpu::Pass& pass, const TraceInputs& inputs);
/// Binds what shaders/trace/traced.glsl writes: all of the images.
gpu::Pass& writeTraced(gpu::Pass& pass, TraceTarget out);

/// Marches the listed rays. `pipeline`: of the technique's shader, or of its logShader.
void recordMarch(gpu::Frame& frame, const Technique& technique, const gpu::Pipeline& pipeline, TraceInputs inputs,
                 TraceTarget out);

} // namespace glint::reflect
