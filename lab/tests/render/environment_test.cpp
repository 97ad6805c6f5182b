// The environment: where its directions are, what it lights, and that nothing gains or loses energy.
#include "lab/tests/render/support/render_test.hpp"

#include "lab/renderer/sky.hpp"

namespace glint::test {
namespace environment_test {

/// Each axis its own colour, smooth between.
glm::vec3 directionColor(const glm::vec3& d) {
    return d * 0.5f + 0.5f;
}

class EnvironmentTest : public RenderTest {
protected:
    /// The middle pixel of a picture of the background alone.
    static glm::vec3 background(const glm::vec3& towards, const render::RenderSettings& settings = {}) {
        SceneParts empty;
        empty.scene.scenes.emplace_back();
        render::ViewParameters view;
        view.camera.viewToWorld = scene::lookAt(glm::vec3(0), towards);
        return draw(empty, view, 17, 9, environmentPicture(256, directionColor), settings).lit.center();
    }
    static void expectNear(const glm::vec3& got, const glm::vec3& expected, float tolerance) {
        EXPECT_LT(largestChannel(glm::abs(got - expected)), tolerance)
            << got.x << " " << got.y << " " << got.z << ", not " << expected.x << " " << expected.y << " "
            << expected.z;
    }
};

TEST_F(EnvironmentTest, BackgroundLiesWhereTheConventionSays) {
    for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, -1, 0),
                                 glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::normalize(glm::vec3(1, 2, -3))})
        expectNear(background(axis), directionColor(axis), 0.01f);
}

TEST_F(EnvironmentTest, RotationTurnsAboutYByTheRightHand) {
    render::RenderSettings settings;
    settings.environment.rotation = 90; // +X goes to -Z
    settings.environment.strength = 2;
    expectNear(background({0, 0, -1}, settings), 2.0f * directionColor({1, 0, 0}), 0.02f);
    expectNear(background({1, 0, 0}, settings), 2.0f * directionColor({0, 0, 1}), 0.02f);
}

TEST_F(EnvironmentTest, InvisibleEnvironmentStillLights) {
    render::RenderSettings settings;
    settings.environment.visible = false;
    SceneParts parts;
    parts.add(square(1), matte(glm::vec3(0.5f)));
    const Frame frame = draw(parts, {orthographicCamera(4), {}, {}, {}}, 33, 33,
                             environmentPicture(64, [](const glm::vec3&) { return glm::vec3(1); }), settings);
    expectNear(frame.lit.at(0, 0), glm::vec3(0), 1e-6f);
    expectNear(frame.lit.center(), glm::vec3(0.5f), 0.002f);
}

TEST_F(EnvironmentTest, DiffuseLightIsTheCosineWeightedMean) {
    // For radiance 1 + d.y the irradiance over pi is 1 + 2/3 n.y (Ramamoorthi, Hanrahan 2001: A1 / A0 = 2/3).
    const auto picture = environmentPicture(128, [](const glm::vec3& d) { return glm::vec3(1 + d.y); });
    SceneParts parts;
    parts.add(ball(1), matte(glm::vec3(1)));
    const Frame frame = draw(parts, {orthographicCamera(2), {}, {}, {}}, 65, 65, picture);
    for (uint32_t y = 4; y < 61; y += 4) {
        const float normalY = 1 - 2 * (float(y) + 0.5f) / 65;
        EXPECT_NEAR(frame.lit.at(32, y).x, 1 + 2.0f / 3 * normalY, 0.01f) << "row " << y;
    }
}

TEST_F(EnvironmentTest, WhiteFurnaceHidesMetalOfAnyRoughness) {
    const auto white = environmentPicture(64, [](const glm::vec3&) { return glm::vec3(1); });
    for (const float roughness : {0.0f, 0.1f, 0.3f, 0.5f, 0.8f, 1.0f}) {
        SceneParts parts;
        parts.add(ball(1), metal(roughness));
        const Frame frame = draw(parts, {orthographicCamera(2.2f), {}, {}, {}}, 64, 64, white);
        for (uint32_t y = 0; y < 64; ++y)
            for (uint32_t x = 0; x < 64; ++x)
                ASSERT_NEAR(frame.lit.at(x, y).x, 1, 0.01f) << "roughness " << roughness << " at " << x << "," << y;
    }
}

TEST_F(EnvironmentTest, WhiteFurnaceNeverBrightensADielectric) {
    const auto white = environmentPicture(64, [](const glm::vec3&) { return glm::vec3(1); });
    for (const float roughness : {0.0f, 0.5f, 1.0f}) {
        scene::Material material = metal(roughness);
        material.metallicFactor = 0;
        SceneParts parts;
        parts.add(ball(1), material);
        const Frame frame = draw(parts, {orthographicCamera(2.2f), {}, {}, {}}, 64, 64, white);
        for (uint32_t y = 0; y < 64; ++y)
            for (uint32_t x = 0; x < 64; ++x)
                ASSERT_NEAR(frame.lit.at(x, y).x, 1, 0.015f) << "roughness " << roughness << " at " << x << "," << y;
    }
}

TEST_F(EnvironmentTest, MirrorShowsTheEnvironmentAndFallbackIsItsSpecularPart) {
    SceneParts parts;
    parts.add(square(1), metal(0));
    const Frame frame =
        draw(parts, {orthographicCamera(4), {}, {}, {}}, 33, 33, environmentPicture(256, directionColor));
    expectNear(frame.lit.center(), directionColor({0, 0, 1}), 0.01f);
    expectNear(frame.fallback.center(), frame.lit.center(), 1e-6f);
    expectNear(frame.fallback.at(0, 0), glm::vec3(0), 1e-6f);
    expectNear(frame.material.center(), glm::vec3(1), 1e-3f);
}

TEST(SkyTest, IsFiniteAndSaneAtEveryElevation) {
    for (float degrees = -10; degrees <= 90; degrees += 5)
        for (const float turbidity : {1.7f, 3.0f, 10.0f}) {
            const render::Sky sky(glm::radians(degrees), 1, turbidity);
            const scene::HdrImage picture = sky.picture(64);
            float brightest = 0;
            for (const glm::vec3& rgb : picture.rgb) {
                ASSERT_TRUE(glm::all(glm::greaterThanEqual(rgb, glm::vec3(0)))) << degrees << " " << turbidity;
                brightest = std::max(brightest, largestChannel(rgb));
            }
            EXPECT_LT(brightest, 60) << degrees << " " << turbidity;
            EXPECT_EQ(sky.sun().has_value(), degrees >= 0) << degrees;
        }
}

} // namespace environment_test
} // namespace glint::test
