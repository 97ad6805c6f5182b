// The source `rays`: scenes of a few triangles whose reflections are known, on both back ends.
#include "gpu/support/host_shading.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <cmath>

namespace glint::test {
namespace rays_source_test {

class RaysSourceTest : public LibraryTest, public testing::WithParamInterface<RayBackend> {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        if (GetParam() == RayBackend::Query && !gpu().rayQuery())
            GTEST_SKIP() << "no ray queries on " << gpu().info().name;
    }

    static Settings raySettings() {
        Settings settings;
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        return settings;
    }

    static Picture look(const SurfaceScene& scene, const SyntheticScene& seen, const SyntheticCamera& camera,
                        uint32_t width, uint32_t height, const Settings& settings,
                        const EnvironmentMap& environment = {}) {
        SurfaceScene::World world = scene.build(gpu(), library(), GetParam());
        SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), seen, camera, width, height);
        Reflections reflections = LibraryTest::reflections(width, height, settings);
        must(reflections.setInputs(g.gbuffer, environment));
        must(reflections.setRays(world.rays, world.surfaces));
        run([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
        });
        return LibraryTest::trace(reflections, camera.view(width, height));
    }
    static Picture look(const SurfaceScene& scene, const SyntheticCamera& camera, uint32_t width, uint32_t height,
                        const Settings& settings, const EnvironmentMap& environment = {}) {
        return look(scene, SurfaceScene::seenBy(scene), camera, width, height, settings, environment);
    }
    static TestEnvironment whiteEnvironment() {
        return TestEnvironment::make(gpu(), 8, 4, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    }
    static glm::vec3 reflected(const Picture& picture, size_t pixel) {
        return glm::vec3(picture.reflection[pixel * 4], picture.reflection[pixel * 4 + 1],
                         picture.reflection[pixel * 4 + 2]);
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, RaysSourceTest, testing::Values(RayBackend::Query, RayBackend::Bvh),
                         [](const auto& backend) { return backend.param == RayBackend::Query ? "query" : "bvh"; });

TEST_P(RaysSourceTest, aMirrorShowsWhatStandsBehindTheCamera) {
    SurfaceScene scene;
    scene.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0));
    scene.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, emitting({0.25f, 0.5f, 0.75f}));
    const SyntheticCamera camera = {.position = {0, 0, 3}, .target = {0, 0, 0}};
    const Picture picture = look(scene, camera, 33, 17, raySettings());
    uint64_t hits = 0;
    for (size_t i = 0; i < picture.pixels(); ++i)
        if (picture.outcome(i) != shared::kOutcomeNone) {
            ++hits;
            EXPECT_EQ(picture.outcome(i), shared::kOutcomeHit);
            EXPECT_NEAR(picture.color(i).g, 0.5, 1e-3);
            EXPECT_GE(picture.hitDistance[i * 4], 10);
        }
    EXPECT_GT(hits, 50u);
    EXPECT_EQ(picture.counted("hit"), hits);
    EXPECT_EQ(picture.statistics.rays, hits);
}

