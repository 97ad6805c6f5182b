// A clear sky computed from the position of the sun: Preetham, Shirley, Smits 1999, "A Practical Analytic Model for
// Daylight" (SIGGRAPH). One unit of radiance is 20 kcd/m^2, so that a white wall in sunlight has a radiance near 1.
#pragma once

#include "lab/renderer/environment.hpp"

#include <optional>

namespace glint::render {

class Sky {
public:
    /// `elevation`  radians above the horizon, [-0.175, pi/2]; below 0 the light fades into dusk
    /// `azimuth`    radians from +X towards +Z
    /// `turbidity`  [1.7, 10]
    Sky(float elevation, float azimuth, float turbidity);

    /// Radiance of the sky without the sun's disc. Below the horizon it is that of grey ground lit by the sky.
    glm::vec3 radiance(const glm::vec3& direction) const;
    /// Returns an equirectangular image of `width` x `width` / 2.
    scene::HdrImage picture(uint32_t width) const;
    /// Empty if the disc is below the horizon.
    std::optional<Sun> sun() const;

private:
    glm::vec3 skyRadiance(const glm::vec3& direction) const;

    glm::vec3 directionToSun_;
    float turbidity_;
    float sunTheta_; ///< radians from the zenith, clamped to the horizon, where the model ends
    float dusk_;     ///< brightness factor, 1 by day
    glm::vec3 sunIrradiance_ = glm::vec3(0);
    glm::vec3 groundRadiance_ = glm::vec3(0);
};

} // namespace glint::render
