#include "reflect/input_checks.hpp"

#include "reflect/gbuffer_images.hpp"
#include "reflect/host_image.hpp"
#include "reflect/host_numbers.hpp"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace glint::reflect {
namespace {

/// Integer formats: reading them through a float sampler is undefined.
bool isInteger(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R8_UINT:
    case VK_FORMAT_R8_SINT:
    case VK_FORMAT_R8G8_UINT:
    case VK_FORMAT_R8G8_SINT:
    case VK_FORMAT_R8G8B8_UINT:
    case VK_FORMAT_R8G8B8_SINT:
    case VK_FORMAT_B8G8R8_UINT:
    case VK_FORMAT_B8G8R8_SINT:
    case VK_FORMAT_R8G8B8A8_UINT:
    case VK_FORMAT_R8G8B8A8_SINT:
    case VK_FORMAT_B8G8R8A8_UINT:
    case VK_FORMAT_B8G8R8A8_SINT:
    case VK_FORMAT_A8B8G8R8_UINT_PACK32:
    case VK_FORMAT_A8B8G8R8_SINT_PACK32:
    case VK_FORMAT_A2R10G10B10_UINT_PACK32:
    case VK_FORMAT_A2R10G10B10_SINT_PACK32:
    case VK_FORMAT_A2B10G10R10_UINT_PACK32:
    case VK_FORMAT_A2B10G10R10_SINT_PACK32:
    case VK_FORMAT_R16_UINT:
    case VK_FORMAT_R16_SINT:
    case VK_FORMAT_R16G16_UINT:
    case VK_FORMAT_R16G16_SINT:
    case VK_FORMAT_R16G16B16_UINT:
    case VK_FORMAT_R16G16B16_SINT:
    case VK_FORMAT_R16G16B16A16_UINT:
    case VK_FORMAT_R16G16B16A16_SINT:
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R32_SINT:
    case VK_FORMAT_R32G32_UINT:
    case VK_FORMAT_R32G32_SINT:
    case VK_FORMAT_R32G32B32_UINT:
    case VK_FORMAT_R32G32B32_SINT:
    case VK_FORMAT_R32G32B32A32_UINT:
    case VK_FORMAT_R32G32B32A32_SINT:
    case VK_FORMAT_R64_UINT:
    case VK_FORMAT_R64_SINT:
    case VK_FORMAT_R64G64_UINT:
    case VK_FORMAT_R64G64_SINT:
    case VK_FORMAT_R64G64B64_UINT:
    case VK_FORMAT_R64G64B64_SINT:
    case VK_FORMAT_R64G64B64A64_UINT:
    case VK_FORMAT_R64G64B64A64_SINT:
    case VK_FORMAT_S8_UINT: return true;
    default: return false;
    }
}

Result<void> checkSize(const HostImage& image, const GBufferImage& known, const ReflectionsDesc& desc) {
    if (!known.ownSize && (image.width != desc.width || image.height != desc.height))
        return invalidArgument("the G-buffer's `{}` is {}x{}, but these reflections were made for {}x{}", known.name,
                               image.width, image.height, desc.width, desc.height);
    if (image.width < 1 || image.height < 1 || image.width > kMaxSize || image.height > kMaxSize)
        return invalidArgument("the G-buffer's `{}` is {}x{}: each side must be 1 to {}", known.name, image.width,
                               image.height, kMaxSize);
    return {};
}

Result<void> checkHostImage(const gpu::Context& context, const HostImage& image, const GBufferImage& known,
                            uint32_t surfaces, const ReflectionsDesc& desc) {
    GLINT_CHECK(checkSize(image, known, desc));
    GLINT_CHECK(checkImage(context, image, formatText("the G-buffer's `{}`", known.name), known.role));
    const uint32_t wanted = known.ofSurfaces ? surfaces : 1;
    if (image.samples != wanted)
        return invalidArgument(
            "the G-buffer's `{}` has {} samples a pixel, but must have {}: depth, normal, material, baseColor, "
            "coatNormal and the material's scalars but occlusion have the same number, all others 1",
            known.name, image.samples, wanted);
    return {};
}