/// Mirrors at x = -1 and 1, both `height` high, under an emissive ceiling: each mirror of a path is one nearer to it.
TEST_P(RaysSourceTest, twoMirrorsShowAsManyBouncesAsAsked) {
    SurfaceScene scene;
    scene.addQuad({-1, 0, -50}, {0, 9.5f, 0}, {0, 0, 100}, whiteMetal(0));
    scene.addQuad({1, 0, -50}, {0, 0, 100}, {0, 9.5f, 0}, whiteMetal(0));
    scene.addQuad({-300, 20, -300}, {0, 0, 600}, {600, 0, 0}, emitting(glm::vec3(1)));
    // The frame shows the mirror at x = 1 alone; its pixels' rays rise ever more steeply.
    SyntheticCamera camera = {.position = {0, 0.05, 0}, .target = {1, 1.2, 0}, .fovY = 1.5};
    const SyntheticScene seen = [](const glm::dvec3& origin,
                                   const glm::dvec3& direction) -> std::optional<SyntheticSurface> {
        const double distance = (1 - origin.x) / direction.x;
        const glm::dvec3 met = origin + direction * distance;
        if (!(distance > 0) || met.y < 0 || met.y > 9.5)
            return {};
        return SyntheticSurface{distance, {-1, 0, 0}, glm::vec3(1), 0, glm::vec3(0)};
    };
    for (const int bounces : {1, 2, 4, 8}) {
        Settings settings = raySettings();
        settings.rays.bounces = bounces;
        settings.rays.environmentOcclusion = false; // no estimate of what further bounces would bring
        const Picture picture = look(scene, seen, camera, 64, 48, settings);
        size_t shining = 0;
        size_t dark = 0;
        for (uint32_t y = 0; y < 48; ++y)
            for (uint32_t x = 0; x < 64; ++x) {
                const glm::dvec3 direction = camera.rayThrough(x, y, 64, 48);
                const glm::dvec3 eye = camera.position;
                const auto surface = seen(eye, direction);
                if (!surface)
                    continue;
                const double rise = direction.y / direction.x * 2; // from mirror to mirror
                double at = eye.y + direction.y * surface->distance;
                int mirrors = 0; // after the one that the frame shows
                bool doubtful = rise <= 1e-3;
                for (at += rise; at < 9.5 && mirrors < 20; at += rise) {
                    ++mirrors;
                    doubtful |= at > 9.45;
                }
                doubtful |= at < 9.55;
                const double along = std::abs(direction.z / direction.x) * (20 / std::max(rise, 1e-3)) * 2;
                if (doubtful || along > 45)
                    continue;
                const bool expected = mirrors < bounces;
                (expected ? shining : dark) += 1;
                EXPECT_EQ(reflected(picture, y * 64 + x).r > 0.5f, expected)
                    << mirrors << " mirrors, " << bounces << " bounces, at " << x << ", " << y;
            }
        EXPECT_GT(shining, 20u) << bounces;
        EXPECT_TRUE(bounces == 8 || dark > 20u) << bounces;
    }
}

/// The floor shows a metal wall, and that the environment, unless a black wall hides it.
TEST_P(RaysSourceTest, theLastSurfaceReflectsWhatIsNotHidden) {
    TestEnvironment environment = whiteEnvironment();
    const auto shown = [&](bool hidden, bool occlusion, int bounces) {
        SurfaceScene scene;
        scene.addQuad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, whiteMetal(0));
        scene.addQuad({-3, 0, -3}, {6, 0, 0}, {0, 4, 0}, whiteMetal(0.2f));
        if (hidden)
            scene.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, blackMatte());
        Settings settings = raySettings();
        settings.denoise.enabled = false;
        settings.rays.bounces = bounces;
        settings.rays.environmentOcclusion = occlusion;
        const SyntheticCamera camera = {.position = {0, 1, 4.5}, .target = {0, 0, -1}};
        const Picture picture = look(scene, camera, 33, 17, settings, environment.map);
        return reflected(picture, picture.pixels() / 2).g;
    };
    for (const int bounces : {1, 2})
        for (const bool occlusion : {false, true})
            EXPECT_NEAR(shown(false, occlusion, bounces), 1, 0.02) << bounces << occlusion;
    EXPECT_NEAR(shown(true, false, 1), 1, 0.02);
    EXPECT_EQ(shown(true, true, 1), 0);
    EXPECT_EQ(shown(true, true, 2), 0) << "the path meets the black wall itself";
}

