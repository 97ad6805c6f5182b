// A host's instance in the form that both back ends use.
#pragma once

#include "base/result.hpp"
#include "glint/ray_scene.hpp"
#include "rays/bounds.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace glint::rays {

/// Every device with ray queries supports this many (Vulkan 1.3, "Required Limits"), and the hierarchy's levels can
/// hold them. Custom indices of instances have as many bits.
constexpr uint32_t kMostInstances = (1u << 24) - 1;

struct Placement {
    glm::dmat4x3 localToWorld;
    glm::dmat3 worldToLocal; ///< for directions; positions first have the local origin subtracted
};

/// Returns no value for a transform that is not finite or not invertible: no ray intersects such an instance.
std::optional<Placement> placementOf(const RayInstance& instance);

/// Returns the bounds of the transformed box, slightly enlarged, as rays are transformed into the instance's space in
/// single precision.
Bounds boundsWS(const Placement& placement, const Bounds& local);

} // namespace glint::rays
