// Transparent layers over the frame's picture: what comes through them and what they reflect.
#pragma once

#include "glint/settings.hpp"
#include "glint/transparent_layer.hpp"
#include "reflect/probes/probes.hpp"
#include "reflect/stages.hpp"
#include "shared/refraction.h"

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

/// What the pass reads of the frame.
struct LayerInputs {
    gpu::Buffer& frameConstants;
    Prepared& prepared;
    Pyramid& pyramid;
    ProbesState* probes;     ///< null: none take part
    gpu::Image* environment; ///< null: none
    gpu::Image& dfg;
    gpu::Image& black; ///< stands in for what is absent
    gpu::Image& blackCube;
};

/// Made if the host announced layers (ReflectionsDesc::transparentLayers).
class Refraction {
public:
    /// `views`: keep what views show. Errors: OutOfMemory; Unsupported on a device that reads too few images in a pass.
    static Result<std::unique_ptr<Refraction>> create(gpu::Context& context, uint32_t width, uint32_t height,
                                                      bool views);

    /// Makes the pipeline for these, which must outlive the frames. Errors: OutOfMemory.
    Result<void> setProbes(ProbesState& probes);

    /// Over `composite`, in place.
    void record(gpu::Frame& frame, const Settings& settings, LayerImages& layer, const LayerInputs& inputs,
                gpu::Image& composite);
    /// A frame's picture is there, without layers.
    void begin(gpu::Frame& frame, gpu::Image& composite);

    gpu::Image& refracted() { return refracted_; } ///< RGBA16F: radiance that comes through the nearest layer; a = 1
    gpu::Image& weights() { return weights_; }     ///< RGBA16F: of screen, probes and sky

private:
    explicit Refraction(gpu::Context& context) : context_(context) {}

    gpu::Context& context_;
    gpu::Pipeline alone_;
    gpu::Pipeline withProbes_; ///< for the host's probes
    gpu::Pipeline edges_;
    gpu::Pipeline depth_;
    gpu::Image solid_;     ///< RGBA16F with mips: the picture without layers
    gpu::Image behind_;    ///< the same with those so far
    gpu::Image layersZ_;   ///< R32F: viewZ of the nearest of these; kBackgroundZ: none
    gpu::Image refracted_; ///< one texel without views
    gpu::Image weights_;
    bool views_ = false;
};

} // namespace glint::reflect