TEST_P(RaysSourceTest, aWhiteFurnaceStaysWhite) {
    TestEnvironment environment = whiteEnvironment();
    for (const float roughness : {0.f, 0.1f, 0.3f, 0.5f, 0.7f, 0.9f, 1.f}) {
        SurfaceScene scene;
        scene.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(roughness));
        scene.addQuad({-1, 0, -2}, {2, 0, 0}, {0, 2, 0}, whiteMetal(roughness)); // stands on it, reflected in it
        Settings settings = raySettings();
        settings.rays.samples = 64;
        settings.rays.bounces = 3;
        const Picture picture =
            look(scene, {.position = {0, 1, 4}, .target = {0, 0.5, 0}}, 32, 24, settings, environment.map);
        double sum = 0;
        size_t reflecting = 0;
        for (size_t i = 0; i < picture.pixels(); ++i)
            if (picture.outcome(i) != shared::kOutcomeNone) {
                // Later bounces weigh directions by what the facets let pass: noise, for few samples.
                EXPECT_NEAR(picture.color(i).r, 1, 0.03) << "roughness " << roughness;
                sum += double(picture.color(i).r);
                ++reflecting;
            }
        EXPECT_NEAR(sum / double(reflecting), 1, 0.005) << "roughness " << roughness; // of lib/dfg.glsl's table
    }
}

/// A box, white outside in every direction: any light inside has leaked.
TEST_P(RaysSourceTest, closedBoxesStayDarkAtAnyScale) {
    TestEnvironment environment = whiteEnvironment();
    SurfaceScene box;
    const SurfaceMaterial wall = blackMatte();
    box.addQuad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, whiteMetal(0));
    box.addQuad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, wall);
    box.addQuad({-1, 0, -1}, {2, 0, 0}, {0, 1, 0}, wall);
    box.addQuad({1, 0, 1}, {-2, 0, 0}, {0, 1, 0}, wall);
    box.addQuad({-1, 0, 1}, {0, 0, -2}, {0, 1, 0}, wall);
    box.addQuad({1, 0, -1}, {0, 0, 2}, {0, 1, 0}, wall);
    for (const float scale : {1e-3f, 1.f, 1e3f}) {
        const SurfaceScene scene = box.scaled(scale);
        SyntheticCamera camera = {.position = glm::dvec3(-0.8, 0.4, 0.9) * double(scale),
                                  .target = glm::dvec3(0.5, -0.1, -0.6) * double(scale),
                                  .fovY = 1.2,
                                  .near = 0.05 * double(scale)};
        for (const float roughness : {0.f, 0.6f}) {
            const SyntheticScene exact = SurfaceScene::seenBy(scene);
            const SyntheticScene seen = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
                std::optional<SyntheticSurface> surface = exact(origin, direction);
                if (surface)
                    surface->perceptualRoughness = roughness;
                return surface;
            };
            Settings settings = raySettings();
            settings.rays.samples = 4;
            const Picture picture = look(scene, seen, camera, 160, 120, settings, environment.map);
            size_t mirrors = 0;
            size_t leaks = 0;
            size_t selfHits = 0;
            for (size_t i = 0; i < picture.pixels(); ++i) {
                mirrors += picture.outcome(i) == shared::kOutcomeHit;
                leaks += picture.outcome(i) != shared::kOutcomeBelowThreshold && reflected(picture, i).r > 0;
                selfHits += picture.outcome(i) == shared::kOutcomeHit && picture.hitDistance[i * 4] < 1e-4f * scale;
            }
            EXPECT_GT(mirrors, 2000u);
            EXPECT_EQ(leaks, 0u) << "scale " << scale << ", roughness " << roughness;
            EXPECT_LE(selfHits, mirrors / 1000) << "scale " << scale << ", roughness " << roughness;
        }
    }
}

/// Emissive objects around a mirror, at three scales.
TEST_P(RaysSourceTest, scaledScenesGiveTheSamePicture) {
    SurfaceScene scene;
    scene.addQuad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, whiteMetal(0));
    for (int i = 0; i < 7; ++i) {
        const float t = static_cast<float>(i);
        scene.addQuad({-1.6f + 0.45f * t, 0, -1.5f + 0.3f * t}, {0.3f, 0, 0.1f}, {0, 0.5f + 0.1f * t, 0.05f},
                      emitting({0.1f * t, 0.5f, 1 - 0.1f * t}));
    }
    std::vector<Picture> pictures;
    for (const float scale : {1.f, 1e-3f, 1e3f}) {
        const SurfaceScene sized = scene.scaled(scale);
        const SyntheticCamera camera = {.position = glm::dvec3(0.2, 1.1, 3) * double(scale),
                                        .target = glm::dvec3(0, 0.3, 0) * double(scale),
                                        .near = 0.05 * double(scale)};
        pictures.push_back(look(sized, camera, 160, 120, raySettings()));
    }
    for (size_t p = 1; p < pictures.size(); ++p) {
        size_t differing = 0;
        for (size_t i = 0; i < pictures[0].pixels(); ++i)
            differing += glm::distance(pictures[0].color(i), pictures[p].color(i)) > 1.f / 255;
        EXPECT_LE(differing, pictures[0].pixels() / 1000); // edges round either way
    }
}

