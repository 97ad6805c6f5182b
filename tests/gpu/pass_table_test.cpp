// docs/passes.md is what frames record, and no shader of the library is missing from it.
#include "gpu/support/drawn_layer.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/pass_table.hpp"
#include "gpu/support/samples.hpp"
#include "gpu/support/surface_scene.hpp"

#include "base/file.hpp"

#include <cstdlib>
#include <map>

namespace glint::test {
namespace pass_table_test {

constexpr std::array<glm::uvec2, 2> kSizes = {glm::uvec2(64, 64), glm::uvec2(128, 128)};
constexpr const char* kPage = GLINT_SOURCE_DIR "/docs/passes.md";

/// What differs from a host that provides everything, and reads results alone.
struct Variation {
    std::string name; ///< as the table shows it
    std::vector<std::pair<const char*, const char*>> settings = {};
    RayBackend backend = RayBackend::Query;
    bool samples = false;    ///< several samples a pixel
    bool backInPlace = true; ///< back faces of the frame's own size
    bool shadesHits = false; ///< the host shades hits
    bool debug = false;      ///< views, inspection, the check of inputs, statistics
    bool probes = true;
    bool edges = false; ///< the layer has pixels that it covers in part
    bool coat = false;  ///< surfaces have a clear coat
};

/// One room and all that a host can provide of it.
class FullHost : public LibraryTest {
protected:
    FullHost()
        : environment_(
              TestEnvironment::make(gpu(), 8, 4, [](const auto& d, uint32_t) { return glm::vec3(d) + 2.0f; })) {
        scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.3f));
        scene_.addQuad({-4, 0, -4}, {8, 0, 0}, {0, 3, 0}, emitting({1, 1, 1}));
        scene_.lights.push_back({});
    }

    gpu::Image image(glm::uvec2 size, VkFormat format, float value) {
        const std::vector<float> texels(size_t{size.x} * size.y * (format == VK_FORMAT_R32_SFLOAT ? 1 : 4), value);
        return uploadTestImage(gpu(), "test/image", format, size.x, size.y, bytesOf(texels));
    }
    gpu::Image samples(glm::uvec2 size, VkFormat format, const glm::vec4& value) {
        return makeSamples(gpu(), "test/samples", format, size.x, size.y, [&](auto...) { return value; });
    }

    /// What the frames recorded.
    gpu::PassLog record(const Variation& variation, const Settings& settings, size_t size);
    /// What objects beside the frames recorded, by the functions that a host calls.
    std::map<std::string, LoggedFrames>& objects() { return objects_; }

private:
    /// Runs the commands and logs their passes.
    void runLogged(gpu::PassLog& log, const std::function<void(VkCommandBuffer)>& commands) {
        gpu::PassLog::current() = &log;
        run(commands);
        gpu::PassLog::current() = nullptr;
    }
    gpu::PassLog& logOf(const std::string& function) {
        LoggedFrames& frames = objects_[function];
        frames.name = function;
        return frames.logs[size_];
    }
    GBuffer gbufferFor(const Variation& variation, glm::uvec2 size);
    void giveSources(Reflections& made, const Variation& variation, SurfaceScene::World& world);
    PlanarMirrors mirrorsFor(const Variation& variation, glm::uvec2 size);

    SyntheticCamera camera_ = {.position = {0, 1, 4}, .target = {0, 0.3, 0}};
    SurfaceScene scene_;
    TestEnvironment environment_;
    std::list<gpu::Image> images_; ///< of the frame's size
    std::optional<SyntheticGBuffer> gbuffer_;
    std::optional<Probes> probes_;
    size_t size_ = 0; ///< in kSizes
    std::map<std::string, LoggedFrames> objects_;
};

