// glint bake and --probes on whole scenes: probes show the scene, and a file of another scene is rejected.
#include "base/file.hpp"
#include "lab/measure/truth/job_hits.hpp"
#include "lab/session/bake_job.hpp"
#include "lab/sources/probe_world.hpp"
#include "lab/tests/image/job_test.hpp"
#include "lab/tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <glm/gtc/packing.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace glint::test {
namespace probes_test {

class BakedProbesTest : public JobTest {
protected:
    static render::RenderJob makeJob(const std::string& scene, const std::vector<std::string>& assignments) {
        render::RenderJob job;
        job.scene = scene;
        job.width = 160;
        job.height = 90;
        job.views = {"reflection", "roughness", "weightProbes"};
        job.display = true;
        job.settings = settingsOf(assignments);
        return job;
    }
    static std::string errorOf(const render::RenderJob& job) {
        const auto result = render::runJob(device(), job);
        if (result)
            return "";
        EXPECT_EQ(result.error().code, ErrorCode::InvalidInput); // exit code 2
        return result.error().message;
    }
};

/// Mean difference of two reflection images as displayed, over smooth surfaces.
double difference(const render::RenderResult& a, const render::RenderResult& b) {
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < a.views[0].rgb8.size(); ++i) {
        const float roughness = a.views[1].rgba[i / 3 * 4];
        if (roughness > 0.25f || roughness == 0)
            continue;
        sum += std::abs(int(a.views[0].rgb8[i]) - int(b.views[0].rgb8[i]));
        ++count;
    }
    return count == 0 ? 0 : sum / static_cast<double>(count);
}

TEST_F(BakedProbesTest, aHallIsReflectedFromAFileAlmostAsByRays) {
    const TempFolder folder;
    const std::string file = folder + "hall.probes";
    render::BakeOptions options;
    options.most = 3;
    options.faceSize = 64;
    const render::RenderJob sky = makeJob("builtin:hall", {"screen.enabled=false"});
    const render::ProbeSet set = must(render::runBakeJob(device(), sky, options));
    ASSERT_GE(set.probes.size(), 1u);
    ASSERT_TRUE(writeFile(file, render::encodeProbes(set)));

    render::RenderJob probes = sky;
    probes.probes = file;
    const render::RenderJob rays =
        makeJob("builtin:hall", {"screen.enabled=false", "rays.enabled=true", "rays.lobe=mirror", "rays.bounces=1"});
    const render::RenderResult exact = must(render::runJob(device(), rays));
    const render::RenderResult looked = must(render::runJob(device(), probes));
    const double withProbes = difference(looked, exact);
    const double withSky = difference(must(render::runJob(device(), sky)), exact);
    RecordProperty("withProbes", std::to_string(withProbes));
    RecordProperty("withSky", std::to_string(withSky));
    EXPECT_LT(withProbes, 0.75 * withSky);
    double most = 0;
    for (size_t i = 0; i < looked.views[2].rgba.size(); i += 4)
        most = std::max<double>(most, looked.views[2].rgba[i]);
    EXPECT_EQ(most, 1);

    // Another light, another scene, a damaged file, no file.
    render::RenderJob other = probes;
    other.settings.render.environment.strength = 3;
    EXPECT_THAT(errorOf(other), testing::HasSubstr("another light"));
    other = makeJob("builtin:mirror", {});
    other.probes = file;
    EXPECT_THAT(errorOf(other),
                testing::AllOf(testing::HasSubstr("builtin:hall"), testing::HasSubstr("another scene")));
    std::filesystem::resize_file(file, 1000);
    EXPECT_THAT(errorOf(probes), testing::HasSubstr("bytes of probes"));
    probes.probes = folder + "none.probes";
    const auto missing = render::runJob(device(), probes);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
}

