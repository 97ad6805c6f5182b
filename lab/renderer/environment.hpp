// Environment light, prepared for lighting: a radiance cube filtered for every roughness, and a diffuse cube.
#pragma once

#include "gpu/resources.hpp"
#include "lab/scene/images/strong_lights.hpp"

#include <glm/glm.hpp>

#include <vector>

namespace glint::render {

/// The sun, or a lamp, is not in the cube maps, where it would cause noise and be spread past a surface's horizon: it
/// is a directional light and a disc in the sky.
using Sun = scene::StrongLight;

constexpr float kSunRadius = 0.00465f; ///< radians, of the real one

/// Orientation of the equirectangular image: u = 0.5 + atan2(d.z, d.x) / 2pi, v = acos(d.y) / pi from the top row.
/// Rotation and strength are not baked in (RenderSettings::environment).
class Environment {
public:
    /// Errors: InvalidInput for an empty image; OutOfMemory, DeviceLost.
    static Result<Environment> create(gpu::Context& context, const scene::HdrImage& equirect,
                                      std::vector<Sun> suns = {});
    /// Preetham's sky with its sun (lab/renderer/sky.hpp); angles in degrees, as in RenderSettings::analyticSky.
    static Result<Environment> createSky(gpu::Context& context, float elevation, float azimuth, float turbidity);
    /// Creates a black environment.
    static Result<Environment> createNone(gpu::Context& context);

    gpu::Image& radiance() { return radiance_; } ///< RGBA16F cube; mip = perceptual roughness * (mips - 1)
    gpu::Image& diffuse() { return diffuse_; }   ///< RGBA16F cube: irradiance / pi
    const std::vector<Sun>& suns() const { return suns_; }
    /// Radiance of 1 in the cubes, whose half floats cannot hold more than 65504: multiply what is read by it.
    float unit() const { return unit_; }

private:
    gpu::Image radiance_;
    gpu::Image diffuse_;
    std::vector<Sun> suns_;
    float unit_ = 1;
};

} // namespace glint::render