TEST_P(RaysSourceTest, holesLetRaysThroughUnlessToldOtherwise) {
    SurfaceScene scene;
    scene.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0));
    SurfaceMaterial net = emitting({1, 0, 0});
    net.alpha = SurfaceAlpha::Mask;
    net.baseColorFactor[3] = 0.2f;
    scene.addQuad({20, -20, 5}, {-40, 0, 0}, {0, 40, 0}, net);
    scene.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, emitting({0, 1, 0}));
    const SyntheticCamera camera = {.position = {0, 0, 3}, .target = {0, 0, 0}};
    for (const bool tested : {true, false}) {
        Settings settings = raySettings();
        settings.rays.alphaTest = tested;
        const Picture picture = look(scene, camera, 33, 17, settings);
        EXPECT_NEAR(reflected(picture, 33 * 8 + 16).r, tested ? 0 : 1, 1e-3);
        EXPECT_NEAR(reflected(picture, 33 * 8 + 16).g, tested ? 1 : 0, 1e-3);
    }
}

TEST_P(RaysSourceTest, masksRangesAndRoughnessLeaveRaysOut) {
    SurfaceScene scene;
    scene.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0));
    scene.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, emitting(glm::vec3(1)));
    scene.triangles.instances[1].mask = 2;
    const SyntheticCamera camera = {.position = {0, 0, 3}, .target = {0, 0, 0}};
    const auto center = [&](const Settings& settings) {
        return reflected(look(scene, camera, 33, 17, settings), 33 * 8 + 16).r;
    };
    Settings settings = raySettings();
    EXPECT_NEAR(center(settings), 1, 1e-3);
    settings.rays.cullMask = 1;
    EXPECT_EQ(center(settings), 0);
    settings = raySettings();
    settings.rays.tMax = 9.9f; // the wall is 10 m from the mirror
    EXPECT_EQ(center(settings), 0);
    settings = raySettings();
    settings.rays.tMin = 10.5f;
    EXPECT_EQ(center(settings), 0);
    settings = raySettings();
    settings.rays.enabled = false;
    EXPECT_EQ(center(settings), 0);
}

/// A small mirror shows a metal of roughness 0.4 behind the camera, which reflects a light behind the mirror.
TEST_P(RaysSourceTest, aPathEndsAtARougherHit) {
    SurfaceScene scene;
    scene.addQuad({-0.5f, -0.5f, -4}, {1, 0, 0}, {0, 1, 0}, whiteMetal(0)); // hides little of the light
    scene.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, whiteMetal(0.4f));
    scene.addQuad({-20, -20, -8}, {40, 0, 0}, {0, 40, 0}, emitting(glm::vec3(1)));
    const SyntheticCamera camera = {.position = {0, 0, 3}, .target = {0, 0, 0}};
    const auto center = [&](float maxRoughness, int bounces) {
        Settings settings = raySettings();
        settings.rays.bounces = bounces;
        settings.rays.samples = 32;
        settings.rays.maxRoughness = maxRoughness;
        return reflected(look(scene, camera, 33, 17, settings), 33 * 8 + 16).r;
    };
    EXPECT_EQ(center(1, 1), 0) << "the metal's own light: none, and there is no environment";
    EXPECT_GT(center(1, 2), 0.5f) << "the light that the metal reflects";
    EXPECT_GT(center(0.41f, 2), 0.5f);
    EXPECT_EQ(center(0.39f, 2), 0) << "the metal is rougher: it is lit as it is in a host's frame";
}

