#include "lab/scene/pose.hpp"

#include "lab/scene/animation_sampling.hpp"
#include "lab/scene/deformation.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace glint::scene {
namespace {

/// The animated properties of a node.
struct NodeState {
    glm::mat4 localToParent = glm::mat4(1);
    std::vector<float> weights; ///< empty: the mesh's own
};

bool isFinite(const glm::mat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row]))
                return false;
    return true;
}

std::vector<NodeState> animateNodes(const Scene& scene, double time) {
    std::vector<NodeState> states(scene.nodes.size());
    std::vector<const Node*> nodes(scene.nodes.size());
    std::unordered_map<int, Node> animated; // copies: most scenes animate few of their nodes
    for (size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = &scene.nodes[i];
    for (const Animation* animation : playedAnimations(scene)) {
        for (const AnimationChannel& channel : animation->channels) {
            Node& node = animated.try_emplace(channel.node, scene.nodes[size_t(channel.node)]).first->second;
            nodes[size_t(channel.node)] = &node;
            std::vector<float> value = sampleChannel(channel, time);
            switch (channel.path) {
            case AnimationPath::Translation: node.translation = {value[0], value[1], value[2]}; break;
            case AnimationPath::Scale: node.scale = {value[0], value[1], value[2]}; break;
            case AnimationPath::Rotation: node.rotation = {value[3], value[0], value[1], value[2]}; break;
            case AnimationPath::Weights: node.weights = std::move(value); break;
            }
        }
    }
    for (size_t i = 0; i < nodes.size(); ++i) {
        const Node& node = *nodes[i];
        states[i].weights = node.weights;
        states[i].localToParent = node.matrix
                                      ? *node.matrix
                                      : glm::translate(glm::mat4(1), node.translation) * glm::mat4_cast(node.rotation) *
                                            glm::scale(glm::mat4(1), node.scale);
    }
    return states;
}

/// Computes localToWorld of every node, parents first. Joints may be outside the drawn scene, so all trees are visited.
std::vector<glm::mat4> composeTransforms(const Scene& scene, const std::vector<NodeState>& states) {
    std::vector<glm::mat4> localToWorld(scene.nodes.size(), glm::mat4(1));
    std::vector<int> open;
    for (size_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].parent < 0)
            open.push_back(static_cast<int>(i));
    while (!open.empty()) {
        const size_t i = static_cast<size_t>(open.back());
        open.pop_back();
        const int parent = scene.nodes[i].parent;
        localToWorld[i] = parent < 0 ? states[i].localToParent : localToWorld[size_t(parent)] * states[i].localToParent;
        open.insert(open.end(), scene.nodes[i].children.begin(), scene.nodes[i].children.end());
    }
    return localToWorld;
}

/// Returns the nodes of a scene, depth first in file order.
std::vector<int> visibleNodes(const Scene& scene, const SceneRoots& roots) {
    std::vector<int> order;
    std::vector<int> open(roots.nodes.rbegin(), roots.nodes.rend());
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        order.push_back(node);
        const std::vector<int>& children = scene.nodes[size_t(node)].children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return order;
}

