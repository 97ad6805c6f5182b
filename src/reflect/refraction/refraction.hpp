// Draws transparent layers over the frame's image: their refraction and their reflections.
#pragma once

#include "glint/settings.hpp"
#include "glint/transparent_layer.hpp"
#include "gpu/mip_chain.hpp"
#include "gpu/retired.hpp"
#include "reflect/probes/probes.hpp"
#include "reflect/stage.hpp"
#include "reflect/stages.hpp"
#include "shared/refraction.h"
#include "shared/trace_constants.h"

#include <memory>

namespace glint::reflect {

/// The host's images of one layer, borrowed.
struct LayerImages {
    gpu::Image depth;
    gpu::Image normal;
    gpu::Image material;
    gpu::Image radiance;
    gpu::Image fallbackSpecular; ///< may be absent
    gpu::Image transmittance;
    gpu::Image absorption;
    gpu::Image body;
    gpu::Image objectCenter; ///< may be absent
    gpu::Image coverage;     ///< may be absent
};

/// Inputs from the frame.
struct LayerInputs {
    FrameInputs frame;
    Prepared prepared;
    Pyramid pyramid;
    ProbesState* probes; ///< null: probes are not used
};

/// Settings for both rays of a layer, which hiz marches. `levels`: of the depth pyramid.
shared::TraceConstants layerTraceConstants(const Settings& settings, uint32_t levels);
/// Settings refraction.*. `probes`, `environment`: the host provides them.
shared::RefractionConstants refractionConstants(const Settings& settings, bool probes, bool environment);

/// Created if the host declares layers (ReflectionsDesc::transparentLayers).
class Refraction {
public:
    static bool wanted(const PlanInputs& inputs) { return inputs.transparentLayers; }
    /// Errors: OutOfMemory; Unsupported on a device that can bind too few images in a pass.
    static Result<std::unique_ptr<Refraction>> create(StageContext& stages);

    /// Compiles the pipeline that layers need, if there are any: by far the largest of the library. Errors:
    /// Unsupported.
    Result<void> make(const Settings& settings) const;
    /// Creates the pipeline for these probes, which must outlive the frames. Errors: OutOfMemory.
    Result<void> setProbes(ProbesState& probes, gpu::Retired& retired);

    /// Draws a layer over `composite`, in place.
    void record(gpu::Frame& frame, LayerImages& layer, const LayerInputs& inputs, gpu::Image& composite);
    /// Begins the layers of a frame, whose image has no layers yet.
    void begin(gpu::Frame& frame, gpu::Image& composite);
    /// The image without layers of the last frame that `begin` began.
    gpu::Image& withoutLayers() { return solid_; }

    gpu::Image& refracted() { return refracted_; } ///< RGBA16F: radiance transmitted by the nearest layer; a = 1
    gpu::Image& weights() { return weights_; }     ///< RGBA16F: weights of screen, probes and sky

private:
    explicit Refraction(gpu::Context& context) : context_(context) {}

    gpu::Context& context_;
    gpu::Pipeline alone_;
    gpu::Pipeline withProbes_; ///< for the host's probes
    gpu::Pipeline edges_;
    gpu::Pipeline depth_;
    gpu::MipChain mips_;
    gpu::Image solid_;     ///< RGBA16F with mips: the image without layers, until the next frame's begin
    gpu::Image behind_;    ///< RGBA16F with mips: the image with the layers so far
    gpu::Image layersZ_;   ///< R32F: viewZ of the nearest layer so far; kBackgroundZ: none
    gpu::Image refracted_; ///< one texel unless views are kept
    gpu::Image weights_;
    bool views_ = false;
};

} // namespace glint::reflect
