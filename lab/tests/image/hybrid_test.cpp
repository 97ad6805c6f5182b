// The hybrid on whole scenes: screen first, rays for the remaining weight, and hardly worse than rays for everything.
#include "lab/measure/figures/image_error.hpp"
#include "lab/measure/truth/job_exact.hpp"
#include "lab/tests/image/job_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint::test {
namespace hybrid_test {

class HybridTest : public JobTest {
protected:
    struct Drawn {
        measure::MirrorError error;
        Statistics::SceneRays rays;
    };
    static Drawn drawExact(std::vector<std::string> assignments) {
        // Bounces are counted: no estimate of what further ones would bring.
        assignments.insert(assignments.begin(),
                           {"fade.border=none", "rays.enabled=true", "rays.environmentOcclusion=false"});
        render::RenderJob job;
        job.scene = "builtin:exact";
        job.camera = "front";
        job.width = 640;
        job.height = 360;
        job.views = {"composite"};
        job.statistics = true;
        job.settings = settingsOf(std::move(assignments));
        const render::RenderResult result = must(render::runJob(device(), job));
        return {must(measure::measureExact(job, result)), result.stats.scene};
    }
    /// Fraction of wrong pixels among the mirror pixels whose paths have at most `bounces` bounces.
    static double wrongShare(const measure::MirrorError& error, size_t bounces) {
        double pixels = 0;
        double wrong = 0;
        for (size_t i = 0; i < bounces; ++i) {
            pixels += double(error.byBounces.at(i).pixels);
            wrong += double(error.byBounces.at(i).wrong);
        }
        return wrong / pixels;
    }
};

TEST_F(HybridTest, MirrorsInMirrorsAreRightForFewerRaysThanRaysAlone) {
    const Drawn hybrid = drawExact({"rays.bounces=2"});
    const Drawn alone = drawExact({"rays.bounces=2", "screen.enabled=false"});
    ASSERT_GT(hybrid.error.byBounces.at(1).pixels, 1000u);
    EXPECT_LT(wrongShare(hybrid.error, 1), 0.01);
    EXPECT_LT(wrongShare(hybrid.error, 2), 0.01);
    EXPECT_LT(wrongShare(alone.error, 2), 0.001);
    EXPECT_LT(double(hybrid.rays.rays), 0.75 * double(alone.rays.rays));
    EXPECT_GT(hybrid.rays.fromScreen, 10000u);
    EXPECT_GT(hybrid.rays.replaced, hybrid.rays.fromScreen);
    EXPECT_EQ(alone.rays.fromScreen + alone.rays.replaced + alone.rays.reusedLight, 0u);
}

TEST_F(HybridTest, OneBounceLeavesTheScreensHitsAlone) {
    const Drawn one = drawExact({"rays.bounces=1"});
    const Drawn two = drawExact({"rays.bounces=2"});
    EXPECT_EQ(one.rays.fromScreen, 0u);
    EXPECT_EQ(one.rays.rays, one.rays.pixels); // no path is longer
    EXPECT_LT(one.rays.pixels, two.rays.pixels);
    EXPECT_LT(wrongShare(one.error, 1), 0.01);
    EXPECT_GT(double(one.error.byBounces.at(1).wrong), 0.5 * double(one.error.byBounces.at(1).pixels));
}

TEST_F(HybridTest, MirrorsOfTheHallAreAlmostThoseOfRaysAlone) {
    const auto draw = [](std::vector<std::string> assignments) {
        assignments.insert(assignments.begin(), {"rays.enabled=true", "lights.shadows=rays"});
        render::RenderJob job;
        job.scene = "builtin:hall";
        job.width = 320;
        job.height = 180;
        job.views = {"composite", "roughness", "reflectivity"};
        job.statistics = true;
        job.settings = settingsOf(std::move(assignments));
        return must(render::runJob(device(), job));
    };
    const render::RenderResult hybrid = draw({});
    const render::RenderResult alone = draw({"screen.enabled=false"});
    std::vector<uint8_t> mirrors;
    for (size_t i = 0; i < alone.views[0].rgba.size(); i += 4)
        mirrors.push_back(alone.views[2].rgba[i] > 0 && alone.views[1].rgba[i] <= 0.01f);
    ASSERT_GT(std::ranges::count(mirrors, uint8_t{1}), 2500);
    EXPECT_GT(measure::psnr(alone.views[0].rgba, hybrid.views[0].rgba, mirrors), 40);
    EXPECT_LT(hybrid.stats.scene.rays, alone.stats.scene.rays);
}

TEST_F(HybridTest, LightOfThePictureIsReusedOnlyWhereAsked) {
    const Drawn with = drawExact({"rays.bounces=2"});
    const Drawn without = drawExact({"rays.bounces=2", "rays.reuseLight=false"});
    EXPECT_GT(with.rays.reusedLight, without.rays.reusedLight);
    EXPECT_EQ(without.rays.reusedLight, without.rays.fromScreen); // the screen's own hits
    EXPECT_EQ(with.rays.rays, without.rays.rays);
}

} // namespace hybrid_test
} // namespace glint::test
