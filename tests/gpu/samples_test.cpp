// Hosts with several samples a pixel: one surface represents each pixel, and edges have no rims.
#include "gpu/support/library_test.hpp"
#include "gpu/support/samples.hpp"
#include "gpu/support/scenes.hpp"

namespace glint::test {
namespace samples_test {

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 27;

class SamplesTest : public LibraryTest {
protected:
    struct Host {
        gpu::Image depth, normal, material, lit, fallback;
        GBuffer gbuffer;
    };

    /// The surface of each sample, and its image; empty: the background.
    using SampleScene = std::function<std::optional<SyntheticSurface>(uint32_t x, uint32_t y, uint32_t sample)>;

    static Host makeHost(const SyntheticCamera& camera, const SampleScene& scene,
                         const std::function<glm::vec3(const SyntheticSurface&)>& fallback = {},
                         const glm::vec3& backgroundRadiance = glm::vec3(0)) {
        Host host;
        const glm::dmat3 worldToView(camera.worldToView());
        const auto surfaces = [&](const char* name, VkFormat format, auto texel) {
            return makeSamples(gpu(), name, format, kWidth, kHeight, [&](uint32_t x, uint32_t y, uint32_t s) {
                const auto surface = scene(x, y, s);
                return surface ? texel(*surface, x, y, s) : glm::vec4(0);
            });
        };
        host.depth = surfaces("test/depth", VK_FORMAT_R32_SFLOAT,
                              [&](const SyntheticSurface& surface, uint32_t x, uint32_t y, uint32_t s) {
                                  const glm::uvec2 at = glm::uvec2(x, y) * 4u + kSampleQuarters[s];
                                  const glm::dvec3 ray = camera.rayThrough(at.x, at.y, kWidth * 4, kHeight * 4);
                                  return glm::vec4(float(camera.deviceDepth(-(worldToView * ray).z * surface.distance)),
                                                   0, 0, 0);
                              });
        host.normal = surfaces("test/normal", VK_FORMAT_R32G32_SFLOAT, [](const SyntheticSurface& surface, auto...) {
            return glm::vec4(encodeOctahedral(surface.normalWS), 0, 0);
        });
        host.material =
            surfaces("test/material", VK_FORMAT_R32G32B32A32_SFLOAT, [](const SyntheticSurface& surface, auto...) {
                return glm::vec4(surface.f0, surface.perceptualRoughness);
            });
        std::vector<glm::vec4> lit;
        std::vector<glm::vec4> replaced;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                glm::vec3 radiance(0);
                glm::vec3 specular(0);
                for (uint32_t s = 0; s < kSamples; ++s) {
                    const auto surface = scene(x, y, s);
                    radiance += surface ? surface->radiance : backgroundRadiance;
                    specular += surface && fallback ? fallback(*surface) : glm::vec3(0);
                }
                lit.emplace_back(radiance / float(kSamples), 1);
                replaced.emplace_back(specular / float(kSamples), 1);
            }
        constexpr VkFormat kWide = VK_FORMAT_R32G32B32A32_SFLOAT;
        host.lit = uploadTestImage(gpu(), "test/lit", kWide, kWidth, kHeight, bytesOf(lit));
        host.fallback = uploadTestImage(gpu(), "test/fallback", kWide, kWidth, kHeight, bytesOf(replaced));
        host.gbuffer.depth = asHostImage(host.depth);
        host.gbuffer.normal = asHostImage(host.normal);
        host.gbuffer.material = asHostImage(host.material);
        host.gbuffer.litRadiance = asHostImage(host.lit);
        if (fallback)
            host.gbuffer.fallbackSpecular = asHostImage(host.fallback);
        return host;
    }

    static Host hostOf(const SyntheticScene& scene, const SyntheticCamera& camera) {
        const auto fine = seen(scene, camera, kWidth * 4, kHeight * 4);
        return makeHost(camera, [&](uint32_t x, uint32_t y, uint32_t s) {
            const glm::uvec2 at = glm::uvec2(x, y) * 4u + kSampleQuarters[s];
            return fine[size_t{at.y} * kWidth * 4 + at.x];
        });
    }

    static std::vector<float> view(Reflections& reflections, const char* name) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = must(reflections.recordView(commands, name)); });
        return download(gpu(), image);
    }
};

