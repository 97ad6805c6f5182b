// Shadow maps of directional and spot lights, side by side in one depth image. Point lights cast no shadows.
#pragma once

#include "gpu/pass.hpp"
#include "lab/renderer/gpu_scene.hpp"
#include "lab/renderer/lights.hpp"

namespace glint::render {

class ShadowMaps {
public:
    static Result<ShadowMaps> create(gpu::Context& context, const GpuScene& scene);

    /// Makes the atlas large enough for `count` lights of `resolution`^2 texels; smaller if the device's image size
    /// limit requires it. Does nothing if the atlas already has that shape. Errors: OutOfMemory.
    Result<void> resize(gpu::Context& context, uint32_t count, uint32_t resolution);

    /// Returns how many of `lights` can cast shadows.
    static uint32_t casters(const std::vector<shared::Light>& lights);

    /// Fills in the shadow fields of the lights that fit into the atlas. The map of a directional light covers the
    /// whole scene, that of a spot light its cone.
    void place(std::span<shared::Light> lights, const scene::Bounds& boundsWS) const;
    /// Draws the shadow maps of the lights that `place` put into the atlas.
    void draw(gpu::Frame& frame, GpuScene& scene, std::span<const shared::Light> lights, gpu::Buffer& lightBuffer);

    gpu::Image& atlas() { return atlas_; } ///< D32_SFLOAT, reversed depth

private:
    gpu::Pipeline opaque_;
    gpu::Pipeline masked_;
    gpu::Image atlas_;
    uint32_t tileSize_ = 0; ///< texels
    uint32_t columns_ = 0;
    uint32_t tiles_ = 0;
};

} // namespace glint::render
