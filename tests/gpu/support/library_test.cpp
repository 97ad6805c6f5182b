#include "gpu/support/library_test.hpp"

#include <glm/gtc/packing.hpp>

#include <cstring>

namespace glint::test {

uint32_t Picture::outcome(size_t pixel) const {
    const glm::vec3 color(outcomeColor[pixel * 4], outcomeColor[pixel * 4 + 1], outcomeColor[pixel * 4 + 2]);
    const std::pair<uint32_t, glm::vec3> known[] = {
        {shared::kOutcomeNone, {0, 0, 0}},
        {shared::kOutcomeSky, {0.25f, 0.6f, 0.9f}},
        {shared::kOutcomeOffScreen, {1, 1, 0}},
        {shared::kOutcomeBehindCamera, {1, 0.5f, 0}},
        {shared::kOutcomeMaxDistance, {0, 0, 1}},
        {shared::kOutcomeOutOfSteps, {1, 0, 0}},
        {shared::kOutcomeHidden, {0.5f, 0, 0.5f}},
        {shared::kOutcomeTooThick, {0.9f, 0.3f, 0.9f}},
        {shared::kOutcomeBackFace, {0.45f, 0.3f, 0.15f}},
        {shared::kOutcomeSide, {0.45f, 0.75f, 0.1f}},
        {shared::kOutcomeInferred, {0.75f, 1, 0.8f}},
        {shared::kOutcomeBelowThreshold, {0.15f, 0.15f, 0.15f}},
        {shared::kOutcomeTooRough, {0.3f, 0.3f, 0.3f}},
        {shared::kOutcomeFacingCamera, {0, 0.5f, 0.5f}},
        {shared::kOutcomeFromNeighbours, {0.2f, 0.3f, 0.45f}},
    };
    for (const auto& [outcome, itsColor] : known)
        if (color == itsColor)
            return outcome;
    if (color.r == 0 && color.b == 0 && color.g > 0)
        return shared::kOutcomeHit; // green, brighter with more steps
    throw std::runtime_error("no outcome has this colour");
}

uint64_t Picture::counted(std::string_view name) const {
    for (const Statistics::Outcome& entry : statistics.outcomes)
        if (entry.name == name)
            return entry.count;
    return 0;
}

double Picture::meanWeight() const {
    double sum = 0;
    size_t hits = 0;
    for (size_t i = 0; i < pixels(); ++i)
        if (hit(i)) {
            sum += weight[i * 4];
            ++hits;
        }
    return hits ? sum / static_cast<double>(hits) : 0;
}

Settings LibraryTest::plainSettings(March march) {
    // The tests' own values: defaults are chosen by measurement and may change.
    Settings settings;
    settings.screen.march = march;
    settings.fade.border = FadeBorder::None_;
    settings.screen.thicknessMode = ThicknessMode::Constant;
    settings.screen.thickness = 0.1f;
    settings.screen.inferred = 0;
    settings.fade.uncertain = false; // certainty_test.cpp
    settings.denoise.enabled = false;
    settings.rough.cones = false;
    settings.screen.selfCollisionSkip = 1;
    settings.reflect.roughnessFadeStart = 0.3f;
    settings.reflect.maxRoughness = 0.6f;
    return settings;
}

void LibraryTest::limitIterations(Settings& settings, int most) {
    settings.screen.maxSteps = most;
    settings.hiz.maxIterations = most;
}

Reflections LibraryTest::reflections(uint32_t width, uint32_t height, const Settings& settings) {
    ReflectionsDesc desc = {width, height, settings, true, true};
    desc.framesInFlight = 1; // `run` waits for each frame
    return must(Reflections::create(library(), desc));
}

std::vector<float> LibraryTest::readView(Reflections& reflections, std::string_view name) {
    HostImage image;
    run([&](VkCommandBuffer commands) { image = must(reflections.recordView(commands, name)); });
    return download(gpu(), image);
}

Picture LibraryTest::trace(Reflections& reflections, const View& view) {
    HostImage composite;
    run([&](VkCommandBuffer commands) { composite = reflections.record(commands, view); });
    Picture picture;
    picture.width = composite.width;
    picture.height = composite.height;
    picture.composite = download(gpu(), composite);
    picture.statistics = reflections.statistics();
    picture.passTimes = reflections.passTimes();
    picture.reflection = readView(reflections, "reflection");
    picture.weight = readView(reflections, "weight");
    picture.hitUV = readView(reflections, "hitUV");
    picture.hitDistance = readView(reflections, "hitDistance");
    picture.lookups = readView(reflections, "lookups");
    picture.outcomeColor = readView(reflections, "outcome");
    return picture;
}

Picture LibraryTest::trace(const SyntheticScene& scene, const SyntheticCamera& camera, uint32_t width, uint32_t height,
                           const Settings& settings, const EnvironmentMap& environment) {
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, camera, width, height);
    Reflections made = reflections(width, height, settings);
    must(made.setInputs(host.gbuffer, environment));
    return trace(made, camera.view(width, height));
}

