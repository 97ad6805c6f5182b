// builtin:thickness: balls on a polished floor in front of an upright mirror, as in Babylon.js' documentation. The
// mirror shows the balls' far sides and the floor their undersides, which the camera does not see:
// `screen.thicknessMode` determines screen-space reflections there (docs/techniques/thickness.md).
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/scenes.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/textures.hpp"

namespace glint::scene::builtin {

namespace {

constexpr float kMirrorZ = -1.3f;

/// Rough, so that the balls themselves reflect nothing.
void addBall(SceneBuilder& b, const char* name, const glm::vec3& albedo, float radius, float x, float z) {
    b.add(name, sphere(radius, 96, 48), b.material(dielectric(name, albedo, 0.9f)), {{x, radius, z}});
}

void addMirror(SceneBuilder& b) {
    constexpr glm::vec2 kHalf(2.1f, 0.8f);
    const Place place = {{0, kHalf.y + 0.06f, kMirrorZ}};
    b.add("mirror", boxSide({kHalf, 0}, Side::PlusZ), b.material(metal("mirror", glm::vec3(0.95f), 0)), place);
    b.add("frame", frame(kHalf, 0.06f, 0.06f), b.material(dielectric("frame", glm::vec3(0.25f, 0.2f, 0.15f), 0.8f)),
          place);
}

} // namespace

Scene makeThickness() {
    SceneBuilder b("builtin:thickness");
    b.camera("main", {1.9f, 1.5f, 3.6f}, {0.15f, 0.42f, -0.5f}, 38);
    Material floor = metal("floor", glm::vec3(1), 0.05f);
    floor.baseColorTexture =
        b.texture(checker("floor tiles", 256, 2, glm::vec3(0.3f, 0.32f, 0.35f), glm::vec3(0.42f, 0.44f, 0.47f)));
    b.add("floor", plane({5, 5}), b.material(floor));
    addMirror(b);
    addBall(b, "red ball", {0.75f, 0.06f, 0.04f}, 0.42f, -0.8f, -0.1f);
    addBall(b, "yellow ball", {0.8f, 0.6f, 0.06f}, 0.3f, 0.25f, 0.35f);
    addBall(b, "blue ball", {0.05f, 0.2f, 0.7f}, 0.2f, 1.05f, 0.1f);
    Light sun;
    sun.name = "sun";
    sun.color = {1, 0.95f, 0.88f};
    sun.intensity = 1.6f; // lux, in the scene's scale: white paper in the sun has about 0.5
    b.light(sun, {-4, 5, 2.5f}, {0, 0, 0});
    return b.take();
}

} // namespace glint::scene::builtin