/// Before a rough metal a wall in two colours: a mirror shows one of them in each pixel, a lobe mixes them.
TEST_P(RaysSourceTest, mirrorIfOneIsAMirrorForOneSampleAlone) {
    SurfaceScene scene;
    scene.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0.5f));
    scene.addQuad({0, -40, 6}, {-40, 0, 0}, {0, 80, 0}, emitting({1, 0, 0}));
    scene.addQuad({40, -40, 6}, {-40, 0, 0}, {0, 80, 0}, emitting({0, 0, 1}));
    const SyntheticCamera camera = {.position = {0, 0, 3}, .target = {0, 0, 0}};
    const auto show = [&](RayLobe lobe, int samples) {
        Settings settings = raySettings();
        settings.rays.lobe = lobe;
        settings.rays.samples = samples;
        settings.rays.regularization = 0;
        return look(scene, camera, 33, 17, settings).reflection;
    };
    const std::vector<float> mirror = show(RayLobe::Mirror, 1);
    const std::vector<float> one = show(RayLobe::Ggx, 1);
    const std::vector<float> four = show(RayLobe::Ggx, 4);
    EXPECT_NE(mirror, one);
    EXPECT_NE(mirror, four);
    EXPECT_EQ(show(RayLobe::MirrorIfOne, 1), mirror);
    EXPECT_EQ(show(RayLobe::MirrorIfOne, 4), four);
}

TEST_P(RaysSourceTest, aLightShinesOnWhatAMirrorShowsUnlessSomethingStandsBetween) {
    for (const bool shadowed : {false, true}) {
        SurfaceScene scene;
        scene.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0));
        SurfaceMaterial matte = blackMatte();
        matte.baseColorFactor = {0.5f, 0.5f, 0.5f, 1};
        scene.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, matte);
        if (shadowed)
            scene.addQuad({-50, 30, -50}, {100, 0, 0}, {0, 0, 100}, blackMatte());
        SurfaceLight sun;
        sun.color = {2, 2, 2};
        sun.directionWS = {0, -std::sqrt(0.5f), std::sqrt(0.5f)};
        scene.lights.push_back(sun);
        const Picture picture = look(scene, {.position = {0, 0, 3}, .target = {0, 0, 0}}, 33, 17, raySettings());
        const double lit = 2 * std::sqrt(0.5) * 0.5 / 3.14159265;
        EXPECT_NEAR(reflected(picture, 33 * 8 + 16).r, shadowed ? 0 : lit, 2e-3);
    }
}

/// A mirror that shows a wall behind the camera through objects before the wall. All surfaces are black except for
/// their emission, transmission and absorption.
class RaysTransparentsTest : public RaysSourceTest {
protected:
    void SetUp() override {
        RaysSourceTest::SetUp();
        scene_.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0));
    }
    SurfaceScene& addWall(float left, float right, const glm::vec3& radiance) {
        return scene_.addQuad({right, -20, 9}, {left - right, 0, 0}, {0, 40, 0}, emitting(radiance));
    }
    /// Two faces `thickness` apart, parts of one mesh; the first one at z = 5 in the middle, rotated about the
    /// vertical.
    void addSlab(float thickness, float angle, const SurfaceMaterial& material) {
        const glm::vec3 side(std::cos(angle), 0, std::sin(angle));
        const glm::vec3 inward(-std::sin(angle), 0, std::cos(angle));
        const glm::vec3 up(0, 10, 0);
        const glm::vec3 near = glm::vec3(0, -5, 5) - 5.f * side;
        scene_.addQuad(near + 10.f * side, -10.f * side, up, material);
        TestMesh& mesh = scene_.triangles.meshes.back();
        const glm::vec3 far = near + thickness * inward;
        mesh.addTriangle(far, far + 10.f * side, far + 10.f * side + up);
        mesh.addTriangle(far, far + 10.f * side + up, far + up);
        scene_.triangles.instances.back().doubleSided = false;
    }
    static SurfaceMaterial glass(float ior) {
        SurfaceMaterial material = blackMatte();
        material.baseColorFactor = {1, 1, 1, 1};
        material.roughnessFactor = 0;
        material.transmissionFactor = 1;
        material.ior = ior;
        return material;
    }
    glm::vec3 middle(int transparents = 8, const EnvironmentMap& environment = {}) const {
        Settings settings = raySettings();
        settings.rays.transparents = transparents;
        return reflected(look(scene_, {.position = {0, 0, 3}, .target = {0, 0, 0}}, 33, 17, settings, environment),
                         33 * 8 + 16);
    }
    static void expectColor(const glm::vec3& found, const glm::vec3& expected) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 4e-3) << c;
    }

    SurfaceScene scene_;
};

