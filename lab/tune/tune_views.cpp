#include "lab/tune/tune_views.hpp"

#include "lab/scene/pose.hpp"
#include "lab/session/settled_frames.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace glint::tune {
namespace {

/// A place of the camera beside its own: it walks around what it looks at and steps nearer.
struct Displacement {
    float degrees = 0; ///< around the focus, to the right
    float nearer = 0;  ///< fraction of the distance to the focus
};

/// Small enough to stay inside a room, large enough to change every reflection by many pixels.
constexpr std::array<Displacement, 2> kHeldBack = {{{8, 0}, {-5, 0.06f}}};

scene::Camera displaced(const scene::Camera& camera, double focusDistance, const Displacement& by) {
    const glm::vec3 position(camera.viewToWorld[3]);
    const glm::vec3 forward = -glm::vec3(camera.viewToWorld[2]);
    const glm::vec3 focus = position + forward * static_cast<float>(focusDistance);
    const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(by.degrees), glm::vec3(0, 1, 0));
    scene::Camera moved = camera;
    moved.viewToWorld =
        glm::translate(glm::mat4(1), focus) * turn * glm::translate(glm::mat4(1), -focus) * camera.viewToWorld;
    moved.viewToWorld[3] -= moved.viewToWorld[2] * (by.nearer * static_cast<float>(focusDistance));
    return moved;
}

} // namespace

std::vector<TuneView> makeViews(ViewSet set, const render::RenderJob& job, const scene::Camera& camera,
                                const scene::Bounds& bounds, uint32_t height,
                                const std::vector<scene::CameraMove>& paths) {
    constexpr double kPixelsPerFrame = 2; // a walk: the default of glint sequence
    const double focus = scene::focusDistance(camera, bounds);
    const double speed = scene::focusSpeed(camera, focus, height, kPixelsPerFrame, render::kFramesPerSecond);
    const double middle = kMovingFrames / render::kFramesPerSecond / 2;
    std::vector<TuneView> views;
    const auto add = [&](const scene::Camera& from, const std::string& suffix, uint32_t seed) {
        for (const scene::CameraMove move : paths) {
            TuneView view;
            view.name = job.scene + (job.camera.empty() ? "" : " " + job.camera) + suffix;
            if (move != scene::CameraMove::Still)
                view.name += fmt::format(" {}", scene::cameraMoves()[static_cast<size_t>(move)]);
            view.move = move;
            view.path = scene::CameraPath::move(move, from, speed, focus, middle);
            view.seed = seed;
            views.push_back(std::move(view));
        }
    };
    if (set == ViewSet::Search) {
        add(camera, "", job.seed);
        return views;
    }
    for (size_t i = 0; i < kHeldBack.size(); ++i)
        add(displaced(camera, focus, kHeldBack[i]), fmt::format(" held {}", i + 1),
            job.seed + 1 + static_cast<uint32_t>(i));
    return views;
}

} // namespace glint::tune
