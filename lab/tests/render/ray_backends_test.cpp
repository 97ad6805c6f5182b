// The two ray back ends in whole pictures, and which of them a program gets.
#include "lab/session/run_job.hpp"
#include "lab/tests/support/assets.hpp"
#include "tests/gpu/support/gpu_test.hpp"

#include <algorithm>
#include <cstdlib>

namespace glint::test {
namespace ray_backends_test {

class RayBackendsTest : public GpuTest {
protected:
    static render::RenderJob job(const std::string& scene, RayBackend backend) {
        render::RenderJob job;
        job.scene = scene;
        job.width = 240;
        job.height = 135;
        job.views = {"composite"};
        job.display = true;
        job.settings.reflections.screen.enabled = false;
        job.settings.reflections.rays.enabled = true;
        job.settings.reflections.rays.backend = backend;
        job.settings.reflections.rays.bounces = 3;
        return job;
    }

    /// Share of the pixels that differ by more than 1/255 in a channel.
    static double differing(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
        size_t count = 0;
        for (size_t i = 0; i < a.size(); i += 3) {
            bool differs = false;
            for (size_t c = 0; c < 3; ++c)
                differs |= std::abs(int(a[i + c]) - int(b[i + c])) > 1;
            count += differs;
        }
        return double(count) / (double(a.size()) / 3);
    }

    static void expectEqualPictures(const std::string& scene, const std::string& camera = {}) {
        if (!gpu().rayQuery())
            GTEST_SKIP() << "no ray queries on " << gpu().info().name;
        std::vector<std::vector<uint8_t>> pictures;
        for (const RayBackend backend : {RayBackend::Query, RayBackend::Bvh}) {
            render::RenderJob asked = job(scene, backend);
            asked.camera = camera;
            pictures.push_back(must(render::runJob(gpu(), asked)).views.at(0).rgb8);
        }
        EXPECT_LE(differing(pictures[0], pictures[1]), 1e-4) << scene;
    }
};

TEST_F(RayBackendsTest, picturesOfTheHallAreEqual) {
    expectEqualPictures("builtin:hall");
}

TEST_F(RayBackendsTest, picturesOfTheExactSceneAreEqual) {
    expectEqualPictures("builtin:exact");
}

TEST_F(RayBackendsTest, picturesOfSpheresAreEqual) {
    expectEqualPictures("builtin:spheres");
}

TEST_F(RayBackendsTest, picturesOfAFileAreEqual) {
    GLINT_NEED_ASSET(path, "scenes/stage1.glb");
    expectEqualPictures(path, (assetsFolder() / "scenes/stage1.camera.json").string());
}

TEST_F(RayBackendsTest, aDeviceWithoutRayQueriesSaysSoOrTakesTheOther) {
    const std::unique_ptr<gpu::Context> plain = must(gpu::Context::create({.rayQuery = false}));
    const Result<render::RenderResult> refused = render::runJob(*plain, job("builtin:mirror", RayBackend::Query));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("ray queries are not enabled"), std::string::npos)
        << refused.error().message;
    const render::RenderResult drawn = must(render::runJob(*plain, job("builtin:mirror", RayBackend::Auto)));
    EXPECT_TRUE(
        std::ranges::any_of(drawn.stats.passes, [](const auto& pass) { return pass.first == "rays/reflect_bvh"; }));
}

} // namespace ray_backends_test
} // namespace glint::test
