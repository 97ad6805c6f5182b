// Punctual lights on simple surfaces against closed forms.
#include "lab/tests/render/support/render_test.hpp"

#include "tests/gpu/support/brdf_oracle.hpp"

namespace glint::test {
namespace lighting_test {

/// glTF's model under one light, with Turquin's compensation, looking along the normal.
glm::dvec3 litSquare(const scene::Material& material, double lightAngle, double irradiance) {
    const double r = std::max(double(material.roughnessFactor), 0.045);
    const double NoL = std::cos(lightAngle);
    const double VoH = std::cos(lightAngle / 2); // H halves the angle between V = N and L
    const double brdf = oracle::ggx(VoH, r * r) * oracle::smithVisibility(1, NoL, r * r);
    const glm::dvec2 dfg = oracle::splitSum(1, material.roughnessFactor);
    const double energy = dfg.x + dfg.y;
    const glm::dvec3 base(material.baseColorFactor);
    const double metallic = material.metallicFactor;
    glm::dvec3 result;
    for (int c = 0; c < 3; ++c) {
        const double f0 = glm::mix(0.04, base[c], metallic);
        const double specular = brdf * oracle::schlick(f0, 1, VoH) * (1 + f0 * (1 / energy - 1));
        const double diffuse = (1 - metallic) * base[c] / oracle::kPi * (1 - oracle::schlick(0.04, 1, VoH));
        result[c] = (specular + diffuse) * NoL * irradiance;
    }
    return result;
}

class LightingTest : public RenderTest {
protected:
    static render::ViewParameters front(float height) { return {orthographicCamera(height), {}, {}, {}}; }
    static scene::Light light(scene::LightType type, float intensity) {
        scene::Light result;
        result.type = type;
        result.intensity = intensity;
        return result;
    }
};

TEST_F(LightingTest, DirectionalLightOnASquare) {
    for (const float roughness : {0.2f, 0.5f, 1.0f})
        for (const float metallic : {0.0f, 0.5f, 1.0f})
            for (const float degrees : {0.0f, 20.0f, 60.0f}) {
                scene::Material material = metal(roughness, {0.9f, 0.5f, 0.2f});
                material.metallicFactor = metallic;
                SceneParts parts;
                parts.add(square(1), material);
                const float angle = glm::radians(degrees);
                parts.addLight(light(scene::LightType::Directional, 3), glm::vec3(0),
                               {-std::sin(angle), 0, -std::cos(angle)});
                const glm::vec3 got = draw(parts, front(2), 9, 9).lit.center();
                const glm::dvec3 expected = litSquare(material, angle, 3);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(got[c], expected[c], 0.01 * expected[c] + 1e-4)
                        << "roughness " << roughness << " metallic " << metallic << " at " << degrees << " degrees";
            }
}

TEST_F(LightingTest, PointLightFallsWithTheSquareOfDistanceUntilItsRange) {
    for (const float range : {std::numeric_limits<float>::infinity(), 3.0f}) {
        SceneParts parts;
        parts.add(square(1), matte(glm::vec3(1)));
        scene::Light lamp = light(scene::LightType::Point, 10);
        lamp.range = range;
        parts.addLight(lamp, {0, 0, 2}, {0, -1, 0});
        // KHR_lights_punctual: max(min(1 - (d / range)^4, 1), 0) / d^2
        const double window = std::isfinite(range) ? 1 - std::pow(2.0 / range, 4) : 1;
        EXPECT_NEAR(draw(parts, front(2), 9, 9).lit.center().x, 10 / oracle::kPi * window / 4, 2e-3);
    }
}

TEST_F(LightingTest, SpotLightIsFullInsideAndDarkOutside) {
    SceneParts parts;
    parts.add(square(4), matte(glm::vec3(1)));
    scene::Light lamp = light(scene::LightType::Spot, 10);
    lamp.innerConeAngle = 0.2f;
    lamp.outerConeAngle = 0.5f;
    parts.addLight(lamp, {0, 0, 2}, {0, 0, -1});
    const Picture lit = draw(parts, front(8), 129, 129).lit;
    EXPECT_NEAR(lit.center().x, 10 / oracle::kPi / 4, 2e-3);
    const auto atAngle = [&](double angle) { // along +X from the middle
        return lit.at(uint32_t((2 * std::tan(angle) / 8 + 0.5) * 129), 64).x;
    };
    EXPECT_EQ(atAngle(0.55), 0);
    const double cosine = std::cos(0.35);
    const double cone = (cosine - std::cos(0.5)) / (std::cos(0.2) - std::cos(0.5));
    EXPECT_NEAR(atAngle(0.35), 10 / oracle::kPi / 4 * std::pow(cosine, 3) * cone * cone, 0.03);
}

TEST_F(LightingTest, LambertBallIsTheCosine) {
    SceneParts parts;
    parts.add(ball(1), matte({0.8f, 0.4f, 0.2f}));
    const glm::vec3 toLight = glm::normalize(glm::vec3(1, 2, 3));
    parts.addLight(light(scene::LightType::Directional, 2), glm::vec3(0), -toLight);
    render::RenderSettings settings;
    settings.lights.shadows = render::ShadowMode::None;
    const Picture lit = draw(parts, front(2), 65, 65, {}, settings).lit;
    for (uint32_t y = 8; y < 60; y += 5)
        for (uint32_t x = 8; x < 60; x += 5) {
            const glm::vec2 p((float(x) + 0.5f) / 32.5f - 1, 1 - (float(y) + 0.5f) / 32.5f);
            if (glm::length(p) > 0.95f)
                continue;
            const glm::vec3 normal(p, std::sqrt(1 - glm::dot(p, p)));
            EXPECT_NEAR(lit.at(x, y).x, 0.8 / oracle::kPi * 2 * std::max(glm::dot(normal, toLight), 0.0f), 0.01);
        }
}

TEST_F(LightingTest, ShadowFallsWhereTheBlockerIs) {
    for (const auto type : {scene::LightType::Directional, scene::LightType::Spot}) {
        SceneParts parts;
        parts.add(square(4), matte(glm::vec3(1)));
        // Not in the camera's way: it stands aside, and the light comes from that side.
        parts.add(square(0.5f), matte(glm::vec3(0)), glm::translate(glm::mat4(1), glm::vec3(2, 0, 2)));
        scene::Light lamp = light(type, type == scene::LightType::Spot ? 100 : 1);
        lamp.outerConeAngle = 0.9f;
        parts.addLight(lamp, glm::vec3(4, 0, 4), glm::normalize(glm::vec3(-1, 0, -1)));
        const Picture lit = draw(parts, front(8), 129, 129).lit;
        const auto at = [&](float x, float y) {
            return lit.at(uint32_t((x / 8 + 0.5f) * 129), uint32_t((0.5f - y / 8) * 129)).x;
        };
        EXPECT_EQ(at(0, 0), 0) << "the middle of the shadow";
        EXPECT_EQ(at(0.3f, 0.3f), 0);
        EXPECT_GT(at(0, 1.5f), 0.05f) << "beside it";
        EXPECT_GT(at(-1.5f, 0), 0.05f);
        // No acne: the open floor is as bright as without shadows.
        render::RenderSettings off;
        off.lights.shadows = render::ShadowMode::None;
        const Picture open = draw(parts, front(8), 129, 129, {}, off).lit;
        for (uint32_t y = 4; y < 30; ++y)
            for (uint32_t x = 4; x < 60; ++x)
                ASSERT_EQ(lit.at(x, y), open.at(x, y)) << x << "," << y;
    }
}

} // namespace lighting_test
} // namespace glint::test
