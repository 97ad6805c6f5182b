#include "lab/measure/motion/surface_motion.hpp"

#include "lab/measure/truth/pixel_camera.hpp"
#include "lab/scene/for_each_row.hpp"

#include <cmath>
#include <limits>

namespace glint::measure {
namespace {

constexpr double kSameDistance = 1e-3; ///< relative: a hit so near to the expected point is that point

/// The point of an item's surface that a hit describes, as the item was in `pose`.
glm::dvec3 positionIn(const scene::Pose& pose, int item, const OracleHit& hit) {
    const scene::DrawItem& drawn = pose.items[static_cast<size_t>(item)];
    const auto corner = [&](size_t k) {
        return glm::dvec3(drawn.geometry->positions[drawn.geometry->indices[hit.firstIndex + k]]);
    };
    const glm::dvec3 positionLS = corner(0) * (1 - hit.barycentric.x - hit.barycentric.y) +
                                  corner(1) * hit.barycentric.x + corner(2) * hit.barycentric.y;
    return glm::dvec3(glm::dmat4(drawn.localToWorld) * glm::dvec4(positionLS, 1));
}

bool sameView(const render::View& a, const render::View& b) {
    return a.width == b.width && a.height == b.height && a.worldToClip == b.worldToClip;
}

bool samePose(const scene::Pose& a, const scene::Pose& b) {
    if (!a.deformed.empty() || !b.deformed.empty() || a.items.size() != b.items.size())
        return false;
    for (size_t i = 0; i < a.items.size(); ++i)
        if (a.items[i].localToWorld != b.items[i].localToWorld)
            return false;
    return true;
}

} // namespace

Result<std::unique_ptr<SurfaceTracker::Moment>> SurfaceTracker::look(double seconds, const render::View& view) const {
    auto moment = std::make_unique<Moment>();
    moment->seconds = seconds;
    moment->view = view;
    GLINT_TRY(pose, scene::pose(*scene_, seconds));
    moment->pose = std::move(pose);
    GLINT_TRY(oracle, RayOracle::create(*scene_, moment->pose));
    moment->oracle = std::make_unique<RayOracle>(std::move(oracle));
    const PixelCamera camera(view);
    moment->items.assign(size_t(view.width) * view.height, -1);
    moment->hits.resize(moment->items.size());
    scene::forEachRow(view.height, [&](uint32_t y) {
        for (uint32_t x = 0; x < view.width; ++x) {
            const PixelRay ray = camera.ray(glm::dvec2(x, y) + 0.5);
            const size_t p = size_t(y) * view.width + x;
            if (const auto hit = moment->oracle->trace(ray.originWS, ray.directionWS, 0)) {
                moment->hits[p] = *hit;
                moment->items[p] = static_cast<int>(hit->item);
            }
        }
    });
    return moment;
}

PixelOrigin SurfaceTracker::originOf(const OracleHit& hit, int item) const {
    constexpr PixelOrigin kNothing = {0, SurfaceOrigin::None};
    const glm::dvec3 positionWS = positionIn(prev_->pose, item, hit);
    const PixelCamera camera(prev_->view);
    if (camera.viewZ(positionWS) <= camera.nearZ())
        return {0, SurfaceOrigin::Outside};
    const glm::dvec2 px = camera.project(positionWS);
    const uint32_t width = prev_->view.width, height = prev_->view.height;
    if (!(px.x >= 0 && px.y >= 0 && px.x < width && px.y < height))
        return {0, SurfaceOrigin::Outside};
    const auto pixel = static_cast<uint32_t>(px.y) * width + static_cast<uint32_t>(px.x);
    const PixelRay ray = camera.ray(px);
    const double distance = glm::dot(positionWS - ray.originWS, ray.directionWS);
    const auto seen = prev_->oracle->trace(ray.originWS, ray.directionWS, 0);
    if (!seen)
        return kNothing;
    if (seen->distance < distance * (1 - kSameDistance))
        return {pixel, SurfaceOrigin::Hidden};
    // The pixel whose centre is nearest may show another surface, at an edge: then one of those around it.
    double nearest = std::numeric_limits<double>::infinity();
    PixelOrigin origin = kNothing;
    const glm::ivec2 first(px - 0.5);
    const glm::ivec2 last(px + 0.5);
    for (int v = first.y; v <= last.y; ++v)
        for (int u = first.x; u <= last.x; ++u) {
            if (u < 0 || v < 0 || u >= int(width) || v >= int(height))
                continue;
            const uint32_t candidate = uint32_t(v) * width + uint32_t(u);
            const double away = glm::distance(px, glm::dvec2(u + 0.5, v + 0.5));
            if (prev_->items[candidate] != item || away >= nearest)
                continue;
            nearest = away;
            origin = {candidate, SurfaceOrigin::Seen};
        }
    return origin;
}

Result<SurfaceMotion> SurfaceTracker::advance(double seconds, const render::View& view) {
    if (prev_ && sameView(prev_->view, view)) {
        if (prev_->seconds == seconds)
            return SurfaceMotion();
        GLINT_TRY(pose, scene::pose(*scene_, seconds));
        if (samePose(prev_->pose, pose))
            return SurfaceMotion();
    }
    GLINT_TRY(now, look(seconds, view));
    SurfaceMotion motion;
    if (prev_ && prev_->pose.items.size() == now->pose.items.size()) {
        motion.resize(now->items.size());
        scene::forEachRow(view.height, [&](uint32_t y) {
            for (size_t p = size_t(y) * view.width; p < size_t(y + 1) * view.width; ++p)
                motion[p] =
                    now->items[p] < 0 ? PixelOrigin{0, SurfaceOrigin::None} : originOf(now->hits[p], now->items[p]);
        });
    }
    prev_ = std::move(now);
    return motion;
}

} // namespace glint::measure
