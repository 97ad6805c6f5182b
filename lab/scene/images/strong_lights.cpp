#include "lab/scene/images/strong_lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint::scene {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBright = 64;           // times the mean of the rest
constexpr double kOfPeak = 1e-3;         // what is darker beside a light is its glow, which the map can hold
constexpr double kLeastShare = 0.01;     // of the picture's light
constexpr double kLargestRadius = 0.052; // radians

double luminance(const glm::vec3& rgb) {
    return 0.2126 * double(rgb.r) + 0.7152 * double(rgb.g) + 0.0722 * double(rgb.b);
}

/// An equirectangular picture's pixels as parts of the sphere.
class Sphere {
public:
    explicit Sphere(const HdrImage& image) : width_(image.width), height_(image.height), rowSolidAngle_(image.height) {
        for (uint32_t y = 0; y < height_; ++y)
            rowSolidAngle_[y] =
                2 * kPi / width_ * (std::cos(kPi * y / height_) - std::cos(kPi * (y + 1) / height_)); // exact
    }

    double solidAngle(size_t pixel) const { return rowSolidAngle_[pixel / width_]; }

    glm::dvec3 direction(size_t pixel) const {
        const double phi = (double(pixel % width_) + 0.5) / width_ * 2 * kPi - kPi; // the centre is +X
        const size_t row = pixel / width_;
        const double theta = (double(row) + 0.5) / height_ * kPi;
        return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
    }

    /// The eight pixels around; a pole joins the pixels of its row.
    template <class Visit>
    void visitNeighbours(size_t pixel, Visit&& visit) const {
        const auto x = int64_t(pixel % width_);
        const auto y = int64_t(pixel / width_);
        for (int64_t dy = -1; dy <= 1; ++dy)
            for (int64_t dx = -1; dx <= 1; ++dx) {
                const int64_t row = y + dy;
                const bool acrossPole = row < 0 || row >= int64_t(height_);
                const int64_t column = x + dx + (acrossPole ? int64_t(width_ / 2) : 0) + int64_t(width_);
                visit(size_t((acrossPole ? y : row) * int64_t(width_) + column % int64_t(width_)));
            }
    }

private:
    uint32_t width_;
    uint32_t height_;
    std::vector<double> rowSolidAngle_;
};

/// Mean radiance of what is no strong light: each round leaves out more of what exceeds the mean.
double meanOfRest(const HdrImage& image, const Sphere& sphere) {
    double mean = 0;
    for (int round = 0; round < 12; ++round) {
        double sum = 0;
        for (size_t i = 0; i < image.rgb.size(); ++i) {
            const double bright = luminance(image.rgb[i]);
            sum += (round == 0 ? bright : std::min(bright, 16 * mean)) * sphere.solidAngle(i);
        }
        mean = sum / (4 * kPi);
    }
    return mean;
}

double totalLight(const HdrImage& image, const Sphere& sphere) {
    double sum = 0;
    for (size_t i = 0; i < image.rgb.size(); ++i)
        sum += luminance(image.rgb[i]) * sphere.solidAngle(i);
    return sum;
}

/// Pixels by the peak that they belong to.
using Owners = std::vector<size_t>;
constexpr size_t kNobodys = SIZE_MAX;

/// The pixels around `peak` that are connected with it, brighter than `threshold`, and nobody's.
std::vector<size_t> regionAround(size_t peak, double threshold, const HdrImage& image, const Sphere& sphere,
                                 Owners& owners) {
    std::vector<size_t> region = {peak};
    owners[peak] = peak;
    for (size_t next = 0; next < region.size(); ++next)
        sphere.visitNeighbours(region[next], [&](size_t there) {
            if (owners[there] == kNobodys && luminance(image.rgb[there]) > threshold) {
                owners[there] = peak;
                region.push_back(there);
            }
        });
    return region;
}

/// The mean of the pixels beside a region.
glm::vec3 radianceBeside(const std::vector<size_t>& region, const Owners& owners, const HdrImage& image,
                         const Sphere& sphere) {
    glm::dvec3 sum(0);
    double weights = 0;
    for (const size_t pixel : region)
        sphere.visitNeighbours(pixel, [&](size_t there) {
            if (owners[there] == owners[pixel])
                return;
            sum += glm::dvec3(image.rgb[there]) * sphere.solidAngle(there);
            weights += sphere.solidAngle(there);
        });
    return weights > 0 ? glm::vec3(sum / weights) : glm::vec3(0);
}

/// What the region has beyond `beside`, as a disc with the same second moment.
StrongLight lightOf(const std::vector<size_t>& region, const glm::vec3& beside, const HdrImage& image,
                    const Sphere& sphere) {
    glm::dvec3 irradiance(0);
    glm::dvec3 middle(0);
    double flux = 0;
    for (const size_t pixel : region) {
        const glm::dvec3 beyond = glm::dvec3(image.rgb[pixel] - beside) * sphere.solidAngle(pixel);
        const double part = std::max(0.2126 * beyond.r + 0.7152 * beyond.g + 0.0722 * beyond.b, 0.0);
        irradiance += beyond;
        middle += part * sphere.direction(pixel);
        flux += part;
    }
    StrongLight light;
    if (flux <= 0)
        return light;
    middle = glm::normalize(middle);
    double moment = 0;
    for (const size_t pixel : region) {
        const double part = std::max(luminance(image.rgb[pixel] - beside), 0.0) * sphere.solidAngle(pixel);
        const double apart = glm::length(sphere.direction(pixel) - middle);
        moment += part * (apart * apart + sphere.solidAngle(pixel) / 6); // a square's own: side^2 / 6
    }
    light.direction = glm::vec3(middle);
    light.irradiance = glm::max(glm::vec3(irradiance), glm::vec3(0));
    light.angularRadius = float(std::sqrt(2 * moment / flux)); // of a disc: radius^2 / 2
    return light;
}

} // namespace

DividedPicture takeStrongLights(const HdrImage& equirect) {
    DividedPicture result;
    result.rest = equirect;
    const Sphere sphere(equirect);
    const double total = totalLight(equirect, sphere);
    const double least = kBright * meanOfRest(equirect, sphere);
    std::vector<size_t> bright;
    for (size_t i = 0; i < equirect.rgb.size(); ++i)
        if (luminance(equirect.rgb[i]) > least)
            bright.push_back(i);
    std::sort(bright.begin(), bright.end(),
              [&](size_t a, size_t b) { return luminance(equirect.rgb[a]) > luminance(equirect.rgb[b]); });
    Owners owners(equirect.rgb.size(), kNobodys);
    for (const size_t peak : bright) {
        if (owners[peak] != kNobodys)
            continue;
        const double threshold = std::max(least, kOfPeak * luminance(equirect.rgb[peak]));
        const std::vector<size_t> region = regionAround(peak, threshold, equirect, sphere, owners);
        const glm::vec3 beside = radianceBeside(region, owners, equirect, sphere);
        const StrongLight light = lightOf(region, beside, equirect, sphere);
        if (light.angularRadius > kLargestRadius || luminance(light.irradiance) < kLeastShare * total)
            continue;
        for (const size_t pixel : region)
            result.rest.rgb[pixel] = beside;
        result.lights.push_back(light);
        if (result.lights.size() == kMostStrongLights)
            break;
    }
    std::sort(result.lights.begin(), result.lights.end(), [](const StrongLight& a, const StrongLight& b) {
        return luminance(a.irradiance) > luminance(b.irradiance);
    });
    return result;
}

} // namespace glint::scene
