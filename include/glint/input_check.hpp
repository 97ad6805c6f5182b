// SPDX-License-Identifier: MIT
// The check of a host's declarations: conventions, matrices and motion, compared with the host's own images
// (Reflections::recordInputCheck). docs/embedding.md.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace glint {

/// What a check found. Declarations that cannot be told apart in the frame are not named: world and view normals of a
/// camera that is not rotated, for example.
struct InputCheck {
    /// Samples that may show a surface, of at most 2048. Below 50 nothing is said, and `findings` is empty.
    uint64_t tested = 0;
    /// Fraction of the samples whose normal is within 10 degrees of the depth's, as declared. Normal maps and curved
    /// surfaces of few pixels lower it; they do not mislead the check.
    double normalsAgree = 0;
    /// True if motion was compared with the matrices of two frames, between which the camera moved enough; with
    /// Conventions::motionDepthScale on screen and in depth.
    bool motionCompared = false;
    /// One line each: what contradicts the declarations, and which declaration fits. Empty: nothing does.
    std::vector<std::string> findings;
};

/// A flat surface of which the host knows where it lies, like a mirror or a floor. Normals and depth determine
/// directions alone; with it the check compares distances and places too.
struct KnownPlane {
    std::array<float, 3> pointWS = {};         ///< metres, any point of the plane
    std::array<float, 3> normalWS = {0, 1, 0}; ///< unit length, on the visible side
};

} // namespace glint
