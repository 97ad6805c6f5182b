#include "lab/renderer/sky.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint::render {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kUnit = 20; // kcd/m^2 in one unit of radiance

/// Perez et al. 1993, "All-weather model for sky luminance distribution": the five parameters of Preetham's appendix 2.
struct Perez {
    float a, b, c, d, e;

    /// `cosTheta` of the view's zenith angle, `gamma` the angle to the sun.
    float operator()(float cosTheta, float gamma) const {
        const float cosGamma = std::cos(gamma);
        return (1 + a * std::exp(b / std::max(cosTheta, 0.01f))) *
               (1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
    }
};

/// Luminance Y and chromaticities x, y: distribution and value at the zenith (Preetham 1999, appendix 2).
struct Coefficients {
    Perez perezY, perezX, perezYChroma;
    float zenithLuminance; ///< kcd/m^2
    float zenithX, zenithY;
};

Coefficients coefficients(float T, float theta) {
    const float chi = (4.0f / 9 - T / 120) * (kPi - 2 * theta);
    const float t2 = theta * theta;
    const float t3 = t2 * theta;
    const auto zenith = [&](const float(&m)[3][4]) {
        const auto row = [&](const float(&r)[4]) { return r[0] * t3 + r[1] * t2 + r[2] * theta + r[3]; };
        return T * T * row(m[0]) + T * row(m[1]) + row(m[2]);
    };
    return {
        {0.1787f * T - 1.4630f, -0.3554f * T + 0.4275f, -0.0227f * T + 5.3251f, 0.1206f * T - 2.5771f,
         -0.0670f * T + 0.3703f},
        {-0.0193f * T - 0.2592f, -0.0665f * T + 0.0008f, -0.0004f * T + 0.2125f, -0.0641f * T - 0.8989f,
         -0.0033f * T + 0.0452f},
        {-0.0167f * T - 0.2608f, -0.0950f * T + 0.0092f, -0.0079f * T + 0.2102f, -0.0441f * T - 1.6537f,
         -0.0109f * T + 0.0529f},
        std::max((4.0453f * T - 4.9710f) * std::tan(chi) - 0.2155f * T + 2.4192f, 0.0f),
        zenith({{0.00166f, -0.00375f, 0.00209f, 0},
                {-0.02903f, 0.06377f, -0.03202f, 0.00394f},
                {0.11693f, -0.21196f, 0.06052f, 0.25886f}}),
        zenith({{0.00275f, -0.00610f, 0.00317f, 0},
                {-0.04214f, 0.08970f, -0.04153f, 0.00516f},
                {0.15346f, -0.26756f, 0.06670f, 0.26688f}}),
    };
}

/// CIE xyY -> linear RGB with Rec. 709 primaries (IEC 61966-2-1); colours outside the gamut are clipped.
glm::vec3 rgbFromxyY(float x, float y, float Y) {
    const glm::vec3 xyz(x / y * Y, Y, (1 - x - y) / y * Y);
    const glm::mat3 toRgb(3.2406f, -0.9689f, 0.0557f, -1.5372f, 1.8758f, -0.2040f, -0.4986f, 0.0415f, 1.0570f);
    return glm::max(toRgb * xyz, glm::vec3(0));
}

/// Sunlight transmitted by the air (Preetham 1999, appendix 1: Rayleigh and Angstrom's aerosols), for one wavelength in
/// each of red, green and blue, times the solar illuminance outside the air.
glm::vec3 sunIrradiance(float theta, float turbidity) {
    const float degrees = glm::degrees(theta);
    const float airMass = 1 / (std::cos(theta) + 0.15f * std::pow(93.885f - degrees, -1.253f));
    const float beta = 0.04608f * turbidity - 0.04586f;
    const glm::vec3 wavelengths(0.610f, 0.550f, 0.465f); // micrometres
    const glm::vec3 rayleigh = glm::exp(-0.008735f * glm::pow(wavelengths, glm::vec3(-4.08f)) * airMass);
    const glm::vec3 aerosol = glm::exp(-beta * glm::pow(wavelengths, glm::vec3(-1.3f)) * airMass);
    constexpr float kSolarIlluminance = 128; // klux
    return kSolarIlluminance / kUnit * rayleigh * aerosol;
}

} // namespace

