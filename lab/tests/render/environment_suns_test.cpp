// Suns of an environment's picture: whatever their radiance, what they light and how mirrors show them.
#include "base/file.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/tests/image/job_test.hpp"
#include "lab/tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace glint::test {
namespace environment_suns_test {

constexpr uint32_t kSide = 96; // pixels
constexpr double kFov = 12;    // degrees

/// A black sky, and a disc of this radiance around `direction`.
scene::HdrImage sun(const glm::dvec3& direction, double radius, const glm::vec3& radiance) {
    scene::HdrImage image{1024, 512, {}};
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const double phi = (x + 0.5) / image.width * 2 * glm::pi<double>() - glm::pi<double>();
            const double theta = (y + 0.5) / image.height * glm::pi<double>();
            const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            image.rgb.push_back(glm::length(d - direction) < radius ? radiance : glm::vec3(0));
        }
    return image;
}

/// Irradiance of a surface with this normal: the sum over the picture.
glm::dvec3 irradiance(const scene::HdrImage& image, const glm::dvec3& normal) {
    glm::dvec3 sum(0);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const double phi = (x + 0.5) / image.width * 2 * glm::pi<double>() - glm::pi<double>();
            const double theta = (y + 0.5) / image.height * glm::pi<double>();
            const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            const double part = 2 * glm::pi<double>() * glm::pi<double>() / (double(image.width) * image.height);
            sum += glm::dvec3(image.rgb[size_t{y} * image.width + x]) *
                   (part * std::sin(theta) * std::max(glm::dot(d, normal), 0.0));
        }
    return sum;
}

class EnvironmentSunsTest : public JobTest {
protected:
    /// The composite of a floor of this material, seen from `toEye`.
    std::vector<float> floorUnder(const scene::HdrImage& sky, const Json& material, const glm::dvec3& toEye) {
        GltfBuilder builder;
        builder.append("materials", material);
        const Json attributes = {
            {"POSITION", builder.addAccessor("VEC3", std::vector<float>{-5, 0, 5, 5, 0, 5, 5, 0, -5, -5, 0, -5})},
            {"NORMAL", builder.addAccessor("VEC3", std::vector<float>{0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0})}};
        Json& floor = builder.addMesh(attributes);
        floor["material"] = 0;
        floor["indices"] = builder.addAccessor("SCALAR", std::vector<uint16_t>{0, 1, 2, 0, 2, 3});
        const std::vector<uint8_t> bytes = builder.glb();
        must(writeFile(temp_ + "floor.glb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
        const glm::dvec3 eye = 3.0 * toEye;
        const Json view = {{"position", {eye.x, eye.y, eye.z}}, {"target", {0, 0, 0}}, {"fovY", kFov}};
        must(writeFile(temp_ + "camera.json", view.dump()));
        const scene::ExrLayer layer{"", "RGB", false, {&sky.rgb[0].x, sky.rgb.size() * 3}, 3};
        must(scene::writeExr(temp_ + "sky.exr", sky.width, sky.height, {&layer, 1}));
        render::RenderJob job;
        job.scene = temp_ + "floor.glb";
        job.camera = temp_ + "camera.json";
        job.environment = temp_ + "sky.exr";
        job.width = job.height = kSide;
        job.views = {"composite"};
        job.settings = settingsOf({});
        return must(render::runJob(device(), job)).views.front().rgba;
    }

    TempFolder temp_;
};

TEST_F(EnvironmentSunsTest, AGroundIsAsBrightAsItsSunHoweverBright) {
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.3, 1, -0.2));
    const Json white = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}},
                        {"extensions", {{"KHR_materials_specular", {{"specularFactor", 0}}}}}};
    for (const float radiance : {5e4f, 3e5f, 4e6f})
        for (const double radius : {0.02, 0.12}) { // a light, and one that is too large to be one
            const scene::HdrImage sky = sun(towards, radius, glm::vec3(radiance, radiance / 2, radiance / 10));
            const std::vector<float> shown = floorUnder(sky, white, glm::normalize(glm::dvec3(0, 1, 0.5)));
            const glm::dvec3 right = irradiance(sky, {0, 1, 0}) / glm::pi<double>();
            if (right.x > scene::kMaxRadiance)
                continue; // of the picture itself
            const float* middle = &shown[(size_t{kSide} * (kSide / 2) + kSide / 2) * 4];
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(middle[c] / right[c], 1, 0.015) << radiance << " of radius " << radius << " channel " << c;
        }
}

/// A mirror's picture of a sun has the sun's light, its place and, where it is smooth enough, its size.
TEST_F(EnvironmentSunsTest, AMirrorShowsTheDiscWithAllOfItsLight) {
    const glm::dvec3 towards = glm::normalize(glm::dvec3(-0.5, 1, 0.2));
    const glm::dvec3 toEye(-towards.x, towards.y, -towards.z);
    const double radius = 0.012;
    const scene::HdrImage sky = sun(towards, radius, glm::vec3(40000));
    const double all = irradiance(sky, towards).x;
    for (const double roughness : {0.0, 0.08}) {
        const Json metal = {{"pbrMetallicRoughness", {{"metallicFactor", 1}, {"roughnessFactor", roughness}}}};
        const std::vector<float> shown = floorUnder(sky, metal, toEye);
        const double scale = std::tan(glm::radians(kFov / 2)) * 2 / kSide; // of a pixel
        double sum = 0;
        double bright = 0;
        for (uint32_t y = 0; y < kSide; ++y)
            for (uint32_t x = 0; x < kSide; ++x) {
                const double u = (x + 0.5 - kSide / 2.0) * scale;
                const double v = (y + 0.5 - kSide / 2.0) * scale;
                const double pixel = scale * scale * std::pow(1 + u * u + v * v, -1.5);
                const double radiance = shown[(size_t{y} * kSide + x) * 4];
                sum += radiance * pixel;
                bright += radiance > 20000 ? pixel : 0;
            }
        EXPECT_NEAR(sum / all, 1, 0.04) << "roughness " << roughness;
        if (roughness == 0) {
            EXPECT_NEAR(bright / (glm::pi<double>() * radius * radius), 1, 0.1) << "the disc's size";
        }
    }
}

} // namespace environment_suns_test
} // namespace glint::test
