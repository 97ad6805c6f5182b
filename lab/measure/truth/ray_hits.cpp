#include "lab/measure/truth/ray_hits.hpp"

#include "base/assert.hpp"
#include "lab/measure/truth/pixel_camera.hpp"
#include "lab/scene/for_each_row.hpp"

#include <algorithm>

namespace glint::measure {
namespace {

constexpr double kRightPX = 2;
constexpr double kRightShare = 0.01; ///< of the ray's length, in 3D

constexpr double kGuessShare = 0.1; ///< as kRightShare, of answers that are no hits
constexpr float kSameWay = 0.9f;    ///< cosine between normals

struct Verdict {
    HitClass hitClass = HitClass::NoRay;
    float errorPX = 0;        ///< of hits whose true hit is visible
    bool answerRight = false; ///< of any outcome with an answer
};

struct ReportedRay {
    glm::dvec2 hitUV;
    uint32_t outcome;
    uint32_t lookups;
};

/// What the tracer knows of an answer.
struct StatedAnswer {
    size_t kind; ///< kAnswer*
    double right;
};

bool isAnswer(uint32_t outcome) {
    return outcome == shared::kOutcomeHit || outcome == shared::kOutcomeSide || outcome == shared::kOutcomeBackFace ||
           outcome == shared::kOutcomeInferred;
}

ReportedRay reportedRay(std::span<const float> rays, size_t pixel) {
    const float* ray = rays.data() + 4 * pixel;
    return {{ray[0], ray[1]},
            std::min(static_cast<uint32_t>(ray[2]), shared::kOutcomeCount - 1),
            static_cast<uint32_t>(ray[3])};
}

StatedAnswer statedAnswer(std::span<const float> certainty, size_t pixel) {
    const float* answer = certainty.data() + 4 * pixel;
    return {std::min(static_cast<size_t>(std::max(answer[0], 0.0f)), size_t{shared::kAnswerKinds - 1}),
            std::clamp(static_cast<double>(answer[1]), 0.0, 1.0)};
}

bool wasTraced(uint32_t outcome) {
    return outcome != shared::kOutcomeNone && outcome < shared::kOutcomeBelowThreshold;
}

size_t pixelAt(const PixelCamera& camera, const glm::dvec2& px) {
    const auto x = std::min(static_cast<uint32_t>(px.x), camera.width() - 1);
    const auto y = std::min(static_cast<uint32_t>(px.y), camera.height() - 1);
    return size_t(y) * camera.width() + x;
}

/// True if the visible surface at `px` is within `share` of the ray's length of the true hit, in space.
bool nearInSpace(const PixelCamera& camera, const GBufferPicture& gbuffer, const RayTruth& truth, const glm::dvec2& px,
                 double share) {
    const auto viewZ = static_cast<double>(gbuffer.viewZ[4 * pixelAt(camera, px)]);
    if (viewZ <= 0)
        return false;
    const glm::dvec3 positionWS = camera.position(camera.ray(px), viewZ);
    return glm::distance(positionWS, glm::dvec3(truth.positionWS)) <= share * static_cast<double>(truth.distance);
}

/// True if what the picture shows at `px` is what the exact ray meets. `rightHit`: the verdict on a hit.
bool isRightAnswer(const PixelCamera& camera, const GBufferPicture& gbuffer, std::span<const RayTruth> truths,
                   const RayTruth& truth, const ReportedRay& reported, bool rightHit) {
    if (!isAnswer(reported.outcome) || truth.met.item < 0)
        return false;
    const glm::dvec2 px = reported.hitUV * glm::dvec2(camera.width(), camera.height());
    const size_t pixel = pixelAt(camera, px);
    if (!(truths[pixel].shown == truth.met))
        return false;
    if (reported.outcome == shared::kOutcomeHit)
        return rightHit;
    const float* normal = gbuffer.normalWS.data() + 4 * pixel;
    return glm::dot(glm::vec3(normal[0], normal[1], normal[2]), truth.normalWS) > kSameWay ||
           nearInSpace(camera, gbuffer, truth, px, kGuessShare);
}

Verdict judge(const PixelCamera& camera, const GBufferPicture& gbuffer, const RayTruth& truth,
              const ReportedRay& reported) {
    const bool hit = reported.outcome == shared::kOutcomeHit;
    const bool visible = truth.kind == TruthKind::Visible;
    if (truth.kind == TruthKind::NoRay)
        return {};
    if (!hit)
        return {visible ? HitClass::Missed : HitClass::RightlyNone};
    if (!visible)
        return {HitClass::FalseHit};
    const glm::dvec2 px = reported.hitUV * glm::dvec2(camera.width(), camera.height());
    const double error = glm::distance(px, glm::dvec2(truth.px));
    const bool right = error <= kRightPX || nearInSpace(camera, gbuffer, truth, px, kRightShare);
    return {right ? HitClass::Right : HitClass::WrongPlace, static_cast<float>(error)};
}

/// Gathers pixels into figures.
class Tally {
public:
    void add(const Verdict& verdict, const StatedAnswer& stated) {
        const auto count = [&](AnswerShare& share) {
            ++share.answers;
            share.right += verdict.answerRight;
            share.stated += stated.right;
        };
        count(figures_.byKind[stated.kind]);
        count(figures_.stated[std::min(static_cast<size_t>(stated.right * kStatedBins), kStatedBins - 1)]);
    }