Sky::Sky(float elevation, float azimuth, float turbidity) : turbidity_(turbidity) {
    directionToSun_ = {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                       std::cos(elevation) * std::sin(azimuth)};
    sunTheta_ = std::clamp(kPi / 2 - elevation, 0.0f, kPi / 2 - 0.001f);
    // Civil dusk: daylight falls by about three powers of ten until the sun is 10 degrees below the horizon.
    dusk_ = std::exp(std::min(elevation, 0.0f) * 40);
    sunIrradiance_ = sunIrradiance(sunTheta_, turbidity_);

    // Grey ground lit by sun and sky; the sky's irradiance is integrated over the upper hemisphere.
    constexpr float kGroundAlbedo = 0.2f;
    glm::vec3 irradiance = elevation > 0 ? sunIrradiance_ * std::sin(elevation) : glm::vec3(0);
    constexpr int kRows = 16;
    constexpr int kColumns = 32;
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const float cosTheta = std::sqrt((static_cast<float>(row) + 0.5f) / kRows); // strata of equal cos * dw
            const float sinTheta = std::sqrt(1 - cosTheta * cosTheta);
            const float phi = 2 * kPi * (static_cast<float>(column) + 0.5f) / kColumns;
            irradiance += skyRadiance({sinTheta * std::cos(phi), cosTheta, sinTheta * std::sin(phi)}) *
                          (kPi / (kRows * kColumns));
        }
    groundRadiance_ = irradiance * kGroundAlbedo / kPi;
}

glm::vec3 Sky::skyRadiance(const glm::vec3& direction) const {
    const Coefficients sky = coefficients(turbidity_, sunTheta_);
    // The model's sun stops at the horizon; the glow stays above the azimuth of the sun.
    const glm::vec3 toSun =
        glm::normalize(glm::vec3(directionToSun_.x, std::max(directionToSun_.y, 0.0f), directionToSun_.z));
    const float gamma = std::acos(std::clamp(glm::dot(direction, toSun), -1.0f, 1.0f));
    const auto relative = [&](const Perez& perez) { return perez(direction.y, gamma) / perez(1, sunTheta_); };
    const float luminance = std::max(sky.zenithLuminance * relative(sky.perezY), 0.0f) * dusk_ / kUnit;
    return rgbFromxyY(sky.zenithX * relative(sky.perezX), sky.zenithY * relative(sky.perezYChroma), luminance);
}

glm::vec3 Sky::radiance(const glm::vec3& direction) const {
    if (direction.y >= 0)
        return skyRadiance(direction);
    // Haze blends the ground into the horizon's sky over the first degrees.
    const glm::vec3 horizon = skyRadiance(glm::normalize(glm::vec3(direction.x, 1e-3f, direction.z)));
    const float haze = std::exp(direction.y * 25);
    return glm::mix(groundRadiance_, horizon, haze);
}

scene::HdrImage Sky::picture(uint32_t width) const {
    scene::HdrImage image{width, width / 2, {}};
    image.rgb.reserve(size_t{image.width} * image.height);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const float theta = (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height) * kPi;
            const float phi = ((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width) - 0.5f) * 2 * kPi;
            image.rgb.push_back(
                radiance({std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)}));
        }
    return image;
}

std::optional<Sun> Sky::sun() const {
    Sun sun;
    sun.angularRadius = kSunRadius;
    // The disc fades out over its own height as it sets.
    const float above = glm::smoothstep(-sun.angularRadius, sun.angularRadius, std::asin(directionToSun_.y));
    if (above == 0)
        return std::nullopt;
    sun.direction = directionToSun_;
    sun.irradiance = sunIrradiance_ * above;
    return sun;
}

} // namespace glint::render
