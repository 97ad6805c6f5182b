#include "lab/scene/gltf/nodes.hpp"

#include "lab/scene/gltf/accessor.hpp"
#include "lab/scene/gltf/skins.hpp"
#include "lab/scene/gltf/vertices.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace glint::scene::gltf {
namespace {

glm::quat normalizedQuat(const glm::vec4& xyzw) {
    const double length = glm::length(glm::dvec4(xyzw));
    const glm::vec4 unit =
        length > 1e-20 && std::isfinite(length) ? glm::vec4(glm::dvec4(xyzw) / length) : glm::vec4(0, 0, 0, 1);
    return {unit.w, unit.x, unit.y, unit.z};
}

void readTransform(const JsonObject& object, Node& node) {
    if (object.has("matrix")) {
        const std::vector<float> values = object.numbers("matrix");
        if (values.size() != 16) {
            object.diagnostics().fail("{} must be 16 numbers", object.pathOf("matrix"));
            return;
        }
        glm::mat4 matrix(1);
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = values[size_t(i)];
        node.matrix = matrix;
        return;
    }
    node.translation = object.vector<3>("translation", glm::vec3(0));
    node.rotation = normalizedQuat(object.vector<4>("rotation", glm::vec4(0, 0, 0, 1)));
    node.scale = object.vector<3>("scale", glm::vec3(1));
}

/// EXT_mesh_gpu_instancing: arrays of translations, rotations and scales, each optional.
std::vector<glm::mat4> readInstances(Document& document, const JsonObject& extension) {
    const JsonObject attributes = extension.object("attributes");
    const Accessor* translation = findAccessor(document, attributes, "TRANSLATION", {kVec3});
    const Accessor* rotation = findAccessor(document, attributes, "ROTATION", {kVec4});
    const Accessor* scale = findAccessor(document, attributes, "SCALE", {kVec3});
    uint64_t count = 0;
    for (const Accessor* accessor : {translation, rotation, scale}) {
        if (accessor && count && accessor->count != count)
            document.diagnostics.fail("{}: accessors have {} and {} elements but must agree", attributes.path(), count,
                                      accessor->count);
        if (accessor)
            count = accessor->count;
    }
    if (document.failed() || !document.reserve(count * sizeof(glm::mat4), attributes.path()))
        return {};
    const auto values = [&](const Accessor* accessor) {
        return accessor ? readFloats(document, *accessor) : std::vector<float>();
    };
    const std::vector<float> t = values(translation), r = values(rotation), s = values(scale);
    if (document.failed())
        return {};
    std::vector<glm::mat4> instances(count, glm::mat4(1));
    for (size_t i = 0; i < count; ++i) {
        if (translation)
            instances[i] = glm::translate(instances[i], {t[i * 3], t[i * 3 + 1], t[i * 3 + 2]});
        if (rotation)
            instances[i] *= glm::mat4_cast(normalizedQuat({r[i * 4], r[i * 4 + 1], r[i * 4 + 2], r[i * 4 + 3]}));
        if (scale)
            instances[i] = glm::scale(instances[i], {s[i * 3], s[i * 3 + 1], s[i * 3 + 2]});
    }
    return instances;
}

Node readNode(Document& document, const JsonObject& object, size_t nodeCount, const Scene& scene) {
    Node node;
    node.name = object.string("name");
    node.children = object.indices("children", nodeCount, "nodes");
    readTransform(object, node);
    node.mesh = object.index("mesh", scene.meshes.size(), "meshes");
    node.skin = object.index("skin", scene.skins.size(), "skins");
    node.camera = object.index("camera", scene.cameras.size(), "cameras");
    node.light = object.extension("KHR_lights_punctual").index("light", scene.lights.size(), "lights");
    if (const JsonObject instancing = object.extension("EXT_mesh_gpu_instancing"); instancing.exists())
        node.instances = readInstances(document, instancing);
    node.weights = object.numbers("weights");
    if (!document.failed() && !node.weights.empty()) {
        const size_t targets = node.mesh < 0 ? 0 : scene.meshes[size_t(node.mesh)].weights.size();
        if (node.weights.size() != targets)
            document.diagnostics.fail("{} has {} numbers but the mesh has {} morph targets", object.pathOf("weights"),
                                      node.weights.size(), targets);
    }
    return node;
}

void linkParents(Document& document, Scene& scene) {
    for (size_t i = 0; i < scene.nodes.size(); ++i) {
        for (const int child : scene.nodes[i].children) {
            int& parent = scene.nodes[size_t(child)].parent;
            if (parent >= 0) {
                document.diagnostics.fail("nodes[{}] has two parents, nodes {} and {}", child, parent, i);
                return;
            }
            parent = static_cast<int>(i);
        }
    }
}

/// As a node has at most one parent, nodes that no root reaches are on a cycle or below one.
void checkNoCycles(Document& document, const Scene& scene) {
    std::vector<bool> reached(scene.nodes.size(), false);
    std::vector<int> open;
    for (size_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].parent < 0)
            open.push_back(static_cast<int>(i));
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        reached[size_t(node)] = true;
        open.insert(open.end(), scene.nodes[size_t(node)].children.begin(), scene.nodes[size_t(node)].children.end());
    }
    const auto lost = std::find(reached.begin(), reached.end(), false);
    if (lost != reached.end())
        document.diagnostics.fail("nodes[{}] is its own ancestor", lost - reached.begin());
}

