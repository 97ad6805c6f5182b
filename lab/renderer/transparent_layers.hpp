// Transparent surfaces as layers that the reflections process one after the other: glint/transparent_layer.hpp.
#pragma once

#include "lab/renderer/surface_pass.hpp"

namespace glint::render {

/// The images of one layer, with at most one surface per pixel. Each layer has its own depth image.
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
    /// Creates up to `most` layers for images of this size. Errors: OutOfMemory; Unsupported on a device with fewer
    /// than eight colour attachments.
    static Result<TransparentLayers> create(gpu::Context& context, const GpuScene& scene, const GBufferOptions& options,
                                            const RayWorld* rayWorld, uint32_t width, uint32_t height, uint32_t most);

    /// Finds the depth of each layer, the nearest first. Surfaces behind the last layer are not drawn.
    void peel(gpu::Frame& frame, GpuScene& scene, gpu::Buffer& view, GBuffer& gbuffer);
    /// Draws one layer. The result is valid until the next call.
    LayerImages& draw(gpu::Frame& frame, GpuScene& scene, const LightingInputs& inputs, uint32_t layer);
    /// With several samples per pixel: measures the coverage of one layer. The result is valid until the next call.
    void cover(gpu::Frame& frame, GpuScene& scene, gpu::Buffer& view, GBuffer& gbuffer, uint32_t layer);

    uint32_t count() const { return static_cast<uint32_t>(depths_.size()); }
    gpu::Image& depth(uint32_t layer) { return depths_[layer]; }
    /// RG8_UNORM: TransparentLayer::coverage of one layer; absent with one sample per pixel.
    gpu::Image& coverage() { return coverage_; }

private:
    Result<void> createCoverage(gpu::Context& context, const GpuScene& scene, uint32_t samples, uint32_t width,
                                uint32_t height);

    std::array<gpu::Pipeline, 3> first_;  ///< by topology: depth of the nearest layer
    std::array<gpu::Pipeline, 3> behind_; ///< by topology: depth of the other layers
    std::array<gpu::Pipeline, 3> lit_;
    std::array<gpu::Pipeline, 3> coverFirst_;
    std::array<gpu::Pipeline, 3> coverBehind_;
    std::vector<gpu::Image> depths_; ///< D32_SFLOAT: reversed; the nearest layer first
    LayerImages images_;
    gpu::Image coverSamples_;
    gpu::Image coverage_;
};

} // namespace glint::render
