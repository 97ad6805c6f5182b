// The lights of a frame: those of the scene and the sky's sun, with their place in the shadow atlas.
#pragma once

#include "render/environment.hpp"
#include "render/render_settings.hpp"
#include "scene/pose.hpp"
#include "shared/light.h"

#include <vector>

namespace glint::render {

/// The scene's lights in the form that shaders read, without shadows. More than shared::kMaxLights - 1 (one is kept for
/// the sun) are left out, with a warning.
std::vector<shared::Light> gpuLights(const scene::Pose& pose);

/// The sun as a directional light, turned and scaled as the environment is.
shared::Light sunLight(const Sun& sun, const EnvironmentSettings& settings);

/// The environment's own direction -> world.
glm::vec3 rotateFromEnvironment(const glm::vec3& direction, float degrees);

} // namespace glint::render
