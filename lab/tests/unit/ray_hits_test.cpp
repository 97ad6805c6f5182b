// Truth on a floor mirror before a wall, where each answer is known from a drawing; and how hits are judged against it.
#include "lab/measure/truth/ray_hits.hpp"

#include "lab/measure/truth/pixel_camera.hpp"
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace glint::measure {
namespace ray_hits_test {

using namespace scene::builtin;

constexpr uint32_t kWidth = 64, kHeight = 36;

/// A floor mirror, a wall behind it that ends on it, and a G-buffer drawn by the oracle's own primary rays.
class RayHitsTest : public testing::Test {
protected:
    RayHitsTest() {
        SceneBuilder b("test");
        b.add("floor", translated(plane({3, 3}), {0, 0, 0}), b.material(perfectMirror("floor")));
        b.add("wall", boxSide({2, 1, 0.1f}, Side::PlusZ), b.material(emission("wall", glm::vec3(1))), {{0, 1, -2}});
        scene_ = b.take();
        pose_ = std::move(scene::pose(scene_, 0)).value();
        oracle_.emplace(std::move(RayOracle::create(scene_, pose_)).value());
        scene::Camera camera;
        camera.viewToWorld = scene::lookAt({0, 1.5f, 4}, {0, 0.5f, 0});
        view_ = render::makeView(camera, kWidth, kHeight);
        draw();
    }

    void draw() {
        const PixelCamera camera(view_);
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const PixelRay eye = camera.ray(glm::dvec2(x, y) + 0.5);
                const auto hit = oracle_->trace(eye.originWS, eye.directionWS, 0);
                const bool floor = hit && scene_.materials[size_t(hit->material)].name == "floor";
                const auto z = hit ? static_cast<float>(camera.viewZ(hit->positionWS)) : 0.0f;
                const glm::vec3 n = hit ? glm::vec3(hit->normalWS) : glm::vec3(0);
                viewZ_.insert(viewZ_.end(), {z, z, z, 1});
                normal_.insert(normal_.end(), {n.x, n.y, n.z, 1});
                const float f0 = floor ? 1.0f : 0.0f;
                material_.insert(material_.end(), {f0, f0, f0, 0});
            }
    }

    GBufferPicture gbuffer() const { return {viewZ_, normal_, material_}; }
    std::vector<RayTruth> truths() const { return traceTruth(*oracle_, view_, gbuffer()); }

    /// Rays that report what `report(truth, ray)` makes of each truth: a perfect tracer at first.
    template <class Report>
    std::vector<float> rays(const std::vector<RayTruth>& truths, const Report& report) const {
        std::vector<float> rays;
        for (const RayTruth& truth : truths) {
            std::array<float, 4> ray = {truth.px.x / kWidth, truth.px.y / kHeight, float(shared::kOutcomeSky), 10};
            if (truth.kind == TruthKind::NoRay)
                ray = {0, 0, float(shared::kOutcomeNone), 0};
            if (truth.kind == TruthKind::Visible)
                ray[2] = float(shared::kOutcomeHit);
            report(truth, ray);
            rays.insert(rays.end(), ray.begin(), ray.end());
        }
        return rays;
    }
    static void perfect(const RayTruth&, std::array<float, 4>&) {}

    scene::Scene scene_;
    scene::Pose pose_;
    std::optional<RayOracle> oracle_;
    render::View view_;
    std::vector<float> viewZ_, normal_, material_;
};

TEST_F(RayHitsTest, TruthIsTheMirroredPointAndVisibleWhereTheWallIs) {
    const PixelCamera camera(view_);
    size_t visible = 0, nothing = 0;
    const std::vector<RayTruth> all = truths();
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const RayTruth& truth = all[size_t(y) * kWidth + x];
            if (material_[4 * (size_t(y) * kWidth + x)] == 0) {
                EXPECT_EQ(truth.kind, TruthKind::NoRay);
                continue;
            }
            // The floor mirrors the eye to (0, -1.5, 4): from there a straight line runs through the floor to the wall.
            const PixelRay eye = camera.ray(glm::dvec2(x, y) + 0.5);
            const glm::dvec3 d = eye.directionWS * glm::dvec3(1, -1, 1);
            const glm::dvec3 o = eye.originWS * glm::dvec3(1, -1, 1);
            const glm::dvec3 wall = o + d * ((-1.9 - o.z) / d.z);
            const bool onWall = std::abs(wall.x) < 1.99 && wall.y < 1.99;
            const bool missesWall = std::abs(wall.x) > 2.01 || wall.y > 2.01;
            if (missesWall) {
                EXPECT_EQ(truth.kind, TruthKind::Nothing) << x << "," << y;
                ++nothing;
            } else if (onWall && truth.kind != TruthKind::OffScreen) {
                EXPECT_EQ(truth.kind, TruthKind::Visible) << x << "," << y;
                EXPECT_LT(glm::distance(glm::dvec3(truth.positionWS), wall), 1e-4);
                EXPECT_LT(glm::distance(glm::dvec2(truth.px), camera.project(wall)), 1e-3);
                EXPECT_FALSE(truth.facesAway);
                ++visible;
            }
        }
    EXPECT_GT(visible, 300u);
    EXPECT_GT(nothing, 100u);
}

