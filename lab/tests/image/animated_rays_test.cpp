// Scenes that move while rays are traced through them: the ray scene is refitted to the new pose, and gives the same
// image as a ray scene built for that pose.
#include "base/file.hpp"
#include "lab/tests/image/job_test.hpp"
#include "lab/tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint::test {
namespace animated_rays_test {

/// A mirror floor, a square that moves over it, and a square whose upper corners are pulled sideways (a morph target).
std::string movingScene(const std::string& path) {
    GltfBuilder builder;
    const std::vector<uint16_t> faces = {0, 1, 2, 0, 2, 3};
    const int indices = builder.addAccessor("SCALAR", faces);
    const auto mesh = [&](const std::vector<float>& corners, const Json& material, const Json& more) {
        Json primitive = {{"attributes", {{"POSITION", builder.addAccessor("VEC3", corners)}}},
                          {"indices", indices},
                          {"material", builder.append("materials", material)}};
        primitive.update(more);
        return builder.append("meshes", {{"primitives", {primitive}}});
    };
    const auto glowing = [](const std::vector<float>& color) {
        return Json{{"doubleSided", true},
                    {"emissiveFactor", color},
                    {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 0}}}};
    };
    const int floor = mesh({-3, 0, 3, 3, 0, 3, 3, 0, -3, -3, 0, -3},
                           {{"pbrMetallicRoughness", {{"metallicFactor", 1}, {"roughnessFactor", 0}}}}, Json::object());
    const std::vector<float> square = {-0.5f, 0.2f, 0, 0.5f, 0.2f, 0, 0.5f, 1.2f, 0, -0.5f, 1.2f, 0};
    const int carried = mesh(square, glowing({1, 0.2f, 0.1f}), Json::object());
    const std::vector<float> pull = {0, 0, 0, 0, 0, 0, 0.8f, 0.4f, -0.5f, 0.8f, 0, -0.5f};
    const int morphed = mesh(square, glowing({0.1f, 0.3f, 1}),
                             {{"targets", Json::array({{{"POSITION", builder.addAccessor("VEC3", pull)}}})}});
    builder.json["meshes"][morphed]["weights"] = {0};
    const int first = builder.append("nodes", {{"mesh", floor}});
    const int second = builder.append("nodes", {{"mesh", carried}, {"translation", {-1.2, 0, 0}}});
    const int third = builder.append("nodes", {{"mesh", morphed}, {"translation", {0.9, 0, -0.5}}});
    builder.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.05}}}});
    const int camera =
        builder.append("nodes", {{"camera", 0}, {"translation", {0, 1.5, 4}}, {"rotation", {-0.1305, 0, 0, 0.9914}}});
    const int times = builder.addAccessor("SCALAR", std::vector<float>{0, 1});
    builder.json["accessors"][times]["min"] = {0};
    builder.json["accessors"][times]["max"] = {1};
    const int moves = builder.addAccessor("VEC3", std::vector<float>{-1.2f, 0, 0, -0.2f, 0.4f, 0.5f});
    const int weights = builder.addAccessor("SCALAR", std::vector<float>{0, 1});
    builder.append("animations",
                   {{"samplers", {{{"input", times}, {"output", moves}}, {{"input", times}, {"output", weights}}}},
                    {"channels",
                     {{{"sampler", 0}, {"target", {{"node", second}, {"path", "translation"}}}},
                      {{"sampler", 1}, {"target", {{"node", third}, {"path", "weights"}}}}}}});
    builder.json["scenes"] = {{{"nodes", {first, second, third, camera}}}};
    builder.json["scene"] = 0;
    const std::vector<uint8_t> bytes = builder.glb();
    EXPECT_TRUE(writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
    return path;
}

class AnimatedRaysTest : public JobTest, public testing::WithParamInterface<const char*> {
protected:
    void SetUp() override {
        if (std::string(GetParam()) == "query" && !device().info().rayQuery)
            GTEST_SKIP() << device().info().name << " has no ray query";
        JobTest::SetUp();
    }
    static std::vector<float> picture(render::ReflectionSession& session) {
        EXPECT_TRUE(session.renderFrame(0));
        return must(session.readView("composite")).rgba;
    }
};

TEST_P(AnimatedRaysTest, aPoseLaterIsAsIfMadeForIt) {
    const TempFolder folder;
    render::RenderJob job;
    job.scene = movingScene(folder + "moving.glb");
    job.width = 160;
    job.height = 90;
    job.views = {"composite"};
    // Paths end in the environment: where they end in the previous frame, the two differ by what frames they had
    // before.
    job.settings = settingsOf({"screen.enabled=false", "rays.enabled=true", "lights.shadows=rays",
                               "rays.environmentOcclusion=false", std::string("rays.backend=") + GetParam()});
    render::ReflectionSession moved = must(render::openJob(device(), job));
    std::vector<float> before = picture(moved);
    for (const double time : {0.4, 1.0, 0.0, 0.7}) {
        ASSERT_TRUE(moved.setTime(time));
        const std::vector<float> later = picture(moved);
        job.time = time;
        render::ReflectionSession made = must(render::openJob(device(), job));
        const std::vector<float> expected = picture(made);
        ASSERT_EQ(later.size(), expected.size());
        size_t different = 0;
        for (size_t i = 0; i < later.size(); i += 4)
            different += std::equal(&later[i], &later[i] + 4, &expected[i]) ? 0 : 1;
        EXPECT_LE(different, later.size() / 4 / 1000) << time; // where a ray hits two triangles at the same distance
        EXPECT_NE(later, before) << time;                      // the test detects motion
        before = later;
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, AnimatedRaysTest, testing::Values("query", "bvh"));

} // namespace animated_rays_test
} // namespace glint::test
