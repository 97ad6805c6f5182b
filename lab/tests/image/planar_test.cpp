// --planar on whole scenes: flat mirrors show the same as rays, mirrors in mirrors too, and sources combine.
#include "base/file.hpp"
#include "lab/measure/figures/image_error.hpp"
#include "lab/measure/truth/job_exact.hpp"
#include "lab/tests/image/job_test.hpp"
#include "lab/tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace planar_test {

class PlanarTest : public JobTest {
protected:
    static render::RenderJob makeJob(const std::string& scene, const std::vector<std::string>& assignments,
                                     uint32_t width = 320, uint32_t height = 180) {
        render::RenderJob job;
        job.scene = scene;
        job.width = width;
        job.height = height;
        job.views = {"composite"};
        job.planar = render::MirrorSearch::Auto;
        job.settings = settingsOf(assignments);
        return job;
    }
    static const std::vector<float>& view(const render::RenderResult& result, const char* name) {
        const auto found = std::ranges::find(result.views, name, &render::RenderedView::name);
        EXPECT_NE(found, result.views.end()) << name;
        return found->rgba;
    }
};

/// A room of three striped emissive walls on a metal floor whose normals wave by `tilt` (a slope) and whose roughness
/// is `roughness`. Returns `path`.
std::string wavyRoom(const std::string& path, double tilt, double roughness) {
    GltfBuilder builder;
    Json nodes = Json::array();
    const auto add = [&](const std::vector<float>& positions, const std::vector<float>& normals,
                         const std::vector<uint16_t>& indices, const Json& material) {
        const Json attributes = {{"POSITION", builder.addAccessor("VEC3", positions)},
                                 {"NORMAL", builder.addAccessor("VEC3", normals)}};
        const int faces = builder.addAccessor("SCALAR", indices);
        const int look = builder.append("materials", material);
        const int mesh = builder.append(
            "meshes", {{"primitives", {{{"attributes", attributes}, {"indices", faces}, {"material", look}}}}});
        nodes.push_back(builder.append("nodes", {{"mesh", mesh}}));
    };
    constexpr int kCells = 48;
    std::vector<float> positions, normals;
    std::vector<uint16_t> indices;
    for (int z = 0; z <= kCells; ++z)
        for (int x = 0; x <= kCells; ++x) {
            const glm::vec3 at(-4 + 8.f * float(x) / kCells, 0, -4 + 8.f * float(z) / kCells);
            const glm::vec3 normal =
                glm::normalize(glm::vec3(tilt * std::sin(2 * at.x), 1, tilt * std::cos(1.5f * at.z)));
            for (int c = 0; c < 3; ++c) {
                positions.push_back(at[c]);
                normals.push_back(normal[c]);
            }
            const auto corner = [&](int dx, int dz) { return static_cast<uint16_t>((z + dz) * (kCells + 1) + x + dx); };
            if (x < kCells && z < kCells)
                for (const uint16_t i :
                     {corner(0, 0), corner(0, 1), corner(1, 0), corner(1, 0), corner(0, 1), corner(1, 1)})
                    indices.push_back(i);
        }
    add(positions, normals, indices,
        {{"extras", {{"glint", {{"planar", true}}}}},
         {"pbrMetallicRoughness", {{"metallicFactor", 1}, {"roughnessFactor", roughness}}}});
    const auto stripe = [&](const glm::vec3& from, const glm::vec3& along, const std::vector<float>& color) {
        const glm::vec3 up(0, 3, 0);
        std::vector<float> quad;
        for (const glm::vec3& corner : {from, from + along, from + along + up, from + up})
            quad.insert(quad.end(), {corner.x, corner.y, corner.z});
        const std::vector<float> facing = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
        add(quad, facing, {0, 1, 2, 0, 2, 3},
            {{"doubleSided", true},
             {"emissiveFactor", color},
             {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 0}}}});
    };
    for (int i = 0; i < 8; ++i) {
        const std::vector<float> color = {i % 2 == 0 ? 1.f : 0.1f, float(i) / 8, i % 3 == 0 ? 0.8f : 0.2f};
        stripe({-4 + float(i), 0, -4}, {1, 0, 0}, color);
        stripe({-4, 0, -4 + float(i)}, {0, 0, 1}, color);
        stripe({4, 0, -4 + float(i)}, {0, 0, 1}, color);
    }
    builder.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.9}, {"znear", 0.05}}}});
    nodes.push_back(builder.append(
        "nodes", {{"camera", 0}, {"translation", {0.3, 1.6, 3.6}}, {"rotation", {-0.1305, 0, 0, 0.9914}}}));
    builder.json["scenes"] = {{{"nodes", nodes}}};
    builder.json["scene"] = 0;
    const std::vector<uint8_t> bytes = builder.glb();
    EXPECT_TRUE(writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
    return path;
}

