// How well the tracer's hits agree with the exact rays': precision, recall, position error, cost, and why rays went
// wrong (docs/truth.md).
#pragma once

#include "measure/ray_truth.hpp"
#include "shared/outcome.h"

#include <array>

namespace glint::measure {

/// What became of one pixel's ray.
enum class HitClass : uint8_t {
    NoRay,       ///< background, or nothing that reflects
    Right,       ///< hit, where the truth is
    WrongPlace,  ///< hit, but the truth is visible elsewhere
    FalseHit,    ///< hit, though the truth is not visible
    Missed,      ///< no hit, though the truth is visible
    RightlyNone, ///< no hit, and the truth is not visible
};
constexpr size_t kHitClasses = 6;

/// Upper ends in pixels of the bands that HitFigures::wrongPlaceByDistance counts; the last band is open.
constexpr std::array kDistanceBandsPX = {4.0f, 8.0f, 16.0f, 64.0f};

/// Figures over some of the pixels.
struct HitFigures {
    uint64_t rays = 0; ///< reflective pixels
    uint64_t visibleTruths = 0;
    uint64_t facingAway = 0;        ///< of visibleTruths: depth agrees, but the camera sees the surface's other side
    uint64_t reported = 0;          ///< outcome hit, whatever its weight
    uint64_t right = 0;             ///< of reported
    double positionErrorMedian = 0; ///< pixels, over right hits
    double positionError95 = 0;     ///< 95th percentile
    double lookupsMean = 0;         ///< depth reads a traced ray
    uint32_t lookups95 = 0;
    uint64_t dipping = 0;      ///< rays that leaning shading normals send below their own triangle
    uint64_t dippingWrong = 0; ///< of these: hits that are not right
    std::array<uint64_t, shared::kOutcomeCount> outcomes = {};
    std::array<uint64_t, shared::kOutcomeCount> missedByOutcome = {}; ///< visible truths without a right hit
    std::array<uint64_t, kTruthKinds> wrongByTruth = {}; ///< hits that are not right; Visible: in the wrong place
    std::array<uint64_t, kDistanceBandsPX.size() + 1> wrongPlaceByDistance = {};

    double precision() const { return reported ? double(right) / double(reported) : 1; }
    double recall() const { return visibleTruths ? double(right) / double(visibleTruths) : 1; }
};

/// Perceptual roughness up to these: mirror, glossy; above: rough.
enum class RoughnessBand : uint8_t { Mirror, Glossy, Rough };
constexpr std::array kRoughnessBands = {0.1f, 0.4f};

struct HitReport {
    HitFigures all;
    std::array<HitFigures, kRoughnessBands.size() + 1> bands; ///< by RoughnessBand
    std::vector<HitClass> classes;                            ///< one a pixel
};

/// A reported hit is right if the truth is visible and lies within 2 pixels of the reported one, or if the surface at
/// the reported pixel is within 1 % of the ray's length of it in space.
///
/// `truths`  traceTruth of the same view and G-buffer
/// `rays`    view "ray" of the tracer: hitUV, outcome, lookups; four floats a pixel
HitReport judgeHits(const render::View& view, const GBufferPicture& gbuffer, std::span<const RayTruth> truths,
                    std::span<const float> rays);

/// Colours for people, RGB bytes: green right, orange wrong place, red false hit, blue missed, grey rightly none, black
/// no ray.
std::vector<uint8_t> classColors(std::span<const HitClass> classes);

} // namespace glint::measure
