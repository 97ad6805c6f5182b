// The renderer's G-buffer, which is the input of the reflections and of debug views. One image per channel, all of one
// size.
#pragma once

#include "glint/settings.hpp"
#include "gpu/pass.hpp"
#include "lab/renderer/render_settings.hpp"

namespace glint::render {

/// How the G-buffer is drawn.
struct GBufferOptions {
    GBufferMode mode = GBufferMode::Prepass;
    uint32_t samples = 1;            ///< samples per pixel
    bool backFaces = false;          ///< also draw GBuffer::backDepth
    uint32_t backFaceDownsample = 0; ///< n: at size / (n + 1), rounded up
    bool backFaceTransparents = true;
    bool lobes = false; ///< also draw GBuffer::lobes and coatNormal
    bool coat = false;  ///< some surface has a clear coat; needs `lobes`
    bool operator==(const GBufferOptions&) const = default;
};

/// Returns the options that the settings require.
GBufferOptions gbufferOptions(const Settings& settings, Antialias antialias);

/// Every image is a colour attachment (depth: a depth attachment), can be sampled, and can be copied from and to. Where
/// nothing was drawn, depth and every channel except litRadiance (the background) and motion are 0.
///
/// With several samples per pixel, mode prepass stores depth, normal and material multisampled, as surfaces must not be
/// mixed; mode geometry stores them with one sample. The other channels are means over the samples.
struct GBuffer {
    gpu::Image deviceDepth; ///< D32_SFLOAT: reversed; 0 = background
    gpu::Image normal;      ///< RG16_SNORM (or RG32_SFLOAT): octahedral, world space, shading normal
    gpu::Image material;    ///< RGBA16F: F0 in rgb, perceptual roughness in a; F0 = 0: reflects nothing
    gpu::Image motion;      ///< RGBA16F: previous UV - current UV, without jitter; previous - current viewZ, metres
    gpu::Image litRadiance; ///< RGBA16F: the complete lit image, linear; a: its mean without highlights
    gpu::Image fallbackSpecular; ///< RGBA16F: the environment's specular part of litRadiance; coats' only with `lobes`
    gpu::Image albedo;           ///< RGBA8_UNORM: base colour, linear, for debug views; a: coverage of the pixel
    gpu::Image lobes;      ///< RGBA16F: F90; strength and perceptual roughness of the clear coat; absent without lobes
    gpu::Image coatNormal; ///< as normal, of the clear coat; absent without lobes
    bool coat = false;     ///< some surface may have one
    gpu::Image backDepth;  ///< as deviceDepth, of the nearest back faces; absent without backFaces; has its own size

    /// Multisampled render targets of the channels that are means; absent with one sample per pixel.
    struct Multisampled {
        gpu::Image depth; ///< mode geometry only: depth of the shading pass
        gpu::Image motion;
        gpu::Image litRadiance;
        gpu::Image fallbackSpecular;
        gpu::Image albedo;
    } multisampled;

    /// Errors: InvalidArgument for a size that the device does not support; OutOfMemory.
    static Result<GBuffer> create(gpu::Context& context, uint32_t width, uint32_t height,
                                  const GBufferOptions& options = {});
    /// The depth image that shaded surfaces are tested against.
    gpu::Image& shadedDepth() { return multisampled.depth ? multisampled.depth : deviceDepth; }
    /// Resolves multisampled channels to their means.
    void resolve(gpu::Frame& frame);
    /// Returns the formats that `create` uses: normal, material, motion, litRadiance, fallbackSpecular, albedo, in the
    /// order of the surface pass's outputs.
    static std::vector<VkFormat> colorFormats(const gpu::Context& context);
    /// Those of lobes and coatNormal.
    static std::vector<VkFormat> lobeFormats(const gpu::Context& context);
};

/// Returns the render target of a channel: its multisampled image if present, otherwise the image itself.
inline gpu::Image& drawn(gpu::Image& multisampled, gpu::Image& image) {
    return multisampled ? multisampled : image;
}

constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
constexpr VkFormat kMotionFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat kRadianceFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

} // namespace glint::render
