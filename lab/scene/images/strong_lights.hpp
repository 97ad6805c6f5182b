// The strong lights of an environment's picture: a sun, or a studio's lamps. No prefiltered map can hold them: half
// floats end at 65504, and the filter spreads such a light past the horizon of the surface that reflects it. So they
// are taken out of the picture, and become lights with highlights and shadows of their own.
#pragma once

#include "lab/scene/images/hdr_image.hpp"

#include <vector>

namespace glint::scene {

/// A small disc of an equirectangular picture.
struct StrongLight {
    glm::vec3 direction = glm::vec3(0, 1, 0); ///< unit, towards the light, in the picture's own space
    glm::vec3 irradiance = glm::vec3(0);      ///< on a surface that faces the light
    float angularRadius = 0;                  ///< radians
};

constexpr size_t kMostStrongLights = 4; ///< each has a shadow map

struct DividedPicture {
    std::vector<StrongLight> lights; ///< the strongest first
    HdrImage rest;                   ///< the picture without them: as bright in their place as around them
};

/// Takes out what is small (a disc of at most three degrees' radius), brighter than 64 times the mean of the rest, and
/// at least a hundredth of the picture's light. Light is moved, and none is lost or added.
DividedPicture takeStrongLights(const HdrImage& equirect);

} // namespace glint::scene
