// The rules by which a G-buffer is compared with itself and with its camera. They name the declarations that contradict
// it: "normal.space view, not world as declared".
//
// Depth and camera determine a surface's normal. The given normals agree with it only if depth, normals, axes, rows and
// camera all mean what is declared, so each other meaning is tried, and the one that agrees best is named.
#pragma once

#include "check/evidence.hpp"
#include "check/normal_agreement.hpp"

#include <functional>
#include <optional>
#include <span>

namespace glint::check {

using Finding = std::optional<std::string>; ///< one line; absent: nothing contradicts the declarations

struct Comparison {
    double agree = 0; ///< share of samples whose normal is within 10 degrees of depth's, as declared
    size_t best = 0;  ///< reading that the finding names; without one the declared reading
    Finding finding;
};

/// A camera that projects in another way than the declared one, and how well normals agree with depth under it.
struct OtherCamera {
    std::string name; ///< "an orthographic camera"
    Agreement fit;
};

/// How well the normals agree with depth under the declared reading.
Agreement agreementAsDeclared(const Evidence& evidence);

/// Compares normals with depth. `bestCamera` is asked where the declarations leave something to explain: for the best
/// of the cameras that are not among the readings. Requires kFewestSamples. Finds nothing in an image without a flat or
/// smooth surface, and cannot tell readings apart that are equal in this image (view and world normals of a camera that
/// is not rotated).
Comparison compareNormals(const Evidence& evidence, const std::function<OtherCamera()>& bestCamera = {});

/// Means over samples, and filtered edges, have shorter normals; more than some of them mean another encoding.
Finding findOddLengths(const Evidence& evidence, size_t reading);

/// A visible surface faces the camera.
Finding findAverted(const Evidence& evidence, size_t reading);

/// The camera's planes enclose the surfaces, unless depth is in another unit.
Finding findOutOfRange(const Evidence& evidence, size_t reading);

/// `roughness`  as stored, one a sample
Finding findRoughnessOutside(std::span<const float> roughness);

/// Stored motion, and that of a surface which stands still under the two cameras, in pixels.
struct Motion {
    glm::vec2 stored, still;
};
/// What stored motion is multiplied with to give previous - current position, +X right, +Y down.
struct MotionUnit {
    glm::vec2 scale;
    bool pixels; ///< the product is in pixels, otherwise in UV
};
struct MotionCheck {
    bool compared = false; ///< false: the camera hardly moved, so nothing was said
    Finding finding;
};
/// Most surfaces stand still, so their motion is that of the camera. `size`: of the image. `nameOf` names a unit in the
/// terms of whoever declared it.
MotionCheck compareMotion(std::span<const Motion> motions, const glm::vec2& size, const MotionUnit& declared,
                          const std::function<std::string(const MotionUnit&)>& nameOf);

/// Stored motion in depth, and that of a surface which stands still under the two cameras, both as fractions of its
/// viewZ.
struct DepthMotion {
    float stored, still;
};
/// Most surfaces stand still. `declared`: what stored motion is multiplied with to give previous - current viewZ.
MotionCheck compareDepthMotion(std::span<const DepthMotion> motions, float declared);

/// "97 %"
std::string percent(double share);

/// `values` must not be empty; changes their order.
float median(std::span<float> values);

} // namespace glint::check
