#include "lab/scene/gltf/skins.hpp"

#include "lab/scene/gltf/accessor.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene::gltf {
namespace {

std::vector<glm::mat4> readInverseBindMatrices(Document& document, const JsonObject& object, size_t jointCount) {
    std::vector<glm::mat4> matrices(jointCount, glm::mat4(1));
    const Accessor* accessor = findAccessor(document, object, "inverseBindMatrices", {kMat4});
    if (!accessor)
        return matrices;
    if (accessor->count < jointCount) {
        document.diagnostics.fail("{} has {} matrices (accessor {}) for {} joints",
                                  object.pathOf("inverseBindMatrices"), accessor->count, accessor->index, jointCount);
        return matrices;
    }
    const std::vector<float> values = readFloats(document, *accessor);
    if (std::any_of(values.begin(), values.end(), [](float value) { return !std::isfinite(value); }))
        document.diagnostics.fail("accessor {}: an inverse bind matrix is not finite", accessor->index);
    if (document.failed())
        return matrices;
    for (size_t i = 0; i < jointCount; ++i)
        for (int k = 0; k < 16; ++k)
            matrices[i][k / 4][k % 4] = values[i * 16 + size_t(k)];
    return matrices;
}

/// The highest joint of a mesh, or -1 if it has none.
int highestJoint(const Mesh& mesh) {
    int highest = -1;
    for (const Primitive& primitive : mesh.primitives)
        for (const SkinSet& set : primitive.skinSets)
            for (const glm::u16vec4& joints : set.joints)
                highest = std::max({highest, int(joints.x), int(joints.y), int(joints.z), int(joints.w)});
    return highest;
}

} // namespace

void readSkins(Document& document, Scene& scene, size_t nodeCount) {
    for (const JsonObject& object : document.root().objects("skins")) {
        Skin skin;
        skin.joints = object.indices("joints", nodeCount, "nodes");
        if (skin.joints.empty() && !document.failed())
            document.diagnostics.fail("{} has no joints", object.path());
        if (document.failed() || !document.reserve(skin.joints.size() * sizeof(glm::mat4), object.path()))
            return;
        skin.inverseBindMatrices = readInverseBindMatrices(document, object, skin.joints.size());
        scene.skins.push_back(std::move(skin));
    }
}

void checkJoints(Document& document, const Scene& scene) {
    std::vector<int> highest(scene.meshes.size());
    std::transform(scene.meshes.begin(), scene.meshes.end(), highest.begin(), highestJoint);
    for (size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (node.skin < 0 || node.mesh < 0)
            continue;
        const size_t joints = scene.skins[size_t(node.skin)].joints.size();
        if (highest[size_t(node.mesh)] >= int(joints)) {
            document.diagnostics.fail("nodes[{}]: mesh {} uses joint {} but skin {} has {}", i, node.mesh,
                                      highest[size_t(node.mesh)], node.skin, joints);
            return;
        }
    }
}

} // namespace glint::scene::gltf
