// glTF's microfacet model in double precision, implemented from the papers, not from the shaders.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint::test::oracle {

constexpr double kPi = std::numbers::pi;

/// Walter et al. 2007, eq. 33.
inline double ggx(double NoH, double alpha) {
    const double cos2 = NoH * NoH;
    const double tan2 = (1 - cos2) / cos2;
    const double k = alpha * alpha + tan2;
    return alpha * alpha / (kPi * cos2 * cos2 * k * k);
}

/// Walter et al. 2007: Smith's lambda for GGX.
inline double lambda(double cosine, double alpha) {
    const double tan2 = (1 - cosine * cosine) / (cosine * cosine);
    return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

/// Heitz 2014, eq. 99, over 4 NoV NoL.
inline double smithVisibility(double NoV, double NoL, double alpha) {
    return 1 / ((1 + lambda(NoV, alpha) + lambda(NoL, alpha)) * 4 * NoV * NoL);
}

inline double schlick(double f0, double f90, double VoH) {
    return f0 + (f90 - f0) * std::pow(1 - VoH, 5);
}

/// Karis 2013: factors of f0 and f90 in the albedo: the BRDF times NoL over the hemisphere of L, written over half
/// vectors (dL = 4 VoH dH, Walter et al. 2007, eq. 14). Midpoint rule; theta = pi / 2 s^3 is dense where D is narrow.
inline glm::dvec2 splitSum(double NoV, double perceptualRoughness) {
    constexpr int kPolar = 2000;
    constexpr int kAround = 256;
    const double alpha = perceptualRoughness * perceptualRoughness;
    const glm::dvec3 V(std::sqrt(1 - NoV * NoV), 0, NoV);
    glm::dvec2 sum(0);
    for (int i = 0; i < kPolar; ++i) {
        const double s = (i + 0.5) / kPolar;
        const double theta = kPi / 2 * s * s * s;
        const double dTheta = kPi / 2 * 3 * s * s / kPolar;
        const double sine = std::sin(theta);
        const double NoH = std::cos(theta);
        for (int j = 0; j < kAround; ++j) {
            const double phi = kPi * (j + 0.5) / kAround; // the other half circle is the same
            const double dPhi = 2 * kPi / kAround;
            const double VoH = V.x * sine * std::cos(phi) + V.z * NoH;
            const double NoL = 2 * VoH * NoH - NoV;
            if (VoH <= 0 || NoL <= 0)
                continue;
            const double value = ggx(NoH, alpha) * smithVisibility(NoV, NoL, alpha) * NoL * 4 * VoH;
            const double fresnel = std::pow(1 - VoH, 5);
            sum += glm::dvec2(1 - fresnel, fresnel) * (value * sine * dTheta * dPhi);
        }
    }
    return sum;
}

} // namespace glint::test::oracle
