#include "lab/scene/builtin/scene_builder.hpp"

#include <cmath>

namespace glint::scene::builtin {

glm::quat turnedY(float degrees) {
    return glm::angleAxis(glm::radians(degrees), glm::vec3(0, 1, 0));
}

glm::quat facing(const glm::vec3& position, const glm::vec3& target) {
    const glm::vec3 direction = glm::normalize(target - position);
    const glm::vec3 up = std::abs(direction.y) < 0.999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    return glm::quatLookAt(direction, up);
}

SceneBuilder::SceneBuilder(std::string name) {
    scene_.name = std::move(name);
    scene_.scenes.push_back({scene_.name, {}});
}

int SceneBuilder::material(Material material) {
    scene_.materials.push_back(std::move(material));
    return static_cast<int>(scene_.materials.size()) - 1;
}

TextureSlot SceneBuilder::texture(Image image, const glm::vec2& uvScale) {
    scene_.images.push_back(std::move(image));
    scene_.textures.push_back({static_cast<int>(scene_.images.size()) - 1, {}});
    TextureSlot slot;
    slot.texture = static_cast<int>(scene_.textures.size()) - 1;
    slot.uvTransform[0][0] = uvScale.x;
    slot.uvTransform[1][1] = uvScale.y;
    return slot;
}

int SceneBuilder::mesh(std::string name, Geometry geometry, int material) {
    std::vector<std::pair<Geometry, int>> primitives;
    primitives.emplace_back(std::move(geometry), material);
    return mesh(std::move(name), std::move(primitives));
}

int SceneBuilder::mesh(std::string name, std::vector<std::pair<Geometry, int>> primitives) {
    Mesh mesh;
    mesh.name = std::move(name);
    mesh.primitives.reserve(primitives.size());
    for (auto& part : primitives) {
        Primitive& primitive = mesh.primitives.emplace_back();
        primitive.geometry = std::move(part.first);
        primitive.material = part.second;
    }
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
}

int SceneBuilder::place(int mesh, const Place& place) {
    node(scene_.meshes[static_cast<size_t>(mesh)].name, place).mesh = mesh;
    return static_cast<int>(scene_.nodes.size()) - 1;
}

int SceneBuilder::add(std::string name, Geometry geometry, int material, const Place& where) {
    return place(mesh(std::move(name), std::move(geometry), material), where);
}

void SceneBuilder::camera(std::string name, const glm::vec3& position, const glm::vec3& target, float fovY) {
    Lens lens;
    lens.name = name;
    lens.fovY = glm::radians(fovY);
    lens.aspectRatio = 16.f / 9.f;
    scene_.cameras.push_back(std::move(lens));
    node(std::move(name), {position, facing(position, target)}).camera = static_cast<int>(scene_.cameras.size()) - 1;
}

void SceneBuilder::light(Light light, const glm::vec3& position, const glm::vec3& target) {
    node(light.name, {position, facing(position, target)}).light = static_cast<int>(scene_.lights.size());
    scene_.lights.push_back(std::move(light));
}

void SceneBuilder::animate(AnimationChannel channel) {
    if (scene_.animations.empty())
        scene_.animations.push_back({scene_.name, {}});
    scene_.animations.front().channels.push_back(std::move(channel));
}

Node& SceneBuilder::node(std::string name, const Place& place) {
    scene_.scenes[0].nodes.push_back(static_cast<int>(scene_.nodes.size()));
    Node& node = scene_.nodes.emplace_back();
    node.name = std::move(name);
    node.translation = place.position;
    node.rotation = place.rotation;
    node.scale = place.scale;
    return node;
}

Material emission(std::string name, const glm::vec3& radiance) {
    Material m;
    m.name = std::move(name);
    m.baseColorFactor = glm::vec4(0, 0, 0, 1);
    m.metallicFactor = 0;
    m.specularFactor = 0;
    m.emissiveFactor = radiance;
    return m;
}

Material perfectMirror(std::string name) {
    return metal(std::move(name), glm::vec3(1), 0);
}

Material metal(std::string name, const glm::vec3& f0, float roughness) {
    Material m;
    m.name = std::move(name);
    m.baseColorFactor = glm::vec4(f0, 1);
    m.metallicFactor = 1;
    m.roughnessFactor = roughness;
    return m;
}

Material dielectric(std::string name, const glm::vec3& albedo, float roughness) {
    Material m = metal(std::move(name), albedo, roughness);
    m.metallicFactor = 0;
    return m;
}

} // namespace glint::scene::builtin
