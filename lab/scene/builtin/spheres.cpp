// builtin:spheres: the material chart. Roughness grows to the right (0..1 in nine columns), metalness upward (0..1 in
// five rows) on steps, and in front stands a row of coloured dielectrics.
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/scenes.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/textures.hpp"

#include <fmt/format.h>

#include <array>

namespace glint::scene::builtin {

namespace {

constexpr int kColumns = 9, kRows = 5;
constexpr float kBallRadius = 0.22f, kBallSpacing = 0.56f; // metres
constexpr float kStepHeight = 0.3f, kStepDepth = 0.62f;

Geometry ball() {
    return sphere(kBallRadius, 48, 24);
}

float columnX(int column, int columns) {
    return kBallSpacing * (static_cast<float>(column) - static_cast<float>(columns - 1) / 2);
}

void addFloor(SceneBuilder& b) {
    Material floor = dielectric("floor", glm::vec3(1), 0.22f);
    floor.baseColorTexture =
        b.texture(checker("floor tiles", 512, 4, glm::vec3(0.2f), glm::vec3(0.15f)), glm::vec2(0.5f));
    b.add("floor", plane({10, 10}), b.material(floor));
}

void addChart(SceneBuilder& b) {
    const int step = b.material(dielectric("step", glm::vec3(0.12f), 0.3f));
    const glm::vec3 color(0.9f, 0.55f, 0.25f); // a warm metal, so that metalness shows as tint
    for (int row = 0; row < kRows; ++row) {
        const float z = -kStepDepth * static_cast<float>(row), top = kStepHeight * static_cast<float>(row + 1);
        b.add("step", roundedBox({2.75f, top / 2, kStepDepth / 2}, 0.012f), step, {{0, top / 2, z}});
        for (int column = 0; column < kColumns; ++column) {
            const float roughness = static_cast<float>(column) / (kColumns - 1);
            Material m =
                dielectric(fmt::format("roughness {:.3f} metallic {:.2f}", roughness, row * 0.25), color, roughness);
            m.metallicFactor = static_cast<float>(row) / (kRows - 1);
            const std::string name = m.name;
            b.add(name, ball(), b.material(std::move(m)), {{columnX(column, kColumns), top + kBallRadius, z}});
        }
    }
}

void addDielectrics(SceneBuilder& b) {
    constexpr std::array<glm::vec3, 7> colors = {
        glm::vec3(0.6f, 0.02f, 0.02f), {0.75f, 0.25f, 0.02f}, {0.7f, 0.6f, 0.05f}, {0.04f, 0.35f, 0.06f},
        {0.02f, 0.3f, 0.35f},          {0.02f, 0.05f, 0.45f}, {0.3f, 0.03f, 0.35f}};
    for (int i = 0; i < 7; ++i) {
        const std::string name = fmt::format("lacquer {}", i);
        const int material = b.material(dielectric(name, colors[static_cast<size_t>(i)], 0.05f));
        b.add(name, ball(), material, {{1.25f * columnX(i, 7), kBallRadius, 1.05f}});
    }
}

/// Two tall strips of light, whose reflections make roughness visible.
void addLights(SceneBuilder& b) {
    const int warm = b.material(emission("warm strip", glm::vec3(4, 2.2f, 0.9f)));
    const int cool = b.material(emission("cool strip", glm::vec3(0.7f, 1.9f, 4)));
    b.add("warm strip", roundedBox({0.05f, 1.2f, 0.05f}, 0.03f), warm, {{-2.95f, 1.2f, 0.1f}});
    b.add("cool strip", roundedBox({0.05f, 1.2f, 0.05f}, 0.03f), cool, {{2.95f, 1.2f, 0.1f}});
    Light sun;
    sun.name = "sun";
    sun.color = {1, 0.93f, 0.82f};
    sun.intensity = 2.5f; // lux, in the scene's scale: white paper in the sun has about 0.8
    b.light(sun, {-4, 6, 5}, {0, 0, 0});
}

} // namespace

Scene makeSpheres() {
    SceneBuilder b("builtin:spheres");
    b.camera("main", {0, 2.2f, 5.9f}, {0, 0.86f, -0.6f}, 34);
    b.camera("grazing", {-2.6f, 0.6f, 4.2f}, {0.3f, 0.6f, -1}, 40);
    addFloor(b);
    addChart(b);
    addDielectrics(b);
    addLights(b);
    return b.take();
}

} // namespace glint::scene::builtin
