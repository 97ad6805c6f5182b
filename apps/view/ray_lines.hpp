// The asked ray in the world, as lines and points that any camera can look at. No window, no device.
#pragma once

#include "glint/inspection.hpp"
#include "render/view.hpp"

#include <glm/glm.hpp>

#include <string_view>
#include <vector>

namespace glint::view {

struct RayLine {
    enum class Kind {
        Ray,     ///< from start to end
        Sight,   ///< from the asking camera to the pixel's surface
        Gap,     ///< from a sample to the surface that the picture shows there
        Frustum, ///< of the asking camera
    };
    Kind kind = Kind::Ray;
    glm::vec3 fromWS = glm::vec3(0);
    glm::vec3 toWS = glm::vec3(0);
};

struct RayPoint {
    enum class Kind { Start, Sample, Answer, Nothing };
    Kind kind = Kind::Sample;
    glm::vec3 positionWS = glm::vec3(0);
    std::string_view decision; ///< of a sample; of an answer the outcome
};

struct RayLines {
    std::vector<RayLine> lines;
    std::vector<RayPoint> points;
};

/// `view`  that the ray was asked in
RayLines rayLines(const RayInspection& ray, const render::View& view);

/// A point of a picture (pixels from the top left) so many metres along the view axis.
glm::vec3 pointAt(const render::View& view, glm::vec2 px, float depth);

/// A point as a camera sees it: pixels from the top left, and metres along the view axis. Behind the camera the pixels
/// mean nothing.
struct Seen {
    glm::vec2 px = glm::vec2(0);
    float depth = 0;
};
Seen seenFrom(const render::View& view, const glm::vec3& pointWS);

/// Takes off what lies nearer than `nearest` metres along the view axis. False: nothing is left.
bool clipToNear(const render::View& view, float nearest, glm::vec3& fromWS, glm::vec3& toWS);

} // namespace glint::view
