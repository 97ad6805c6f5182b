#include "lab/scene/camera_path.hpp"

#include "base/assert.hpp"
#include "base/file.hpp"
#include "lab/scene/pose.hpp"

#include <nlohmann/json.hpp>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::scene {
namespace {

using PathJson = nlohmann::json;

constexpr size_t kLongestPathFile = 16 << 20; ///< bytes
constexpr double kFarthest = 1e9;             ///< metres and seconds

Result<double> pathNumber(const PathJson& key, const char* name, double min, double max, std::string_view where) {
    const auto found = key.find(name);
    const double value = found != key.end() && found->is_number() ? found->get<double>() : std::nan("");
    if (!(value >= min && value <= max))
        return invalidInput("{}: {} must be a number between {} and {}", where, name, min, max);
    return value;
}

Result<glm::vec3> pathPoint(const PathJson& key, const char* name, std::string_view where) {
    const auto found = key.find(name);
    const auto isCoordinate = [](const PathJson& value) {
        return value.is_number() && std::abs(value.get<double>()) <= kFarthest;
    };
    if (found == key.end() || !found->is_array() || found->size() != 3 || !std::ranges::all_of(*found, isCoordinate))
        return invalidInput("{}: {} must be three numbers, in metres", where, name);
    return glm::vec3((*found)[0].get<float>(), (*found)[1].get<float>(), (*found)[2].get<float>());
}

Result<PathKey> pathKey(const PathJson& json, const std::string& where) {
    if (!json.is_object())
        return invalidInput("{}: must be an object with time, position, target and, if wanted, fovY", where);
    for (const auto& item : json.items())
        if (item.key() != "time" && item.key() != "position" && item.key() != "target" && item.key() != "fovY")
            return invalidInput("{}: {} is not a field of a key; known are time, position, target, fovY", where,
                                item.key());
    PathKey key;
    GLINT_TRY(seconds, pathNumber(json, "time", -kFarthest, kFarthest, where));
    GLINT_TRY(position, pathPoint(json, "position", where));
    GLINT_TRY(target, pathPoint(json, "target", where));
    key.seconds = seconds;
    key.position = position;
    key.target = target;
    if (position == target)
        return invalidInput("{}: target must differ from position", where);
    if (json.contains("fovY")) {
        GLINT_TRY(degrees, pathNumber(json, "fovY", 0.1, 179, where));
        key.fovY = glm::radians(static_cast<float>(degrees));
    }
    return key;
}

/// A value between two keys: a cubic with the slopes of the neighbouring keys (Catmull, Rom 1974, "A Class of Local
/// Interpolating Splines", with times that need not be evenly spaced).
template <class Value>
Value smooth(const std::vector<PathKey>& keys, double seconds, const Value& (*get)(const PathKey&)) {
    const auto after = std::ranges::upper_bound(keys, seconds, {}, &PathKey::seconds);
    if (after == keys.begin())
        return get(keys.front());
    if (after == keys.end())
        return get(keys.back());
    const auto to = static_cast<size_t>(after - keys.begin());
    const size_t from = to - 1;
    const auto slope = [&](size_t a, size_t b) {
        return (get(keys[b]) - get(keys[a])) / static_cast<float>(keys[b].seconds - keys[a].seconds);
    };
    const double duration = keys[to].seconds - keys[from].seconds;
    const Value out = slope(from > 0 ? from - 1 : from, to) * static_cast<float>(duration);
    const Value in = slope(from, std::min(to + 1, keys.size() - 1)) * static_cast<float>(duration);
    const auto t = static_cast<float>((seconds - keys[from].seconds) / duration);
    const float t2 = t * t, t3 = t2 * t;
    return get(keys[from]) * (2 * t3 - 3 * t2 + 1) + out * (t3 - 2 * t2 + t) + get(keys[to]) * (3 * t2 - 2 * t3) +
           in * (t3 - t2);
}

glm::vec3 levelForward(const Camera& camera) {
    const glm::vec3 forward = -glm::vec3(camera.viewToWorld[2]);
    const glm::vec3 level(forward.x, 0, forward.z);
    return glm::length(level) > 1e-3f ? glm::normalize(level) : forward;
}

} // namespace