INSTANTIATE_TEST_SUITE_P(Backends, RaysTransparentsTest, testing::Values(RayBackend::Query, RayBackend::Bvh),
                         [](const auto& backend) { return backend.param == RayBackend::Query ? "query" : "bvh"; });

TEST_P(RaysTransparentsTest, thinWallsTintAndBlendedOnesCover) {
    SurfaceMaterial pane = glass(1.5f);
    pane.baseColorFactor = {0.5f, 1, 0.25f, 1};
    addWall(-20, 20, {1, 2, 4}).addQuad({5, -5, 5}, {-10, 0, 0}, {0, 10, 0}, pane);
    SurfaceMaterial veil = emitting({2, 0, 0});
    veil.alpha = SurfaceAlpha::Blend;
    veil.baseColorFactor[3] = 0.25f;
    scene_.addQuad({5, -5, 7}, {-10, 0, 0}, {0, 10, 0}, veil);
    const glm::vec3 veiled = glm::vec3(2, 0, 0) * 0.25f + glm::vec3(1, 2, 4) * 0.75f;
    expectColor(middle(), glm::vec3(0.5f, 1, 0.25f) * veiled);
    expectColor(middle(1), glm::vec3(0.5f, 1, 0.25f) * glm::vec3(1, 2, 4)); // the second one is not visible
    expectColor(middle(0), {1, 2, 4});
}

TEST_P(RaysTransparentsTest, bodiesAbsorbByTheWayInside) {
    SurfaceMaterial body = glass(1);
    body.thicknessFactor = 3;
    body.attenuationColor = {0.5f, 0.25f, 1};
    body.attenuationDistance = 1.5f;
    addWall(-20, 20, {1, 1, 1});
    addSlab(2, 0.7f, body);
    const float way = 2 / std::cos(0.7f) / 1.5f;
    expectColor(middle(), {std::pow(0.5f, way), std::pow(0.25f, way), 1});
}

TEST_P(RaysTransparentsTest, anOpenBodyIsAsThickAsItsMaterialSays) {
    SurfaceMaterial body = glass(1);
    body.thicknessFactor = 0.5f;
    body.attenuationColor = {0.5f, 0.25f, 1};
    body.attenuationDistance = 1;
    addWall(-20, 20, {1, 1, 1}).addQuad({5, -5, 5}, {-10, 0, 0}, {0, 10, 0}, body);
    expectColor(middle(), {std::sqrt(0.5f), 0.5f, 1});
}

TEST_P(RaysTransparentsTest, aSlabShiftsWhatStandsBehindIt) {
    // By t sin(a) (1 - cos(a) / (n cos(a'))) with sin(a) = n sin(a'): 0.658 m at 45 degrees, n = 1.5 and t = 2.
    addWall(-0.6f, 0.6f, {1, 0, 0});
    addWall(0.6f, 0.72f, {0, 1, 0});
    addWall(-0.72f, -0.6f, {0, 1, 0});
    SurfaceMaterial body = glass(1.5f);
    body.specularFactor = 0; // no reflection
    body.thicknessFactor = 2;
    addSlab(2, 0.7853982f, body);
    expectColor(middle(), {0, 1, 0});
    scene_.materials.back().ior = 1;
    expectColor(middle(), {1, 0, 0});
}