void readScenes(Document& document, Scene& scene) {
    const JsonObject root = document.root();
    for (const JsonObject& object : root.objects("scenes")) {
        SceneRoots roots{object.string("name"), object.indices("nodes", scene.nodes.size(), "nodes")};
        std::vector<int> sorted = roots.nodes;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
            document.diagnostics.fail("{} names a node twice", object.pathOf("nodes"));
        for (const int node : roots.nodes)
            if (scene.nodes[size_t(node)].parent >= 0)
                document.diagnostics.fail("{} names node {}, which is a child of node {}; scenes hold root nodes",
                                          object.pathOf("nodes"), node, scene.nodes[size_t(node)].parent);
        scene.scenes.push_back(std::move(roots));
    }
    if (scene.scenes.empty()) { // a library of parts; show all of them
        SceneRoots roots;
        for (size_t i = 0; i < scene.nodes.size(); ++i)
            if (scene.nodes[i].parent < 0)
                roots.nodes.push_back(static_cast<int>(i));
        scene.scenes.push_back(std::move(roots));
    }
    scene.defaultScene = std::max(root.index("scene", scene.scenes.size(), "scenes"), 0);
}

uint64_t geometryBytes(const Mesh& mesh) {
    uint64_t bytes = 0;
    for (const Primitive& primitive : mesh.primitives)
        bytes +=
            primitive.geometry.positions.size() * bytesPerVertex(primitive) + primitive.geometry.indices.size() * 4;
    return bytes;
}

/// Reserves the memory that `pose` needs: an item per primitive, instance and node, a copy of each deformed mesh.
void reservePose(Document& document, const Scene& scene) {
    constexpr uint64_t kItemBytes = 128; // about a DrawItem
    std::vector<uint64_t> bytesOf(scene.meshes.size());
    std::transform(scene.meshes.begin(), scene.meshes.end(), bytesOf.begin(), geometryBytes);
    for (size_t i = 0; i < scene.nodes.size() && !document.failed(); ++i) {
        const Node& node = scene.nodes[i];
        if (node.mesh < 0)
            continue;
        const Mesh& mesh = scene.meshes[size_t(node.mesh)];
        const bool deformed = node.skin >= 0 || !mesh.weights.empty();
        const uint64_t items = mesh.primitives.size() * std::max<uint64_t>(node.instances.size(), 1);
        document.reserve(items * kItemBytes + (deformed ? bytesOf[size_t(node.mesh)] : 0), fmt::format("nodes[{}]", i));
    }
}

} // namespace

void readNodes(Document& document, Scene& scene) {
    const std::vector<JsonObject> objects = document.root().objects("nodes");
    readSkins(document, scene, objects.size());
    for (const JsonObject& object : objects) {
        if (document.failed())
            return;
        scene.nodes.push_back(readNode(document, object, objects.size(), scene));
    }
    if (document.failed())
        return;
    linkParents(document, scene);
    if (!document.failed())
        checkNoCycles(document, scene);
    if (!document.failed())
        readScenes(document, scene);
    if (!document.failed())
        checkJoints(document, scene);
    if (!document.failed())
        reservePose(document, scene);
}

} // namespace glint::scene::gltf