/// Errors on the mirror's pixels, against the image that rays make.
struct FloorError {
    double wrong = 0; ///< fraction whose error exceeds 0.1
    double rms = 0;
    double bias = 0; ///< mean of planar minus rays
};

/// Three mirrors at right angles, alone, against the exact image: seen directly, in each other, and once more.
TEST_F(PlanarTest, MirrorsInMirrorsAreRightAsDeepAsTheyAreDrawn) {
    for (const int depth : {1, 2, 3}) {
        const auto job =
            makeJob("builtin:exact", {"screen.enabled=false", "mirrors.depth=" + std::to_string(depth)}, 640, 360);
        const measure::MirrorError error = must(measure::measureExact(job, must(render::runJob(device(), job))));
        ASSERT_EQ(error.byBounces.size(), 3u);
        for (int bounce = 1; bounce <= 3; ++bounce) {
            const auto& of = error.byBounces[static_cast<size_t>(bounce) - 1];
            ASSERT_GT(of.pixels, 1000u);
            const double share = double(of.wrong) / double(of.pixels);
            if (bounce <= depth)
                EXPECT_LT(share, 0.02) << bounce << " bounces of " << depth; // measured: 0.3, 0.5 and 1.3 %
            else
                EXPECT_GT(share, 0.9) << bounce << " bounces of " << depth;
        }
    }
}

/// The bound for a mirror of roughness 0: 40 dB against rays.
TEST_F(PlanarTest, AFlatMirrorIsThePictureThatRaysMake) {
    for (const char* resolution : {"1", "0.5"}) {
        const std::vector<std::string> common = {"screen.enabled=false", "mirrors.reflections=false",
                                                 std::string("mirrors.resolution=") + resolution};
        std::vector<std::string> traced = common;
        traced.insert(traced.end(), {"planar.enabled=false", "rays.enabled=true"});
        const auto planar = must(render::runJob(device(), makeJob("builtin:mirror", common)));
        const auto rays = must(render::runJob(device(), makeJob("builtin:mirror", traced)));
        double squares = 0;
        for (size_t i = 0; i < view(rays, "composite").size(); ++i) {
            const double difference = double(view(planar, "composite")[i]) - double(view(rays, "composite")[i]);
            squares += difference * difference;
        }
        const double psnr = -10 * std::log10(squares / double(view(rays, "composite").size()));
        RecordProperty(std::string("psnr") + (std::string(resolution) == "1" ? "Full" : "Half"), std::to_string(psnr));
        EXPECT_GT(psnr, std::string(resolution) == "1" ? 40 : 25) << resolution; // measured: 67.9 and 29.4
    }
}

/// Bent rays are marched in the image's depth; rough rays sample it blurred.
TEST_F(PlanarTest, WavesAndRoughnessLookAsByRays) {
    const TempFolder folder;
    const auto errorOf = [&](double tilt, double roughness, int samples) {
        const std::string scene = wavyRoom(folder + "room.glb", tilt, roughness);
        auto planar = makeJob(scene, {"screen.enabled=false", "mirrors.reflections=false"}, 240, 135);
        auto rays = makeJob(scene,
                            {"screen.enabled=false", "planar.enabled=false", "rays.enabled=true",
                             "rays.samples=" + std::to_string(samples)},
                            240, 135);
        planar.views = rays.views = {"composite", "weightPlanar"};
        const auto drawn = must(render::runJob(device(), planar));
        const auto traced = must(render::runJob(device(), rays));
        FloorError error;
        double pixels = 0;
        for (size_t i = 0; i < view(drawn, "weightPlanar").size(); i += 4) {
            if (view(drawn, "weightPlanar")[i] < 0.99f)
                continue;
            double worst = 0;
            for (size_t c = 0; c < 3; ++c) {
                const double off = double(view(drawn, "composite")[i + c]) - double(view(traced, "composite")[i + c]);
                worst = std::max(worst, std::abs(off));
                error.rms += off * off / 3;
                error.bias += off / 3;
            }
            ++pixels;
            error.wrong += worst > 0.1 ? 1 : 0;
        }
        EXPECT_GT(pixels, 5000) << tilt << " " << roughness;
        return FloorError{error.wrong / pixels, std::sqrt(error.rms / pixels), error.bias / pixels};
    };
    const FloorError flat = errorOf(0, 0, 1);
    const FloorError waves = errorOf(0.05, 0, 1);
    const FloorError smooth = errorOf(0, 0.1, 32);
    const FloorError rough = errorOf(0, 0.3, 32);
    EXPECT_LT(flat.rms, 0.01);
    EXPECT_LT(waves.wrong, 0.10);
    EXPECT_LT(smooth.rms, 0.03);
    EXPECT_LT(rough.rms, 0.09);
    for (const FloorError& error : {flat, waves, smooth, rough})
        EXPECT_LT(std::abs(error.bias), 0.005);
}