/// A red wall before +X, a green one before -X, a blue one before +Z and a yellow floor that reflects a little.
std::string colouredRoom(const std::string& path) {
    GltfBuilder builder;
    const auto quad = [&](const std::vector<float>& corners, const std::vector<float>& color, float metallic) {
        const std::vector<uint16_t> indices = {0, 1, 2, 0, 2, 3};
        const int positions = builder.addAccessor("VEC3", corners);
        const int faces = builder.addAccessor("SCALAR", indices);
        const int material = builder.append(
            "materials",
            {{"doubleSided", true},
             {"emissiveFactor", metallic > 0 ? std::vector<float>{0, 0, 0} : color},
             {"pbrMetallicRoughness",
              {{"baseColorFactor", metallic > 0 ? std::vector<float>{1, 1, 1, 1} : std::vector<float>{0, 0, 0, 1}},
               {"metallicFactor", metallic},
               {"roughnessFactor", metallic > 0 ? 0.05 : 1.0}}}});
        const int mesh = builder.append(
            "meshes", {{"primitives",
                        {{{"attributes", {{"POSITION", positions}}}, {"indices", faces}, {"material", material}}}}});
        builder.append("nodes", {{"mesh", mesh}});
    };
    quad({2, 0, -3, 2, 0, 3, 2, 3, 3, 2, 3, -3}, {1, 0, 0}, 0);
    quad({-2, 0, -3, -2, 3, -3, -2, 3, 3, -2, 0, 3}, {0, 1, 0}, 0);
    quad({-2, 0, 3, -2, 3, 3, 2, 3, 3, 2, 0, 3}, {0, 0, 1}, 0);
    quad({-2, 0, -3, -2, 0, 3, 2, 0, 3, 2, 0, -3}, {1, 1, 0}, 1);
    builder.json["scenes"] = {{{"nodes", {0, 1, 2, 3}}}};
    builder.json["scene"] = 0;
    const std::vector<uint8_t> bytes = builder.glb();
    EXPECT_TRUE(writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
    return path;
}

/// The room's radiance in a direction; black through its open side and above. Its floor has nothing to reflect.
glm::vec3 wallSeen(const glm::dvec3& from, const glm::dvec3& direction) {
    const glm::dvec3 toX = from + direction * (((direction.x > 0 ? 2 : -2) - from.x) / direction.x);
    if (direction.x != 0 && toX.y > 0 && toX.y < 3 && std::abs(toX.z) < 3)
        return direction.x > 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::dvec3 toZ = from + direction * ((3 - from.z) / direction.z);
    if (direction.z > 0 && toZ.y > 0 && toZ.y < 3 && std::abs(toZ.x) < 2)
        return {0, 0, 1};
    return glm::vec3(0);
}

/// Vulkan 1.3, "Cube Map Face Selection".
glm::dvec3 cubeDirection(uint32_t face, double a, double b) {
    const glm::dvec3 directions[] = {{1, -b, -a}, {-1, -b, a}, {a, 1, b}, {a, -1, -b}, {a, -b, 1}, {-a, -b, -1}};
    return directions[face];
}

/// A camera that looks into the room from its open side.
render::RenderJob lookInto(const TempFolder& folder, render::RenderJob job) {
    job.camera = folder + "camera.json";
    EXPECT_TRUE(writeFile(job.camera, R"({"position": [0.3, 2.5, -6], "target": [0, 0.5, 0], "fovY": 40})"));
    job.environment = "none";
    return job;
}

TEST_F(BakedProbesTest, everyFaceShowsItsOwnSide) {
    const TempFolder folder;
    const std::string scene = colouredRoom(folder + "room.glb");
    const render::RenderJob job = lookInto(folder, makeJob(scene, {"screen.enabled=false"}));
    render::BakeOptions options;
    options.most = 1;
    options.faceSize = 32;
    options.bounces = 1;
    const render::ProbeSet set = must(render::runBakeJob(device(), job, options));
    ASSERT_EQ(set.probes.size(), 1u);
    const render::BakedProbe& baked = set.probes[0];
    const auto& at = baked.probe.capturePositionWS;
    size_t compared = 0;
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < 32; ++y)
            for (uint32_t x = 0; x < 32; ++x) {
                const auto through = [&](double u, double v) {
                    return wallSeen({at[0], at[1], at[2]}, cubeDirection(face, (x + u) / 16 - 1, (y + v) / 16 - 1));
                };
                const glm::vec3 wanted = through(0.5, 0.5);
                if (through(-0.3, -0.3) != wanted || through(1.3, -0.3) != wanted || through(-0.3, 1.3) != wanted ||
                    through(1.3, 1.3) != wanted)
                    continue; // an edge runs through the texel
                const glm::vec3 found(glm::unpackHalf4x16(baked.texels[(size_t{face} * 32 + y) * 32 + x]));
                ASSERT_LT(glm::length(found - wanted), 0.05) << "face " << face << " at " << x << ", " << y;
                ++compared;
            }
    EXPECT_GT(compared, 4500u); // of 6144
    // The proxy's walls are the room's walls.
    const ProbeVolume& proxy = baked.probe.proxyVolume;
    EXPECT_NEAR(proxy.centerWS[0] + proxy.halfExtents[0], 2, 0.1);
    EXPECT_NEAR(proxy.centerWS[0] - proxy.halfExtents[0], -2, 0.1);
    EXPECT_NEAR(proxy.centerWS[2] + proxy.halfExtents[2], 3, 0.1);
}

