#include "lab/measure/truth/specular_integral.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint::measure {
namespace {

constexpr double kPi = std::numbers::pi;

/// Heitz 2014: sqrt(a^2 + (1 - a^2) cos^2), twice which is G1's denominator without the cosine.
double smithRoot(double cosine, double alpha2) {
    return std::sqrt(alpha2 + (1 - alpha2) * cosine * cosine);
}

/// D G2 / (4 NoV NoL) times NoL.
double lobe(const ReflectingPoint& at, const glm::dvec3& L) {
    const double NoL = glm::dot(at.normal, L);
    if (NoL <= 0)
        return 0;
    const double alpha2 = std::pow(at.perceptualRoughness, 4);
    const double NoV = std::max(glm::dot(at.normal, at.toEye), 1e-6);
    const glm::dvec3 H = glm::normalize(L + at.toEye);
    const double NoH = glm::dot(at.normal, H);
    const double spread = NoH * NoH * (alpha2 - 1) + 1;
    const double normals = alpha2 / (kPi * spread * spread);
    return normals * 0.5 / (NoL * smithRoot(NoV, alpha2) + NoV * smithRoot(NoL, alpha2)) * NoL;
}

glm::dvec3 directionAt(double x, double y, const scene::HdrImage& equirect) {
    const double phi = x / equirect.width * 2 * kPi - kPi; // the centre is +X
    const double theta = y / equirect.height * kPi;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

/// Parts along a pixel's side: a tenth of the lobe each.
int partsOf(const scene::HdrImage& equirect, double perceptualRoughness) {
    const double pixel = kPi / equirect.height;
    const double narrow = 0.2 * perceptualRoughness * perceptualRoughness;
    return std::clamp(int(std::ceil(pixel / std::max(narrow, 1e-4))), 1, 16);
}

} // namespace

glm::dvec3 specularIntegral(const scene::HdrImage& equirect, const ReflectingPoint& at) {
    const int parts = partsOf(equirect, at.perceptualRoughness);
    glm::dvec3 sum(0);
    double albedo = 0;
    for (uint32_t y = 0; y < equirect.height; ++y)
        for (uint32_t x = 0; x < equirect.width; ++x) {
            double weight = 0;
            for (int part = 0; part < parts * parts; ++part) {
                const int row = part / parts;
                const double partY = y + (row + 0.5) / parts;
                const double partX = x + (part % parts + 0.5) / parts;
                weight += lobe(at, directionAt(partX, partY, equirect)) * std::sin(partY / equirect.height * kPi);
            }
            sum += weight * glm::dvec3(equirect.rgb[size_t{y} * equirect.width + x]);
            albedo += weight;
        }
    return sum / albedo;
}

} // namespace glint::measure
