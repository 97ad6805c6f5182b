#include "check/normal_agreement.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace glint::check {
namespace {

float degreesBetween(const glm::vec3& a, const glm::vec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

/// The orthonormal frame of two directions, x along the first. Columns are zero if they are nearly parallel.
glm::mat3 frameOf(const glm::vec3& a, const glm::vec3& b) {
    constexpr float kLeastSine = 0.2f; // nearer ones determine no axis
    const glm::vec3 normal = glm::cross(a, b);
    const float sine = glm::length(normal);
    if (sine < kLeastSine)
        return glm::mat3(0);
    return {a, glm::cross(normal / sine, a), normal / sine};
}

} // namespace

/// Geman, McClure 1985: robust to directions that agree with nothing.
Agreement agreement(const glm::mat3& rotation, std::span<const glm::vec3> from, std::span<const glm::vec3> to) {
    GLINT_ASSERT(from.size() == to.size(), "{} and {} directions", from.size(), to.size());
    constexpr float kScaleDegrees = 3;
    Agreement result;
    std::vector<float> angles;
    for (size_t i = 0; i < from.size(); ++i) {
        if (from[i] == glm::vec3(0) || to[i] == glm::vec3(0))
            continue;
        const float degrees = degreesBetween(rotation * from[i], to[i]);
        result.score += 1 / (1 + (degrees / kScaleDegrees) * (degrees / kScaleDegrees));
        result.share += degrees < kAgreeDegrees;
        angles.push_back(degrees);
    }
    if (!angles.empty()) {
        const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
        std::nth_element(angles.begin(), middle, angles.end());
        result.middleDegrees = *middle;
    }
    if (!from.empty()) {
        result.score /= static_cast<double>(from.size());
        result.share /= static_cast<double>(from.size());
    }
    return result;
}

RotationFit fitRotation(std::span<const glm::vec3> from, std::span<const glm::vec3> to) {
    constexpr size_t kTested = 2000; // directions that each trial is compared with
    constexpr int kTrials = 1000;    // finds a pair of which both agree even where only one direction in ten does
    GLINT_ASSERT(from.size() == to.size(), "{} and {} directions", from.size(), to.size());
    std::vector<glm::vec3> fewFrom, fewTo;
    const size_t stride = from.size() / kTested + 1;
    for (size_t i = 0; i < from.size(); i += stride)
        if (from[i] != glm::vec3(0) && to[i] != glm::vec3(0)) {
            fewFrom.push_back(from[i]);
            fewTo.push_back(to[i]);
        }
    RotationFit best;
    best.agreement.score = -1;
    std::mt19937 random(1);
    for (int trial = 0; trial < kTrials && fewFrom.size() > 1; ++trial) {
        const size_t a = random() % fewFrom.size(), b = random() % fewFrom.size();
        const float spread = degreesBetween(fewFrom[a], fewFrom[b]) - degreesBetween(fewTo[a], fewTo[b]);
        if (std::abs(spread) > kAgreeDegrees) // no rotation changes the angle between two directions
            continue;
        const glm::mat3 frameFrom = frameOf(fewFrom[a], fewFrom[b]), frameTo = frameOf(fewTo[a], fewTo[b]);
        if (frameFrom == glm::mat3(0) || frameTo == glm::mat3(0))
            continue;
        const glm::mat3 rotation = frameTo * glm::transpose(frameFrom);
        if (const Agreement one = agreement(rotation, fewFrom, fewTo); one.score > best.agreement.score)
            best = {rotation, one};
    }
    best.agreement = agreement(best.rotation, from, to);
    return best;
}

} // namespace glint::check
