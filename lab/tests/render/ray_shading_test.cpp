// What rays bring home is what the raster pass draws: rays are sent straight on along the camera's own, so that both
// see the same points of whole scenes.
#include "lab/tests/render/support/render_test.hpp"

#include "glint/glint.hpp"
#include "lab/renderer/ray_world.hpp"
#include "lab/scene/builtin/builtin.hpp"
#include "tests/gpu/support/synthetic_gbuffer.hpp"

#include <algorithm>

namespace glint::test {
namespace ray_shading_test {

struct Differences {
    size_t pixels = 0; ///< that show a surface
    double median = 0; ///< of the relative difference, largest channel
    double percentile95 = 0;
    double percentile99 = 0;
};

class RayShadingTest : public RenderTest, public testing::WithParamInterface<RayBackend> {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        if (GetParam() == RayBackend::Query && !gpu().rayQuery())
            GTEST_SKIP() << "no ray queries on " << gpu().info().name;
    }

    /// Every other pixel, so that no depths beside it say how a mirror stands.
    static bool hasMirror(size_t x, size_t y) { return (x + y) % 2 == 0; }

    /// A G-buffer whose mirrors stand edge-on just before the eye: what they reflect is what lies straight ahead.
    static SyntheticGBuffer passOn(const render::View& view) {
        const uint32_t w = view.width;
        const uint32_t h = view.height;
        std::vector<float> depth;
        std::vector<glm::vec2> normals;
        for (uint32_t y = 0; y < h; ++y)
            for (uint32_t x = 0; x < w; ++x) {
                depth.push_back(hasMirror(x, y) ? 0.5f : 0.0f);
                const glm::dvec2 ndc((x + 0.5) / w * 2 - 1, 1 - (y + 0.5) / h * 2);
                const glm::dvec4 ahead = glm::inverse(glm::dmat4(view.viewToClip)) * glm::dvec4(ndc, 0.5, 1);
                const glm::dvec3 directionWS =
                    glm::dmat3(view.viewToWorld) * glm::normalize(glm::dvec3(ahead) / ahead.w);
                normals.push_back(encodeOctahedral(glm::normalize(glm::cross(directionWS, glm::dvec3(0.3, 0.8, 0.1)))));
            }
        const std::vector<glm::vec4> white(size_t{w} * h, glm::vec4(1, 1, 1, 0));
        const std::vector<glm::vec4> black(size_t{w} * h, glm::vec4(0));
        SyntheticGBuffer out;
        out.depth = uploadTestImage(gpu(), "test/depth", VK_FORMAT_R32_SFLOAT, w, h, bytesOf(depth));
        out.normal = uploadTestImage(gpu(), "test/normal", VK_FORMAT_R32G32_SFLOAT, w, h, bytesOf(normals));
        out.material = uploadTestImage(gpu(), "test/material", VK_FORMAT_R32G32B32A32_SFLOAT, w, h, bytesOf(white));
        out.litRadiance = uploadTestImage(gpu(), "test/lit", VK_FORMAT_R32G32B32A32_SFLOAT, w, h, bytesOf(black));
        out.gbuffer.depth = asHostImage(out.depth);
        out.gbuffer.normal = asHostImage(out.normal);
        out.gbuffer.material = asHostImage(out.material);
        out.gbuffer.litRadiance = asHostImage(out.litRadiance);
        return out;
    }

    static Settings raySettings() {
        Settings settings;
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.transparents = 0;             // drawOpaque draws none
        settings.rays.environmentOcclusion = false; // what is drawn reflects the environment, hidden or not
        return settings;
    }

