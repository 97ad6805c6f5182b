// How the G-buffer is drawn, and how edges are smoothed.
#include "lab/tests/render/support/render_test.hpp"

#include "lab/session/run_job.hpp"

#include "base/file.hpp"
#include "tests/support/temp_folder.hpp"

#include <algorithm>

namespace glint::test {
namespace antialias_test {

class AntialiasTest : public RenderTest {
protected:
    static render::GBufferOptions options(GBufferMode mode, uint32_t samples) {
        render::GBufferOptions result;
        result.mode = mode;
        result.samples = samples;
        return result;
    }

    static glm::mat4 turned(float angle) { return glm::rotate(glm::mat4(1), angle, glm::vec3(0, 0, 1)); }

    /// A finished picture in 8 bits, through the whole program.
    static Picture render(const std::string& scene, const std::vector<std::string>& settings, uint32_t width,
                          uint32_t height, const std::string& camera = {}, const std::string& environment = {},
                          uint32_t frames = 1) {
        ::glint::render::RenderJob job;
        job.scene = scene;
        job.camera = camera;
        job.environment = environment;
        job.width = width;
        job.height = height;
        job.views = {"composite"};
        job.display = true;
        job.frames = frames;
        job.settings = must(::glint::render::loadSettings({{}, "", "", settings}));
        const ::glint::render::RenderResult result = must(::glint::render::runJob(gpu(), job));
        Picture picture{result.width, result.height, {}};
        for (size_t i = 0; i < result.views[0].rgb8.size(); ++i) {
            picture.texels.push_back(float(result.views[0].rgb8[i]) / 255);
            if (i % 3 == 2)
                picture.texels.push_back(1);
        }
        return picture;
    }

    /// Each pixel the mean of 4 x 4, of linear colours.
    static Picture shrunk(const Picture& large) {
        Picture picture{large.width / 4, large.height / 4, {}};
        for (uint32_t y = 0; y < picture.height; ++y)
            for (uint32_t x = 0; x < picture.width; ++x) {
                glm::vec4 sum(0);
                for (uint32_t i = 0; i < 16; ++i)
                    sum += large.at(x * 4 + i % 4, y * 4 + i / 4);
                for (int c = 0; c < 4; ++c)
                    picture.texels.push_back(sum[c] / 16);
            }
        return picture;
    }

    static Picture linear(Picture picture) {
        for (float& value : picture.texels)
            value = value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
        return picture;
    }

    static double error(const Picture& a, const Picture& b) {
        double sum = 0;
        for (size_t i = 0; i < a.texels.size(); ++i)
            sum += glm::pow(double(a.texels[i]) - double(b.texels[i]), 2.0);
        return std::sqrt(sum / double(a.texels.size()));
    }