    void add(const RayTruth& truth, const ReportedRay& reported, const Verdict& verdict) {
        ++figures_.rays;
        ++figures_.outcomes[reported.outcome];
        const bool visible = truth.kind == TruthKind::Visible;
        const bool right = verdict.hitClass == HitClass::Right;
        figures_.dipping += truth.dips;
        figures_.visibleTruths += visible;
        figures_.facingAway += visible && truth.facesAway;
        if (wasTraced(reported.outcome))
            lookups_.push_back(reported.lookups);
        if (visible && !right)
            ++figures_.missedByOutcome[reported.outcome];
        if (reported.outcome != shared::kOutcomeHit)
            return;
        ++figures_.reported;
        if (right) {
            ++figures_.right;
            errors_.push_back(verdict.errorPX);
            return;
        }
        figures_.dippingWrong += truth.dips;
        ++figures_.wrongByTruth[static_cast<size_t>(truth.kind)];
        if (visible) {
            const auto band = std::ranges::lower_bound(kDistanceBandsPX, verdict.errorPX);
            ++figures_.wrongPlaceByDistance[static_cast<size_t>(band - kDistanceBandsPX.begin())];
        }
    }

    HitFigures take() {
        double sum = 0;
        for (const uint32_t lookups : lookups_)
            sum += lookups;
        figures_.lookupsMean = lookups_.empty() ? 0 : sum / static_cast<double>(lookups_.size());
        figures_.lookups95 = percentile(lookups_, 0.95);
        figures_.positionErrorMedian = static_cast<double>(percentile(errors_, 0.5));
        figures_.positionError95 = static_cast<double>(percentile(errors_, 0.95));
        return figures_;
    }

private:
    /// Returns the smallest value that at least this fraction of all values does not exceed; 0 without values.
    template <class T>
    static T percentile(std::vector<T>& values, double share) {
        if (values.empty())
            return 0;
        const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::ranges::nth_element(values, values.begin() + rank);
        return values[static_cast<size_t>(rank)];
    }

    HitFigures figures_;
    std::vector<float> errors_;
    std::vector<uint32_t> lookups_;
};

size_t bandOf(float perceptualRoughness) {
    return static_cast<size_t>(std::ranges::upper_bound(kRoughnessBands, perceptualRoughness) -
                               kRoughnessBands.begin());
}

} // namespace

HitReport judgeHits(const render::View& view, const GBufferPicture& gbuffer, std::span<const RayTruth> truths,
                    std::span<const float> rays, std::span<const float> certainty) {
    const size_t pixels = size_t(view.width) * view.height;
    GLINT_ASSERT(truths.size() == pixels && rays.size() == 4 * pixels, "{} truths, {} floats of rays for {} pixels",
                 truths.size(), rays.size(), pixels);
    GLINT_ASSERT(certainty.empty() || certainty.size() == 4 * pixels, "{} floats of certainty for {} pixels",
                 certainty.size(), pixels);
    const PixelCamera camera(view);
    std::vector<Verdict> verdicts(pixels);
    scene::forEachRow(view.height, [&](uint32_t y) {
        for (size_t i = size_t(y) * view.width; i < (size_t(y) + 1) * view.width; ++i) {
            const ReportedRay reported = reportedRay(rays, i);
            verdicts[i] = judge(camera, gbuffer, truths[i], reported);
            verdicts[i].answerRight =
                isRightAnswer(camera, gbuffer, truths, truths[i], reported, verdicts[i].hitClass == HitClass::Right);
        }
    });

    HitReport report;
    report.classes.reserve(pixels);
    Tally all;
    std::array<Tally, kRoughnessBands.size() + 1> bands;
    for (size_t i = 0; i < pixels; ++i) {
        report.classes.push_back(verdicts[i].hitClass);
        if (truths[i].kind == TruthKind::NoRay)
            continue;
        const ReportedRay reported = reportedRay(rays, i);
        Tally& band = bands[bandOf(gbuffer.material[4 * i + 3])];
        all.add(truths[i], reported, verdicts[i]);
        band.add(truths[i], reported, verdicts[i]);
        if (certainty.empty() || !isAnswer(reported.outcome))
            continue;
        const StatedAnswer stated = statedAnswer(certainty, i);
        all.add(verdicts[i], stated);
        band.add(verdicts[i], stated);
    }
    report.all = all.take();
    for (size_t band = 0; band < bands.size(); ++band)
        report.bands[band] = bands[band].take();
    return report;
}

std::vector<uint8_t> classColors(std::span<const HitClass> classes) {
    constexpr std::array<std::array<uint8_t, 3>, kHitClasses> kColors = {
        {{0, 0, 0}, {40, 170, 60}, {245, 150, 20}, {220, 30, 40}, {50, 90, 230}, {70, 70, 70}}};
    std::vector<uint8_t> rgb;
    rgb.reserve(3 * classes.size());
    for (const HitClass hitClass : classes) {
        const auto& color = kColors[static_cast<size_t>(hitClass)];
        rgb.insert(rgb.end(), color.begin(), color.end());
    }
    return rgb;
}

} // namespace glint::measure