/// `surfaces`: samples a pixel of the images of surfaces.
Result<void> checkGBufferImage(const gpu::Context& context, const GBuffer& gbuffer, const GBufferImage& known,
                               uint32_t surfaces, const ReflectionsDesc& desc) {
    const HostImage& image = gbuffer.*known.host;
    if (!image && !known.required(gbuffer))
        return {};
    if (!image.image || !image.view)
        return invalidArgument("the G-buffer's `{}` is missing: hand over an image and its view", known.name);
    return checkHostImage(context, image, known, surfaces, desc);
}

/// Number of channels of a format that shaders read as floats; 4 for packed and compressed formats that may have fewer.
uint32_t channelsOf(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R8_UNORM:
    case VK_FORMAT_R8_SNORM:
    case VK_FORMAT_R8_SRGB:
    case VK_FORMAT_R16_UNORM:
    case VK_FORMAT_R16_SNORM:
    case VK_FORMAT_R16_SFLOAT:
    case VK_FORMAT_R32_SFLOAT: return 1;
    case VK_FORMAT_R8G8_UNORM:
    case VK_FORMAT_R8G8_SNORM:
    case VK_FORMAT_R8G8_SRGB:
    case VK_FORMAT_R16G16_UNORM:
    case VK_FORMAT_R16G16_SNORM:
    case VK_FORMAT_R16G16_SFLOAT:
    case VK_FORMAT_R32G32_SFLOAT: return 2;
    case VK_FORMAT_R8G8B8_UNORM:
    case VK_FORMAT_B8G8R8_UNORM:
    case VK_FORMAT_R16G16B16_SFLOAT:
    case VK_FORMAT_R32G32B32_SFLOAT:
    case VK_FORMAT_R5G6B5_UNORM_PACK16:
    case VK_FORMAT_B5G6R5_UNORM_PACK16:
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
    case VK_FORMAT_E5B9G9R9_UFLOAT_PACK32: return 3;
    default: return 4;
    }
}

/// The image was stated before, in the G-buffer or for another scalar: both statements must agree.
Result<void> checkStatedAlike(const HostImage& image, const char* scalar, const HostImage& before, const char* name) {
    if (isSameImage(image, before) &&
        (image.layout != before.layout || image.format != before.format || image.samples != before.samples))
        return invalidArgument("the G-buffer's `{}` is in the image of `{}`, but states another layout, format or "
                               "number of samples: state the same HostImage",
                               scalar, name);
    return {};
}

Result<void> checkScalar(const gpu::Context& context, const GBuffer& gbuffer, const MaterialScalar& scalar,
                         uint32_t surfaces, const ReflectionsDesc& desc) {
    const MaterialChannel& stated = gbuffer.*scalar.stated;
    if (stated.channel > 3)
        return invalidArgument("the G-buffer's `{}` is in channel {}: an image has channels 0 to 3", scalar.name,
                               stated.channel);
    if (!std::isfinite(stated.scale) || !std::isfinite(stated.bias))
        return invalidArgument("the G-buffer's `{}` has scale {} and bias {}: both must be finite", scalar.name,
                               stated.scale, stated.bias);
    if (!scalar.used(gbuffer) && stated.image)
        return invalidArgument("the G-buffer's `{}` has an image, but the material kind has no {}: state the kind that "
                               "has, or no image",
                               scalar.name, scalar.name);
    if (!scalar.isRead(gbuffer))
        return {};
    const HostImage& image = scalar.image(gbuffer);
    if (!image.image || !image.view)
        return invalidArgument("the G-buffer's `{}` is missing: hand over its image and view, or `material`, or state "
                               "a constant by scale 0",
                               scalar.name);
    const GBufferImage known = {scalar.name, nullptr, nullptr, nullptr, ImageRole::Color, scalar.ofSurfaces, false};
    GLINT_CHECK(checkHostImage(context, image, known, surfaces, desc));
    if (stated.channel >= channelsOf(image.format))
        return invalidArgument("the G-buffer's `{}` is in channel {}, but the format of its image (VkFormat {}) has "
                               "{} channels",
                               scalar.name, stated.channel, static_cast<int>(image.format), channelsOf(image.format));
    for (const GBufferImage& other : kGBufferImages)
        GLINT_CHECK(checkStatedAlike(image, scalar.name, gbuffer.*other.host, other.name));
    for (const MaterialScalar& other : kMaterialScalars)
        if (other.isRead(gbuffer))
            GLINT_CHECK(checkStatedAlike(image, scalar.name, other.image(gbuffer), other.name));
    return {};
}

