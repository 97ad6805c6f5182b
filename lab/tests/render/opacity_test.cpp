// The alpha of a frame: how much of each pixel surfaces cover, whatever the renderer keeps in its own images' alpha.
#include "lab/session/run_job.hpp"
#include "tests/gpu/support/gpu_test.hpp"

#include <cmath>
#include <functional>

namespace glint::test {
namespace opacity_test {

class OpacityTest : public GpuTest {
protected:
    static render::RenderResult draw(const std::string& scene, std::vector<std::string> assignments) {
        render::RenderJob job;
        job.scene = scene;
        job.width = 192;
        job.height = 108;
        job.views = {"composite", "scene", "depth"};
        job.settings = must(render::loadSettings({{}, "", "", std::move(assignments)}));
        return must(render::runJob(gpu(), job));
    }
    static size_t count(const render::RenderedView& view, size_t channel, const std::function<bool(float)>& is) {
        size_t count = 0;
        for (size_t i = channel; i < view.rgba.size(); i += 4)
            count += is(view.rgba[i]);
        return count;
    }
};

TEST_F(OpacityTest, IsOneOnSurfacesAndZeroInTheSky) {
    for (const char* mode : {"gbuffer.mode=prepass", "gbuffer.mode=geometry"})
        for (const char* reflects : {"screen.enabled=true", "reflect.strength=0"}) {
            const render::RenderResult result = draw("builtin:spheres", {mode, reflects});
            const render::RenderedView& depth = result.views[2];
            for (size_t i = 0; i < depth.rgba.size(); i += 4) {
                const float expected = depth.rgba[i] > 0 ? 1 : 0;
                ASSERT_EQ(result.views[0].rgba[i + 3], expected) << mode << " " << reflects << " pixel " << i / 4;
                ASSERT_EQ(result.views[1].rgba[i + 3], expected) << mode << " " << reflects << " pixel " << i / 4;
            }
            EXPECT_GT(count(depth, 0, [](float z) { return z > 0; }), 5000u);
            EXPECT_GT(count(depth, 0, [](float z) { return z == 0; }), 500u);
        }
}

TEST_F(OpacityTest, OfSeveralSamplesIsTheShareThatIsCovered) {
    const render::RenderedView picture = draw("builtin:spheres", {"display.antialias=msaa4"}).views[0];
    const size_t edges = count(picture, 3, [](float a) { return a > 0 && a < 1; });
    EXPECT_GT(edges, 50u);
    for (size_t i = 3; i < picture.rgba.size(); i += 4) // of four samples, in 8 bits
        EXPECT_NEAR(picture.rgba[i] * 4, std::round(picture.rgba[i] * 4), 0.01f);
}

TEST_F(OpacityTest, GlassInFrontOfTheSkyIsOpaque) {
    // Nothing but glass and the wall behind it; what transmits light shows the sky itself and lets none of it through.
    for (const char* layers : {"refraction.enabled=true", "refraction.enabled=false"}) {
        const render::RenderedView picture = draw("builtin:glass", {layers}).views[0];
        EXPECT_EQ(count(picture, 3, [](float a) { return a != 0 && std::abs(a - 1) > 1e-3f; }), 0u) << layers;
        EXPECT_GT(count(picture, 3, [](float a) { return std::abs(a - 1) <= 1e-3f; }), 5000u) << layers;
    }
}

} // namespace opacity_test
} // namespace glint::test
