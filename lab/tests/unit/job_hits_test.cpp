// Truth that is kept for one G-buffer and traced again for another.
#include "lab/measure/truth/job_hits.hpp"

#include "lab/measure/truth/pixel_camera.hpp"

#include <gtest/gtest.h>

namespace glint::measure {
namespace job_hits_test {

constexpr uint32_t kWidth = 96, kHeight = 54;

/// builtin:exact drawn by the oracle, and rays that all say "sky".
class TruthKeeperTest : public testing::Test {
protected:
    TruthKeeperTest() {
        job_.scene = "builtin:exact";
        job_.width = kWidth;
        job_.height = kHeight;
        inputs_ = std::move(render::loadJobInputs(job_)).value();
        view_ = render::makeView(inputs_.camera, kWidth, kHeight);
        const RayOracle oracle = std::move(RayOracle::create(*inputs_.scene, inputs_.pose)).value();
        const PixelCamera camera(view_);
        result_.width = kWidth;
        result_.height = kHeight;
        for (const std::string& name : hitViews())
            result_.views.push_back({name, {}, {}});
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const PixelRay eye = camera.ray(glm::dvec2(x, y) + 0.5);
                const auto hit = oracle.trace(eye.originWS, eye.directionWS, 0);
                const glm::vec3 n = hit ? glm::vec3(hit->normalWS) : glm::vec3(0);
                add(0, {hit ? static_cast<float>(camera.viewZ(hit->positionWS)) : 0.0f, 0, 0, 1});
                add(1, {n.x, n.y, n.z, 1});
                add(2, {1, 1, 1, 1});
                add(3, {0, 0, static_cast<float>(shared::kOutcomeSky), 7});
                add(4, {y < kHeight / 2 ? 0.2f : 0.05f, 0, 0, 1});
            }
    }
    void add(size_t view, std::initializer_list<float> value) {
        result_.views[view].rgba.insert(result_.views[view].rgba.end(), value);
    }
    std::vector<float>& pixels(size_t view) { return result_.views[view].rgba; }

    render::RenderJob job_;
    render::JobInputs inputs_;
    render::View view_;
    render::RenderResult result_; ///< depth, normal, reflectivity, ray, roughness
};

TEST_F(TruthKeeperTest, JudgesAsIfItHadTracedTheTruthEachTime) {
    TruthKeeper keeper;
    const auto expectFresh = [&](const char* what) {
        const HitReport kept = std::move(keeper.judge(inputs_, view_, result_, false)).value();
        const HitReport fresh = std::move(measureHits(job_, result_)).value();
        EXPECT_EQ(kept.classes, fresh.classes) << what;
        EXPECT_EQ(kept.all.visibleTruths, fresh.all.visibleTruths) << what;
        return kept;
    };
    const HitReport none = expectFresh("no hits");
    EXPECT_GT(none.all.visibleTruths, 100u);
    EXPECT_EQ(none.all.reported, 0u);

    for (size_t i = 0; i < pixels(3).size(); i += 4) // other rays on the same G-buffer
        pixels(3)[i + 2] = static_cast<float>(shared::kOutcomeHit);
    EXPECT_GT(expectFresh("all hit the corner").all.reported, 1000u);

    std::fill(pixels(2).begin(), pixels(2).begin() + std::ptrdiff_t{kWidth} * kHeight * 2, 0.0f); // another G-buffer
    EXPECT_LT(expectFresh("the upper half reflects nothing").all.rays, none.all.rays);
}

TEST_F(TruthKeeperTest, CountsByTheRoughnessOfTheSurface) {
    const HitReport report = std::move(measureHits(job_, result_)).value();
    const auto rays = [&](RoughnessBand band) { return report.bands[static_cast<size_t>(band)].rays; };
    EXPECT_GT(rays(RoughnessBand::Glossy), 100u);
    EXPECT_GT(rays(RoughnessBand::Mirror), 100u);
    EXPECT_EQ(rays(RoughnessBand::Rough), 0u);
    EXPECT_EQ(rays(RoughnessBand::Glossy) + rays(RoughnessBand::Mirror), report.all.rays);
}

TEST(HitSettings, LetEveryReflectivePixelTraceItsMirrorRay) {
    render::ProgramSettings settings;
    settings.reflections.reflect.threshold = 0.3f;
    settings.reflections.reflect.maxRoughness = 0.2f;
    settings.reflections.screen.step = 7;
    settings.render.display.antialias = render::Antialias::Msaa4;
    const render::ProgramSettings all = hitSettings(settings);
    EXPECT_EQ(all.reflections.reflect.threshold, 0);
    EXPECT_EQ(all.reflections.reflect.maxRoughness, 1);
    EXPECT_EQ(all.reflections.rough.factor, 0);
    EXPECT_EQ(all.render.display.antialias, render::Antialias::None);
    EXPECT_EQ(all.reflections.screen.step, 7);
}

} // namespace job_hits_test
} // namespace glint::measure
