// builtin:glass: the refraction chart, in front of a chequered wall. From the top: index of refraction 1 to 2.4;
// roughness 0 to 0.6; absorption distance (green) 0.1 to 6 m, at a thickness of 0.5 m, in balls and in cubes. A pane
// stands in front of the right-hand column.
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/scenes.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/textures.hpp"

#include <fmt/format.h>

#include <array>

namespace glint::scene::builtin {

namespace {

constexpr size_t kColumns = 6;
constexpr float kRadius = 0.25f, kSpacing = 0.68f; // metres
constexpr std::array<float, 4> kRowHeights = {2.45f, 1.78f, 1.11f, 0.44f};

Material glass(std::string name, float ior, float roughness) {
    Material material = dielectric(std::move(name), glm::vec3(1), roughness);
    material.transmissionFactor = 1;
    material.ior = ior;
    material.thicknessFactor = 2 * kRadius;
    return material;
}

void addThing(SceneBuilder& b, Material material, Geometry shape, size_t row, size_t column) {
    const float x = kSpacing * (static_cast<float>(column) - static_cast<float>(kColumns - 1) / 2);
    const std::string name = material.name;
    b.add(name, std::move(shape), b.material(std::move(material)), {{x, kRowHeights[row], 0}, turnedY(20)});
}

void addRows(SceneBuilder& b) {
    constexpr std::array<float, kColumns> iors = {1, 1.1f, 1.33f, 1.5f, 1.8f, 2.4f};
    constexpr std::array<float, kColumns> roughnesses = {0, 0.1f, 0.2f, 0.3f, 0.45f, 0.6f};
    constexpr std::array<float, kColumns> distances = {0.1f, 0.25f, 0.5f, 1, 3, 6};
    const Geometry ball = sphere(kRadius, 64, 32);
    for (size_t i = 0; i < kColumns; ++i) {
        addThing(b, glass(fmt::format("ior {}", iors[i]), iors[i], 0), ball, 0, i);
        addThing(b, glass(fmt::format("roughness {}", roughnesses[i]), 1.5f, roughnesses[i]), ball, 1, i);
        Material green = glass(fmt::format("green after {} m", distances[i]), 1.5f, 0);
        green.attenuationColor = {0.1f, 0.8f, 0.3f};
        green.attenuationDistance = distances[i];
        addThing(b, green, ball, 2, i);
        green.name += ", cube";
        addThing(b, green, box(glm::vec3(kRadius)), 3, i);
    }
}

} // namespace

Scene makeGlass() {
    SceneBuilder b("builtin:glass");
    b.camera("main", {0, 1.55f, 6.2f}, {0, 1.42f, 0}, 30);
    Material wall = dielectric("wall", glm::vec3(1), 0.8f);
    wall.baseColorTexture = b.texture(
        checker("wall tiles", 512, 4, glm::vec3(0.75f, 0.72f, 0.65f), glm::vec3(0.12f, 0.16f, 0.25f)), glm::vec2(0.7f));
    b.add("wall", boxSide({4, 2, 0}, Side::PlusZ), b.material(wall), {{0, 1.6f, -1.4f}});
    Material floor = dielectric("floor", glm::vec3(1), 0.5f);
    floor.baseColorTexture =
        b.texture(checker("floor tiles", 512, 4, glm::vec3(0.5f, 0.1f, 0.08f), glm::vec3(0.6f)), glm::vec2(0.7f));
    b.add("floor", plane({10, 10}), b.material(floor));
    addRows(b);
    Material pane = glass("pane", 1.5f, 0);
    pane.thicknessFactor = 0.06f;
    b.add("pane", box({0.5f, 1.1f, 0.03f}), b.material(pane), {{1.6f, 1.3f, 0.9f}, turnedY(-25)});
    Light sun;
    sun.name = "sun";
    sun.type = LightType::Directional;
    sun.intensity = 2;
    b.light(sun, {2, 4, 4}, {0, 1, 0});
    return b.take();
}

} // namespace glint::scene::builtin
