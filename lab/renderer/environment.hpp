// Environment light, prepared for lighting: a radiance cube filtered for every roughness, and a diffuse cube.
#pragma once

#include "gpu/resources.hpp"
#include "lab/scene/images/hdr_image.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace glint::render {

/// The sun is not in the cube maps, where it would cause noise: it is a directional light and a disc in the sky.
struct Sun {
    glm::vec3 directionToSun = glm::vec3(0, 1, 0); ///< unit, in the environment's own space
    glm::vec3 irradiance = glm::vec3(0);           ///< on a surface that faces the sun
    float angularRadius = 0.00465f;                ///< radians
};

/// Orientation of the equirectangular image: u = 0.5 + atan2(d.z, d.x) / 2pi, v = acos(d.y) / pi from the top row.
/// Rotation and strength are not baked in (RenderSettings::environment).
class Environment {
public:
    /// Errors: InvalidInput for an empty image; OutOfMemory, DeviceLost.
    static Result<Environment> create(gpu::Context& context, const scene::HdrImage& equirect,
                                      std::optional<Sun> sun = std::nullopt);
    /// Preetham's sky with its sun (lab/renderer/sky.hpp); angles in degrees, as in RenderSettings::analyticSky.
    static Result<Environment> createSky(gpu::Context& context, float elevation, float azimuth, float turbidity);
    /// Creates a black environment.
    static Result<Environment> createNone(gpu::Context& context);

    gpu::Image& radiance() { return radiance_; } ///< RGBA16F cube; mip = perceptual roughness * (mips - 1)
    gpu::Image& diffuse() { return diffuse_; }   ///< RGBA16F cube: irradiance / pi
    const std::optional<Sun>& sun() const { return sun_; }

private:
    gpu::Image radiance_;
    gpu::Image diffuse_;
    std::optional<Sun> sun_;
};

} // namespace glint::render
