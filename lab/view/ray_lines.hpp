// The inspected ray in world space, as lines and points for any camera. Needs no window and no device.
#pragma once

#include "glint/inspection.hpp"
#include "lab/renderer/view.hpp"

#include <glm/glm.hpp>

#include <string_view>
#include <vector>

namespace glint::view {

struct RayLine {
    enum class Kind {
        Ray,     ///< from start to end
        Sight,   ///< from the inspecting camera to the pixel's surface
        Gap,     ///< from a sample to the visible surface at its pixel
        Frustum, ///< of the inspecting camera
    };
    Kind kind = Kind::Ray;
    glm::vec3 fromWS = glm::vec3(0);
    glm::vec3 toWS = glm::vec3(0);
};

struct RayPoint {
    enum class Kind { Start, Sample, Answer, Nothing };
    Kind kind = Kind::Sample;
    glm::vec3 positionWS = glm::vec3(0);
    std::string_view decision; ///< of a sample; for a hit, the outcome
};

struct RayLines {
    std::vector<RayLine> lines;
    std::vector<RayPoint> points;
};

/// `view`  that the ray was traced in
RayLines rayLines(const RayInspection& ray, const render::View& view);

/// Returns the world position of an image point (pixels from the top left) at `depth` metres along the view axis.
glm::vec3 pointAt(const render::View& view, glm::vec2 px, float depth);

/// A point as a camera sees it: pixels from the top left, and metres along the view axis. The pixels are undefined
/// behind the camera.
struct Seen {
    glm::vec2 px = glm::vec2(0);
    float depth = 0;
};
Seen seenFrom(const render::View& view, const glm::vec3& pointWS);

/// Clips the part nearer than `nearest` metres along the view axis. Returns false if nothing remains.
bool clipToNear(const render::View& view, float nearest, glm::vec3& fromWS, glm::vec3& toWS);

} // namespace glint::view