TEST_F(SamplesTest, insideASurfaceThePictureIsThatOfOneSample) {
    for (const bool orthographic : {false, true}) {
        SyntheticCamera camera;
        camera.orthoHeight = orthographic ? 3 : 0;
        const SyntheticScene scene = floorAndWall();
        const auto fine = seen(scene, camera, kWidth * 4, kHeight * 4);
        const Host host = hostOf(scene, camera);
        Reflections many = reflections(kWidth, kHeight);
        must(many.setInputs(host.gbuffer));
        const Picture picture = trace(many, camera.view(kWidth, kHeight));
        const std::vector<float> depth = view(many, "depth");

        const SyntheticGBuffer one = SyntheticGBuffer::render(gpu(), scene, camera, kWidth, kHeight);
        Reflections single = reflections(kWidth, kHeight);
        must(single.setInputs(one.gbuffer));
        const Picture expected = trace(single, camera.view(kWidth, kHeight));
        const std::vector<float> expectedDepth = view(single, "depth");

        const auto isFloor = [](const std::optional<SyntheticSurface>& s) { return s && s->f0.x > 0; };
        uint32_t inside = 0;
        uint32_t sameOutcome = 0;
        uint32_t hits = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            uint32_t floors = 0;
            for (const glm::uvec2& quarter : kSampleQuarters)
                floors += isFloor(fine[size_t{i / kWidth * 4 + quarter.y} * kWidth * 4 + i % kWidth * 4 + quarter.x]);
            if (floors != 0 && floors != kSamples)
                continue;
            ++inside;
            ASSERT_NEAR(depth[i * 4], expectedDepth[i * 4], 2e-4 * expectedDepth[i * 4]) << i << orthographic;
            sameOutcome += picture.outcome(i) == expected.outcome(i);
            hits += expected.hit(i);
        }
        EXPECT_GT(inside, picture.pixels() * 9 / 10);
        EXPECT_GT(hits, 150u);
        EXPECT_GE(sameOutcome, inside * 98 / 100);
    }
}

TEST_F(SamplesTest, edgesAreTheMixOfTheirSurfaces) {
    const TestEnvironment environment =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(3, 1, 0.5f); });
    SyntheticCamera camera;
    camera.position = {0, 0, 0};
    camera.target = {0, 0, -1};
    const glm::vec3 backgroundRadiance(4, 3, 2);
    struct Far {
        const char* name;
        std::optional<float> f0; ///< none: the background
    };
    for (const CompositeModel model : {CompositeModel::Physical, CompositeModel::Lerp})
        for (const float nearF0 : {0.0f, 0.04f, 0.7f})
            for (const Far& far : {Far{"background", {}}, Far{"matte", 0.0f}, Far{"mirror", 0.9f}})
                for (const bool nearIsLeft : {false, true}) {
                    const auto surface = [&](bool near, uint32_t x, uint32_t y, uint32_t s) {
                        const glm::uvec2 at = glm::uvec2(x, y) * 4u + kSampleQuarters[s];
                        const glm::dvec3 ray = camera.rayThrough(at.x, at.y, kWidth * 4, kHeight * 4);
                        SyntheticSurface out;
                        out.distance = (near ? 2 : 6) / -ray.z;
                        out.normalWS = {0, 0, 1};
                        out.f0 = glm::vec3(near ? nearF0 : *far.f0);
                        out.perceptualRoughness = near ? 0.1f : 0.3f;
                        out.radiance = near ? glm::vec3(1, 0.5f, 0.25f) : glm::vec3(0.3f, 2, 1);
                        return out;
                    };
                    // Each row has its edge in the middle, with a coverage of its own.
                    const auto scene = [&](uint32_t x, uint32_t y, uint32_t s) -> std::optional<SyntheticSurface> {
                        const uint32_t column = nearIsLeft ? x : kWidth - 1 - x;
                        const bool near = column < kWidth / 2 || (column == kWidth / 2 && s < y % 4);
                        if (!near && !far.f0)
                            return {};
                        return surface(near, x, y, s);
                    };
                    const Host host = makeHost(
                        camera, scene, [](const SyntheticSurface& s) { return s.f0 * s.radiance * 0.9f; },
                        backgroundRadiance);
                    Settings settings = plainSettings();
                    settings.screen.enabled = false;
                    settings.composite.model = model;
                    Reflections made = reflections(kWidth, kHeight, settings);
                    must(made.setInputs(host.gbuffer, environment.map));
                    HostImage composite;
                    run([&](VkCommandBuffer commands) {
                        composite = made.record(commands, camera.view(kWidth, kHeight));
                    });
                    const std::vector<float> picture = download(gpu(), composite);
                    const auto at = [&](uint32_t column, uint32_t y) {
                        const uint32_t x = nearIsLeft ? column : kWidth - 1 - column;
                        const float* p = &picture[(size_t{y} * kWidth + x) * 4];
                        return glm::vec3(p[0], p[1], p[2]);
                    };
                    for (uint32_t y = 8; y < 20; ++y) {
                        const glm::vec3 inner = at(kWidth / 2 - 1, y);
                        const glm::vec3 outer = at(kWidth / 2 + 1, y);
                        const glm::vec3 mix = glm::mix(outer, inner, float(y % 4) / 4);
                        const glm::vec3 edge = at(kWidth / 2, y);
                        for (int c = 0; c < 3; ++c)
                            ASSERT_NEAR(edge[c], mix[c], 0.01f * std::max(inner[c], outer[c]))
                                << "model " << int(model) << ", F0 " << nearF0 << " before " << far.name << ", row "
                                << y;
                    }
                }
}

