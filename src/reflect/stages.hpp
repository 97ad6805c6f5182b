// What one stage of the frame hands to the next: structs of images, in the order of the frame. A stage's function takes
// the structs before it and fills in its own; src/reflect/frame.cpp lists them top to bottom.
#pragma once

#include "gpu/pass.hpp"

namespace glint::reflect {

/// The host's images, wrapped so that barriers can be worked out; borrowed.
struct Inputs {
    gpu::Image depth;
    gpu::Image normal;
    gpu::Image material;  ///< may be absent
    gpu::Image baseColor; ///< may be absent
    gpu::Image litRadiance;
    gpu::Image fallbackSpecular;   ///< may be absent
    gpu::Image backDepth;          ///< may be absent; own size
    gpu::Image motion;             ///< may be absent
    gpu::Image environment;        ///< cube; may be absent
    gpu::Image environmentDiffuse; ///< cube; may be absent
};

/// `prepare`: the G-buffer in Glint's own conventions.
struct Prepared {
    gpu::Image viewZ;    ///< R32F, metres; kBackgroundZ where nothing was drawn
    gpu::Image surface;  ///< RG32UI, lib/surface.glsl
    gpu::Image material; ///< RGBA16F: F0; share of the pixel that shows this surface, 1 but for hosts with many samples
    gpu::Image edge;     ///< RGBA32UI, lib/edge.glsl: the second surface where that share is below 1; else one texel
    /// R32F, metres, of the size of the host's backDepth: where the nearest back face is; kBackgroundZ where there is
    /// none. One texel of kBackgroundZ until a host hands over back faces and screen.thicknessMode asks for them.
    gpu::Image backViewZ;
};

/// `trace/classify`: which pixels need a ray.
struct Rays {
    gpu::Buffer list; ///< shared::RayListHeader, then a word a ray
};

/// `prepare/pyramid`, for the marchers that ask for it.
struct Pyramid {
    gpu::Image cells; ///< RGBA32UI, lib/pyramid.glsl
    gpu::Buffer tiles;
    uint32_t levels = 0; ///< the coarsest one's number
};

/// `trace`: what the screen source answered, at the picture's size or smaller: screen.resolutionScale takes the top
/// left part of the same images.
struct Traced {
    gpu::Image radianceWeight;  ///< RGBA16F: radiance at the hit, weight [0, 1]; absent if only the next is wanted
    gpu::Image radianceWeight8; ///< RGBA8: the same with screen.targetFormat rgba8
    gpu::Image unused;          ///< RGBA16F, one texel: stands in for whichever of the two a frame does not write
    gpu::Image unused8;         ///< RGBA8
    gpu::Image rayRecord;       ///< RG32UI, lib/ray_record.glsl
    bool eightBits = false;     ///< this frame writes radianceWeight8
    uint32_t width = 1;         ///< pixels that this frame traces
    uint32_t height = 1;
    gpu::Image& target() { return eightBits ? radianceWeight8 : radianceWeight; }
};

/// The previous frame, as far as hits take their colour from it (screen.colorSource previous).
struct History {
    gpu::Image color; ///< its picture with reflections
    gpu::Image viewZ; ///< what it showed
};

/// `denoise`: the screen source's answer for every pixel.
struct Denoised {
    gpu::Image radianceWeight;    ///< RGBA16F, the picture's size; absent until settings ask for it
    gpu::Image blurred[2];        ///< RGBA16F: along x, then along both; absent until settings ask for it
    gpu::Image* answer = nullptr; ///< the image that holds this frame's answer: `radianceWeight`, or the traced one
};

/// What the sources have answered that are asked before one; `black` where they are not.
struct EarlierAnswers {
    uint32_t before; ///< bit s: source s (shared/hierarchy.h) is one of them
    gpu::Image& screen;
    gpu::Image& rays;
    gpu::Image& raysRecord; ///< which of the screen's answers rays replaced; of no matter without rays
    gpu::Image& planar;
    gpu::Image& probes;

    /// As shaders/hierarchy/taken_before.glsl declares them.
    gpu::Pass& bind(gpu::Pass& pass) const {
        return pass.read("earlierScreen", screen)
            .read("earlierRays", rays)
            .read("earlierRaysRecord", raysRecord)
            .read("earlierPlanar", planar)
            .read("earlierProbes", probes);
    }
};

/// `hierarchy`: all sources under the one rule.
struct Reflected {
    gpu::Image reflected; ///< RGBA16F: sum of weight * radiance, total weight
    gpu::Image weights;   ///< RG32UI: each source's own, shaders/lib/source_weights.glsl
};

} // namespace glint::reflect