/// Every combination of the five sources; none adds light: a pixel's weights sum to 1 at most.
TEST_F(PlanarTest, AnySourcesGoTogether) {
    auto job = makeJob("builtin:mirror", {}, 80, 45);
    job.environment = "sky";
    render::ReflectionSession session = must(render::openJob(device(), job));
    for (unsigned sources = 0; sources < 32; ++sources) {
        Settings& settings = job.settings.reflections;
        settings.screen.enabled = (sources & 1) != 0;
        settings.rays.enabled = (sources & 2) != 0;
        settings.planar.enabled = (sources & 4) != 0;
        settings.probes.enabled = (sources & 8) != 0;
        settings.sky.enabled = (sources & 16) != 0;
        ASSERT_TRUE(session.setSettings(job.settings)) << sources;
        ASSERT_TRUE(session.renderFrame(sources)) << sources;
        render::RenderResult result;
        for (const char* name : {"composite", "weights", "weightPlanar"})
            result.views.push_back(must(session.readView(name)));
        bool planar = false;
        for (size_t i = 0; i < view(result, "weights").size(); i += 4) {
            const float* const four = &view(result, "weights")[i];
            const float mirrored = view(result, "weightPlanar")[i];
            planar |= mirrored > 0;
            ASSERT_LE(four[0] + four[1] + four[2] + four[3] + mirrored, 1 + 2.5f / 1023) << sources;
            for (size_t c = 0; c < 4; ++c)
                ASSERT_TRUE(std::isfinite(view(result, "composite")[i + c])) << sources;
        }
        EXPECT_EQ(planar, (sources & 4) != 0) << sources; // it is asked first
    }
}

/// In the user's order planar comes before rays, and answers the pixels that it has images for.
TEST_F(PlanarTest, TheOrderDecidesWhoAnswers) {
    auto job = makeJob("builtin:mirror", {"rays.enabled=true", "order.planar=0"}, 160, 90);
    job.views = {"weightPlanar", "weightRays", "roughness"};
    const auto result = must(render::runJob(device(), job));
    double planar = 0, rays = 0;
    for (size_t i = 0; i < view(result, "weightPlanar").size(); i += 4) {
        planar += double(view(result, "weightPlanar")[i]);
        rays += double(view(result, "weightRays")[i]);
    }
    EXPECT_GT(planar, 1000);
    EXPECT_LT(rays, 0.05 * planar);
}

TEST_F(PlanarTest, OddSizesSeveralSamplesAndModesWork) {
    for (const std::vector<std::string>& assignments :
         {std::vector<std::string>{"display.antialias=msaa4"},
          {"gbuffer.mode=geometry"},
          {"gbuffer.mode=geometry", "display.antialias=msaa4"},
          {"mirrors.resolution=0.05"},
          {"screen.thicknessMode=backface", "screen.backfaceDownsample=2"}}) {
        for (const auto& [width, height] : {std::pair(1u, 1u), std::pair(17u, 9u), std::pair(64u, 37u)}) {
            const auto result = must(render::runJob(device(), makeJob("builtin:exact", assignments, width, height)));
            for (const float value : view(result, "composite"))
                ASSERT_TRUE(std::isfinite(value)) << assignments[0];
        }
    }
}

} // namespace planar_test
} // namespace glint::test