void grow(Bounds& bounds, const glm::vec3& point) {
    bounds.min = glm::min(bounds.min, point);
    bounds.max = glm::max(bounds.max, point);
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Empty if there are no vertices or if one of them was deformed beyond the range of a float.
Bounds localBounds(const Geometry& geometry) {
    Bounds bounds;
    for (const glm::vec3& position : geometry.positions) {
        if (!isFinite(position))
            return {};
        grow(bounds, position);
    }
    return bounds;
}

/// Keeps position and rotation without scale, which a lens cannot have.
glm::mat4 rigid(const glm::mat4& localToWorld) {
    const glm::vec3 backward = glm::vec3(localToWorld[2]);
    const glm::vec3 up = glm::vec3(localToWorld[1]);
    const glm::vec3 right = glm::cross(up, backward);
    if (!(glm::length(backward) > 0) || !(glm::length(right) > 0))
        return glm::translate(glm::mat4(1), glm::vec3(localToWorld[3]));
    const glm::vec3 z = glm::normalize(backward);
    const glm::vec3 x = glm::normalize(right);
    return {glm::vec4(x, 0), glm::vec4(glm::cross(z, x), 0), glm::vec4(z, 0), localToWorld[3]};
}

Camera placeCamera(const Lens& lens, const std::string& nodeName, const glm::mat4& localToWorld) {
    Camera camera;
    camera.name = lens.name.empty() ? nodeName : lens.name;
    camera.viewToWorld = rigid(localToWorld);
    camera.orthographic = lens.orthographic;
    camera.fovY = lens.fovY;
    camera.orthoHeight = lens.orthoHeight;
    camera.aspectRatio = lens.aspectRatio.value_or(0.0f);
    camera.near = lens.near;
    camera.far = lens.far;
    return camera;
}

PosedLight placeLight(const Light& light, const glm::mat4& localToWorld) {
    PosedLight posed{light, glm::vec3(localToWorld[3]), glm::vec3(0, 0, -1)};
    const glm::vec3 direction = -glm::vec3(localToWorld[2]);
    if (const float length = glm::length(direction); length > 0 && std::isfinite(length))
        posed.directionWS = direction / length;
    return posed;
}

/// Builds a Pose, node by node.
class Poser {
public:
    Poser(const Scene& scene, double time)
        : scene_(scene), states_(animateNodes(scene, time)), localToWorld_(composeTransforms(scene, states_)) {}

    Pose run(const SceneRoots& roots) {
        for (const int node : visibleNodes(scene_, roots))
            addNode(node);
        return std::move(pose_);
    }

private:
    void addNode(int index) {
        const Node& node = scene_.nodes[size_t(index)];
        const glm::mat4& localToWorld = localToWorld_[size_t(index)];
        if (!isFinite(localToWorld)) // beyond the range of a float: not visible
            return;
        if (node.camera >= 0)
            pose_.cameras.push_back(placeCamera(scene_.cameras[size_t(node.camera)], node.name, localToWorld));
        if (node.light >= 0)
            pose_.lights.push_back(placeLight(scene_.lights[size_t(node.light)], localToWorld));
        if (node.mesh >= 0)
            for (const Primitive& primitive : scene_.meshes[size_t(node.mesh)].primitives)
                addPrimitive(primitive, index);
    }

    void addPrimitive(const Primitive& primitive, int index) {
        const Node& node = scene_.nodes[size_t(index)];
        const bool skinned = node.skin >= 0 && !primitive.skinSets.empty();
        const Geometry* geometry = &primitive.geometry;
        if (skinned || !primitive.morphTargets.empty())
            geometry = deform(primitive, index, skinned);
        if (!geometry || geometry->indices.empty())
            return;
        if (skinned || node.instances.empty())
            return addItem(*geometry, primitive.material, index, skinned ? glm::mat4(1) : localToWorld_[size_t(index)]);
        for (const glm::mat4& instance : node.instances)
            addItem(*geometry, primitive.material, index, localToWorld_[size_t(index)] * instance);
    }

    const Geometry* deform(const Primitive& primitive, int index, bool skinned) {
        const Node& node = scene_.nodes[size_t(index)];
        auto geometry = std::make_unique<Geometry>(primitive.geometry);
        if (!primitive.morphTargets.empty()) {
            const std::vector<float>& weights = states_[size_t(index)].weights;
            morph(primitive, weights.empty() ? scene_.meshes[size_t(node.mesh)].weights : weights, *geometry);
        }
        if (skinned)
            skin(primitive, skinMatrices(scene_.skins[size_t(node.skin)]), *geometry);
        pose_.deformed.push_back(std::move(geometry));
        return pose_.deformed.back().get();
    }

    std::vector<glm::mat4> skinMatrices(const Skin& skin) const {
        std::vector<glm::mat4> matrices(skin.joints.size());
        for (size_t i = 0; i < matrices.size(); ++i)
            matrices[i] = localToWorld_[size_t(skin.joints[i])] * skin.inverseBindMatrices[i];
        return matrices;
    }

    void addItem(const Geometry& geometry, int material, int node, const glm::mat4& localToWorld) {
        const auto [entry, isNew] = boundsOf_.try_emplace(&geometry);
        if (isNew)
            entry->second = localBounds(geometry);
        const Bounds& local = entry->second;
        Bounds world;
        for (int corner = 0; corner < 8 && !local.empty(); ++corner) {
            const glm::vec3 point(corner & 1 ? local.max.x : local.min.x, corner & 2 ? local.max.y : local.min.y,
                                  corner & 4 ? local.max.z : local.min.z);
            const glm::vec3 pointWS(localToWorld * glm::vec4(point, 1));
            if (!isFinite(pointWS))
                return; // beyond the range of a float: not visible
            grow(world, pointWS);
        }
        if (world.empty())
            return;
        grow(pose_.boundsWS, world.min);
        grow(pose_.boundsWS, world.max);
        pose_.items.push_back({&geometry, material, node, localToWorld, world});
    }

    const Scene& scene_;
    std::vector<NodeState> states_;
    std::vector<glm::mat4> localToWorld_;
    std::unordered_map<const Geometry*, Bounds> boundsOf_; ///< in each geometry's own space
    Pose pose_;
};

} // namespace

Result<Pose> pose(const Scene& scene, double time, int sceneIndex) {
    if (sceneIndex < 0)
        sceneIndex = scene.defaultScene;
    if (static_cast<size_t>(sceneIndex) >= scene.scenes.size())
        return invalidArgument("{} has no scene {}; it has {}", scene.name, sceneIndex, scene.scenes.size());
    return Poser(scene, time).run(scene.scenes[size_t(sceneIndex)]);
}

} // namespace glint::scene
