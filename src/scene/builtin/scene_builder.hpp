// Puts a Scene together by hand: each call adds one thing and returns its index or its node.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <utility>
#include <vector>

namespace glint::scene::builtin {

/// Where a thing stands. All nodes are roots; built-in scenes need no tree.
struct Place {
    glm::vec3 position = glm::vec3(0);
    glm::quat rotation = glm::quat(1, 0, 0, 0);
    glm::vec3 scale = glm::vec3(1);
};

/// Turned around +Y by `degrees`, counter-clockwise seen from above.
glm::quat turnedY(float degrees);
/// Turns -Z, the way that cameras and lights look, towards `target`.
glm::quat facing(const glm::vec3& position, const glm::vec3& target);

class SceneBuilder {
public:
    explicit SceneBuilder(std::string name);

    int material(Material material);
    /// `uvScale`: repeats per unit of uv.
    TextureSlot texture(Image image, const glm::vec2& uvScale = glm::vec2(1));
    int mesh(std::string name, Geometry geometry, int material);
    int mesh(std::string name, std::vector<std::pair<Geometry, int>> primitives);
    /// Puts a mesh into the world, under the mesh's name.
    void place(int mesh, const Place& place);
    /// A mesh that stands in one place only.
    void add(std::string name, Geometry geometry, int material, const Place& place = {});

    /// `fovY` in degrees, for pictures of 16:9.
    void camera(std::string name, const glm::vec3& position, const glm::vec3& target, float fovY);
    void light(Light light, const glm::vec3& position, const glm::vec3& target);

    Scene take() { return std::move(scene_); }

private:
    Node& node(std::string name, const Place& place);

    Scene scene_;
};

// ---------------------------------------------------------------- the materials that every scene needs

/// Shines `radiance` and reflects nothing: a dielectric with F0 = F90 = 0 (KHR_materials_specular) and no diffuse part.
Material emission(std::string name, const glm::vec3& radiance);
/// A perfect mirror: F = 1 for every angle, no blur.
Material perfectMirror(std::string name);
Material metal(std::string name, const glm::vec3& f0, float roughness);
Material dielectric(std::string name, const glm::vec3& albedo, float roughness);

} // namespace glint::scene::builtin
