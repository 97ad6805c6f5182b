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
    gpu::Image fallbackSpecular; ///< may be absent
    gpu::Image backDepth;        ///< may be absent; own size
    gpu::Image environment;      ///< cube; may be absent
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

/// `trace`: what the screen source answered.
struct Traced {
    gpu::Image radianceWeight; ///< RGBA16F: radiance at the hit, weight [0, 1]
    gpu::Image rayRecord;      ///< RG32UI, lib/ray_record.glsl
};

/// `hierarchy`: all sources under the one rule.
struct Reflected {
    gpu::Image reflected; ///< RGBA16F: sum of weight * radiance, total weight
    gpu::Image weights;   ///< RGBA8: each source's own
};

} // namespace glint::reflect
