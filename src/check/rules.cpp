#include "check/rules.hpp"

#include "base/format.hpp"
#include "check/normal_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace glint::check {
namespace {

/// The smaller of the two steps to neighbouring pixels, which stays on the surface at its edges. 0: none.
glm::vec3 step(const glm::vec3& before, const glm::vec3& here, const glm::vec3& after) {
    const bool hasBefore = before.z < 0, hasAfter = after.z < 0;
    if (hasBefore && (!hasAfter || std::abs(here.z - before.z) < std::abs(after.z - here.z)))
        return here - before;
    return hasAfter ? after - here : glm::vec3(0);
}

/// Normal of the depth image, view space, toward the camera. Returns 0 where there is none.
glm::vec3 depthNormalVS(const Evidence& evidence, size_t reading, size_t sample) {
    const auto at = [&](int dx, int dy) { return evidence.positionVS(reading, sample, dx, dy); };
    const glm::vec3 here = at(0, 0);
    if (here.z >= 0)
        return glm::vec3(0);
    const glm::vec3 right = step(at(-1, 0), here, at(1, 0));
    const glm::vec3 down = step(at(0, -1), here, at(0, 1));
    const glm::vec3 normal = glm::cross(right, down);
    const float length = glm::length(normal);
    if (!(length > 0) || !std::isfinite(length))
        return glm::vec3(0);
    return glm::dot(normal, here) > 0 ? -normal / length : normal / length;
}

std::vector<glm::vec3> depthNormalsVS(const Evidence& evidence, size_t reading) {
    std::vector<glm::vec3> normals;
    for (size_t sample = 0; sample < evidence.samples(); ++sample)
        normals.push_back(depthNormalVS(evidence, reading, sample));
    return normals;
}

std::vector<glm::vec3> givenNormalsWS(const Evidence& evidence, size_t reading) {
    std::vector<glm::vec3> normals;
    for (size_t sample = 0; sample < evidence.samples(); ++sample)
        normals.push_back(evidence.normalWS(reading, sample));
    return normals;
}

constexpr double kClearly = 0.05; ///< scores that differ by less are equal

/// How well the normals of one reading agree with its depth.
struct Hypothesis {
    size_t reading = 0;
    double score = 0;
    double agree = 0; ///< share of samples
    float middleDegrees = 0;
};

/// Prefers what is declared among equals.
Hypothesis judge(const Evidence& evidence, size_t reading, const std::vector<glm::vec3>& depthNormals) {
    constexpr double kCostOfChange = 0.01;
    const Agreement found = agreement(evidence.worldToView(reading), givenNormalsWS(evidence, reading), depthNormals);
    return {reading, found.score - kCostOfChange * evidence.changes(reading), found.share, found.middleDegrees};
}

/// `declared`: of reading 0. Readings that share positions share the normals of their depth.
Hypothesis bestReading(const Evidence& evidence, const Hypothesis& declared) {
    Hypothesis best = declared;
    std::vector<glm::vec3> depthNormals;
    for (size_t reading = 0; reading < evidence.readings(); ++reading) {
        if (reading == 0 || !evidence.samePositions(reading, reading - 1))
            depthNormals = depthNormalsVS(evidence, reading);
        const Hypothesis one = judge(evidence, reading, depthNormals);
        if (one.score > best.score)
            best = one;
    }
    return best;
}

/// The camera rotation with which world normals agree best, as an angle to the camera's.
struct Turn {
    float degrees = 0;
    Agreement fit;
};
Turn bestTurn(const Evidence& evidence) {
    if (!evidence.seesTurnOfCamera())
        return {};
    const RotationFit fit = fitRotation(givenNormalsWS(evidence, 0), depthNormalsVS(evidence, 0));
    const glm::mat3 turn = fit.rotation * glm::transpose(evidence.worldToView(0));
    const float cosine = (turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2;
    return {glm::degrees(std::acos(glm::clamp(cosine, -1.0f, 1.0f))), fit.agreement};
}

constexpr double kGood = 0.3; ///< share of pixels from which a meaning explains the image

/// What contradicts the declarations. Without a reading that explains the image better, the declared one stays: what
/// the other rules find under a reading that nothing speaks for would be a second, wrong finding.
Comparison explain(const Evidence& evidence, const Hypothesis& declared, const Hypothesis& best,
                   const std::function<OtherCamera()>& bestCamera) {
    const auto with = [&](size_t reading, Finding finding) {
        return Comparison{declared.agree, reading, std::move(finding)};
    };
    const Turn turn = bestTurn(evidence);
    const OtherCamera camera = bestCamera ? bestCamera() : OtherCamera();
    if (camera.fit.share >= kGood && camera.fit.score > best.score + kClearly && camera.fit.score > turn.fit.score)
        return with(0, formatText("depth and normals agree with {} (half of the pixels within {:.1f} degrees, {:.1f} "
                                  "as declared): {}",
                                  camera.name, camera.fit.middleDegrees, declared.middleDegrees,
                                  evidence.advice().otherCamera));
    if (turn.fit.share >= kGood && turn.degrees > kAgreeDegrees && turn.fit.score > best.score + kClearly)
        return with(0, formatText("depth and normals agree with a camera that is turned by {:.0f} degrees ({} of "
                                  "pixels, {} as declared): {}",
                                  turn.degrees, percent(turn.fit.share), percent(declared.agree),
                                  evidence.advice().turnedCamera));
    if (best.reading != 0 && best.agree >= kGood && best.score > declared.score + kClearly)
        return with(best.reading,
                    formatText("depth and normals agree with {} ({} of pixels, {} as declared)",
                               evidence.differences(best.reading), percent(best.agree), percent(declared.agree)));
    if (declared.agree < kGood)
        return with(0, formatText("the normals of only {} of pixels agree with depth and camera, and no other meaning "
                                  "agrees better: {}",
                                  percent(declared.agree), evidence.advice().nothingAgrees));
    return with(0, {});
}

/// The share of surfaces that stand still if stored motion has this unit.
double shareStill(std::span<const Motion> motions, const glm::vec2& size, const MotionUnit& unit) {
    constexpr float kOffPX = 0.5f, kOff = 0.05f;
    const glm::vec2 toPixels = unit.scale * (unit.pixels ? glm::vec2(1) : size);
    const auto still = std::ranges::count_if(motions, [&](const Motion& motion) {
        return glm::length(motion.stored * toPixels - motion.still) < kOffPX + kOff * glm::length(motion.still);
    });
    return double(still) / double(motions.size());
}

double shareStill(std::span<const DepthMotion> motions, float scale) {
    constexpr float kOffDepth = 0.0005f, kOff = 0.05f;
    const auto still = std::ranges::count_if(motions, [&](const DepthMotion& motion) {
        return std::abs(motion.stored * scale - motion.still) < kOffDepth + kOff * std::abs(motion.still);
    });
    return double(still) / double(motions.size());
}

constexpr double kGoodMotion = 0.3;     ///< share of pixels that stand still
constexpr double kMuchMoreMotion = 0.1; ///< than as declared

} // namespace

std::string percent(double share) {
    return formatText("{:.0f} %", 100 * share);
}

float median(std::span<float> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Agreement agreementAsDeclared(const Evidence& evidence) {
    return agreement(evidence.worldToView(0), givenNormalsWS(evidence, 0), depthNormalsVS(evidence, 0));
}

Comparison compareNormals(const Evidence& evidence, const std::function<OtherCamera()>& bestCamera) {
    const Hypothesis declared = judge(evidence, 0, depthNormalsVS(evidence, 0));
    if (declared.score + kClearly >= 1) // nothing can be clearly better
        return {declared.agree, 0, {}};
    return explain(evidence, declared, bestReading(evidence, declared), bestCamera);
}

Finding findOddLengths(const Evidence& evidence, size_t reading) {
    constexpr float kTolerance = 0.05f;
    constexpr double kMany = 0.25;
    uint64_t odd = 0;
    for (size_t sample = 0; sample < evidence.samples(); ++sample)
        odd += !(std::abs(evidence.normalLength(reading, sample) - 1) < kTolerance);
    const double share = double(odd) / double(evidence.samples());
    if (!(share > kMany))
        return {};
    return formatText("the normals of {} of pixels do not have unit length: {}", percent(share),
                      evidence.advice().unitLength);
}

Finding findAverted(const Evidence& evidence, size_t reading) {
    constexpr float kAway = -0.2f; // cosine: interpolated and mapped normals lean away a little at silhouettes
    constexpr double kMany = 0.05;
    const glm::mat3 toView = evidence.worldToView(reading);
    uint64_t away = 0;
    for (size_t sample = 0; sample < evidence.samples(); ++sample)
        if (const glm::vec3 here = evidence.positionVS(reading, sample, 0, 0); here.z < 0)
            away += glm::dot(toView * evidence.normalWS(reading, sample), evidence.toCameraVS(reading, here)) < kAway;
    const double share = double(away) / double(evidence.samples());
    if (!(share > kMany))
        return {};
    return formatText("the normals of {} of pixels point away from the camera: {}", percent(share),
                      evidence.advice().facing);
}

Finding findOutOfRange(const Evidence& evidence, size_t reading) {
    std::vector<float> depths;
    for (size_t sample = 0; sample < evidence.samples(); ++sample)
        if (const glm::vec3 here = evidence.positionVS(reading, sample, 0, 0); here.z < 0)
            depths.push_back(-here.z);
    if (depths.empty())
        return {};
    const float middle = median(depths);
    const glm::vec2 planes = evidence.planes(reading);
    if (!(middle < planes.x || middle > planes.y))
        return {};
    return formatText("half of the surfaces lie {} than {:.3g} m, outside the near and far planes of the camera "
                      "({:.3g} and {:.3g} m): {}",
                      middle < planes.x ? "nearer" : "farther", middle, planes.x, planes.y, evidence.advice().range);
}

Finding findRoughnessOutside(std::span<const float> roughness) {
    constexpr double kSome = 0.01;
    const auto outside =
        std::ranges::count_if(roughness, [](float value) { return !(value >= -0.001f && value <= 1.001f); });
    const double share = double(outside) / double(std::max<size_t>(roughness.size(), 1));
    if (!(share > kSome))
        return {};
    return formatText("the roughness of {} of pixels is not from 0 to 1", percent(share));
}

MotionCheck compareMotion(std::span<const Motion> motions, const glm::vec2& size, const MotionUnit& declared,
                          const std::function<std::string(const MotionUnit&)>& nameOf) {
    constexpr float kMovesPX = 2;
    const auto moved =
        std::ranges::count_if(motions, [](const Motion& motion) { return glm::length(motion.still) > kMovesPX; });
    if (motions.size() < kFewestSamples || moved < std::ssize(motions) / 2)
        return {};
    const double asDeclared = shareStill(motions, size, declared);
    double most = 0;
    MotionUnit best = {};
    for (const bool pixels : {false, true})
        for (const float factor : {1.0f, 0.5f}) // halves: clip space
            for (const glm::vec2 sign : {glm::vec2(1, 1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(-1, -1)}) {
                const MotionUnit unit = {factor * sign, pixels};
                if (const double share = shareStill(motions, size, unit); share > most) {
                    most = share;
                    best = unit;
                }
            }
    if (asDeclared >= kGoodMotion && most < asDeclared + kMuchMoreMotion)
        return {true, {}};
    if (most < kGoodMotion)
        return {true, formatText("the motion of only {} of pixels agrees with the cameras: everything moves, or "
                                 "motion is not that to the previous frame",
                                 percent(asDeclared))};
    return {true, formatText("motion agrees with the cameras as {}, not {} as declared ({} of pixels, {} as declared)",
                             nameOf(best), nameOf(declared), percent(most), percent(asDeclared))};
}

MotionCheck compareDepthMotion(std::span<const DepthMotion> motions, float declared) {
    constexpr float kMovesDepth = 0.004f;
    const auto moved =
        std::ranges::count_if(motions, [](const DepthMotion& motion) { return std::abs(motion.still) > kMovesDepth; });
    if (motions.size() < kFewestSamples || moved < std::ssize(motions) / 2)
        return {};
    const double asDeclared = shareStill(motions, declared);
    double most = 0;
    float best = 0;
    for (const float size : {1.0f, std::abs(declared), 0.01f, 0.001f}) // metres, centimetres, millimetres
        for (const float scale : {size, -size})
            if (const double share = shareStill(motions, scale); share > most) {
                most = share;
                best = scale;
            }
    if (asDeclared >= kGoodMotion && most < asDeclared + kMuchMoreMotion)
        return {true, {}};
    if (most < kGoodMotion)
        return {true, formatText("motion's third channel agrees with the cameras in only {} of pixels: everything "
                                 "moves, or it is not previous - current viewZ; state motionDepthScale 0 then",
                                 percent(asDeclared))};
    return {true, formatText("motion agrees with the cameras as motionDepthScale {}, not {} as declared ({} of "
                             "pixels, {} as declared)",
                             best, declared, percent(most), percent(asDeclared))};
}

} // namespace glint::check
