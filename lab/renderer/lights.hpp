// The lights of a frame: the scene's lights and the environment's suns, with their tiles in the shadow atlas.
#pragma once

#include "lab/renderer/environment.hpp"
#include "lab/renderer/render_settings.hpp"
#include "lab/scene/pose.hpp"
#include "shared/light.h"

#include <vector>

namespace glint::render {

/// Returns the scene's lights in the form that shaders read, without shadows. Lights beyond shared::kMaxLights -
/// scene::kMostStrongLights are dropped with a warning: the rest is reserved for the environment's.
std::vector<shared::Light> gpuLights(const scene::Pose& pose);

/// Returns the sun as a directional light, with the environment's rotation and strength applied.
shared::Light sunLight(const Sun& sun, const EnvironmentSettings& settings);

/// Rotates a direction from environment space to world space.
glm::vec3 rotateFromEnvironment(const glm::vec3& direction, float degrees);

} // namespace glint::render
