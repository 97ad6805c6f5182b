#include "lab/scene/camera.hpp"

#include "lab/scene/pose.hpp"

#include <nlohmann/json.hpp>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

namespace glint::scene {
namespace {

using Json = nlohmann::json;

/// A camera file in memory. Getters record the first error, as "view.json:3: fovY ...".
class CameraFile {
public:
    CameraFile(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}

    Result<Camera> read() {
        // Exceptions, as only they contain the position of the error.
        try {
            root_ = Json::parse(text_);
        } catch (const Json::exception& exception) {
            const std::string_view what = exception.what();
            return invalidInput("{}: {}", name_, what.substr(std::min(what.size(), what.find("] ") + 2)));
        }
        if (!root_.is_object())
            return invalidInput("{}: must be one JSON object, {{\"position\": ...}}", name_);
        const Camera camera = readCamera();
        if (error_)
            return *error_;
        return camera;
    }

private:
    Camera readCamera() {
        checkKeys();
        Camera camera;
        camera.name = name_;
        const glm::vec3 position = vector("position");
        const glm::vec3 target = vector("target");
        if (!error_ && position == target)
            fail("target", "must differ from position");
        camera.viewToWorld = lookAt(position, target);
        camera.orthographic = root_.contains("orthoHeight");
        if (camera.orthographic == root_.contains("fovY"))
            fail("fovY", "or orthoHeight must be given, and not both");
        else if (camera.orthographic)
            camera.orthoHeight = number("orthoHeight", 1e-6f, 1e6f).value_or(camera.orthoHeight);
        else
            camera.fovY = glm::radians(number("fovY", 0.1f, 179.0f).value_or(45.0f));
        camera.width = static_cast<int>(number("width", 1, 16384).value_or(0.0f));
        camera.height = static_cast<int>(number("height", 1, 16384).value_or(0.0f));
        if (camera.width && camera.height)
            camera.aspectRatio = float(camera.width) / float(camera.height);
        camera.near = number("near", 1e-6f, 1e6f).value_or(camera.near);
        // An orthographic depth range must be finite; the default is 1 km.
        camera.far = number("far", 1e-6f, 1e9f).value_or(camera.orthographic ? 1000.0f : camera.far);
        if (!(camera.far > camera.near))
            fail("far", "must be larger than near");
        return camera;
    }

    void checkKeys() {
        constexpr std::string_view kKeys[] = {"position", "target", "fovY", "orthoHeight",
                                              "width",    "height", "near", "far"};
        for (const auto& item : root_.items())
            if (std::find(std::begin(kKeys), std::end(kKeys), item.key()) == std::end(kKeys))
                fail(item.key(), "is not a key of camera files; known are position, target, fovY, orthoHeight, width, "
                                 "height, near, far");
    }

    glm::vec3 vector(const char* key) {
        glm::vec3 result(0);
        const auto found = root_.find(key);
        bool ok = found != root_.end() && found->is_array() && found->size() == 3;
        for (size_t i = 0; ok && i < 3; ++i) {
            const Json& value = (*found)[i];
            ok = value.is_number() && std::abs(value.get<double>()) <= 1e9;
            if (ok)
                result[int(i)] = value.get<float>();
        }
        if (!ok)
            fail(key, "must be three numbers, in metres");
        return result;
    }

    std::optional<float> number(const char* key, float min, float max) {
        const auto found = root_.find(key);
        if (found == root_.end())
            return std::nullopt;
        const double value = found->is_number() ? found->get<double>() : std::nan("");
        if (!(value >= double(min) && value <= double(max))) {
            fail(key, fmt::format("must be a number between {} and {}", min, max));
            return std::nullopt;
        }
        return static_cast<float>(value);
    }

    void fail(const std::string& key, std::string_view what) {
        if (error_)
            return;
        const size_t at = text_.find('"' + key + '"'); // absent keys have no line
        const std::string line =
            at == std::string::npos ? ""
                                    : fmt::format("{}:", 1 + std::count(text_.begin(), text_.begin() + long(at), '\n'));
        error_ = invalidInput("{}:{} {} {}", name_, line, key, what);
    }

    std::string name_;
    std::string text_;
    Json root_;
    std::optional<Error> error_;
};

} // namespace

Result<Camera> readCameraFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return makeError(ErrorCode::NotFound, "{}: no such file, or it may not be read", path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (file.bad() || text.empty())
        return invalidInput("{}: is empty or not a file", path);
    return CameraFile(path, text).read();
}

glm::mat4 lookAt(const glm::vec3& position, const glm::vec3& target) {
    const glm::vec3 difference = position - target;
    const float length = glm::length(difference);
    const glm::vec3 backward = length > 0 ? difference / length : glm::vec3(0, 0, 1);
    // For a vertical view, -Z is up.
    const bool vertical = std::abs(backward.y) > 0.99999f;
    const glm::vec3 right = glm::normalize(glm::cross(vertical ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0), backward));
    const glm::vec3 up = glm::cross(backward, right);
    return {glm::vec4(right, 0), glm::vec4(up, 0), glm::vec4(backward, 0), glm::vec4(position, 1)};
}

Camera frameBounds(const Bounds& bounds, float aspectRatio) {
    Bounds box = bounds;
    if (box.empty())
        box = {glm::vec3(-0.5f), glm::vec3(0.5f)};
    constexpr float kAzimuth = glm::radians(30.0f);   // to the right of glTF's front, +Z
    constexpr float kElevation = glm::radians(18.0f); // looks slightly down
    constexpr float kMargin = 1.05f;
    const glm::vec3 center = box.min + (box.max - box.min) * 0.5f;
    const glm::vec3 backward(std::sin(kAzimuth) * std::cos(kElevation), std::sin(kElevation),
                             std::cos(kAzimuth) * std::cos(kElevation));

    Camera camera;
    camera.name = "framed";
    camera.fovY = glm::radians(40.0f);
    camera.aspectRatio = aspectRatio;
    const glm::mat3 axes(lookAt(backward, glm::vec3(0)));
    const float tanY = std::tan(camera.fovY / 2) / kMargin;
    const float tanX = tanY * aspectRatio;
    // A corner (x, y, z), in the camera's axes from the centre, is visible if |x| <= tanX * (distance - z).
    float distance = 0;
    float radius = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                              corner & 4 ? box.max.z : box.min.z);
        const glm::vec3 offset = (point - center) * axes;
        distance = std::max({distance, std::abs(offset.x) / tanX + offset.z, std::abs(offset.y) / tanY + offset.z});
        radius = std::max(radius, glm::length(offset));
    }
    if (radius <= 0) { // a single point
        radius = 1e-3f;
        distance = 3 * radius;
    }
    camera.viewToWorld = lookAt(center + backward * distance, center);
    // Leaves room to move closer and keeps depth precision.
    camera.near = std::max((distance - radius) * 0.5f, radius * 1e-3f);
    return camera;
}

} // namespace glint::scene
