// Transparent surfaces as layers that reflections take one after the other: glint/transparent_layer.hpp.
#pragma once

#include "render/surface_pass.hpp"

namespace glint::render {

/// One layer's images; at most one surface a pixel. Depth is an image a layer.
struct LayerImages {
    gpu::Image radiance;         ///< RGBA16F
    gpu::Image fallbackSpecular; ///< RGBA16F
    gpu::Image normal;           ///< as the G-buffer's
    gpu::Image material;         ///< RGBA16F: F0, perceptual roughness
    gpu::Image transmittance;    ///< RGBA16F
    gpu::Image absorption;       ///< RGBA16F
    gpu::Image body;             ///< RGBA16F
    gpu::Image objectCenter;     ///< RGBA32F
};

class TransparentLayers {
public:
    /// Up to `most` layers of a picture of this size. Errors: OutOfMemory; Unsupported on a device that draws into
    /// fewer than eight images at a time.
    static Result<TransparentLayers> create(gpu::Context& context, const GpuScene& scene, const GBufferOptions& options,
                                            const RayWorld* rayWorld, uint32_t width, uint32_t height, uint32_t most);

    /// Finds the depth of each layer, the nearest first, and how much of each pixel they cover. What lies behind the
    /// last one is not drawn.
    void peel(gpu::Frame& frame, GpuScene& scene, gpu::Buffer& view, GBuffer& gbuffer);
    /// Draws one of them. Valid until the next.
    LayerImages& draw(gpu::Frame& frame, GpuScene& scene, const LightingInputs& inputs, uint32_t layer);

    uint32_t count() const { return static_cast<uint32_t>(depths_.size()); }
    gpu::Image& depth(uint32_t layer) { return depths_[layer]; }
    /// R8_UNORM: share of the pixel's samples in which any layer is seen; absent with one sample a pixel.
    gpu::Image& coverage() { return coverage_; }

private:
    Result<void> createCoverage(gpu::Context& context, const GpuScene& scene, uint32_t samples, uint32_t width,
                                uint32_t height);
    void cover(gpu::Frame& frame, GpuScene& scene, gpu::Buffer& view, GBuffer& gbuffer);

    std::array<gpu::Pipeline, 3> first_;  ///< by topology: depth of the nearest layer, ...
    std::array<gpu::Pipeline, 3> behind_; ///< ... and of the others
    std::array<gpu::Pipeline, 3> lit_;
    std::array<gpu::Pipeline, 3> cover_;
    std::vector<gpu::Image> depths_; ///< D32_SFLOAT: reversed; the nearest layer's first
    LayerImages images_;
    gpu::Image coverSamples_;
    gpu::Image coverage_;
};

} // namespace glint::render
