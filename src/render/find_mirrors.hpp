// Which surfaces of a scene are worth a picture from behind them: those that a scene names, and those that are flat,
// smooth and large. Works on the posed scene, so that it needs no GPU.
#pragma once

#include "glint/planar.hpp"
#include "scene/pose.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace glint::render {

enum class MirrorSearch {
    None,
    Named, ///< those whose material says so: extras.glint.planar true
    Auto,  ///< the named ones, then all that look like it; not those with extras.glint.planar false
};

/// As the command line says them, in their order.
inline constexpr std::array<std::string_view, 3> kMirrorSearchNames = {"none", "named", "auto"};

/// Coplanar surfaces are one mirror: one picture serves them all. Named ones first, then the largest; at most `most`.
std::vector<PlanarMirror> findMirrors(const scene::Scene& scene, const scene::Pose& pose, MirrorSearch search,
                                      size_t most);

} // namespace glint::render