Result<void> checkConventions(const Conventions& conventions) {
    if (!std::isfinite(conventions.motionScale[0]) || !std::isfinite(conventions.motionScale[1]))
        return invalidArgument("motionScale must be finite");
    if (!std::isfinite(conventions.motionDepthScale))
        return invalidArgument("motionDepthScale must be finite");
    if (!std::isfinite(conventions.linearDepthScale) || conventions.linearDepthScale == 0)
        return invalidArgument("linearDepthScale is {}: it must be finite and not 0", conventions.linearDepthScale);
    if (conventions.depth == DepthKind::Device && conventions.linearDepthScale != 1)
        return invalidArgument("linearDepthScale is {}, but depth is device depth: state DepthKind::LinearViewZ, or "
                               "leave it at 1",
                               conventions.linearDepthScale);
    if (conventions.roughness == RoughnessKind::Alpha && conventions.material == MaterialKind::SpecularGlossiness)
        return invalidArgument("RoughnessKind::Alpha with MaterialKind::SpecularGlossiness, whose glossiness is 1 - "
                               "perceptual roughness: state MaterialKind::F0Roughness for alpha");
    return {};
}

Result<void> checkEnvironment(const gpu::Context& context, const EnvironmentMap& environment) {
    if (!environment.cube)
        return {};
    if (!std::isfinite(environment.strength) || environment.strength < 0 || !std::isfinite(environment.rotation))
        return invalidArgument("the environment needs a strength that is not negative ({}) and a finite rotation ({})",
                               environment.strength, environment.rotation);
    GLINT_CHECK(checkCube(context, environment.cube, environment.mips, "the environment's cube"));
    if (environment.diffuse)
        GLINT_CHECK(checkCube(context, environment.diffuse, 1, "the environment's diffuse cube"));
    return {};
}

bool isFinite(const Matrix4& matrix) {
    return std::ranges::all_of(matrix, [](float value) { return std::isfinite(value); });
}

/// Returns |det| / product of the column lengths: 1 for a scaled rotation, 0 for a singular matrix.
template <class Matrix>
double volume(const Matrix& matrix) {
    double lengths = 1;
    for (int column = 0; column < Matrix::length(); ++column)
        lengths *= glm::length(matrix[column]);
    return lengths > 0 ? std::abs(glm::determinant(matrix)) / lengths : 0;
}

} // namespace

Result<void> checkImage(const gpu::Context& context, const HostImage& image, std::string_view what, ImageRole role) {
    if (isInNoLayout(image))
        return invalidArgument(
            "{} is in no layout (VkImageLayout {}), so it shows nothing: state the one that it is in", what,
            static_cast<int>(image.layout));
    if (image.format == VK_FORMAT_UNDEFINED)
        return invalidArgument("{} has no format (VK_FORMAT_UNDEFINED): state that of its view", what);
    const int format = image.format;
    if (isInteger(image.format))
        return invalidArgument("{} has an integer format (VkFormat {}), but is read as floats: use a float, unorm or "
                               "snorm format",
                               what, format);
    if (role != ImageRole::Depth && gpu::isDepth(image.format))
        return invalidArgument("{} has a depth format (VkFormat {}), but holds colours", what, format);
    if (!context.supportsFormat(image.format, VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_BIT))
        return invalidArgument("{} has a format that {} cannot sample (VkFormat {})", what, context.info().name,
                               format);
    if (image.usage != 0 && (image.usage & VK_IMAGE_USAGE_SAMPLED_BIT) == 0)
        return invalidArgument(
            "{} was created without VK_IMAGE_USAGE_SAMPLED_BIT (usage {:#x}): shaders cannot read it", what,
            image.usage);
    const VkImageViewType type = role == ImageRole::Cube ? VK_IMAGE_VIEW_TYPE_CUBE : VK_IMAGE_VIEW_TYPE_2D;
    if (image.viewType && *image.viewType != type)
        return invalidArgument("{} has a view of another type (VkImageViewType {}): it must be {}", what,
                               static_cast<int>(*image.viewType),
                               role == ImageRole::Cube ? "VK_IMAGE_VIEW_TYPE_CUBE" : "VK_IMAGE_VIEW_TYPE_2D");
    return {};
}

