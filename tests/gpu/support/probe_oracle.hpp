// Weights and lookups of reflection probes in double precision, implemented from the formulas of
// docs/techniques/probes.md, not from the shaders.
#pragma once

#include "glint/probes.hpp"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace glint::test::oracle {

inline glm::dvec3 toDvec(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// Transforms a world point or direction into the volume's axes.
inline glm::dvec3 intoVolume(const ProbeVolume& volume, const glm::dvec3& v, bool point) {
    const auto& q = volume.rotation;
    const glm::dquat toWorld(q[3], q[0], q[1], q[2]);
    return glm::conjugate(toWorld) * (point ? v - toDvec(volume.centerWS) : v);
}

inline double probeWeight(const Probe& probe, const glm::dvec3& positionWS, const glm::dvec3& normalWS,
                          const glm::dvec3& directionWS) {
    const glm::dvec3 p = intoVolume(probe.influence, positionWS, true);
    const glm::dvec3 r = intoVolume(probe.influence, directionWS, false);
    double alpha = 1;
    bool inner = true;
    if (probe.shape == ProbeShape::Sphere) {
        const double inside = probe.influence.halfExtents[0] - glm::length(p);
        alpha = std::clamp(inside / std::max<double>(probe.blendDistance[0], 1e-9), 0.0, 1.0);
        inner = inside >= probe.blendNormalDistance[0];
    } else {
        for (size_t face = 0; face < 6; ++face) {
            const double sign = face % 2 == 0 ? 1 : -1;
            const double inside = probe.influence.halfExtents[face / 2] - sign * p[static_cast<int>(face / 2)];
            alpha = std::min(alpha, inside / std::max<double>(probe.blendDistance[face], 1e-9));
            inner = inner && inside >= probe.blendNormalDistance[face];
        }
        alpha = std::clamp(alpha, 0.0, 1.0);
    }
    if (!inner) {
        const glm::dvec3 outward = glm::normalize(positionWS - toDvec(probe.capturePositionWS));
        alpha *= std::clamp((0.6 - glm::dot(normalWS, outward)) / 0.4, 0.0, 1.0);
    }
    double faces = 0;
    for (size_t face = 0; face < 6; ++face) {
        const double along = (face % 2 == 0 ? 1 : -1) * r[static_cast<int>(face / 2)];
        faces += std::clamp(4 * along - 1, 0.0, 1.0) * probe.faceFade[face];
    }
    alpha *= std::clamp(faces, 0.0, 1.0);
    return alpha * alpha * (3 - 2 * alpha) * probe.weight;
}

/// The weight of each probe: smallest volume first, each at most the remaining weight.
inline std::vector<double> probeShares(const std::vector<Probe>& probes, const glm::dvec3& positionWS,
                                       const glm::dvec3& normalWS, const glm::dvec3& directionWS) {
    const auto volume = [](const Probe& probe) {
        const auto& e = probe.influence.halfExtents;
        return probe.shape == ProbeShape::Sphere ? 4.0 / 3 * std::numbers::pi * std::pow(double(e[0]), 3)
                                                 : 8.0 * e[0] * e[1] * e[2];
    };
    std::vector<size_t> order(probes.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::stable_sort(order, {}, [&](size_t i) { return volume(probes[i]); });
    std::vector<double> shares(probes.size(), 0);
    double left = 1;
    for (const size_t i : order) {
        shares[i] = std::min(probeWeight(probes[i], positionWS, normalWS, directionWS), left);
        left -= shares[i];
    }
    return shares;
}

/// Metres to where a ray leaves the proxy from inside.
inline double proxyDistance(const Probe& probe, const glm::dvec3& positionWS, const glm::dvec3& directionWS) {
    const glm::dvec3 p = intoVolume(probe.proxyVolume, positionWS, true);
    const glm::dvec3 d = intoVolume(probe.proxyVolume, directionWS, false);
    if (probe.proxy == ProbeProxy::Sphere) {
        const double r = probe.proxyVolume.halfExtents[0];
        const double b = 2 * glm::dot(d, p);
        const double c = glm::dot(p, p) - r * r;
        return std::max((std::sqrt(std::max(b * b - 4 * c, 0.0)) - b) / 2, 0.0);
    }
    double t = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        const double half = probe.proxyVolume.halfExtents[static_cast<size_t>(axis)];
        if (std::abs(d[axis]) > 1e-7)
            t = std::min(t, ((d[axis] > 0 ? half : -half) - p[axis]) / d[axis]);
    }
    return std::max(t, 0.0);
}

} // namespace glint::test::oracle