TEST_F(RayHitsTest, LeaningNormalsSendRaysBelowTheirSurface) {
    for (size_t i = 0; i < normal_.size(); i += 4) // floor normals that lean away from the camera: rays dip steeply
        if (material_[i] > 0) {
            normal_[i + 1] = 0;
            normal_[i + 2] = -1;
        }
    size_t rays = 0, dipping = 0;
    for (const RayTruth& truth : truths()) {
        rays += truth.kind != TruthKind::NoRay;
        dipping += truth.dips;
    }
    EXPECT_GT(rays, 0u);
    EXPECT_EQ(dipping, rays);
}

TEST_F(RayHitsTest, WhatSomethingElseCoversIsHidden) {
    for (uint32_t y = 0; y < kHeight / 2; ++y) // a board before the upper half of the picture
        for (uint32_t x = 0; x < kWidth; ++x)
            viewZ_[4 * (size_t(y) * kWidth + x)] = 1;
    for (const RayTruth& truth : truths()) {
        if (truth.kind != TruthKind::Visible && truth.kind != TruthKind::Hidden)
            continue;
        EXPECT_EQ(truth.kind, truth.px.y < kHeight / 2 ? TruthKind::Hidden : TruthKind::Visible);
    }
}

TEST_F(RayHitsTest, APerfectTracerHasPerfectFigures) {
    const std::vector<RayTruth> all = truths();
    const HitReport report = judgeHits(view_, gbuffer(), all, rays(all, perfect));
    EXPECT_EQ(report.all.precision(), 1);
    EXPECT_EQ(report.all.recall(), 1);
    EXPECT_EQ(report.all.right, report.all.visibleTruths);
    EXPECT_LT(report.all.positionError95, 1e-3);
    EXPECT_EQ(report.all.lookupsMean, 10);
    EXPECT_EQ(report.all.lookups95, 10u);
    EXPECT_EQ(report.all.dipping, 0u);
    EXPECT_EQ(report.all.rays, report.bands[size_t(RoughnessBand::Mirror)].rays);
    EXPECT_EQ(report.bands[size_t(RoughnessBand::Rough)].rays, 0u);
    EXPECT_EQ(report.classes.size(), size_t(kWidth) * kHeight);
}

