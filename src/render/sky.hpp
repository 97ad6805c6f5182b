// A clear sky computed from where the sun stands: Preetham, Shirley, Smits 1999, "A Practical Analytic Model for
// Daylight" (SIGGRAPH). One unit of radiance stands for 20 kcd/m^2, so that a white wall in the sun comes out near 1.
#pragma once

#include "render/environment.hpp"

namespace glint::render {

class Sky {
public:
    /// `elevation`  radians above the horizon, [-0.175, pi/2]; below 0 the light fades into dusk
    /// `azimuth`    radians from +X towards +Z
    /// `turbidity`  [1.7, 10]
    Sky(float elevation, float azimuth, float turbidity);

    /// Radiance of the sky, without the sun's disc; below the horizon a grey ground in that light.
    glm::vec3 radiance(const glm::vec3& direction) const;
    /// Equirectangular, `width` x `width` / 2.
    scene::HdrImage picture(uint32_t width) const;
    /// Empty once the disc is under the horizon.
    std::optional<Sun> sun() const;

private:
    glm::vec3 skyRadiance(const glm::vec3& direction) const;

    glm::vec3 directionToSun_;
    float turbidity_;
    float sunTheta_; ///< radians from the zenith, at most at the horizon: the model ends there
    float dusk_;     ///< factor, 1 by day
    glm::vec3 sunIrradiance_ = glm::vec3(0);
    glm::vec3 groundRadiance_ = glm::vec3(0);
};

} // namespace glint::render
