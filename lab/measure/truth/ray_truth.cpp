#include "lab/measure/truth/ray_truth.hpp"

#include "base/assert.hpp"
#include "lab/measure/truth/pixel_camera.hpp"
#include "lab/scene/for_each_row.hpp"

#include <algorithm>
#include <cmath>

namespace glint::measure {
namespace {

constexpr double kOwnDepth = 0.01; ///< of viewZ

/// Returns the change of viewZ over one pixel at `px`, of the plane through `positionWS`. Returns 0 if the camera sees
/// the plane edge-on within that pixel, as it has no depth there.
double depthSlope(const PixelCamera& camera, const glm::dvec3& positionWS, const glm::dvec3& normalWS,
                  const glm::dvec2& px) {
    const double here = camera.viewZ(positionWS);
    double slope = 0;
    for (const glm::dvec2 step : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
        const PixelRay ray = camera.ray(px + step);
        const double along = glm::dot(normalWS, ray.directionWS);
        if (along >= 0) // the plane is edge-on, or seen from behind
            return 0;
        const double distance = glm::dot(normalWS, positionWS - ray.originWS) / along;
        slope = std::max(slope, std::abs(camera.viewZ(ray.originWS + ray.directionWS * distance) - here));
    }
    return slope;
}

struct Tracer {
    const RayOracle& oracle;
    const PixelCamera camera;
    const GBufferPicture& gbuffer;

    double viewZ(uint32_t x, uint32_t y) const {
        return static_cast<double>(gbuffer.viewZ[4 * (size_t(y) * camera.width() + x)]);
    }

    static MetSurface surfaceOf(const std::optional<OracleHit>& hit) {
        return hit ? MetSurface{static_cast<int>(hit->item), hit->material} : MetSurface{};
    }

    RayTruth trace(uint32_t x, uint32_t y) const {
        RayTruth truth;
        const size_t i = 4 * (size_t(y) * camera.width() + x);
        const double startZ = viewZ(x, y);
        const float f0 = std::max({gbuffer.material[i], gbuffer.material[i + 1], gbuffer.material[i + 2]});
        if (startZ <= 0)
            return truth;
        const PixelRay eye = camera.ray(glm::dvec2(x, y) + 0.5);
        const std::optional<OracleHit> start = oracle.trace(eye.originWS, eye.directionWS, 0);
        truth.shown = surfaceOf(start);
        if (!(f0 > kLeastF0))
            return truth;
        const glm::dvec3 normalWS =
            glm::normalize(glm::dvec3(gbuffer.normalWS[i], gbuffer.normalWS[i + 1], gbuffer.normalWS[i + 2]));
        const glm::dvec3 startWS = camera.position(eye, startZ);
        const glm::dvec3 directionWS = glm::normalize(glm::reflect(eye.directionWS, normalWS));
        const std::optional<OracleHit> hit = oracle.trace(startWS, directionWS, kStartSkip * startZ);
        truth.dips = start && glm::dot(directionWS, start->geometricNormalWS) < 0;
        truth.kind = TruthKind::Nothing;
        if (!hit)
            return truth;
        truth.positionWS = glm::vec3(hit->positionWS);
        truth.distance = static_cast<float>(hit->distance);
        truth.normalWS = glm::vec3(hit->normalWS);
        truth.met = surfaceOf(hit);
        classify(truth, *hit);
        return truth;
    }

    void classify(RayTruth& truth, const OracleHit& hit) const {
        const double z = camera.viewZ(hit.positionWS);
        if (z < camera.nearZ()) {
            truth.kind = TruthKind::BehindCamera;
            return;
        }
        const glm::dvec2 px = camera.project(hit.positionWS);
        truth.px = glm::vec2(px);
        const PixelRay seen = camera.ray(px);
        truth.facesAway = glm::dot(hit.geometricNormalWS, seen.directionWS) >= 0;
        if (px.x < 0 || px.y < 0 || px.x >= camera.width() || px.y >= camera.height()) {
            truth.kind = TruthKind::OffScreen;
            return;
        }
        const double shown = viewZ(static_cast<uint32_t>(px.x), static_cast<uint32_t>(px.y));
        const double allowed = std::max(kOwnDepth * z, depthSlope(camera, hit.positionWS, hit.geometricNormalWS, px));
        truth.kind = shown > 0 && std::abs(shown - z) <= allowed ? TruthKind::Visible : TruthKind::Hidden;
    }
};

} // namespace

std::vector<RayTruth> traceTruth(const RayOracle& oracle, const render::View& view, const GBufferPicture& gbuffer) {
    const size_t pixels = size_t(view.width) * view.height;
    GLINT_ASSERT(gbuffer.viewZ.size() == 4 * pixels && gbuffer.normalWS.size() == 4 * pixels &&
                     gbuffer.material.size() == 4 * pixels,
                 "{} floats of depth for {} pixels", gbuffer.viewZ.size(), pixels);
    const Tracer tracer = {oracle, PixelCamera(view), gbuffer};
    std::vector<RayTruth> truths(pixels);
    scene::forEachRow(view.height, [&](uint32_t y) {
        for (uint32_t x = 0; x < view.width; ++x)
            truths[size_t(y) * view.width + x] = tracer.trace(x, y);
    });
    return truths;
}

} // namespace glint::measure
