#include "reflect/check/known_plane.hpp"

#include "base/format.hpp"
#include "reflect/host_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace glint::reflect {
namespace {

constexpr double kEnough = 0.1;   ///< share of the samples that must show the plane
constexpr float kOff = 0.01f;     ///< of the distance from the camera
constexpr float kCosine = 0.985f; ///< 10 degrees: kAgreeDegrees

struct Plane {
    glm::vec3 pointWS, normalWS;

    float height(const glm::vec3& positionWS) const { return glm::dot(normalWS, positionWS - pointWS); }
};

/// The samples that have the plane's normal.
std::vector<size_t> likePlane(const HostEvidence& evidence, size_t reading, const Plane& plane) {
    std::vector<size_t> alike;
    for (size_t i = 0; i < evidence.samples(); ++i)
        if (evidence.positionVS(reading, i, 0, 0).z < 0 &&
            glm::dot(evidence.normalWS(reading, i), plane.normalWS) > kCosine)
            alike.push_back(i);
    return alike;
}

double shareOnPlane(const HostEvidence& evidence, size_t reading, const Plane& plane) {
    const glm::vec3 eyeWS = evidence.eyeWS(reading);
    uint64_t on = 0;
    for (const size_t sample : likePlane(evidence, reading, plane)) {
        const glm::vec3 positionWS = evidence.positionWS(reading, sample);
        on += std::abs(plane.height(positionWS)) < kOff * glm::length(positionWS - eyeWS);
    }
    return double(on) / double(evidence.samples());
}

/// The factor on all distances with which the samples lie on the plane, and the share of samples that do.
struct Scale {
    float factor = 0;
    double share = 0;
};
Scale bestScale(const HostEvidence& evidence, size_t reading, const Plane& plane) {
    const glm::vec3 eyeWS = evidence.eyeWS(reading);
    std::vector<float> factors;
    for (const size_t sample : likePlane(evidence, reading, plane)) {
        const glm::vec3 toSample = evidence.positionWS(reading, sample) - eyeWS;
        const float factor = -plane.height(eyeWS) / glm::dot(plane.normalWS, toSample);
        if (std::isfinite(factor) && factor > 0)
            factors.push_back(factor);
    }
    if (factors.empty())
        return {};
    const float middle = check::median(factors);
    const auto near = std::ranges::count_if(factors, [&](float f) { return std::abs(f / middle - 1) < kOff; });
    return {middle, double(near) / double(evidence.samples())};
}

std::string wrongScale(const Scale& scale, double declared, const Conventions& conventions) {
    const std::string where = formatText("the known plane lies {:.3g} times as far away as depth says ({} of pixels, "
                                         "{} as declared)",
                                         scale.factor, check::percent(scale.share), check::percent(declared));
    if (conventions.depth == DepthKind::LinearViewZ)
        return formatText("{}: linearDepthScale {:.3g}, not {:.3g} as declared, or other units in View::worldToView",
                          where, scale.factor * conventions.linearDepthScale, conventions.linearDepthScale);
    return where + ": View::viewToClip has another near plane than depth, or View::worldToView other units";
}

} // namespace

check::Finding findPlaneElsewhere(const HostEvidence& evidence, size_t reading, const KnownPlane& stated,
                                  const Conventions& conventions) {
    const Plane plane = {toVec(stated.pointWS), toVec(stated.normalWS)};
    const double declared = shareOnPlane(evidence, 0, plane);
    if (declared >= kEnough)
        return {};
    size_t best = 0;
    double most = declared;
    for (size_t other = 1; other < evidence.readings(); ++other)
        if (const double share = shareOnPlane(evidence, other, plane);
            share > most + 0.01 * (evidence.changes(other) - evidence.changes(best))) {
            best = other;
            most = share;
        }
    if (most >= kEnough)
        return formatText("the known plane agrees with {} ({} of pixels, {} as declared)", evidence.differences(best),
                          check::percent(most), check::percent(declared));
    if (const Scale scale = bestScale(evidence, reading, plane); scale.share >= kEnough)
        return wrongScale(scale, declared, conventions);
    return formatText("only {} of pixels lie on the known plane, and no other declaration puts them there: check "
                      "View::worldToView and the plane, of which a tenth of the pixels must be",
                      check::percent(declared));
}

} // namespace glint::reflect