TEST_F(RayHitsTest, EachWayToBeWrongIsCountedAsWhatItIs) {
    const std::vector<RayTruth> all = truths();
    size_t visible = 0, notVisible = 0;
    const auto count = [&](const RayTruth& truth) {
        return truth.kind == TruthKind::Visible ? visible++ : truth.kind == TruthKind::NoRay ? 0 : notVisible++;
    };
    const HitReport report =
        judgeHits(view_, gbuffer(), all, rays(all, [&](const RayTruth& truth, auto& ray) {
                      const size_t number = count(truth);
                      if (truth.kind == TruthKind::Visible && number == 0)
                          ray[2] = float(shared::kOutcomeOutOfSteps);
                      if (truth.kind == TruthKind::Visible && number == 1)
                          ray[0] += ray[0] < 0.5f ? 10.0f / kWidth
                                                  : -10.0f / kWidth; // along the wall: farther than 1 % of the ray
                      if (truth.kind == TruthKind::Visible && number == 2)
                          ray[0] += ray[0] < 0.5f ? 1.5f / kWidth : -1.5f / kWidth; // near enough
                      if (truth.kind == TruthKind::Nothing && number == 0)
                          ray[2] = float(shared::kOutcomeHit);
                  }));
    const HitFigures& f = report.all;
    EXPECT_EQ(f.visibleTruths, visible);
    EXPECT_EQ(f.reported, visible); // one more, one less
    EXPECT_EQ(f.right, visible - 2);
    EXPECT_EQ(f.missedByOutcome[shared::kOutcomeOutOfSteps], 1u);
    EXPECT_EQ(f.missedByOutcome[shared::kOutcomeHit], 1u);
    EXPECT_EQ(f.wrongByTruth[size_t(TruthKind::Visible)], 1u);
    EXPECT_EQ(f.wrongByTruth[size_t(TruthKind::Nothing)], 1u);
    EXPECT_EQ(f.wrongPlaceByDistance[2], 1u); // 8 to 16 px
    EXPECT_EQ(std::ranges::count(report.classes, HitClass::Missed), 1);
    EXPECT_EQ(std::ranges::count(report.classes, HitClass::WrongPlace), 1);
    EXPECT_EQ(std::ranges::count(report.classes, HitClass::FalseHit), 1);
    EXPECT_EQ(std::ranges::count(report.classes, HitClass::RightlyNone), std::ptrdiff_t(notVisible) - 1);
    EXPECT_EQ(classColors(report.classes).size(), 3 * report.classes.size());
}

TEST_F(RayHitsTest, StatedWeightsAreHeldAgainstTheShareOfRightAnswers) {
    // Every second hit is where the ray starts, on the floor. Right ones state 0.95, the others 0.35; all are of one
    // kind.
    const std::vector<RayTruth> all = truths();
    std::vector<float> certainty;
    size_t count = 0;
    const std::vector<float> reported = rays(all, [&](const RayTruth& truth, std::array<float, 4>& ray) {
        const size_t pixel = certainty.size() / 4;
        const bool wrong = truth.kind == TruthKind::Visible && ++count % 2 == 0;
        if (wrong) {
            ray[0] = (static_cast<float>(pixel % kWidth) + 0.5f) / kWidth;
            ray[1] = (static_cast<float>(pixel / kWidth) + 0.5f) / kHeight;
        }
        certainty.insert(certainty.end(), {float(shared::kAnswerPlain), wrong ? 0.35f : 0.95f, 1, 1});
    });
    const HitFigures figures = judgeHits(view_, gbuffer(), all, reported, certainty).all;
    const AnswerShare& plain = figures.byKind[shared::kAnswerPlain];
    EXPECT_EQ(plain.answers, count);
    EXPECT_NEAR(plain.share(), 0.5, 0.02);
    EXPECT_NEAR(figures.stated[9].share(), 1, 0.02);
    EXPECT_NEAR(figures.stated[9].meanStated(), 0.95, 1e-5);
    EXPECT_EQ(figures.stated[3].right, 0u);
    EXPECT_NEAR(figures.stated[3].meanStated(), 0.35, 1e-5);
    EXPECT_EQ(figures.stated[0].answers, 0u);
    EXPECT_EQ(judgeHits(view_, gbuffer(), all, reported).all.stated[9].answers, 0u) << "nothing is stated";
}

} // namespace ray_hits_test
} // namespace glint::measure
