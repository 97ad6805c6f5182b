// Compares the tracer's hits with exact rays: precision, recall, position error, cost, and the causes of wrong rays
// (docs/truth.md).
#pragma once

#include "lab/measure/truth/ray_truth.hpp"
#include "shared/answer_kinds.h"
#include "shared/outcome.h"

#include <array>

namespace glint::measure {

/// The result of one pixel's ray.
enum class HitClass : uint8_t {
    NoRay,       ///< background, or a surface that does not reflect
    Right,       ///< hit, at the true position
    WrongPlace,  ///< hit, but the true hit is visible elsewhere
    FalseHit,    ///< hit, though the true hit is not visible
    Missed,      ///< no hit, though the true hit is visible
    RightlyNone, ///< no hit, and the true hit is not visible
};
constexpr size_t kHitClasses = 6;

/// Upper bounds in pixels of the bands that HitFigures::wrongPlaceByDistance counts; the last band is unbounded.
constexpr std::array kDistanceBandsPX = {4.0f, 8.0f, 16.0f, 64.0f};

/// Answers, and how many of them are right.
struct AnswerShare {
    uint64_t answers = 0;
    uint64_t right = 0;
    double stated = 0; ///< sum of the weights that they state

    double share() const { return answers ? static_cast<double>(right) / static_cast<double>(answers) : 0; }
    void add(const AnswerShare& other) {
        answers += other.answers;
        right += other.right;
        stated += other.stated;
    }
    double meanStated() const { return answers ? stated / static_cast<double>(answers) : 0; }
};
constexpr size_t kStatedBins = 10; ///< of stated weight, equally wide

/// Figures over a subset of the pixels.
struct HitFigures {
    uint64_t rays = 0; ///< reflective pixels
    uint64_t visibleTruths = 0;
    uint64_t facingAway = 0; ///< of visibleTruths: the depth agrees, but the camera sees the other side of the surface
    uint64_t reported = 0;   ///< rays with outcome hit, whatever their weight
    uint64_t right = 0;      ///< of reported
    double positionErrorMedian = 0; ///< pixels, over right hits
    double positionError95 = 0;     ///< 95th percentile
    double lookupsMean = 0;         ///< depth fetches per traced ray
    uint32_t lookups95 = 0;
    uint64_t dipping = 0;      ///< rays that interpolated shading normals send below their own triangle
    uint64_t dippingWrong = 0; ///< of dipping: hits that are not right
    std::array<uint64_t, shared::kOutcomeCount> outcomes = {};
    std::array<uint64_t, shared::kOutcomeCount> missedByOutcome = {}; ///< visible true hits without a right hit
    std::array<uint64_t, kTruthKinds> wrongByTruth = {}; ///< hits that are not right; Visible: in the wrong place
    std::array<uint64_t, kDistanceBandsPX.size() + 1> wrongPlaceByDistance = {};
    std::array<AnswerShare, kStatedBins> stated = {};          ///< answers of any outcome, by stated weight
    std::array<AnswerShare, shared::kAnswerKinds> byKind = {}; ///< the same, by what the march knows of them

    double precision() const { return reported ? double(right) / double(reported) : 1; }
    double recall() const { return visibleTruths ? double(right) / double(visibleTruths) : 1; }
};

/// Upper bounds of perceptual roughness: mirror, glossy; rough above.
enum class RoughnessBand : uint8_t { Mirror, Glossy, Rough };
constexpr std::array kRoughnessBands = {0.1f, 0.4f};

struct HitReport {
    HitFigures all;
    std::array<HitFigures, kRoughnessBands.size() + 1> bands; ///< by RoughnessBand
    std::vector<HitClass> classes;                            ///< one per pixel
};

/// A reported hit is right if the true hit is visible and lies within 2 pixels of the reported one, or if the surface
/// at the reported pixel is within 1 % of the ray's length of the true hit in space.
/// An answer of any outcome is right if the picture shows at its pixel the surface that the exact ray meets; a hit also
/// has to be right, and a guess (side, backFace, inferred) lie within a tenth of the ray's length of the true hit, or
/// on a part of the surface that faces the same way.
///
/// `truths`     traceTruth of the same view and G-buffer
/// `rays`       view "ray" of the tracer: hitUV, outcome, lookups; four floats per pixel
/// `certainty`  view "color" of the same frame with debug.certainty; empty: no figures of stated weights
HitReport judgeHits(const render::View& view, const GBufferPicture& gbuffer, std::span<const RayTruth> truths,
                    std::span<const float> rays, std::span<const float> certainty = {});

/// Returns display colours as RGB bytes: green right, orange wrong place, red false hit, blue missed, grey rightly
/// none, black no ray.
std::vector<uint8_t> classColors(std::span<const HitClass> classes);

} // namespace glint::measure
