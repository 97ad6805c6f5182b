#include "lab/view/ray_lines.hpp"

#include <array>
#include <cmath>

namespace glint::view {
namespace {

glm::vec3 vec(const Float3& v) {
    return {v[0], v[1], v[2]};
}

float depthOf(const render::View& view, const glm::vec3& pointWS) {
    return -(view.worldToView * glm::vec4(pointWS, 1)).z;
}

/// Adds the frustum up to `depth`: its edges and its end rectangle.
void addFrustum(RayLines& lines, const render::View& view, float depth) {
    const glm::vec2 size(view.width, view.height);
    const std::array<glm::vec2, 4> corners = {glm::vec2(0), {size.x, 0}, size, {0, size.y}};
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 end = pointAt(view, corners[i], depth);
        const glm::vec3 start = view.orthographic ? pointAt(view, corners[i], 0) : view.positionWS();
        lines.lines.push_back({RayLine::Kind::Frustum, start, end});
        lines.lines.push_back({RayLine::Kind::Frustum, end, pointAt(view, corners[(i + 1) % 4], depth)});
    }
}

} // namespace

glm::vec3 pointAt(const render::View& view, glm::vec2 px, float depth) {
    const glm::mat4& p = view.viewToClip;
    const glm::vec2 ndc = (px / glm::vec2(view.width, view.height) * 2.0f - 1.0f) * glm::vec2(1, -1);
    const float z = -depth;
    const float w = p[2][3] * z + p[3][3]; // 1 where the projection is orthographic
    const glm::vec3 pointVS((ndc.x * w - p[2][0] * z - p[3][0]) / p[0][0],
                            (ndc.y * w - p[2][1] * z - p[3][1]) / p[1][1], z);
    return glm::vec3(view.viewToWorld * glm::vec4(pointVS, 1));
}

Seen seenFrom(const render::View& view, const glm::vec3& pointWS) {
    const glm::vec4 clip = view.worldToClip * glm::vec4(pointWS, 1);
    const glm::vec2 ndc = glm::vec2(clip) / clip.w;
    return {(ndc * glm::vec2(0.5f, -0.5f) + 0.5f) * glm::vec2(view.width, view.height), depthOf(view, pointWS)};
}

bool clipToNear(const render::View& view, float nearest, glm::vec3& fromWS, glm::vec3& toWS) {
    const float from = depthOf(view, fromWS), to = depthOf(view, toWS);
    if (from < nearest && to < nearest)
        return false;
    const glm::vec3 start = fromWS, step = toWS - fromWS;
    if (from < nearest)
        fromWS = start + step * ((nearest - from) / (to - from));
    else if (to < nearest)
        toWS = start + step * ((nearest - from) / (to - from));
    return true;
}

RayLines rayLines(const RayInspection& ray, const render::View& view) {
    RayLines result;
    const glm::vec2 pixel(static_cast<float>(ray.pixel[0]) + 0.5f, static_cast<float>(ray.pixel[1]) + 0.5f);
    const float reach = ray.background || !std::isfinite(ray.depth) ? 1.0f : ray.depth;
    addFrustum(result, view, reach);
    result.lines.push_back({RayLine::Kind::Sight, view.orthographic ? pointAt(view, pixel, 0) : view.positionWS(),
                            pointAt(view, pixel, reach)});
    if (!ray.traced) {
        result.points.push_back({RayPoint::Kind::Nothing, pointAt(view, pixel, reach), {}});
        return result;
    }
    for (const RaySample& sample : ray.samples) {
        if (!std::isfinite(sample.rayDepth))
            continue;
        const glm::vec2 px(sample.positionPX[0], sample.positionPX[1]);
        const glm::vec3 point = pointAt(view, px, sample.rayDepth);
        if (sample.level == 0 && std::isfinite(sample.sceneDepth)) // a coarse cell's depth belongs to no pixel
            result.lines.push_back({RayLine::Kind::Gap, point, pointAt(view, px, sample.sceneDepth)});
        result.points.push_back({RayPoint::Kind::Sample, point, sample.decision});
    }
    const glm::vec3 start = vec(ray.start.positionWS), end = vec(ray.end.positionWS);
    result.lines.push_back({RayLine::Kind::Ray, start, end});
    result.points.push_back({RayPoint::Kind::Start, start, {}});
    result.points.push_back({ray.answered ? RayPoint::Kind::Answer : RayPoint::Kind::Nothing, end, ray.outcome});
    return result;
}

} // namespace glint::view