Result<void> checkCube(const gpu::Context& context, const HostImage& cube, uint32_t mips, std::string_view what) {
    if (!cube.image || !cube.view || cube.width < 1 || cube.width != cube.height)
        return invalidArgument("{} is {}x{}: it needs an image with square faces, and its view", what, cube.width,
                               cube.height);
    const auto most = static_cast<uint32_t>(std::bit_width(cube.width));
    if (mips < 1 || mips > most)
        return invalidArgument("{} has {} mips: faces of {} texels have 1 to {}", what, mips, cube.width, most);
    if (cube.mips != 0 && mips > cube.mips)
        return invalidArgument("{} has {} mips, but its view shows {}", what, mips, cube.mips);
    if (cube.samples != 1)
        return invalidArgument("{} has {} samples a pixel, but must have 1", what, cube.samples);
    return checkImage(context, cube, what, ImageRole::Cube);
}

Result<void> checkView(const View& view) {
    constexpr double kFlat = 1e-9; // off-centre projections are above; singular ones, with float rounding, below
    if (!isFinite(view.worldToView) || !isFinite(view.viewToClip))
        return invalidArgument("View::{} has a number that is not finite",
                               isFinite(view.worldToView) ? "viewToClip" : "worldToView");
    const glm::dmat4 worldToView(glm::make_mat4(view.worldToView.data()));
    const glm::dmat4 viewToClip(glm::make_mat4(view.viewToClip.data()));
    const glm::dvec4 last = glm::row(worldToView, 3);
    if (glm::any(glm::greaterThan(glm::abs(last - glm::dvec4(0, 0, 0, 1)), glm::dvec4(1e-4))))
        return invalidArgument("View::worldToView has the last row ({}, {}, {}, {}), not (0, 0, 0, 1): matrices are "
                               "column-major, for column vectors",
                               last.x, last.y, last.z, last.w);
    if (!(volume(glm::dmat3(worldToView)) > kFlat))
        return invalidArgument("View::worldToView has no inverse (determinant {})", glm::determinant(worldToView));
    if (!(volume(viewToClip) > kFlat))
        return invalidArgument("View::viewToClip has no inverse (determinant {})", glm::determinant(viewToClip));
    return {};
}

Result<void> checkPlane(const KnownPlane& plane) {
    constexpr float kRounding = 1e-3f;
    const float length = glm::length(toVec(plane.normalWS));
    if (!within(plane.pointWS, -kLongest, kLongest) || !(std::abs(length - 1) < kRounding))
        return invalidArgument("a KnownPlane needs a point in metres and a normal of unit length; it has the length {}",
                               length);
    return {};
}

Result<void> checkInputs(const gpu::Context& context, const GBuffer& gbuffer, const EnvironmentMap& environment,
                         const ReflectionsDesc& desc) {
    const uint32_t samples = gbuffer.depth.samples;
    if (gbuffer.depth && (samples < 1 || samples > 16 || !std::has_single_bit(samples)))
        return invalidArgument("the G-buffer's `depth` has {} samples a pixel: 1, 2, 4, 8 or 16", samples);
    for (const GBufferImage& known : kGBufferImages)
        GLINT_CHECK(checkGBufferImage(context, gbuffer, known, samples, desc));
    GLINT_CHECK(checkConventions(gbuffer.conventions));
    constexpr uint32_t kWithDepth = 3;
    if (gbuffer.motion && gbuffer.conventions.motionDepthScale != 0 && channelsOf(gbuffer.motion.format) < kWithDepth)
        return invalidArgument("motionDepthScale is {}, but the format of the G-buffer's `motion` (VkFormat {}) has {} "
                               "channels: the third one holds the difference in depth",
                               gbuffer.conventions.motionDepthScale, static_cast<int>(gbuffer.motion.format),
                               channelsOf(gbuffer.motion.format));
    for (const MaterialScalar& scalar : kMaterialScalars)
        GLINT_CHECK(checkScalar(context, gbuffer, scalar, samples, desc));
    return checkEnvironment(context, environment);
}