GBuffer FullHost::gbufferFor(const Variation& variation, glm::uvec2 size) {
    const auto keep = [&](gpu::Image made) {
        images_.push_back(std::move(made));
        HostImage host = asHostImage(images_.back());
        host.samples = images_.back().desc().samples;
        return host;
    };
    gbuffer_ = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene_), camera_, size.x, size.y);
    GBuffer gbuffer = gbuffer_->gbuffer;
    if (variation.samples) {
        gbuffer.depth = keep(samples(size, VK_FORMAT_R32_SFLOAT, glm::vec4(0.02f)));
        gbuffer.normal = keep(samples(size, VK_FORMAT_R32G32_SFLOAT, glm::vec4(0)));
        gbuffer.material = keep(samples(size, VK_FORMAT_R32G32B32A32_SFLOAT, glm::vec4(0.5f)));
    }
    if (variation.coat) {
        gbuffer.coat = {.scale = 0, .bias = 1};
        gbuffer.coatNormal = gbuffer.normal;
    }
    gbuffer.fallbackSpecular = keep(image(size, VK_FORMAT_R32G32B32A32_SFLOAT, 0.1f));
    gbuffer.motion = keep(image(size, VK_FORMAT_R32G32B32A32_SFLOAT, 0));
    gbuffer.backDepth = keep(image(variation.backInPlace ? size : size / 2u, VK_FORMAT_R32_SFLOAT, 0.01f));
    gbuffer.transparentDepth = keep(image(size, VK_FORMAT_R32_SFLOAT, 0.03f));
    return gbuffer;
}

PlanarMirrors FullHost::mirrorsFor(const Variation& variation, glm::uvec2 size) {
    const PlanarMirror mirror = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 2}, 0};
    PlanarMirrors mirrors = must(PlanarMirrors::create(library(), {std::span(&mirror, 1), size.x, size.y, {}}));
    images_.push_back(image(size, VK_FORMAT_R32G32B32A32_SFLOAT, 1));
    PlanarPicture picture = {asHostImage(images_.back()), {}, mirroredView(camera_.view(size.x, size.y), mirror)};
    images_.push_back(variation.samples ? samples(size, VK_FORMAT_R32_SFLOAT, glm::vec4(0.02f))
                                        : image(size, VK_FORMAT_R32_SFLOAT, 0.02f));
    picture.depth = asHostImage(images_.back());
    picture.depth.samples = images_.back().desc().samples;
    runLogged(logOf("`PlanarMirrors::record`"),
              [&](VkCommandBuffer commands) { must(mirrors.record(commands, 0, picture)); });
    return mirrors;
}

void FullHost::giveSources(Reflections& made, const Variation& variation, SurfaceScene::World& world) {
    if (variation.probes) {
        Probe probe;
        probe.cube = environment_.map.cube;
        probe.influence = probe.proxyVolume = {{0, 1, 0}, {0, 0, 0, 1}, {4, 4, 4}};
        probes_ = must(Probes::create(library(), {std::span(&probe, 1), 16}));
        must(made.setProbes(*probes_));
    }
    runLogged(logOf("`RayScene::record`"), [&](VkCommandBuffer commands) { world.rays.record(commands); });
    runLogged(logOf("`SurfaceTable::record`"), [&](VkCommandBuffer commands) { world.surfaces.record(commands); });
    if (variation.probes)
        runLogged(logOf("`Probes::record`"), [&](VkCommandBuffer commands) { probes_->record(commands); });
    if (variation.shadesHits)
        must(made.setRays(world.rays, [](VkCommandBuffer, const RayHits&) {}));
    else
        must(made.setRays(world.rays, world.surfaces));
}

gpu::PassLog FullHost::record(const Variation& variation, const Settings& settings, size_t at) {
    gpu::PassLog log;
    size_ = at;
    const glm::uvec2 size = kSizes[at];
    ReflectionsDesc desc = {size.x, size.y, settings};
    desc.settings.rays.backend = variation.backend;
    desc.statistics = desc.views = desc.inspection = desc.inputCheck = variation.debug;
    desc.transparentLayers = true;
    desc.framesInFlight = 1;
    Reflections made = must(Reflections::create(library(), desc));
    must(made.setInputs(gbufferFor(variation, size), environment_.map));
    SurfaceScene::World world = scene_.build(gpu(), library(), variation.backend);
    giveSources(made, variation, world);
    PlanarMirrors mirrors = mirrorsFor(variation, size);
    must(made.setPlanar(mirrors));
    const DrawnLayer layer =
        DrawnLayer::draw(gpu(), pane(1, {.coverage = variation.edges ? 0.5f : 1.0f}), camera_, size.x, size.y);
    View view = camera_.view(size.x, size.y);
    for (uint32_t frame = 0; frame < 3; ++frame) { // histories begin when frames have been executed
        view.frameIndex = frame;
        runLogged(log, [&](VkCommandBuffer commands) {
            const HostImage picture = made.record(commands, view);
            must(made.recordLayer(commands, layer.layer, picture));
        });
    }
    if (variation.debug)
        runLogged(log, [&](VkCommandBuffer commands) {
            must(made.recordView(commands, "outcome"));
            for (const std::string& name : made.passImages())
                must(made.recordView(commands, name));
            must(made.recordInspection(commands, size.x / 2, size.y / 2));
            must(made.recordInputCheck(commands));
        });
    images_.clear();
    return log;
}

