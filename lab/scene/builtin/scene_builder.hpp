// Builds a Scene in code: each call adds one element and returns its index or node.
#pragma once

#include "lab/scene/scene.hpp"

#include <string>
#include <utility>
#include <vector>

namespace glint::scene::builtin {

/// Position, rotation and scale of an element. All nodes are roots, as built-in scenes need no tree.
struct Place {
    glm::vec3 position = glm::vec3(0);
    glm::quat rotation = glm::quat(1, 0, 0, 0);
    glm::vec3 scale = glm::vec3(1);
};

/// Returns a rotation around +Y by `degrees`, counter-clockwise seen from above.
glm::quat turnedY(float degrees);
/// Returns a rotation of -Z, the view direction of cameras and lights, towards `target`.
glm::quat facing(const glm::vec3& position, const glm::vec3& target);

class SceneBuilder {
public:
    explicit SceneBuilder(std::string name);

    int material(Material material);
    /// `uvScale`: repeats per unit of uv.
    TextureSlot texture(Image image, const glm::vec2& uvScale = glm::vec2(1));
    int mesh(std::string name, Geometry geometry, int material);
    int mesh(std::string name, std::vector<std::pair<Geometry, int>> primitives);
    /// Adds an instance of a mesh to the scene, under the mesh's name. Returns its node.
    int place(int mesh, const Place& place);
    /// Adds a mesh with a single instance. Returns its node.
    int add(std::string name, Geometry geometry, int material, const Place& place = {});

    /// `fovY` in degrees, for 16:9 images.
    void camera(std::string name, const glm::vec3& position, const glm::vec3& target, float fovY);
    void light(Light light, const glm::vec3& position, const glm::vec3& target);

    /// Adds a channel to the scene's only animation.
    void animate(AnimationChannel channel);

    Scene take() { return std::move(scene_); }

private:
    Node& node(std::string name, const Place& place);

    Scene scene_;
};

// ---------------------------------------------------------------- the materials that every scene needs

/// Emits `radiance` and reflects nothing: a dielectric with F0 = F90 = 0 (KHR_materials_specular) and no diffuse part.
Material emission(std::string name, const glm::vec3& radiance);
/// A perfect mirror: F = 1 at every angle, roughness 0.
Material perfectMirror(std::string name);
Material metal(std::string name, const glm::vec3& f0, float roughness);
Material dielectric(std::string name, const glm::vec3& albedo, float roughness);

} // namespace glint::scene::builtin
