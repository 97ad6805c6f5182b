// Builds the list of pixels that need a ray, in two passes. The first pass belongs to a source, has 8 x 8 pixels per
// group, and marks pixels through trace/ray_list.glsl. The second is trace/list. The order of the list depends only on
// the image.
#pragma once

#include "gpu/pass.hpp"
#include "reflect/stages.hpp"
#include "shared/trace_constants.h"

namespace glint::reflect {

class RayLister {
public:
    /// For images of up to this size. Errors: OutOfMemory.
    static Result<RayLister> create(gpu::Context& context, uint32_t width, uint32_t height);

    /// A list for as many. Errors: OutOfMemory.
    static Result<Rays> makeList(gpu::Context& context, const char* name, uint32_t width, uint32_t height);

    /// Call before the first pass.
    void begin(gpu::Frame& frame);
    /// Binds the first pass's outputs, as trace/ray_list.glsl declares them.
    gpu::Pass& bind(gpu::Pass& pass) { return pass.readWrite("rayTiles", tiles_).readWrite("rayBlocks", blocks_); }

    /// The pixels of the list, as bits (trace/ray_list.glsl), until the next `begin`.
    gpu::Buffer& tiles() { return tiles_; }

    /// Group counts that are dispatched if there is a ray, in addition to the rays.
    struct IfAny {
        glm::uvec2 pyramidGroups = glm::uvec2(0);
        glm::uvec2 backFaceGroups = glm::uvec2(0);
        bool always = false; ///< also without a ray
    };
    /// Records the second pass, after a first pass over `width` x `height` pixels.
    void list(gpu::Frame& frame, Rays& rays, uint32_t width, uint32_t height, const IfAny& ifAny);

private:
    gpu::Pipeline list_;
    gpu::Buffer tiles_;  ///< 64 bits per tile
    gpu::Buffer blocks_; ///< one word per kTilesPerBlock tiles
};

} // namespace glint::reflect