constexpr float kWall = 0.1f; // radiance
constexpr float kPanel = 4;

/// A bright panel before a wall, over a floor that reflects. The panel's sides lean, so that they cross pixels
/// everywhere.
SyntheticScene panelBeforeWall(double panelWidth, double panelZ, float floorRoughness) {
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        std::optional<SyntheticSurface> nearest;
        const auto offer = [&](double distance, const glm::dvec3& normalWS, float f0, float radiance) {
            if (distance > 0 && (!nearest || distance < nearest->distance)) {
                nearest.emplace();
                nearest->distance = distance;
                nearest->normalWS = normalWS;
                nearest->f0 = glm::vec3(f0);
                nearest->radiance = glm::vec3(radiance);
            }
        };
        offer(-origin.y / direction.y, {0, 1, 0}, 1, 0);
        if (nearest)
            nearest->perceptualRoughness = floorRoughness;
        offer((-3 - origin.z) / direction.z, {0, 0, 1}, 0, kWall);
        const double toPanel = (panelZ - origin.z) / direction.z;
        const glm::dvec3 at = origin + direction * toPanel;
        if (std::abs(at.x + 0.3 * at.y) < 0.5 * panelWidth && at.y < 1.1)
            offer(toPanel, {0, 0, 1}, 0, kPanel);
        return nearest;
    };
}

/// The picture's light is the mean of a pixel's surfaces, but a ray meets one of them.
TEST_F(SamplesTest, reflectionsShowOneSurfaceOfAnEdge) {
    const SyntheticCamera camera = {.position = {0, 1, 3}, .target = {0, 0.5, -1}};
    const Host host = hostOf(panelBeforeWall(1.4, -2, 0), camera);
    Settings settings = plainSettings();
    settings.denoise.enabled = false;
    Reflections made = reflections(kWidth, kHeight, settings);
    must(made.setInputs(host.gbuffer));
    const Picture picture = trace(made, camera.view(kWidth, kHeight));
    const std::vector<float> colors = view(made, "color");
    uint32_t panels = 0, walls = 0, mixes = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i)
        if (picture.hit(i)) {
            const float shown = colors[size_t{i} * 4];
            ++(shown < 1.1f * kWall ? walls : shown > 0.9f * kPanel ? panels : mixes);
        }
    EXPECT_GT(panels, 40u);
    EXPECT_GT(walls, 40u);
    EXPECT_EQ(mixes, 0u);
}

/// Pixels of a lamp thinner than they are would look like the wall's, close behind it.
TEST_F(SamplesTest, roughSurfacesKeepTheLightOfThinLamps) {
    const SyntheticCamera camera = {.position = {0, 1, 3}, .target = {0, 0.5, -1}};
    const SyntheticScene scene = panelBeforeWall(0.12, -2.99, 0.2f);
    Settings settings = plainSettings();
    settings.denoise.enabled = false;
    const auto reflected = [&](const GBuffer& gbuffer) {
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setInputs(gbuffer));
        const Picture picture = trace(made, camera.view(kWidth, kHeight));
        const std::vector<float> colors = view(made, "color");
        double sum = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i)
            if (picture.hit(i))
                sum += std::max(double(colors[size_t{i} * 4]) - double(kWall), 0.0);
        return sum;
    };
    const Host many = hostOf(scene, camera);
    const SyntheticGBuffer one = SyntheticGBuffer::render(gpu(), scene, camera, kWidth, kHeight);
    GBuffer sameLight = one.gbuffer;
    sameLight.litRadiance = many.gbuffer.litRadiance;
    const double expected = reflected(sameLight);
    EXPECT_GT(expected, 10);
    EXPECT_NEAR(reflected(many.gbuffer) / expected, 1, 0.1);
}

TEST_F(SamplesTest, thinThingsKeepTheirReflection) {
    // A wire of one sample a pixel before the background: it has no neighbour of its surface, and still reflects by its
    // coverage.
    const TestEnvironment environment =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(2); });
    SyntheticCamera camera;
    camera.position = {0, 0, 0};
    camera.target = {0, 0, -1};
    const Host host = makeHost(camera, [&](uint32_t x, uint32_t, uint32_t s) -> std::optional<SyntheticSurface> {
        if (x != kWidth / 2 || s != 2)
            return {};
        SyntheticSurface wire;
        wire.distance = 2;
        wire.normalWS = {0, 0, 1};
        wire.f0 = glm::vec3(1);
        return wire;
    });
    Settings settings = plainSettings();
    settings.screen.enabled = false;
    Reflections made = reflections(kWidth, kHeight, settings);
    must(made.setInputs(host.gbuffer, environment.map));
    const Picture picture = trace(made, camera.view(kWidth, kHeight));
    const uint32_t middle = kHeight / 2 * kWidth + kWidth / 2;
    EXPECT_NEAR(picture.color(middle).x, 0.5f, 0.01f);
    EXPECT_EQ(picture.color(middle + 1).x, 0);
}

} // namespace samples_test
} // namespace glint::test
