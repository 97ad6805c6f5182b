#include "lab/scene/animation_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace glint::scene {
namespace {

/// The two keys around a time, and its position between them.
struct Segment {
    size_t from = 0;
    size_t to = 0;
    double duration = 0; ///< seconds
    float fraction = 0;  ///< [0, 1]
};

Segment findSegment(const std::vector<float>& times, double time) {
    const auto after =
        std::upper_bound(times.begin(), times.end(), time, [](double t, float key) { return t < double(key); });
    if (after == times.begin())
        return {};
    const size_t from = static_cast<size_t>(after - times.begin()) - 1;
    if (after == times.end())
        return {from, from, 0, 0};
    const double duration = double(*after) - double(times[from]);
    return {from, from + 1, duration, static_cast<float>((time - double(times[from])) / duration)};
}

glm::quat toQuat(const float* xyzw) {
    return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

std::vector<float> fromQuat(const glm::quat& q) {
    const float length = glm::length(q);
    if (!(length > 0) || !std::isfinite(length))
        return {0, 0, 0, 1};
    return {q.x / length, q.y / length, q.z / length, q.w / length};
}

/// Cubic Hermite spline; a key is in-tangent, value, out-tangent, and tangents are per second.
std::vector<float> sampleCubic(const AnimationChannel& channel, const Segment& segment, size_t components) {
    const float* from = channel.values.data() + segment.from * components * 3;
    const float* to = channel.values.data() + segment.to * components * 3;
    const float t = segment.fraction, t2 = t * t, t3 = t2 * t;
    const float duration = static_cast<float>(segment.duration);
    std::vector<float> result(components);
    for (size_t i = 0; i < components; ++i) {
        const float value0 = from[components + i];
        const float outTangent0 = from[components * 2 + i] * duration;
        const float inTangent1 = to[i] * duration;
        const float value1 = to[components + i];
        result[i] = (2 * t3 - 3 * t2 + 1) * value0 + (t3 - 2 * t2 + t) * outTangent0 + (-2 * t3 + 3 * t2) * value1 +
                    (t3 - t2) * inTangent1;
    }
    return result;
}

} // namespace

std::vector<float> sampleChannel(const AnimationChannel& channel, double time) {
    const bool cubic = channel.interpolation == Interpolation::CubicSpline;
    const bool rotation = channel.path == AnimationPath::Rotation;
    const size_t components = channel.values.size() / channel.times.size() / (cubic ? 3 : 1);
    const Segment segment = findSegment(channel.times, time);
    if (cubic) {
        std::vector<float> value = sampleCubic(channel, segment, components);
        return rotation ? fromQuat(toQuat(value.data())) : value;
    }
    const float* from = channel.values.data() + segment.from * components;
    const float* to = channel.values.data() + segment.to * components;
    const float fraction = channel.interpolation == Interpolation::Step ? 0.0f : segment.fraction;
    if (rotation) // along the shorter arc
        return fromQuat(glm::slerp(glm::normalize(toQuat(from)), glm::normalize(toQuat(to)), fraction));
    std::vector<float> result(components);
    for (size_t i = 0; i < components; ++i)
        result[i] = from[i] + (to[i] - from[i]) * fraction;
    return result;
}

std::vector<double> stepTimes(const Scene& scene) {
    std::set<double> seconds;
    for (const Animation* animation : playedAnimations(scene)) {
        for (const AnimationChannel& channel : animation->channels) {
            if (channel.interpolation != Interpolation::Step)
                continue;
            const auto components = static_cast<std::ptrdiff_t>(channel.values.size() / channel.times.size());
            for (size_t key = 1; key < channel.times.size(); ++key) {
                const auto value = channel.values.begin() + static_cast<std::ptrdiff_t>(key) * components;
                if (!std::equal(value, value + components, value - components))
                    seconds.insert(channel.times[key]);
            }
        }
    }
    return {seconds.begin(), seconds.end()};
}

std::vector<const Animation*> playedAnimations(const Scene& scene) {
    std::vector<const Animation*> played;
    std::set<std::pair<int, AnimationPath>> driven;
    for (const Animation& animation : scene.animations) {
        const bool collides =
            std::any_of(animation.channels.begin(), animation.channels.end(), [&](const auto& channel) {
                return driven.count({channel.node, channel.path}) != 0;
            });
        if (collides)
            continue;
        for (const AnimationChannel& channel : animation.channels)
            driven.insert({channel.node, channel.path});
        played.push_back(&animation);
    }
    return played;
}

} // namespace glint::scene
