#include "lab/renderer/environment.hpp"

#include "gpu/cube_prefilter.hpp"
#include "gpu/transfer.hpp"
#include "lab/renderer/sky.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <bit>
#include <optional>

namespace glint::render {
namespace {

constexpr VkFormat kCubeFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr uint32_t kSmallestFace = 32;
constexpr uint32_t kLargestFace = 1024;
constexpr uint32_t kDiffuseFace = 16;

/// About one face texel per texel of the image's equator, so that mip 0 is as sharp as the image.
uint32_t faceSize(const scene::HdrImage& equirect) {
    return std::clamp(std::bit_ceil(equirect.width / 4), kSmallestFace, kLargestFace);
}

Result<gpu::Image> makeCube(gpu::Context& context, const char* name, uint32_t face, uint32_t mips) {
    return gpu::Image::create(context, {name, kCubeFormat, face, face, mips, 6, gpu::ImageShape::Cube,
                                        VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                            VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
}

/// The radiance that is stored as 1. Environments that are too bright for halves are stored darker; what is dark then
/// loses bits before what is bright is cut.
float unitOf(const scene::HdrImage& equirect) {
    constexpr float kLargestStored = 65000;
    constexpr float kLargestUnit = 4096;
    float brightest = 0;
    for (const glm::vec3& rgb : equirect.rgb)
        brightest = std::max({brightest, rgb.r, rgb.g, rgb.b});
    return std::clamp(brightest / kLargestStored, 1.0f, kLargestUnit);
}

Result<gpu::Image> uploadEquirect(gpu::Context& context, const scene::HdrImage& equirect, float unit) {
    GLINT_TRY(image, gpu::Image::create(context, {"environment/equirect", kCubeFormat, equirect.width, equirect.height,
                                                  1, 1, gpu::ImageShape::Flat,
                                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
    std::vector<uint64_t> texels(equirect.rgb.size()); // four halves each
    std::transform(equirect.rgb.begin(), equirect.rgb.end(), texels.begin(), [unit](const glm::vec3& rgb) {
        return glm::packHalf4x16(glm::vec4(glm::min(rgb / unit, glm::vec3(scene::kMaxRadiance)), 1));
    });
    GLINT_CHECK(gpu::uploadImage(context, image, std::as_bytes(std::span(texels))));
    return image;
}

} // namespace

Result<Environment> Environment::create(gpu::Context& context, const scene::HdrImage& equirect, std::vector<Sun> suns) {
    if (equirect.width == 0 || equirect.rgb.size() != size_t{equirect.width} * equirect.height)
        return makeError(ErrorCode::InvalidInput, "the environment's picture is empty");
    GLINT_TRY(toCube, gpu::Pipeline::compute(context, {"environment/equirect_to_cube", 0, {}}));
    GLINT_TRY(prefilter, gpu::CubePrefilter::create(context));
    GLINT_TRY(integrate, gpu::Pipeline::compute(context, {"environment/diffuse", 0, {}}));

    const uint32_t face = faceSize(equirect);
    const uint32_t mips = gpu::cubeMips(face, gpu::kLastFilteredFace);
    const float unit = unitOf(equirect);
    GLINT_TRY(picture, uploadEquirect(context, equirect, unit));
    GLINT_TRY(source, makeCube(context, "environment/source", face, gpu::cubeMips(face, 1)));
    Environment result;
    GLINT_TRY(radiance, makeCube(context, "environment/radiance", face, mips));
    GLINT_TRY(diffuse, makeCube(context, "environment/diffuse", kDiffuseFace, 1));

    GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(context, commands);
        constexpr auto kWrap = gpu::SamplerKind::LinearRepeat;
        frame.pass(toCube).read("equirect", picture, kWrap).write("cube", source).dispatch(face, face, 6);
        frame.pass(toCube).read("equirect", picture, kWrap).write("cube", radiance).dispatch(face, face, 6);
        frame.makeMips(source);
        prefilter.filter(frame, source, radiance);
        frame.pass(integrate).read("source", source).write("diffuse", diffuse).dispatch(kDiffuseFace, kDiffuseFace, 6);
    }));
    result.radiance_ = std::move(radiance);
    result.diffuse_ = std::move(diffuse);
    result.suns_ = std::move(suns);
    result.unit_ = unit;
    return result;
}

Result<Environment> Environment::createSky(gpu::Context& context, float elevation, float azimuth, float turbidity) {
    const Sky sky(glm::radians(elevation), glm::radians(azimuth), turbidity);
    const std::optional<Sun> sun = sky.sun();
    return create(context, sky.picture(512), sun ? std::vector<Sun>{*sun} : std::vector<Sun>());
}

Result<Environment> Environment::createNone(gpu::Context& context) {
    return create(context, {4, 2, std::vector<glm::vec3>(8, glm::vec3(0))});
}

} // namespace glint::render
