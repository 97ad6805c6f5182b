// Checks of the host's inputs before they are used: each mistake gives one clear error.
#pragma once

#include "base/result.hpp"
#include "glint/reflections.hpp"
#include "reflect/refraction/refraction.hpp"

#include <array>
#include <string_view>

namespace glint::reflect {

constexpr uint32_t kMaxSize = 16384; ///< pixels per side; every Vulkan 1.3 desktop device supports it

/// An image of a layer: one sample per pixel; most have no default if absent.
struct LayerImage {
    const char* name;
    HostImage TransparentLayer::*host;
    gpu::Image LayerImages::*borrowed;
    bool optional;
};

constexpr std::array<LayerImage, 10> kLayerImages = {{
    {"depth", &TransparentLayer::depth, &LayerImages::depth, false},
    {"normal", &TransparentLayer::normal, &LayerImages::normal, false},
    {"material", &TransparentLayer::material, &LayerImages::material, false},
    {"radiance", &TransparentLayer::radiance, &LayerImages::radiance, false},
    {"fallbackSpecular", &TransparentLayer::fallbackSpecular, &LayerImages::fallbackSpecular, true},
    {"transmittance", &TransparentLayer::transmittance, &LayerImages::transmittance, false},
    {"absorption", &TransparentLayer::absorption, &LayerImages::absorption, false},
    {"body", &TransparentLayer::body, &LayerImages::body, false},
    {"objectCenter", &TransparentLayer::objectCenter, &LayerImages::objectCenter, true},
    {"coverage", &TransparentLayer::coverage, &LayerImages::coverage, true},
}};

enum class ImageRole : uint8_t {
    Color, ///< a 2D view that shaders read as floats
    Depth, ///< as Color, and depth formats
    Cube,  ///< a cube view that shaders read as floats
};

/// Checks one image except for its size: format, layout, usage and view. `what` begins the message.
Result<void> checkImage(const gpu::Context& context, const HostImage& image, std::string_view what, ImageRole role);

/// Checks a cube map of which `mips` levels are read. Errors: InvalidArgument.
Result<void> checkCube(const gpu::Context& context, const HostImage& cube, uint32_t mips, std::string_view what);

/// Errors: InvalidArgument for a matrix with a non-finite number, a singular matrix, or a worldToView whose last row is
/// not (0, 0, 0, 1), as in a transposed matrix.
Result<void> checkView(const View& view);

/// Errors: InvalidArgument for a number that is not finite, or a normal without unit length.
Result<void> checkPlane(const KnownPlane& plane);

/// Checks the arguments of Reflections::setInputs. Errors: InvalidArgument names the image or the number.
Result<void> checkInputs(const gpu::Context& context, const GBuffer& gbuffer, const EnvironmentMap& environment,
                         const ReflectionsDesc& desc);

/// Checks the argument of Reflections::setOutputs; `gbuffer`: the inputs in force. Errors: InvalidArgument names the
/// image.
Result<void> checkOutputs(const gpu::Context& context, const Outputs& outputs, const GBuffer& gbuffer,
                          const ReflectionsDesc& desc);

/// Checks that no image is both input and output. Errors: InvalidArgument names the images.
Result<void> checkApart(const Outputs& outputs, const GBuffer& gbuffer);

/// Checks that the outputs have what the settings read again. Errors: InvalidArgument names the setting.
Result<void> checkOutputSettings(const Outputs& outputs, const Settings& settings);

/// Checks the arguments of Reflections::recordLayer. Errors: InvalidArgument names the image.
Result<void> checkLayer(const gpu::Context& context, const TransparentLayer& layer, const ReflectionsDesc& desc);

/// Checks the setting against the scene's back end: the scene was created before, so the setting cannot choose it.
Result<void> checkBackend(const Settings& settings, RayBackend backend);

} // namespace glint::reflect