    static double meanError(const Picture& a, const Picture& b) {
        double sum = 0;
        for (size_t i = 0; i < a.texels.size(); ++i)
            sum += std::abs(double(a.texels[i]) - double(b.texels[i]));
        return sum / double(a.texels.size());
    }
};

TEST_F(AntialiasTest, BothModesDrawTheSameBits) {
    SceneParts parts;
    scene::Material masked = metal(0.3f, {1, 0.5f, 0.2f});
    masked.alphaMode = scene::AlphaMode::Mask;
    masked.doubleSided = true;
    parts.add(ball(1), metal(0.2f));
    parts.add(square(1), matte({0.2f, 0.5f, 0.8f}), glm::translate(glm::mat4(1), glm::vec3(0.7f, 0.4f, -0.5f)));
    parts.add(square(0.8f), masked, glm::rotate(glm::mat4(1), 0.8f, glm::vec3(1, 1, 0)));
    scene::Material coated = metal(0.5f);
    coated.clearcoatFactor = 1;
    parts.add(ball(0.6f), coated, glm::translate(glm::mat4(1), glm::vec3(-1, -1, 1)));
    const auto sky = environmentPicture(64, [](const glm::vec3& d) { return glm::abs(d) * 3.0f; });
    render::ViewParameters view{orthographicCamera(4), {}, {}, {}};
    view.prevCamera = view.camera;
    view.prevCamera->viewToWorld[3].x += 0.2f;
    const Frame prepass = draw(parts, view, 65, 49, sky);
    const Frame geometry = draw(parts, view, 65, 49, sky, {}, options(GBufferMode::Geometry, 1));
    EXPECT_EQ(prepass.lit.texels, geometry.lit.texels);
    EXPECT_EQ(prepass.depth.texels, geometry.depth.texels);
    EXPECT_EQ(prepass.normal.texels, geometry.normal.texels);
    EXPECT_EQ(prepass.material.texels, geometry.material.texels);
    EXPECT_EQ(prepass.fallback.texels, geometry.fallback.texels);
    EXPECT_EQ(prepass.motion.texels, geometry.motion.texels);
}

TEST_F(AntialiasTest, TheModeDecidesWhichPassesRun) {
    for (const bool geometry : {false, true}) {
        ::glint::render::RenderJob job;
        job.scene = "builtin:mirror";
        job.width = job.height = 16;
        job.settings = must(
            ::glint::render::loadSettings({{}, "", "", {geometry ? "gbuffer.mode=geometry" : "gbuffer.mode=prepass"}}));
        const auto result = must(::glint::render::runJob(gpu(), job));
        const auto ran = [&](const char* name) {
            return std::any_of(result.stats.passes.begin(), result.stats.passes.end(),
                               [&](const auto& pass) { return pass.first == name; });
        };
        EXPECT_EQ(ran("render/geometry"), geometry);
        EXPECT_EQ(ran("render/shading"), geometry);
        EXPECT_EQ(ran("render/surface"), !geometry);
    }
}

TEST_F(AntialiasTest, SamplesMeasureCoverage) {
    // A white square turned by 30 degrees: along its edges every pixel is as bright as its covered part, in quarters.
    SceneParts parts;
    parts.add(square(1), emissive(glm::vec3(1)), turned(0.5236f));
    const render::ViewParameters view{orthographicCamera(4), {}, {}, {}};
    const Picture one = draw(parts, view, 64, 64).lit;
    for (const GBufferMode mode : {GBufferMode::Prepass, GBufferMode::Geometry}) {
        const Frame frame = draw(parts, view, 64, 64, {}, {}, options(mode, 4));
        uint32_t between = 0;
        float area = 0;
        for (size_t i = 0; i < frame.lit.texels.size(); i += 4) {
            const float value = frame.lit.texels[i];
            ASSERT_EQ(value * 4, std::round(value * 4));
            between += value > 0 && value < 1;
            area += value * (4.0f / 64) * (4.0f / 64);
        }
        EXPECT_GT(between, 60u);
        EXPECT_NEAR(area, 4, 0.03f);
        EXPECT_EQ(frame.lit.center(), glm::vec3(1));
        EXPECT_EQ(frame.depth.texels.empty(), mode == GBufferMode::Prepass) << "the prepass keeps all samples";
    }
    for (size_t i = 0; i < one.texels.size(); i += 4)
        ASSERT_EQ(one.texels[i], std::round(one.texels[i]));
}

TEST_F(AntialiasTest, TransparentEdgesAreSmoothToo) {
    scene::Material pane = emissive(glm::vec3(1));
    pane.alphaMode = scene::AlphaMode::Blend;
    pane.baseColorFactor.a = 0.5f;
    SceneParts parts;
    parts.add(square(1.5f), emissive(glm::vec3(0, 0.5f, 0)), glm::translate(turned(0.3f), glm::vec3(0, 0, -1)));
    parts.add(square(1), pane, turned(0.5236f));
    const render::ViewParameters view{orthographicCamera(4), {}, {}, {}};
    for (const GBufferMode mode : {GBufferMode::Prepass, GBufferMode::Geometry}) {
        const Picture lit = draw(parts, view, 64, 64, {}, {}, options(mode, 4)).lit;
        EXPECT_EQ(lit.center(), glm::vec3(0.5f, 0.75f, 0.5f));
        uint32_t between = 0;
        for (size_t i = 0; i < lit.texels.size(); i += 4) {
            ASSERT_EQ(lit.texels[i] * 8, std::round(lit.texels[i] * 8));
            between += lit.texels[i] > 0 && lit.texels[i] < 0.5f;
        }
        EXPECT_GT(between, 60u);
    }
}

TEST_F(AntialiasTest, EveryKindIsNearerToManyPixels) {
    const TempFolder temp;
    const std::string path = temp + "camera.json";
    must(writeFile(path, R"({"position": [1, 2.2, 5], "target": [0, 0.3, -1], "orthoHeight": 4})"));
    for (const std::string& camera : {std::string(), path})
        for (const bool reflections : {false, true}) {
            SCOPED_TRACE((camera.empty() ? "perspective" : "orthographic") +
                         std::string(reflections ? ", with reflections" : ", the host alone"));
            std::vector<std::string> sets = {"display.tonemap=none"};
            if (!reflections)
                sets.emplace_back("screen.enabled=false");
            const Picture truth = shrunk(render("builtin:mirror", sets, 480, 272, camera));
            const auto drawn = [&](const std::string& antialias, const std::string& mode) {
                std::vector<std::string> all = sets;
                all.insert(all.end(), {"display.antialias=" + antialias, "gbuffer.mode=" + mode});
                return render("builtin:mirror", all, 120, 68, camera);
            };
            const Picture none = drawn("none", "prepass");
            EXPECT_GT(error(none, truth), 0.02);
            EXPECT_LT(error(drawn("fxaa", "prepass"), truth), error(none, truth) * (reflections ? 0.95 : 0.99));
            // One ray a pixel at this size and at four times this size do not hit the same: the host's own edges tell
            // how smooth the samples are, the reflections that nothing is undone by them. A mirror shows one surface of
            // an edge, and where that is the other one, a pixel is wholly wrong: the mean of squares tells little else.
            for (const char* mode : {"prepass", "geometry"}) {
                const Picture samples = drawn("msaa4", mode);
                if (reflections)
                    EXPECT_LT(meanError(samples, truth), meanError(none, truth));
                else
                    EXPECT_LT(error(samples, truth), error(none, truth) * 0.8);
            }
        }
}

/// What a frame shows is smooth as a whole: edges in mirrors as those of the host.
TEST_F(AntialiasTest, AccumulatedFramesAreNearerToManyPixels) {
    const std::vector<std::string> sets = {"display.tonemap=none", "denoise.enabled=false"};
    const auto drawn = [&](const std::string& antialias, uint32_t frames) {
        std::vector<std::string> all = sets;
        all.push_back("display.antialias=" + antialias);
        return linear(render("builtin:mirror", all, 120, 68, {}, {}, frames));
    };
    const Picture truth = shrunk(linear(render("builtin:mirror", sets, 480, 272)));
    const Picture none = drawn("none", 1);
    // Measured 0.52: at this size textures are blurred more, and no mean of its pixels has the larger one's details.
    EXPECT_LT(error(drawn("accumulate", 16), truth), 0.6 * error(none, truth));
    EXPECT_EQ(drawn("accumulate", 1).texels, none.texels);
    EXPECT_EQ(drawn("accumulate", 2).texels, none.texels) << "neither the first nor the last frame is shifted";
}

TEST_F(AntialiasTest, AccumulatedFramesOfGlassConverge) {
    const auto drawn = [](const std::string& antialias, uint32_t frames) {
        return linear(render("builtin:glass", {"denoise.enabled=false", "display.antialias=" + antialias}, 96, 54, {},
                             {}, frames));
    };
    const Picture truth = drawn("accumulate", 48);
    EXPECT_LT(error(drawn("accumulate", 16), truth), 0.3 * error(drawn("none", 1), truth));
}

TEST_F(AntialiasTest, LayersOfGlassAreSmoothToo) {
    // Nothing but the balls' and cubes' outlines: with an index of 1 and no reflections they only absorb.
    const std::vector<std::string> sets = {"display.tonemap=none",          "screen.enabled=false",
                                           "refraction.reflections=false",  "refraction.ior=1",
                                           "refraction.thickness=0.5",      "refraction.absorptionDistance=0.2",
                                           "refraction.transmittanceRed=0", "refraction.transmittanceGreen=0.5",
                                           "refraction.transmittanceBlue=0"};
    const TempFolder temp;
    const std::string balls = temp + "camera.json"; // along a row of balls: most edges are those of one before another
    must(writeFile(balls, R"({"position": [5.5, 1.4, 3.2], "target": [-0.3, 1.07, 0], "fovY": 7})"));
    // With stepped edges between balls the second would be 0.9.
    for (const auto& [camera, most] : {std::pair{std::string(), 0.8}, std::pair{balls, 0.84}}) {
        const Picture truth = shrunk(render("builtin:glass", sets, 480, 272, camera));
        const auto errorOf = [&](const std::string& antialias, const std::string& mode) {
            std::vector<std::string> all = sets;
            all.insert(all.end(), {"display.antialias=" + antialias, "gbuffer.mode=" + mode});
            return error(render("builtin:glass", all, 120, 68, camera), truth);
        };
        const double none = errorOf("none", "prepass");
        EXPECT_LT(errorOf("msaa4", "prepass"), most * none) << camera;
        EXPECT_LT(errorOf("msaa4", "geometry"), most * none) << camera;
    }
}

TEST_F(AntialiasTest, FxaaSmoothsSlantsAndLeavesTheRest) {
    // Dark left of a steep line, bright right of it: what a pixel should be is the part of it that lies right.
    constexpr uint32_t kSize = 64;
    const auto lineAt = [](float y) { return 20 + y * 0.31f; };
    std::vector<glm::vec4> texels;
    std::vector<float> covered;
    for (uint32_t y = 0; y < kSize; ++y)
        for (uint32_t x = 0; x < kSize; ++x) {
            texels.emplace_back(glm::vec3(float(x) + 0.5f > lineAt(float(y) + 0.5f) ? 1.0f : 0.0f), 1);
            covered.push_back(std::clamp(float(x) + 1 - lineAt(float(y) + 0.5f), 0.0f, 1.0f));
        }
    const auto make = [&](VkFormat format, VkImageUsageFlags usage) {
        return must(
            gpu::Image::create(gpu(), {"test/display", format, kSize, kSize, 1, 1, gpu::ImageShape::Flat, usage}));
    };
    gpu::Image hdr = make(VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    gpu::Image ldr = make(VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    must(gpu::uploadImage(gpu(), hdr, std::as_bytes(std::span(texels))));
    render::DisplayPass pass = must(render::DisplayPass::create(gpu()));
    const auto show = [&](render::Antialias antialias) {
        render::DisplaySettings settings;
        settings.tonemap = render::Tonemap::None;
        settings.antialias = antialias;
        must(pass.resize(gpu(), kSize, kSize, settings));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            pass.draw(frame, hdr, ldr, settings);
        });
        return Picture{kSize, kSize, must(gpu::downloadImageAsFloats(gpu(), ldr))};
    };
    const Picture aliased = show(render::Antialias::None);
    const Picture smooth = show(render::Antialias::Fxaa);
    double before = 0;
    double after = 0;
    for (uint32_t y = 8; y < kSize - 8; ++y)
        for (uint32_t x = 0; x < kSize; ++x) {
            const size_t i = size_t{y} * kSize + x;
            if (std::abs(float(x) + 0.5f - lineAt(float(y) + 0.5f)) > 3) {
                ASSERT_EQ(smooth.texels[i * 4], aliased.texels[i * 4]) << "far from the edge";
            }
            before += std::abs(aliased.texels[i * 4] - covered[i]);
            after += std::abs(smooth.texels[i * 4] - covered[i]);
        }
    EXPECT_LT(after, before * 0.5);
}

TEST_F(AntialiasTest, ProbesRunFromTheBottomUp) {
    // Two rows: the upper one red, the lower one blue (Radiance's RGBE, flat).
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    for (const char* texel : {"\x80\x00\x00\x81", "\x00\x00\x80\x81"})
        for (int x = 0; x < 4; ++x)
            file += std::string(texel, 4);
    const TempFolder temp;
    const std::string environment = temp + "probe.hdr";
    const std::string camera = temp + "camera.json";
    must(writeFile(environment, file));
    must(writeFile(camera, R"({"position": [0, 60, 0], "target": [0.1, 90, 0], "fovY": 40})"));
    for (const bool probe : {false, true}) {
        const Picture up =
            render("builtin:mirror",
                   {"display.tonemap=none", probe ? "environment.isProbe=true" : "environment.isProbe=false"}, 16, 16,
                   camera, environment);
        EXPECT_EQ(up.center().x > 0.5f, !probe);
        EXPECT_EQ(up.center().z > 0.5f, probe);
    }
}

} // namespace antialias_test
} // namespace glint::test
