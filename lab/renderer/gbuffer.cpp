#include "lab/renderer/gbuffer.hpp"

namespace glint::render {
namespace {

/// 16 bits keep a mirror's reflection sharp; 32-bit floats are used where 16-bit formats are not renderable.
VkFormat normalFormat(const gpu::Context& context) {
    constexpr VkFormatFeatureFlags2 kNeeded =
        VK_FORMAT_FEATURE_2_COLOR_ATTACHMENT_BIT | VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_BIT;
    return context.supportsFormat(VK_FORMAT_R16G16_SNORM, kNeeded) ? VK_FORMAT_R16G16_SNORM : VK_FORMAT_R32G32_SFLOAT;
}

uint32_t largestImage(const gpu::Context& context) {
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    context.api().GetPhysicalDeviceProperties2(context.physicalDevice(), &properties);
    return properties.properties.limits.maxImageDimension2D;
}

} // namespace

GBufferOptions gbufferOptions(const Settings& settings, Antialias antialias) {
    GBufferOptions options;
    options.mode = settings.gbuffer.mode;
    options.samples = antialias == Antialias::Msaa4 ? 4 : 1;
    options.backFaces = settings.screen.enabled && settings.screen.thicknessMode == ThicknessMode::Backface;
    options.backFaceDownsample = static_cast<uint32_t>(settings.screen.backfaceDownsample);
    options.backFaceTransparents = settings.screen.backfaceTransparents;
    return options;
}

std::vector<VkFormat> GBuffer::colorFormats(const gpu::Context& context) {
    return {normalFormat(context), VK_FORMAT_R16G16B16A16_SFLOAT, kMotionFormat, kRadianceFormat,
            kRadianceFormat,       VK_FORMAT_R8G8B8A8_UNORM};
}

std::vector<VkFormat> GBuffer::lobeFormats(const gpu::Context& context) {
    return {VK_FORMAT_R16G16B16A16_SFLOAT, normalFormat(context)};
}

Result<GBuffer> GBuffer::create(gpu::Context& context, uint32_t width, uint32_t height, const GBufferOptions& options) {
    const uint32_t largest = largestImage(context);
    if (width == 0 || height == 0 || width > largest || height > largest)
        return invalidArgument("a picture of {}x{} pixels cannot be made: each side may have 1 to {} on {}", width,
                               height, largest, context.info().name);
    const std::vector<VkFormat> formats = colorFormats(context);
    GBuffer result;
    constexpr VkImageUsageFlags kColor = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    constexpr VkImageUsageFlags kDepth = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    const auto make = [&](gpu::Image& image, const char* name, VkFormat format, VkImageUsageFlags attachment,
                          uint32_t samples) -> Result<void> {
        gpu::ImageDesc desc = {name,
                               format,
                               width,
                               height,
                               1,
                               1,
                               gpu::ImageShape::Flat,
                               attachment | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                   VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                               samples};
        if (samples > 1 && !context.supportsSamples(format, desc.usage, samples))
            return makeError(ErrorCode::Unsupported,
                             "{} cannot draw '{}' with {} samples a pixel: set display.antialias to fxaa or none",
                             context.info().name, name, samples);
        GLINT_TRY(made, gpu::Image::create(context, desc));
        image = std::move(made);
        return {};
    };
    const uint32_t samples = options.samples;
    const bool prepass = options.mode == GBufferMode::Prepass;
    const uint32_t surfaceSamples = prepass ? samples : 1;
    GLINT_CHECK(make(result.deviceDepth, "gbuffer/deviceDepth", kDepthFormat, kDepth, surfaceSamples));
    GLINT_CHECK(make(result.normal, "gbuffer/normal", formats[0], kColor, surfaceSamples));
    GLINT_CHECK(make(result.material, "gbuffer/material", formats[1], kColor, surfaceSamples));
    GLINT_CHECK(make(result.motion, "gbuffer/motion", formats[2], kColor, 1));
    GLINT_CHECK(make(result.litRadiance, "gbuffer/litRadiance", formats[3], kColor, 1));
    GLINT_CHECK(make(result.fallbackSpecular, "gbuffer/fallbackSpecular", formats[4], kColor, 1));
    GLINT_CHECK(make(result.albedo, "gbuffer/albedo", formats[5], kColor, 1));
    if (options.lobes) {
        const std::vector<VkFormat> lobes = lobeFormats(context);
        GLINT_CHECK(make(result.lobes, "gbuffer/lobes", lobes[0], kColor, surfaceSamples));
        GLINT_CHECK(make(result.coatNormal, "gbuffer/coatNormal", lobes[1], kColor, surfaceSamples));
        result.coat = options.coat;
    }
    if (samples > 1) {
        Multisampled& m = result.multisampled;
        if (prepass)
            GLINT_CHECK(make(m.motion, "gbuffer/multisampled/motion", formats[2], kColor, samples));
        else
            GLINT_CHECK(make(m.depth, "gbuffer/multisampled/depth", kDepthFormat, kDepth, samples));
        GLINT_CHECK(make(m.litRadiance, "gbuffer/multisampled/litRadiance", formats[3], kColor, samples));
        GLINT_CHECK(make(m.fallbackSpecular, "gbuffer/multisampled/fallbackSpecular", formats[4], kColor, samples));
        GLINT_CHECK(make(m.albedo, "gbuffer/multisampled/albedo", formats[5], kColor, samples));
    }
    if (options.backFaces) {
        const uint32_t divisor = options.backFaceDownsample + 1;
        width = (width + divisor - 1) / divisor;
        height = (height + divisor - 1) / divisor;
        GLINT_CHECK(make(result.backDepth, "gbuffer/backDepth", kDepthFormat, kDepth, 1));
    }
    return result;
}

void GBuffer::resolve(gpu::Frame& frame) {
    const auto average = [&](gpu::Image& samples, gpu::Image& image) {
        if (samples)
            frame.resolve(samples, image);
    };
    average(multisampled.motion, motion);
    average(multisampled.litRadiance, litRadiance);
    average(multisampled.fallbackSpecular, fallbackSpecular);
    average(multisampled.albedo, albedo);
}

} // namespace glint::render