using PassTableTest = FullHost;

/// What no preset's frames run.
std::vector<Variation> variations() {
    return {
        {"a layer with partly covered pixels", {}, RayBackend::Query, false, true, false, false, true, true},
        {"views, inspection, statistics", {}, RayBackend::Query, false, true, false, true},
        {"back faces of another size", {}, RayBackend::Query, false, false},
        {"several samples a pixel", {}, RayBackend::Query, true},
        {"`screen.march` proxy", {{"screen.march", "proxy"}}},
        {"`screen.transparents`", {{"screen.colorSource", "previous"}, {"screen.transparents", "true"}}},
        {"`blur.strength` without the denoiser", {{"denoise.enabled", "false"}, {"blur.strength", "1"}}},
        {"`screen.resolutionScale` without cones",
         {{"denoise.enabled", "false"}, {"screen.resolutionScale", "0.5"}, {"rough.cones", "false"}}},
        {"`denoise.stabilizeSeconds`", {{"denoise.stabilizeSeconds", "0.1"}}},
        {"`rays.interpolate`", {{"rays.enabled", "true"}, {"denoise.enabled", "false"}, {"rays.interpolate", "0.5"}}},
        {"`rays.backend` bvh", {{"rays.enabled", "true"}}, RayBackend::Bvh},
        {"`rays.backend` bvh, `rays.sampleLights`",
         {{"rays.enabled", "true"}, {"rays.sampleLights", "true"}},
         RayBackend::Bvh},
        {"hits shaded by the host", {{"rays.enabled", "true"}}, RayBackend::Query, false, true, true},
        {"hits shaded by the host, `rays.backend` bvh", {{"rays.enabled", "true"}}, RayBackend::Bvh, false, true, true},
        {"a layer without probes", {}, RayBackend::Query, false, true, false, false, false},
        {"views and rays", {{"rays.enabled", "true"}}, RayBackend::Query, false, true, false, true},
        {"the check of inputs with several samples a pixel", {}, RayBackend::Query, true, true, false, true},
        {.name = "a clear coat", .settings = {{"rays.enabled", "true"}}, .coat = true},
        {.name = "a clear coat with several samples a pixel", .samples = true, .coat = true},
        {"inspection with linear", {{"screen.march", "linear"}}, RayBackend::Query, false, true, false, true},
        {"inspection with adaptive", {{"screen.march", "adaptive"}}, RayBackend::Query, false, true, false, true},
        {"inspection with proxy", {{"screen.march", "proxy"}}, RayBackend::Query, false, true, false, true},
    };
}

TEST_F(PassTableTest, TheCommittedPageIsWhatFramesRecord) {
    if (!library().gpu().rayQuery())
        GTEST_SKIP() << "the page has frames with ray queries";
    PassTable table(kSizes);
    const auto add = [&](const Variation& variation, const Settings& settings, bool isPreset) {
        LoggedFrames frames = {variation.name, isPreset, {}};
        for (size_t i = 0; i < kSizes.size(); ++i)
            frames.logs[i] = record(variation, settings, i);
        table.add(frames);
    };
    for (const std::string_view preset : presetNames()) {
        SCOPED_TRACE(preset);
        Settings settings;
        must(applyPreset(settings, preset));
        add({std::string(preset)}, settings, true);
    }
    for (const Variation& variation : variations()) {
        SCOPED_TRACE(variation.name);
        Settings settings;
        for (const auto& [key, value] : variation.settings)
            must(set(settings, key, value));
        add(variation, settings, false);
    }
    for (const auto& [function, frames] : objects())
        table.add(frames);
    for (const gpu::EmbeddedShader& shader : gpu::shaders::reflect())
        EXPECT_TRUE(table.shaders().contains(std::string(shader.name)))
            << shader.name << " ran in no frame of this test: add one that runs it";
    if (const char* const update = std::getenv("GLINT_UPDATE_PAGES"); update && std::string_view(update) == "1")
        must(writeFile(kPage, table.page()));
    EXPECT_EQ(must(readFile(kPage, 1 << 20)), table.page()) << "run: GLINT_UPDATE_PAGES=1 scripts/test -R '^PassTable'";
}

} // namespace pass_table_test
} // namespace glint::test
