// Strong lights of environments: what is taken out, that no light is lost, and what stays.
#include "lab/scene/images/strong_lights.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <functional>

namespace glint::test {
namespace strong_lights_test {

constexpr double kPi = glm::pi<double>();

glm::dvec3 directionOf(const scene::HdrImage& image, uint32_t x, uint32_t y) {
    const double phi = (x + 0.5) / image.width * 2 * kPi - kPi;
    const double theta = (y + 0.5) / image.height * kPi;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

double solidAngle(const scene::HdrImage& image, uint32_t y) {
    return 2 * kPi / image.width * (std::cos(y * kPi / image.height) - std::cos((y + 1) * kPi / image.height));
}

scene::HdrImage picture(const std::function<glm::vec3(const glm::dvec3&)>& radiance) {
    scene::HdrImage image{512, 256, {}};
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            image.rgb.push_back(radiance(directionOf(image, x, y)));
    return image;
}

/// A disc around `direction`, with `beside` elsewhere.
scene::HdrImage disc(const glm::dvec3& direction, double radius, const glm::vec3& radiance, const glm::vec3& beside) {
    return picture(
        [&](const glm::dvec3& d) { return glm::length(d - glm::normalize(direction)) < radius ? radiance : beside; });
}

glm::dvec3 totalLight(const scene::HdrImage& image) {
    glm::dvec3 sum(0);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            sum += solidAngle(image, y) * glm::dvec3(image.rgb[size_t{y} * image.width + x]);
    return sum;
}

TEST(StrongLights, ASunIsTakenOutWhereverItStandsAndNoLightIsLost) {
    const glm::vec3 colour(2e5f, 1.8e5f, 1.5e5f); // beyond halves
    for (const glm::dvec3 direction : {glm::dvec3(0.3, 0.6, 0.5), {0, 1, 0.01}, {0, -1, 0}, {-1, 0.2, 0}}) {
        const scene::HdrImage image = disc(direction, 0.025, colour, glm::vec3(0.2f, 0.3f, 0.4f));
        const scene::DividedPicture divided = scene::takeStrongLights(image);
        ASSERT_EQ(divided.lights.size(), 1u) << direction.y;
        const scene::StrongLight& light = divided.lights[0];
        EXPECT_LT(glm::length(glm::dvec3(light.direction) - glm::normalize(direction)), 0.004);
        EXPECT_NEAR(light.angularRadius, 0.025, 0.004);
        const glm::dvec3 before = totalLight(image);
        const glm::dvec3 after = totalLight(divided.rest) + glm::dvec3(light.irradiance);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(after[c] / before[c], 1, 1e-4);
            EXPECT_NEAR(totalLight(divided.rest)[c], 4 * kPi * (c + 2) * 0.1, 0.01) << "as bright as around it";
        }
    }
}

TEST(StrongLights, UnderABlackSkyTheOnlyLightIsTaken) {
    const scene::DividedPicture divided =
        scene::takeStrongLights(disc({0.2, 1, 0}, 0.03, glm::vec3(300000), glm::vec3(0)));
    ASSERT_EQ(divided.lights.size(), 1u);
    EXPECT_NEAR(divided.lights[0].irradiance.x, 300000 * kPi * 0.03 * 0.03, 0.02 * 300000 * kPi * 0.03 * 0.03);
    EXPECT_EQ(totalLight(divided.rest), glm::dvec3(0));
}

TEST(StrongLights, SeveralLampsComeTheStrongestFirstAndTheFourStrongest) {
    scene::HdrImage image = picture([](const glm::dvec3&) { return glm::vec3(0.1f); });
    for (uint32_t lamp = 0; lamp < 6; ++lamp)
        for (uint32_t i = 0; i < 4; ++i)
            image.rgb[size_t{100 + i / 2} * image.width + 80 * lamp + i % 2] = glm::vec3(float(2000 + 500 * lamp));
    const scene::DividedPicture divided = scene::takeStrongLights(image);
    ASSERT_EQ(divided.lights.size(), scene::kMostStrongLights);
    for (size_t i = 1; i < divided.lights.size(); ++i)
        EXPECT_GT(divided.lights[i - 1].irradiance.x, divided.lights[i].irradiance.x);
    EXPECT_EQ(divided.rest.rgb[size_t{100} * image.width + 80], glm::vec3(2500)) << "the second weakest stays";
}

TEST(StrongLights, WindowsSkiesAndFaintPointsStay) {
    const scene::HdrImage stays[] = {
        disc({1, 0.5, 0}, 0.3, glm::vec3(500), glm::vec3(0.3f)),   // a window
        disc({1, 0.5, 0}, 0.02, glm::vec3(12), glm::vec3(0.3f)),   // a bright cloud
        disc({1, 0.5, 0}, 0.008, glm::vec3(150), glm::vec3(0.5f)), // a star: less than a hundredth of the light
        picture([](const glm::dvec3& d) { return glm::vec3(float(1 + d.y)); }), disc({0, 1, 0}, 0.1, {}, {})};
    for (const scene::HdrImage& image : stays) {
        const scene::DividedPicture divided = scene::takeStrongLights(image);
        EXPECT_TRUE(divided.lights.empty());
        EXPECT_EQ(divided.rest.rgb, image.rgb);
    }
}

} // namespace strong_lights_test
} // namespace glint::test