Result<std::vector<PathKey>> readPathFile(const std::string& path) {
    GLINT_TRY(text, readFile(path, kLongestPathFile));
    PathJson root;
    try {
        root = PathJson::parse(text);
    } catch (const PathJson::exception& exception) { // only exceptions contain the position of the error
        const std::string_view what = exception.what();
        return invalidInput("{}: {}", path, what.substr(std::min(what.size(), what.find("] ") + 2)));
    }
    if (!root.is_object() || root.size() != 1 || !root.contains("keys") || !root["keys"].is_array() ||
        root["keys"].empty())
        return invalidInput("{}: must be {{\"keys\": [...]}} with at least one key", path);
    std::vector<PathKey> keys;
    for (size_t i = 0; i < root["keys"].size(); ++i) {
        const std::string where = fmt::format("{}: keys[{}]", path, i);
        GLINT_TRY(key, pathKey(root["keys"][i], where));
        if (!keys.empty() && key.seconds <= keys.back().seconds)
            return invalidInput("{}: time must be larger than that of the key before", where);
        if (!keys.empty() && key.fovY.has_value() != keys.front().fovY.has_value())
            return invalidInput("{}: either every key has fovY or none", where);
        keys.push_back(key);
    }
    return keys;
}

std::span<const std::string_view> cameraMoves() {
    static constexpr std::array<std::string_view, 5> kNames = {"still", "pan", "dolly", "truck", "orbit"};
    return kNames;
}

CameraPath CameraPath::move(CameraMove move, const Camera& camera, double speed, double focusDistance, double middle) {
    GLINT_ASSERT(focusDistance > 0, "{} m", focusDistance);
    CameraPath path;
    path.camera_ = camera;
    path.move_ = move;
    path.speed_ = speed;
    path.focusDistance_ = focusDistance;
    path.middle_ = middle;
    return path;
}

Result<CameraPath> CameraPath::through(std::vector<PathKey> keys, const Camera& camera) {
    GLINT_ASSERT(!keys.empty(), "no keys");
    if (camera.orthographic && keys.front().fovY)
        return invalidInput("the path has fovY, but camera '{}' is orthographic: leave fovY out", camera.name);
    CameraPath path;
    path.camera_ = camera;
    path.keys_ = std::move(keys);
    return path;
}

Camera CameraPath::at(double seconds) const {
    Camera camera = camera_;
    if (!keys_.empty()) {
        const glm::vec3 position =
            smooth<glm::vec3>(keys_, seconds, [](const PathKey& key) -> const glm::vec3& { return key.position; });
        const glm::vec3 target =
            smooth<glm::vec3>(keys_, seconds, [](const PathKey& key) -> const glm::vec3& { return key.target; });
        camera.viewToWorld = lookAt(position, target);
        if (keys_.front().fovY)
            camera.fovY =
                std::clamp(smooth<float>(keys_, seconds, [](const PathKey& key) -> const float& { return *key.fovY; }),
                           glm::radians(0.1f), glm::radians(179.0f)); // between keys a cubic may overshoot them
        return camera;
    }
    const double metres = speed_ * (seconds - middle_);
    const auto angle = static_cast<float>(metres / focusDistance_);
    const glm::mat4& base = camera_.viewToWorld;
    const glm::vec3 position(base[3]);
    const auto turned = [&](const glm::vec3& pivot, float radians) {
        return glm::translate(glm::mat4(1), pivot) * glm::rotate(glm::mat4(1), radians, glm::vec3(0, 1, 0)) *
               glm::translate(glm::mat4(1), -pivot) * base;
    };
    switch (move_) {
    case CameraMove::Still: break;
    case CameraMove::Pan: camera.viewToWorld = turned(position, -angle); break;
    case CameraMove::Dolly:
        camera.viewToWorld[3] += glm::vec4(levelForward(camera_) * static_cast<float>(metres), 0);
        break;
    case CameraMove::Truck:
        camera.viewToWorld[3] += glm::vec4(glm::vec3(base[0]) * static_cast<float>(metres), 0);
        break;
    case CameraMove::Orbit:
        camera.viewToWorld = turned(position - glm::vec3(base[2]) * static_cast<float>(focusDistance_), angle);
        break;
    }
    return camera;
}

double focusSpeed(const Camera& camera, double focusDistance, uint32_t height, double pixelsPerFrame, double fps) {
    const double imageHeight =
        camera.orthographic ? double(camera.orthoHeight) : 2 * focusDistance * std::tan(double(camera.fovY) / 2);
    return pixelsPerFrame * fps * imageHeight / double(height);
}

double focusDistance(const Camera& camera, const Bounds& bounds) {
    if (bounds.empty())
        return 1;
    const glm::vec3 toCenter = bounds.min + (bounds.max - bounds.min) * 0.5f - glm::vec3(camera.viewToWorld[3]);
    const double along = glm::dot(toCenter, -glm::vec3(camera.viewToWorld[2]));
    const double diagonal = glm::length(bounds.max - bounds.min);
    return std::max({along, diagonal / 20, 1e-3});
}

} // namespace glint::scene
