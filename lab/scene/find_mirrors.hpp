// Finds the surfaces of a scene that should be planar mirrors: those that the scene names, and those that are flat,
// smooth and large. Works on the posed scene and needs no GPU.
#pragma once

#include "glint/planar.hpp"
#include "lab/scene/pose.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace glint::render {

enum class MirrorSearch {
    None,
    Named, ///< surfaces whose material has extras.glint.planar true
    Auto,  ///< named surfaces, then every suitable surface without extras.glint.planar false
};

/// The command line's names, in the order of MirrorSearch.
inline constexpr std::array<std::string_view, 3> kMirrorSearchNames = {"none", "named", "auto"};

/// Returns at most `most` mirrors: named ones first, then the largest. Coplanar surfaces form one mirror with one
/// mirrored view.
std::vector<PlanarMirror> findMirrors(const scene::Scene& scene, const scene::Pose& pose, MirrorSearch search,
                                      size_t most);

} // namespace glint::render
