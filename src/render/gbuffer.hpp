// What the renderer hands to the reflections, and to whoever looks on. One image a channel, all of one size.
#pragma once

#include "glint/settings.hpp"
#include "gpu/pass.hpp"
#include "render/render_settings.hpp"

namespace glint::render {

/// How the G-buffer is drawn.
struct GBufferOptions {
    GBufferMode mode = GBufferMode::Prepass;
    uint32_t samples = 1;            ///< a pixel
    bool backFaces = false;          ///< also draw GBuffer::backDepth
    uint32_t backFaceDownsample = 0; ///< n: at size / (n + 1), rounded up
    bool backFaceTransparents = true;
    bool operator==(const GBufferOptions&) const = default;
};

/// As the settings ask for it.
GBufferOptions gbufferOptions(const Settings& settings, Antialias antialias);

/// Every image is a colour attachment (depth: a depth attachment), can be sampled and copied from and to. Where nothing
/// was drawn, depth and every channel but litRadiance (the background) and motion are 0.
///
/// With several samples a pixel, mode prepass gives depth, normal and material all of them, as surfaces must not be
/// mixed; mode geometry gives them one. The others are means over the samples.
struct GBuffer {
    gpu::Image deviceDepth; ///< D32_SFLOAT: reversed; 0 = background
    gpu::Image normal;      ///< RG16_SNORM (or RG32_SFLOAT): octahedral, world space, shading normal
    gpu::Image material;    ///< RGBA16F: F0 in rgb, perceptual roughness in a; F0 = 0: reflects nothing
    gpu::Image motion;      ///< RG16F: previous UV - current UV, without jitter
    gpu::Image
        litRadiance; ///< RGBA16F: the whole lit picture, linear, scene-referred; a: Conventions::highlightsInAlpha
    gpu::Image fallbackSpecular; ///< RGBA16F: the environment's specular part of litRadiance, base layer only
    gpu::Image albedo;           ///< RGBA8_UNORM: base colour, linear, for debug views
    gpu::Image backDepth;        ///< as deviceDepth, of the nearest back faces; absent unless asked for; own size

    /// What is drawn to where an image above is a mean; absent with one sample a pixel.
    struct Multisampled {
        gpu::Image depth; ///< mode geometry only: the shading pass's own
        gpu::Image motion;
        gpu::Image litRadiance;
        gpu::Image fallbackSpecular;
        gpu::Image albedo;
    } multisampled;

    /// Errors: InvalidArgument for a size that the device cannot make; OutOfMemory.
    static Result<GBuffer> create(gpu::Context& context, uint32_t width, uint32_t height,
                                  const GBufferOptions& options = {});
    /// The depth image that shaded surfaces are tested against.
    gpu::Image& shadedDepth() { return multisampled.depth ? multisampled.depth : deviceDepth; }
    /// Averages what was drawn with several samples.
    void resolve(gpu::Frame& frame);
    /// The formats that `create` will choose: normal, material, motion, litRadiance, fallbackSpecular, albedo, in the
    /// order of the surface pass's outputs.
    static std::vector<VkFormat> colorFormats(const gpu::Context& context);
};

/// What is drawn to for one of its images: the image itself, or its many samples.
inline gpu::Image& drawn(gpu::Image& multisampled, gpu::Image& image) {
    return multisampled ? multisampled : image;
}

constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
constexpr VkFormat kMotionFormat = VK_FORMAT_R16G16_SFLOAT;
constexpr VkFormat kRadianceFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

} // namespace glint::render
