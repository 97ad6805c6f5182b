// Cameras over time: movements around a camera, and paths read from files.
#pragma once

#include "lab/scene/camera.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::scene {

/// A key of a path file.
struct PathKey {
    double seconds = 0;
    glm::vec3 position = glm::vec3(0); ///< metres
    glm::vec3 target = glm::vec3(0);   ///< metres
    std::optional<float> fovY;         ///< radians; none: the lens of the camera that the path is for
};

/// Reads {"keys": [{"time", "position", "target", "fovY"}, ...]}: seconds, strictly increasing; metres; degrees, which
/// either every key has or none. Errors name the file, the key and the field.
Result<std::vector<PathKey>> readPathFile(const std::string& path);

enum class CameraMove {
    Still,
    Pan,   ///< turns to the right about +Y
    Dolly, ///< forward, level
    Truck, ///< to the right
    Orbit, ///< to the right around the focus, which stays in the centre
};

/// The names of CameraMove, in its order: "still", "pan", ...
std::span<const std::string_view> cameraMoves();

class CameraPath {
public:
    /// `speed`         metres per second; Pan and Orbit: of the point at the focus and of the camera
    /// `focusDistance` metres along the view axis, > 0
    /// `middle`        seconds after which the camera is at `camera`: the movement passes through it
    static CameraPath move(CameraMove move, const Camera& camera, double speed, double focusDistance, double middle);
    /// A path through keys. Position, target and angle are smooth in time and constant before the first and after the
    /// last key. `keys` is not empty. Errors: InvalidInput if keys have an angle and `camera` is orthographic.
    static Result<CameraPath> through(std::vector<PathKey> keys, const Camera& camera);

    Camera at(double seconds) const;

private:
    Camera camera_;
    CameraMove move_ = CameraMove::Still;
    double speed_ = 0;
    double focusDistance_ = 1;
    double middle_ = 0;
    std::vector<PathKey> keys_; ///< not empty: the path follows them
};

/// Returns the speed in metres per second at which a point at `focusDistance` moves by `pixelsPerFrame` in the image of
/// a camera that moves sideways.
double focusSpeed(const Camera& camera, double focusDistance, uint32_t height, double pixelsPerFrame, double fps);

/// Returns the distance along the view axis to the centre of `bounds`, at least a twentieth of their diagonal; 1 for
/// empty bounds.
double focusDistance(const Camera& camera, const Bounds& bounds);

} // namespace glint::scene
