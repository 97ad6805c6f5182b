// How well two lists of directions agree, and the rotation under which they agree best.
#pragma once

#include <glm/glm.hpp>

#include <span>

namespace glint::check {

/// Directions closer than this agree: shading normals of smooth meshes are this near to their triangles'.
constexpr float kAgreeDegrees = 10;

struct Agreement {
    double score = 0;        ///< [0, 1], counts near directions more than far ones
    double share = 0;        ///< of all pairs: those that agree
    float middleDegrees = 0; ///< half of the pairs without zero vectors differ by less
};

/// Compares `rotation` * from[i] with to[i], unit vectors; a pair with a zero vector agrees under no rotation.
Agreement agreement(const glm::mat3& rotation, std::span<const glm::vec3> from, std::span<const glm::vec3> to);

struct RotationFit {
    glm::mat3 rotation{1};
    Agreement agreement;
};

/// Returns the rotation with the best score of those that a random sample of pairs of directions determines: robust to
/// directions that agree with nothing. The same input gives the same result.
/// Based on: Fischler, Bolles 1981, "Random Sample Consensus".
RotationFit fitRotation(std::span<const glm::vec3> from, std::span<const glm::vec3> to);

} // namespace glint::check
