// A host's instance as both back ends take it.
#pragma once

#include "base/result.hpp"
#include "glint/ray_scene.hpp"
#include "rays/bounds.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace glint::rays {

struct Placement {
    glm::dmat4x3 localToWorld;
    glm::dmat3 worldToLocal; ///< of directions; positions are first counted from the local origin
};

/// Nothing for a transform that is not finite or cannot be inverted: such an instance is met by no ray.
std::optional<Placement> placementOf(const RayInstance& instance);

/// The box of the transformed box, a little larger: rays are moved into the instance's space in single precision.
Bounds boundsWS(const Placement& placement, const Bounds& local);

} // namespace glint::rays
