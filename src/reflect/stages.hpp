// The data that stages of the frame pass on: structs of images, in the order of the frame. Each stage's class owns the
// images and fills in its own struct; src/reflect/frame.cpp lists the stages top to bottom.
#pragma once

#include "reflect/host.hpp"
#include "shared/frame_constants.h"
#include "shared/hierarchy.h"

#include <array>

namespace glint::reflect {

/// Data that does not change from frame to frame (prepare/tables.hpp).
struct StandIns {
    gpu::Image& dfg;        ///< RG16F: lib/dfg.glsl
    gpu::Image& black;      ///< one texel, for absent images
    gpu::Image& blackCube;  ///< for an absent environment
    gpu::Buffer& noProbes;  ///< for the lists of absent probes: zeros, a grid without a cell
    gpu::Buffer& blueNoise; ///< noise for directions; without Tables::makeNoise any buffer
};

/// Inputs of most passes.
struct FrameInputs {
    gpu::Buffer& constants; ///< shared::FrameConstants
    const shared::FrameConstants& values;
    Inputs& host;
    StandIns standIns;
    gpu::Image& rayRates;    ///< R8: denoise/ray_rate.glsl
    gpu::Image& historyMeta; ///< RGBA16F, of the previous frame's mean: denoise/accumulate.comp
};

/// `prepare`: the G-buffer in Glint's own conventions.
struct Prepared {
    gpu::Image& viewZ;   ///< R32F, metres; kBackgroundZ where nothing was drawn
    gpu::Image& surface; ///< RG32UI, lib/surface.glsl
    /// F0: in the host's format, or RGBA16F with the fraction of the pixel that this surface covers
    /// (Host::resolvesMaterial).
    gpu::Image& material;
    /// RGBA32UI, lib/edge.glsl: the second surface where that fraction is below 1; otherwise one texel.
    gpu::Image& edge;
    /// R32F, metres: the back of the object that the pixel shows; kBackgroundZ if unknown. One texel of kBackgroundZ
    /// until a host provides back faces and screen.thicknessMode uses them. With `backFacesInPlace` the host's image,
    /// in its conventions.
    gpu::Image& backViewZ;
    bool backFacesKnown;
    bool backFacesInPlace;
    /// RG32UI: the clear coat over `surface`; in the coat's own passes the surface below; without coats `surface`.
    gpu::Image& otherLobe;
};

/// What a march may meet: the surfaces of `Prepared`, or the transparent ones in front of them
/// (trace/transparents.hpp).
struct Met {
    gpu::Image& viewZ;     ///< R32F
    gpu::Image& surface;   ///< RG32UI
    gpu::Image& backViewZ; ///< as Prepared::backViewZ
};

/// Which pixels need a ray.
struct Rays {
    gpu::Buffer list; ///< shared::RayListHeader, then one word per ray
};

/// `prepare/pyramid`, for marchers that use it.
struct Pyramid {
    gpu::Image& cells; ///< RGBA32UI, lib/pyramid.glsl
    uint32_t levels;   ///< index of the coarsest level
};

/// `trace`: the answer of the screen source, at the frame's size or smaller: with screen.resolutionScale it is the top
/// left part of the same images.
struct Traced {
    gpu::Image& target;    ///< RGBA16F, or RGBA8 with screen.targetFormat rgba8: radiance at the hit, weight [0, 1]
    gpu::Image& rayRecord; ///< RG32UI, lib/ray_record.glsl; one texel unless FramePlan::keepsRecord
    uint32_t width;        ///< pixels that this frame traces
    uint32_t height;
};

/// The previous frame, which hits fetch their radiance from (screen.colorSource previous).
struct PreviousFrame {
    gpu::Image& color;      ///< its image with reflections, without layers of transparent surfaces
    gpu::Image& withLayers; ///< the same with layers
    gpu::Image& viewZ;      ///< its viewZ
};

/// What mirrors show of rough surfaces (shaders/lib/mirrored.glsl).
struct MirroredImages {
    gpu::Image& surface;
    gpu::Image& light;
};

/// Images of the sentinels (rays/sentinels_main.glsl), a texel for each tile.
struct SentinelImages {
    gpu::Image& rayBefore;
    gpu::Image& pathBefore;
    gpu::Image& ray;
    gpu::Image& path;
    gpu::Image& change;
};

/// The answers of the sources that come before a source; `black` for all others.
struct EarlierAnswers {
    uint32_t before; ///< bit s is set if source s (shared/hierarchy.h) comes before
    std::array<gpu::Image*, shared::kMaxSources> answers; ///< by source number
    gpu::Image& raysRecord; ///< which of the screen's answers `rays` replaced; unused without rays

    /// Binds the answers, as shaders/hierarchy/answers.glsl declares them.
    gpu::Pass& bind(gpu::Pass& pass) const {
        return pass.read("answers", answers).read("answersRaysRecord", raysRecord);
    }
};

/// `hierarchy`: the combination of all sources.
struct Reflected {
    gpu::Image& reflected; ///< RGBA16F: sum of weight * radiance, total weight
    gpu::Image& weights;   ///< RG32UI: the weight of each source, shaders/lib/source_weights.glsl
};

} // namespace glint::reflect
