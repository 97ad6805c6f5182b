// Tone maps and the sRGB curve against their specifications, in double precision.
#include "lab/tests/render/support/render_test.hpp"

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace display_test {

double srgb(double linear) { // IEC 61966-2-1
    linear = std::clamp(linear, 0.0, 1.0);
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// Khronos PBR Neutral, specification version 1.0.
glm::dvec3 neutral(glm::dvec3 c) {
    const double F90 = 0.04;
    const double Ks = 0.8 - F90;
    const double Kd = 0.15;
    const double x = std::min({c.r, c.g, c.b});
    const double f = x <= 2 * F90 ? x - x * x / (4 * F90) : F90;
    c -= f;
    const double p = std::max({c.r, c.g, c.b});
    if (p <= Ks)
        return c;
    const double pn = 1 - (1 - Ks) * (1 - Ks) / (p + 1 - 2 * Ks);
    const double g = 1 / (Kd * (p - pn) + 1);
    return glm::mix(glm::dvec3(pn), c * (pn / p), g);
}

class DisplayTest : public RenderTest {
protected:
    static std::vector<glm::vec3> colors() {
        std::vector<glm::vec3> list;
        for (const float r : {0.0f, 0.02f, 0.3f, 0.8f, 1.0f, 4.0f, 50.0f})
            for (const float g : {0.0f, 0.05f, 0.5f, 2.0f})
                list.emplace_back(r, g, 0.25f);
        return list;
    }

    /// The colours as a picture one pixel high, shown: [0, 1] as stored in 8 bits.
    static std::vector<glm::vec3> show(const std::vector<glm::vec3>& list, render::DisplaySettings settings) {
        std::vector<glm::vec4> texels;
        for (const glm::vec3& color : list)
            texels.emplace_back(color, 1);
        const auto width = static_cast<uint32_t>(list.size());
        const auto make = [&](VkFormat format, VkImageUsageFlags usage) {
            return must(
                gpu::Image::create(gpu(), {"test/display", format, width, 1, 1, 1, gpu::ImageShape::Flat, usage}));
        };
        gpu::Image hdr =
            make(VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
        gpu::Image ldr = make(VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
        must(gpu::uploadImage(gpu(), hdr, std::as_bytes(std::span(texels))));
        render::DisplayPass pass = must(render::DisplayPass::create(gpu()));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            pass.draw(frame, hdr, ldr, settings);
        });
        const Picture picture{width, 1, must(gpu::downloadImageAsFloats(gpu(), ldr))};
        std::vector<glm::vec3> shown;
        for (uint32_t x = 0; x < width; ++x)
            shown.emplace_back(picture.at(x, 0));
        return shown;
    }
    static void expectShown(const std::vector<glm::vec3>& shown, size_t i, const glm::dvec3& linear) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(shown[i][c], srgb(linear[c]), 1.0 / 255) << "colour " << i << " channel " << c;
    }
};

TEST_F(DisplayTest, NoneClampsAfterExposure) {
    const auto shown = show(colors(), {render::Tonemap::None, 1});
    for (size_t i = 0; i < shown.size(); ++i)
        expectShown(shown, i, glm::dvec3(colors()[i]) * 2.0);
}

TEST_F(DisplayTest, NeutralFollowsItsSpecification) {
    const auto shown = show(colors(), {render::Tonemap::Neutral, 0});
    for (size_t i = 0; i < shown.size(); ++i)
        expectShown(shown, i, neutral(colors()[i]));
}

TEST_F(DisplayTest, AgxKeepsGreysGreyAndRisesWithLight) {
    std::vector<glm::vec3> greys;
    for (int stop = -12; stop <= 6; ++stop)
        greys.emplace_back(std::exp2(float(stop)) * 0.18f);
    const auto shown = show(greys, {render::Tonemap::Agx, 0});
    for (size_t i = 0; i < shown.size(); ++i) {
        EXPECT_NEAR(shown[i].r, shown[i].g, 1.01 / 255);
        EXPECT_NEAR(shown[i].r, shown[i].b, 1.01 / 255);
        EXPECT_GE(shown[i].g, i > 0 ? shown[i - 1].g : 0);
    }
    EXPECT_LT(shown.front().g, 0.03);
    EXPECT_GT(shown.back().g, 0.95);
    // The pivot of Sobotka's curve: middle grey is shown as 0.18^(1 / 2.4).
    EXPECT_NEAR(shown[12].g, std::pow(0.18, 1 / 2.4), 0.015);
}

} // namespace display_test
} // namespace glint::test
