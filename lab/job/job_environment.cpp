#include "lab/job/job_environment.hpp"

#include <cstddef>
#include <utility>

namespace glint::render {
namespace {

/// Flips an image whose rows run from the bottom up.
scene::HdrImage turnedOver(const scene::HdrImage& image) {
    scene::HdrImage result = {image.width, image.height, {}};
    for (uint32_t y = image.height; y-- > 0;)
        result.rgb.insert(result.rgb.end(), image.rgb.begin() + std::ptrdiff_t{y} * image.width,
                          image.rgb.begin() + std::ptrdiff_t{y + 1} * image.width);
    return result;
}

} // namespace

Result<Environment> makeEnvironment(gpu::Context& context, const JobInputs& inputs, const RenderSettings& settings,
                                    StrongLights strongLights) {
    switch (inputs.environment) {
    case EnvironmentKind::Image: {
        const scene::HdrImage picture =
            settings.environment.isProbe ? turnedOver(inputs.environmentImage) : inputs.environmentImage;
        if (strongLights == StrongLights::Kept)
            return Environment::create(context, picture);
        scene::DividedPicture divided = scene::takeStrongLights(picture);
        return Environment::create(context, divided.rest, std::move(divided.lights));
    }
    case EnvironmentKind::Sky:
        return Environment::createSky(context, settings.analyticSky.elevation, settings.analyticSky.azimuth,
                                      settings.analyticSky.turbidity);
    case EnvironmentKind::None: break;
    }
    return Environment::createNone(context);
}

} // namespace glint::render
