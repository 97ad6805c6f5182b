#include "lab/scene/gltf/animations.hpp"

#include "lab/scene/gltf/accessor.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene::gltf {
namespace {

std::optional<AnimationPath> readPath(const JsonObject& target) {
    const std::string path = target.string("path");
    if (path == "translation")
        return AnimationPath::Translation;
    if (path == "rotation")
        return AnimationPath::Rotation;
    if (path == "scale")
        return AnimationPath::Scale;
    if (path == "weights")
        return AnimationPath::Weights;
    target.diagnostics().warn("{} is \"{}\", which is not animated", target.pathOf("path"), path);
    return std::nullopt;
}

Interpolation readInterpolation(const JsonObject& sampler) {
    const std::string name = sampler.string("interpolation");
    if (name == "STEP")
        return Interpolation::Step;
    if (name == "CUBICSPLINE")
        return Interpolation::CubicSpline;
    if (!name.empty() && name != "LINEAR")
        sampler.diagnostics().fail("{} is \"{}\", which is none of STEP, LINEAR and CUBICSPLINE",
                                   sampler.pathOf("interpolation"), name);
    return Interpolation::Linear;
}

/// Returns the floats per key for this property; 0 if the node lacks the property.
size_t componentsPerKey(const Scene& scene, const AnimationChannel& channel) {
    const Node& node = scene.nodes[size_t(channel.node)];
    switch (channel.path) {
    case AnimationPath::Translation:
    case AnimationPath::Scale: return 3;
    case AnimationPath::Rotation: return 4;
    case AnimationPath::Weights: return node.mesh < 0 ? 0 : scene.meshes[size_t(node.mesh)].weights.size();
    }
    return 0;
}

void checkFinite(Document& document, const Accessor& accessor, const std::vector<float>& values) {
    if (std::any_of(values.begin(), values.end(), [](float value) { return !std::isfinite(value); }))
        document.diagnostics.fail("accessor {}: an animation's value is not finite", accessor.index);
}

void readSampler(Document& document, const JsonObject& sampler, size_t components, AnimationChannel& channel) {
    if (!sampler.has("input"))
        sampler.failMissing("input");
    if (!sampler.has("output"))
        sampler.failMissing("output");
    const Accessor* input = findAccessor(document, sampler, "input", {kScalar});
    const Accessor* output = findAccessor(document, sampler, "output", {kVec3, kVec4, kScalar});
    channel.interpolation = readInterpolation(sampler);
    if (document.failed())
        return;
    const uint64_t valuesPerKey = components * (channel.interpolation == Interpolation::CubicSpline ? 3 : 1);
    const uint64_t wanted = input->count * valuesPerKey;
    const uint64_t given = output->count * output->shape.components();
    if (input->count == 0 || wanted != given) {
        document.diagnostics.fail("{}: {} keys (accessor {}) need {} numbers but accessor {} has {}", sampler.path(),
                                  input->count, input->index, wanted, output->index, given);
        return;
    }
    channel.times = readFloats(document, *input);
    channel.values = readFloats(document, *output);
    checkFinite(document, *input, channel.times);
    checkFinite(document, *output, channel.values);
    if (!std::is_sorted(channel.times.begin(), channel.times.end()))
        document.diagnostics.fail("accessor {}: the times of an animation must rise", input->index);
}

void readChannel(Document& document, const JsonObject& object, const std::vector<JsonObject>& samplers,
                 const Scene& scene, Animation& animation) {
    const JsonObject target = object.object("target");
    AnimationChannel channel;
    channel.node = target.index("node", scene.nodes.size(), "nodes");
    const int sampler = object.requiredIndex("sampler", samplers.size(), "samplers in this animation");
    if (document.failed() || channel.node < 0)
        return; // the specification: a channel without a node is ignored
    const std::optional<AnimationPath> path = readPath(target);
    if (!path)
        return;
    channel.path = *path;
    if (scene.nodes[size_t(channel.node)].matrix && channel.path != AnimationPath::Weights) {
        document.diagnostics.warn("{} animates node {}, which has a matrix and stays as it is", object.path(),
                                  channel.node);
        return;
    }
    const size_t components = componentsPerKey(scene, channel);
    if (components == 0) {
        document.diagnostics.warn("{} animates morph weights of node {}, which has no morph targets", object.path(),
                                  channel.node);
        return;
    }
    readSampler(document, samplers[size_t(sampler)], components, channel);
    animation.channels.push_back(std::move(channel));
}

} // namespace

void readAnimations(Document& document, Scene& scene) {
    for (const JsonObject& object : document.root().objects("animations")) {
        Animation animation;
        animation.name = object.string("name");
        const std::vector<JsonObject> samplers = object.objects("samplers");
        for (const JsonObject& channel : object.objects("channels")) {
            if (document.failed())
                return;
            readChannel(document, channel, samplers, scene, animation);
        }
        scene.animations.push_back(std::move(animation));
    }
}

} // namespace glint::scene::gltf