Picture LibraryTest::traceWithin(const std::vector<Probe>& volumes, const SyntheticScene& scene,
                                 const SyntheticCamera& camera, uint32_t width, uint32_t height, Settings settings) {
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, camera, width, height);
    settings.probes.enabled = false;
    Reflections made = reflections(width, height, settings);
    must(made.setInputs(host.gbuffer));
    const TestVolumes given = TestVolumes::giveTo(made, gpu(), library(), volumes);
    return trace(made, camera.view(width, height));
}

TestVolumes TestVolumes::giveTo(Reflections& reflections, gpu::Context& context, Context& library,
                                std::vector<Probe> volumes) {
    TestEnvironment cube = TestEnvironment::make(context, 1, 1, [](const auto&, uint32_t) { return glm::vec3(0); });
    for (Probe& probe : volumes) {
        probe.cube = cube.map.cube;
        probe.prefiltered = true;
    }
    Probes probes = must(Probes::create(library, {volumes, 0}));
    must(reflections.setProbes(probes));
    must(context.submitAndWait([&](VkCommandBuffer commands) { probes.record(commands); }));
    return {std::move(cube), std::move(probes)};
}

namespace {

/// Vulkan 1.3, 16.5.4 "Cube Map Face Selection", inverted: face, s and t to a direction.
glm::dvec3 cubeDirection(uint32_t face, double s, double t) {
    const double a = 2 * s - 1;
    const double b = 2 * t - 1;
    const glm::dvec3 directions[] = {{1, -b, -a}, {-1, -b, a}, {a, 1, b}, {a, -1, -b}, {a, -b, 1}, {-a, -b, -1}};
    return glm::normalize(directions[face]);
}

} // namespace

TestEnvironment TestEnvironment::make(gpu::Context& context, uint32_t size, uint32_t mips,
                                      const std::function<glm::vec3(const glm::dvec3&, uint32_t)>& radiance,
                                      const std::function<double(const glm::dvec3&)>& alpha) {
    TestEnvironment out;
    out.cube = must(gpu::Image::create(
        context, {"test/environment", VK_FORMAT_R16G16B16A16_SFLOAT, size, size, mips, 6, gpu::ImageShape::Cube,
                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    for (uint32_t mip = 0; mip < mips; ++mip)
        for (uint32_t face = 0; face < 6; ++face) {
            const uint32_t side = std::max(size >> mip, 1u);
            std::vector<glm::u16vec4> texels;
            for (uint32_t y = 0; y < side; ++y)
                for (uint32_t x = 0; x < side; ++x) {
                    const glm::dvec3 direction = cubeDirection(face, (x + 0.5) / side, (y + 0.5) / side);
                    texels.push_back(
                        glm::packHalf(glm::vec4(radiance(direction, mip), alpha ? alpha(direction) : 1.0)));
                }
            gpu::Buffer staging = must(gpu::Buffer::create(
                context, {"test/face", texels.size() * 8, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::BufferHome::Upload}));
            std::memcpy(staging.mapped(), texels.data(), texels.size() * 8);
            must(context.submitAndWait([&](VkCommandBuffer commands) {
                gpu::Frame frame(context, commands);
                frame.copyFromBuffer(staging, 0, out.cube, mip, face);
                frame.hand(out.cube, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
            }));
        }
    out.map.cube = asHostImage(out.cube);
    out.map.mips = mips;
    return out;
}

} // namespace glint::test