    static Differences compare(const scene::Scene& scene, const scene::Camera* camera, render::ShadowMode shadows) {
        const scene::Pose pose = must(scene::pose(scene, 0));
        render::RenderSettings settings;
        settings.lights.shadows = shadows;
        render::Renderer renderer = must(render::Renderer::create(
            gpu(), scene, pose, must(render::Environment::createSky(gpu(), 35, 0, 3)), settings));
        render::RayWorld world = must(
            render::RayWorld::create(gpu(), library(), renderer.scene(), scene, pose, renderer.lights(), GetParam()));
        run([&](VkCommandBuffer commands) { world.record(commands); });
        world.releaseStaging();
        must(renderer.setRayWorld(&world));
        must(renderer.resize(320, 180));
        render::ViewParameters parameters;
        parameters.camera = camera                 ? *camera
                            : pose.cameras.empty() ? scene::frameBounds(pose.boundsWS, 16.f / 9)
                                                   : pose.cameras.front();
        const render::View view = renderer.view(parameters);
        SyntheticGBuffer mirrors = passOn(view);

        Reflections reflections = must(Reflections::create(library(), {320, 180, raySettings(), true, true}));
        gpu::Image& cube = renderer.environment().radiance();
        EnvironmentMap environment = {asHostImage(cube), cube.desc().mips};
        environment.diffuse = asHostImage(renderer.environment().diffuse());
        must(reflections.setInputs(mirrors.gbuffer, environment));
        must(reflections.setRays(world.rays(), world.surfaces()));
        HostImage seen;
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            renderer.drawOpaque(frame, parameters);
            glint::View camera_;
            camera_.worldToView = toMatrix4(view.worldToView);
            camera_.viewToClip = toMatrix4(view.viewToClip);
            reflections.record(commands, camera_);
            seen = must(reflections.recordView(commands, "reflection"));
        });
        const std::vector<float> rays = download(gpu(), seen);
        const std::vector<float> raster = must(gpu::downloadImageAsFloats(gpu(), renderer.gbuffer().litRadiance));
        std::vector<double> differences;
        for (size_t i = 0; i < raster.size(); i += 4) {
            if (raster[i + 3] < 1 || !hasMirror(i / 4 % view.width, i / 4 / view.width))
                continue;
            double largest = 0;
            double difference = 0;
            for (size_t c = 0; c < 3; ++c) {
                largest = std::max(largest, double(raster[i + c]));
                difference = std::max(difference, std::abs(double(raster[i + c]) - double(rays[i + c])));
            }
            differences.push_back(difference / std::max(largest, 1e-3));
        }
        std::sort(differences.begin(), differences.end());
        const auto at = [&](double share) { return differences[size_t(share * double(differences.size() - 1))]; };
        Differences result = {differences.size(), at(0.5), at(0.95), at(0.99)};
        return result;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, RayShadingTest, testing::Values(RayBackend::Query, RayBackend::Bvh),
                         [](const auto& backend) { return backend.param == RayBackend::Query ? "query" : "bvh"; });

TEST_P(RayShadingTest, unshadowedHallLooksAsItIsDrawn) {
    const Differences found = compare(must(scene::builtinScene("hall")), nullptr, render::ShadowMode::None);
    EXPECT_LT(found.median, 0.003);
    EXPECT_LT(found.percentile95, 0.05);
}

TEST_P(RayShadingTest, shadowedSpheresLookAsTheyAreDrawn) {
    // Maps are soft where rays are sharp: at the borders of shadows the pictures part.
    const Differences found = compare(must(scene::builtinScene("spheres")), nullptr, render::ShadowMode::Maps);
    EXPECT_LT(found.median, 0.003);
    EXPECT_LT(found.percentile95, 0.12);
}

TEST_P(RayShadingTest, hallWithShadowsByRaysLooksAsItIsDrawn) {
    // Both are sharp, and every light casts them: the borders lie where they lie, but for pixels that they cross.
    const Differences found = compare(must(scene::builtinScene("hall")), nullptr, render::ShadowMode::Rays);
    EXPECT_LT(found.median, 0.003);
    EXPECT_LT(found.percentile95, 0.05);
}

} // namespace ray_shading_test
} // namespace glint::test