namespace {

Result<void> checkOutput(const gpu::Context& context, const HostImage& image, const char* name,
                         const ReflectionsDesc& desc) {
    if (!image)
        return {};
    if (!image.view)
        return invalidArgument("the output `{}` has no view", name);
    if (image.width != desc.width || image.height != desc.height)
        return invalidArgument("the output `{}` is {}x{}, but these reflections were made for {}x{}", name, image.width,
                               image.height, desc.width, desc.height);
    GLINT_CHECK(checkImage(context, image, formatText("the output `{}`", name), ImageRole::Color));
    if (image.format != VK_FORMAT_R16G16B16A16_SFLOAT)
        return invalidArgument("the output `{}` has VkFormat {}, but must have VK_FORMAT_R16G16B16A16_SFLOAT ({})",
                               name, static_cast<int>(image.format), static_cast<int>(VK_FORMAT_R16G16B16A16_SFLOAT));
    constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    if (image.usage != 0 && (image.usage & kUsage) != kUsage)
        return invalidArgument("the output `{}` was created with usage {:#x}: shaders write and read it, so "
                               "it needs STORAGE and SAMPLED ({:#x})",
                               name, image.usage, kUsage);
    if (image.samples != 1)
        return invalidArgument("the output `{}` has {} samples a pixel, but must have 1", name, image.samples);
    if (image.mips > 1)
        return invalidArgument("the output `{}` has a view of {} mips, but is written through a view of one", name,
                               image.mips);
    return {};
}

} // namespace

Result<void> checkApart(const Outputs& outputs, const GBuffer& gbuffer) {
    for (const auto& output :
         {std::pair(&outputs.composite, "composite"), std::pair(&outputs.reflection, "reflection")}) {
        const HostImage* const image = output.first;
        const char* const name = output.second;
        if (!*image)
            continue;
        const auto check = [image, name](const HostImage& input, const char* inputName) -> Result<void> {
            if (input.image == image->image)
                return invalidArgument("the output `{}` is the image of the G-buffer's `{}`, which is read while it is "
                                       "written: hand over another",
                                       name, inputName);
            return {};
        };
        for (const GBufferImage& known : kGBufferImages)
            GLINT_CHECK(check(gbuffer.*known.host, known.name));
        for (const MaterialScalar& scalar : kMaterialScalars)
            GLINT_CHECK(check((gbuffer.*scalar.stated).image, scalar.name));
    }
    return {};
}

Result<void> checkOutputs(const gpu::Context& context, const Outputs& outputs, const GBuffer& gbuffer,
                          const ReflectionsDesc& desc) {
    GLINT_CHECK(checkOutput(context, outputs.composite, "composite", desc));
    GLINT_CHECK(checkOutput(context, outputs.reflection, "reflection", desc));
    if (outputs.composite && outputs.composite.image == outputs.reflection.image)
        return invalidArgument("the outputs `composite` and `reflection` are one image: hand over two");
    GLINT_CHECK(checkOutputSettings(outputs, desc.settings));
    return checkApart(outputs, gbuffer);
}

Result<void> checkOutputSettings(const Outputs& outputs, const Settings& settings) {
    if (outputs.reflection && !outputs.composite && settings.screen.colorSource == ColorSource::Previous)
        return invalidArgument("screen.colorSource previous reads the previous frame's image with reflections, but the "
                               "outputs have `reflection` alone: hand over `composite` too, or set current");
    return {};
}

Result<void> checkLayer(const gpu::Context& context, const TransparentLayer& layer, const ReflectionsDesc& desc) {
    for (const auto& [name, host, borrowed, optional] : kLayerImages) {
        const HostImage& image = layer.*host;
        if (optional && !image)
            continue;
        if (!image.image || !image.view)
            return invalidArgument("the layer's `{}` is missing: hand over an image and its view", name);
        if (image.width != desc.width || image.height != desc.height)
            return invalidArgument("the layer's `{}` is {}x{}, but these reflections were made for {}x{}", name,
                                   image.width, image.height, desc.width, desc.height);
        if (image.samples != 1)
            return invalidArgument("the layer's `{}` has {} samples a pixel, but must have 1", name, image.samples);
        GLINT_CHECK(checkImage(context, image, formatText("the layer's `{}`", name),
                               host == &TransparentLayer::depth ? ImageRole::Depth : ImageRole::Color));
    }
    return {};
}

Result<void> checkBackend(const Settings& settings, RayBackend backend) {
    const RayBackend wanted = settings.rays.backend;
    if (settings.rays.enabled && wanted != RayBackend::Auto && wanted != backend)
        return invalidArgument("rays.backend is {}, but the RayScene was made for {}",
                               wanted == RayBackend::Query ? "query" : "bvh",
                               backend == RayBackend::Query ? "query" : "bvh");
    return {};
}

} // namespace glint::reflect
