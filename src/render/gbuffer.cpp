#include "render/gbuffer.hpp"

namespace glint::render {
namespace {

/// 16 bits keep a mirror's reflection sharp; where they cannot be drawn to, floats can.
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

GBufferOptions gbufferOptions(const Settings& settings) {
    GBufferOptions options;
    options.backFaces = settings.screen.enabled && settings.screen.thicknessMode == ThicknessMode::Backface;
    options.backFaceDownsample = static_cast<uint32_t>(settings.screen.backfaceDownsample);
    options.backFaceTransparents = settings.screen.backfaceTransparents;
    return options;
}

std::vector<VkFormat> GBuffer::colorFormats(const gpu::Context& context) {
    return {normalFormat(context), VK_FORMAT_R16G16B16A16_SFLOAT, kMotionFormat, kRadianceFormat,
            kRadianceFormat,       VK_FORMAT_R8G8B8A8_UNORM};
}

Result<GBuffer> GBuffer::create(gpu::Context& context, uint32_t width, uint32_t height, const GBufferOptions& options) {
    const uint32_t largest = largestImage(context);
    if (width == 0 || height == 0 || width > largest || height > largest)
        return invalidArgument("a picture of {}x{} pixels cannot be made: each side may have 1 to {} on {}", width,
                               height, largest, context.info().name);
    const std::vector<VkFormat> formats = colorFormats(context);
    GBuffer result;
    const auto make = [&](gpu::Image& image, const char* name, VkFormat format,
                          VkImageUsageFlags attachment = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT) -> Result<void> {
        GLINT_TRY(made,
                  gpu::Image::create(context, {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                                               attachment | VK_IMAGE_USAGE_SAMPLED_BIT |
                                                   VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
        image = std::move(made);
        return {};
    };
    GLINT_CHECK(
        make(result.deviceDepth, "gbuffer/deviceDepth", kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT));
    GLINT_CHECK(make(result.normal, "gbuffer/normal", formats[0]));
    GLINT_CHECK(make(result.material, "gbuffer/material", formats[1]));
    GLINT_CHECK(make(result.motion, "gbuffer/motion", formats[2]));
    GLINT_CHECK(make(result.litRadiance, "gbuffer/litRadiance", formats[3]));
    GLINT_CHECK(make(result.fallbackSpecular, "gbuffer/fallbackSpecular", formats[4]));
    GLINT_CHECK(make(result.albedo, "gbuffer/albedo", formats[5]));
    if (options.backFaces) {
        const uint32_t divisor = options.backFaceDownsample + 1;
        width = (width + divisor - 1) / divisor;
        height = (height + divisor - 1) / divisor;
        GLINT_CHECK(
            make(result.backDepth, "gbuffer/backDepth", kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT));
    }
    return result;
}

} // namespace glint::render