TEST_P(RaysTransparentsTest, aWhiteFurnaceStaysWhite) {
    TestEnvironment environment = whiteEnvironment();
    for (const float roughness : {0.f, 0.5f})
        for (const float thickness : {0.f, 1.f}) {
            scene_ = {};
            scene_.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0));
            SurfaceMaterial body = glass(1.5f);
            body.roughnessFactor = roughness;
            body.thicknessFactor = thickness;
            addSlab(1, 0.5f, body);
            EXPECT_NEAR(middle(8, environment.map).g, 1, 0.01) << roughness << ", " << thickness;
        }
}

/// Shadows equal the renderer's: glass casts none.
TEST_P(RaysTransparentsTest, glassCastsNoShadow) {
    SurfaceMaterial matte = blackMatte();
    matte.baseColorFactor = {0.5f, 0.5f, 0.5f, 1};
    scene_.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, matte);
    SurfaceLight sun;
    sun.color = {2, 2, 2};
    sun.directionWS = {0, -std::sqrt(0.5f), std::sqrt(0.5f)};
    scene_.lights.push_back(sun);
    const glm::vec3 lit = middle();
    EXPECT_GT(lit.r, 0.1f);
    scene_.addQuad({-50, 30, -50}, {100, 0, 0}, {0, 0, 100}, glass(1.5f));
    expectColor(middle(), lit);
}

/// The host's shading: a compute pass of the test's own over the hits.
TEST_P(RaysSourceTest, hitsAreHandedOutToBeShadedByTheHost) {
    SurfaceScene scene;
    scene.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0));
    scene.addQuad({20, -20, 6}, {-20, 0, 0}, {0, 40, 0}, blackMatte()); // the right half of the view behind the camera
    const SyntheticCamera camera = {.position = {0, 0, 3}, .target = {0, 0, 0}};
    constexpr uint32_t w = 65;
    constexpr uint32_t h = 33;
    SurfaceScene::World world = scene.build(gpu(), library(), GetParam());
    SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene), camera, w, h);
    Reflections reflections = LibraryTest::reflections(w, h, raySettings());
    must(reflections.setInputs(g.gbuffer));
    const HostShading shading(gpu());
    size_t calls = 0;
    must(reflections.setRays(world.rays, [&](VkCommandBuffer commands, const RayHits& hits) {
        ++calls;
        shading.record(commands, hits);
    }));
    run([&](VkCommandBuffer commands) { world.rays.record(commands); });
    const Picture picture = LibraryTest::trace(reflections, camera.view(w, h));
    EXPECT_EQ(calls, 1u);
    size_t met = 0;
    size_t missed = 0;
    for (size_t i = 0; i < picture.pixels(); ++i) {
        if (picture.outcome(i) == shared::kOutcomeHit) { // instance, distance over 100, front
            ++met;
            ASSERT_NEAR(reflected(picture, i).r, 1, 1e-3);
            ASSERT_NEAR(reflected(picture, i).g, picture.hitDistance[i * 4] / 100, 1e-3);
            ASSERT_NEAR(reflected(picture, i).b, 1, 1e-3);
        } else if (picture.outcome(i) == shared::kOutcomeSky) {
            ++missed;
            ASSERT_EQ(reflected(picture, i), glm::vec3(0)); // weight 0
        }
    }
    EXPECT_GT(met, 100u);
    EXPECT_GT(missed, 100u);
}

TEST_P(RaysSourceTest, theOtherBackEndIsRefused) {
    SurfaceScene scene;
    scene.addQuad({-2, -2, -4}, {4, 0, 0}, {0, 4, 0}, whiteMetal(0));
    SurfaceScene::World world = scene.build(gpu(), library(), GetParam());
    Settings settings = raySettings();
    settings.rays.backend = GetParam() == RayBackend::Query ? RayBackend::Bvh : RayBackend::Query;
    Reflections reflections = LibraryTest::reflections(8, 8, settings);
    const Result<void> refused = reflections.setRays(world.rays, world.surfaces);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("rays.backend"), std::string::npos) << refused.error().message;
    settings.rays.backend = GetParam();
    must(reflections.setSettings(settings));
    must(reflections.setRays(world.rays, world.surfaces));
}

} // namespace rays_source_test
} // namespace glint::test