TEST_F(BakedProbesTest, marchProxyFindsTheRoomByItsBakedProxy) {
    const TempFolder folder;
    render::RenderJob job =
        lookInto(folder, makeJob(colouredRoom(folder + "room.glb"), {"screen.march=proxy", "probes.enabled=false"}));
    job.width = 640;
    job.height = 360;
    job.probes = folder + "room.probes";
    render::BakeOptions options;
    options.most = 1;
    options.faceSize = 64;
    options.bounces = 1;
    const render::ProbeSet set = must(render::runBakeJob(device(), job, options));
    ASSERT_TRUE(writeFile(job.probes, render::encodeProbes(set)));
    const render::RenderJob measured = measure::hitJob(job);
    const measure::HitFigures hits = must(measure::measureHits(measured, must(render::runJob(device(), measured)))).all;
    EXPECT_GT(hits.visibleTruths, 10000u);
    EXPECT_GT(hits.precision(), 0.98);
    EXPECT_GT(hits.recall(), 0.98);
    EXPECT_LT(hits.positionErrorMedian, 1);
    EXPECT_LE(hits.lookupsMean, 1);
    RecordProperty("precision", std::to_string(hits.precision()));
    RecordProperty("recall", std::to_string(hits.recall()));
    RecordProperty("positionErrorMedian", std::to_string(hits.positionErrorMedian));
    RecordProperty("positionError95", std::to_string(hits.positionError95));
    RecordProperty("lookupsMean", std::to_string(hits.lookupsMean));
}

TEST_F(BakedProbesTest, placesAreTakenAsTheyAreGiven) {
    const TempFolder folder;
    const std::string scene = colouredRoom(folder + "room.glb");
    const render::RenderJob job = lookInto(folder, makeJob(scene, {"screen.enabled=false"}));
    render::BakeOptions options;
    options.faceSize = 16;
    options.bounces = 1;
    options.places = must(render::parseProbePlaces(
        R"({"probes": [{"position": [0.5, 1, 1], "influence": {"center": [0, 1, 0], "halfExtents": [3, 3, 4]}},
                       {"position": [0, 2, 0], "influence": {"shape": "sphere", "center": [0, 1, 0], "radius": 2},
                        "proxy": {"shape": "none"}}]})",
        "places"));
    const render::ProbeSet set = must(render::runBakeJob(device(), job, options));
    ASSERT_EQ(set.probes.size(), 2u);
    EXPECT_EQ(set.probes[0].probe.capturePositionWS, (std::array<float, 3>{0.5f, 1, 1}));
    const ProbeVolume& proxy = set.probes[0].probe.proxyVolume; // fitted to the room
    EXPECT_NEAR(proxy.centerWS[0] + proxy.halfExtents[0], 2, 0.1);
    EXPECT_NEAR(proxy.centerWS[1] - proxy.halfExtents[1], 0, 0.1);
    EXPECT_EQ(set.probes[1].probe.shape, ProbeShape::Sphere);
    EXPECT_EQ(set.probes[1].probe.proxy, ProbeProxy::Infinite);
    options.places[1].probe.influence.rotation = {1, 1, 1, 1};
    const auto wrong = render::runBakeJob(device(), job, options);
    ASSERT_FALSE(wrong);
    EXPECT_THAT(wrong.error().message, testing::HasSubstr("probe 1"));
}

TEST_F(BakedProbesTest, aSceneThatReflectsNothingGetsNone) {
    const TempFolder folder;
    render::RenderJob job = lookInto(folder, makeJob(colouredRoom(folder + "room.glb"), {}));
    ASSERT_TRUE(
        writeFile(job.camera, R"({"position": [0, 2, -6], "target": [0, 2, -20], "fovY": 40})")); // away from the room
    const render::ProbeSet set = must(render::runBakeJob(device(), job, {}));
    EXPECT_TRUE(set.probes.empty());
    const render::RenderResult without = must(render::runJob(device(), job));
    job.probes = folder + "none.probes";
    ASSERT_TRUE(writeFile(job.probes, render::encodeProbes(set)));
    EXPECT_EQ(must(render::runJob(device(), job)).views[0].rgba, without.views[0].rgba);
}

TEST_F(BakedProbesTest, autoTakesTheFileBesideTheSceneOrBakes) {
    const TempFolder folder;
    const std::string scene = colouredRoom(folder + "room.glb");
    render::RenderJob job = lookInto(folder, makeJob(scene, {"screen.enabled=false"}));
    job.probes = "auto";
    const render::RenderResult baked = must(render::runJob(device(), job));
    render::BakeOptions coarse; // distinguishes these from the probes that auto bakes
    coarse.most = 1;
    coarse.faceSize = 16;
    const render::ProbeSet set = must(render::runBakeJob(device(), job, coarse));
    const std::string beside = render::probeFileFor(scene);
    EXPECT_EQ(beside, scene + ".probes");
    ASSERT_TRUE(writeFile(beside, render::encodeProbes(set)));
    render::RenderJob named = job;
    named.probes = beside;
    const render::RenderResult read = must(render::runJob(device(), job));
    EXPECT_EQ(read.views[0].rgba, must(render::runJob(device(), named)).views[0].rgba);
    EXPECT_NE(read.views[0].rgba, baked.views[0].rgba);
    ASSERT_TRUE(writeFile(beside, "GLINTPRB damaged"));
    EXPECT_EQ(must(render::runJob(device(), job)).views[0].rgba, baked.views[0].rgba);
}

} // namespace probes_test
} // namespace glint::test
