// The source `probes`: where it places reflections, its weight in a pixel, and that its weight is never too large.
#include "gpu/support/library_test.hpp"
#include "gpu/support/probe_oracle.hpp"
#include "gpu/support/surface_scene.hpp"

#include <gmock/gmock.h>

#include "shared/frame_constants.h"

#include <algorithm>
#include <limits>
#include <random>

namespace glint::test {
namespace probes_test {

Settings probesAlone() {
    Settings settings;
    settings.screen.enabled = false;
    settings.sky.enabled = false;
    return settings;
}

TestEnvironment constantCube(gpu::Context& context, const glm::vec3& radiance, uint32_t mips = 1) {
    return TestEnvironment::make(context, 16, mips, [&](const glm::dvec3&, uint32_t) { return radiance; });
}

Probe probeOf(const TestEnvironment& cube) {
    Probe probe;
    probe.cube = cube.map.cube;
    probe.mips = cube.map.mips;
    probe.prefiltered = true;
    return probe;
}

/// A mirror floor without objects.
SyntheticScene mirrorFloor(float perceptualRoughness = 0) {
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) -> std::optional<SyntheticSurface> {
        const double distance = -origin.y / direction.y;
        if (!(distance > 0) || distance > 100)
            return {};
        return SyntheticSurface{distance, {0, 1, 0}, glm::vec3(1), perceptualRoughness, glm::vec3(0.25f)};
    };
}

glm::dvec3 reflected(const Picture& picture, size_t pixel) {
    return {picture.reflection[pixel * 4], picture.reflection[pixel * 4 + 1], picture.reflection[pixel * 4 + 2]};
}

class ProbesTest : public LibraryTest {
protected:
    static Picture look(const std::vector<Probe>& list, const SyntheticScene& scene, const SyntheticCamera& camera,
                        uint32_t width, uint32_t height, const Settings& settings,
                        const EnvironmentMap& environment = {}, uint32_t faceSize = 0) {
        Probes probes = must(Probes::create(library(), {list, faceSize}));
        SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), scene, camera, width, height);
        Reflections reflections = LibraryTest::reflections(width, height, settings);
        must(reflections.setInputs(g.gbuffer, environment));
        must(reflections.setProbes(probes));
        run([&](VkCommandBuffer commands) { probes.record(commands); });
        return LibraryTest::trace(reflections, camera.view(width, height));
    }
    static bool ran(const Picture& picture, std::string_view pass) {
        return std::ranges::any_of(picture.passTimes, [&](const PassTime& time) { return time.name == pass; });
    }
};

// ---------------------------------------------------------------- where

/// A room of 4 x 3 x 5 m whose walls' colour is their position; its floor is a mirror.
constexpr glm::dvec3 kRoomCenter = {0.5, 1.5, -1};
constexpr glm::dvec3 kRoomHalf = {2, 1.5, 2.5};

/// Where a ray from inside leaves the room.
glm::dvec3 wallPoint(const glm::dvec3& origin, const glm::dvec3& direction) {
    double t = 1e30;
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0)
            t = std::min(t, (kRoomCenter[axis] + std::copysign(kRoomHalf[axis], direction[axis]) - origin[axis]) /
                                direction[axis]);
    return origin + direction * t;
}

const glm::dvec3 kShown = {2.5, 1, 4.5}; ///< added, so that no channel is negative

struct Misplaced {
    double worstPX = 0;       ///< over all floor pixels
    double worstCornerPX = 0; ///< over the reflected corners that the picture shows
    int pixels = 0;
    int corners = 0;
};

/// Distance on screen between each floor pixel's reflection and its correct place.
Misplaced misplaced(const Picture& picture, const SyntheticCamera& camera) {
    Misplaced out;
    const uint32_t width = picture.width;
    const uint32_t height = picture.height;
    const auto placed = [&](const glm::dvec3& p) { return camera.project({p.x, -p.y, p.z}, width, height); };
    std::vector<glm::dvec2> shownAt(picture.pixels(), glm::dvec2(-1e9));
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::dvec3 direction = camera.rayThrough(x, y, width, height);
            if (wallPoint(camera.position, direction).y > 1e-9)
                continue; // not the floor
            const size_t i = size_t{y} * width + x;
            shownAt[i] = placed(reflected(picture, i) - kShown);
            out.worstPX = std::max(out.worstPX, glm::distance(shownAt[i], glm::dvec2(x + 0.5, y + 0.5)));
            ++out.pixels;
        }
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const glm::dvec3 at = kRoomCenter + side * kRoomHalf;
        const glm::dvec2 truth = placed(at);
        if (camera.viewZ({at.x, -at.y, at.z}) < 0.1 ||
            !(truth.x > 3 && truth.x < width - 3 && truth.y > 3 && truth.y < height - 3))
            continue;
        // The pixel that shows a place nearest to the corner.
        double nearest = 1e9;
        glm::dvec2 found(0);
        for (size_t i = 0; i < picture.pixels(); ++i)
            if (const double d = glm::distance(reflected(picture, i) - kShown, at);
                shownAt[i].x > -1e8 && d < nearest) {
                nearest = d;
                found = {static_cast<double>(i % width) + 0.5, static_cast<double>(i / width) + 0.5};
            }
        out.worstCornerPX = std::max(out.worstCornerPX, glm::distance(found, truth));
        ++out.corners;
    }
    return out;
}

TEST_F(ProbesTest, aBoxRoomIsReflectedInItsPlace) {
    const TestEnvironment cube = TestEnvironment::make(gpu(), 256, 1, [](const glm::dvec3& direction, uint32_t) {
        return glm::vec3(wallPoint(kRoomCenter, direction) + kShown);
    });
    Probe probe = probeOf(cube);
    probe.capturePositionWS = {0.5f, 1.5f, -1};
    probe.influence = {{0.5f, 1.5f, -1}, {0, 0, 0, 1}, {3, 2, 4}};
    probe.proxyVolume = {{0.5f, 1.5f, -1}, {0, 0, 0, 1}, {2, 1.5f, 2.5f}};
    const SyntheticScene room = [](const glm::dvec3& origin,
                                   const glm::dvec3& direction) -> std::optional<SyntheticSurface> {
        const glm::dvec3 at = wallPoint(origin, direction);
        const bool floor = at.y < 1e-9;
        return SyntheticSurface{glm::length(at - origin), floor ? glm::dvec3(0, 1, 0) : -direction,
                                glm::vec3(floor ? 1.f : 0.f), 0, glm::vec3(0)};
    };
    // Off the room's middle, so that no reflection is correct by symmetry.
    const SyntheticCamera camera = {.position = {1.7, 2.2, 1.2}, .target = {0.1, 0, -1.6}, .fovY = 1.1};
    const Picture picture = look({probe}, room, camera, 192, 128, probesAlone());
    const Misplaced right = misplaced(picture, camera);
    EXPECT_GT(right.pixels, 10000);
    EXPECT_GE(right.corners, 2);
    EXPECT_LT(right.worstPX, 2);
    EXPECT_LT(right.worstCornerPX, 2);
    RecordProperty("worstPX", std::to_string(right.worstPX));
    RecordProperty("worstCornerPX", std::to_string(right.worstCornerPX));
    RecordProperty("corners", right.corners);

    Settings far = probesAlone();
    far.probes.parallax = false;
    EXPECT_GT(misplaced(look({probe}, room, camera, 192, 128, far), camera).worstPX, 20); // the test detects parallax

    // The same room in other axes: turned by a quarter about y, x and z swap.
    Probe turned = probe;
    const float s = std::sqrt(0.5f);
    turned.influence.rotation = turned.proxyVolume.rotation = {0, s, 0, s};
    turned.influence.halfExtents = {4, 2, 3};
    turned.proxyVolume.halfExtents = {2.5f, 1.5f, 2};
    EXPECT_LT(misplaced(look({turned}, room, camera, 192, 128, probesAlone()), camera).worstPX, 2);
}

/// No box: a ball above the floor, half a wall and the open sky, each in its own colour.
struct Seen {
    glm::vec3 radiance = {0, 0, 1}; // the sky
    double distance = std::numeric_limits<double>::infinity();
};
Seen openPlace(const glm::dvec3& origin, const glm::dvec3& direction) {
    Seen seen;
    const auto meet = [&](double distance, const glm::vec3& radiance) {
        if (distance > 1e-9 && distance < seen.distance)
            seen = {radiance, distance};
    };
    meet(-origin.y / direction.y, {0, 0, 0}); // the floor
    const double toWall = (-4 - origin.z) / direction.z;
    if (const glm::dvec3 at = origin + toWall * direction; at.x < 0 && at.y < 3)
        meet(toWall, {0, 1, 0});
    const glm::dvec3 toBall = origin - glm::dvec3(-0.5, 0.9, -1);
    const double b = glm::dot(direction, toBall);
    if (const double root = b * b - glm::dot(toBall, toBall) + 0.5 * 0.5; root > 0)
        meet(-b - std::sqrt(root), {1, 0, 0});
    return seen;
}

TEST_F(ProbesTest, withDistancesWhatIsNoBoxIsReflectedInItsPlace) {
    const glm::dvec3 capture = {0.6, 1.4, 0.5};
    const TestEnvironment cube = TestEnvironment::make(
        gpu(), 256, 1, [&](const glm::dvec3& d, uint32_t) { return openPlace(capture, glm::normalize(d)).radiance; },
        [&](const glm::dvec3& d) { return 1 / openPlace(capture, glm::normalize(d)).distance; });
    Probe probe = probeOf(cube);
    probe.capturePositionWS = {0.6f, 1.4f, 0.5f};
    probe.influence = {{0, 0, 0}, {0, 0, 0, 1}, {50, 50, 50}};
    probe.proxyVolume = {{0, 1.5f, 0}, {0, 0, 0, 1}, {6, 1.5f, 4}}; // the floor and the wall
    const TestEnvironment sky = constantCube(gpu(), {0, 0, 1});     // the answer where the probe's wall and ball hide
    const SyntheticCamera camera = {.position = {0.3, 1.6, 3}, .target = {0, 0, -0.6}, .fovY = 0.9};
    constexpr uint32_t kWidth = 192, kHeight = 128;
    const auto wrongShare = [&](bool distances, int steps) {
        probe.alphaIsInverseDistance = distances;
        Settings settings = probesAlone();
        settings.sky.enabled = true;
        settings.probes.steps = steps;
        const Picture picture = look({probe}, mirrorFloor(), camera, kWidth, kHeight, settings, sky.map);
        int wrong = 0, pixels = 0;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const glm::dvec3 d = camera.rayThrough(x, y, kWidth, kHeight);
                if (d.y >= 0)
                    continue;
                const glm::dvec3 at = camera.position - d * (camera.position.y / d.y);
                if (at.z < -3.9)
                    continue; // behind the wall
                const glm::dvec3 r = {d.x, -d.y, d.z};
                const Seen met = openPlace(at, r);
                const glm::dvec3 toMet = std::isinf(met.distance) ? r : at + met.distance * r - capture;
                const double shown = openPlace(capture, glm::normalize(toMet)).distance;
                if (std::isinf(met.distance) ? !std::isinf(shown) : shown < 0.99 * glm::length(toMet))
                    continue; // the probe's cube does not show it
                const glm::dvec3 right = met.radiance;
                wrong += glm::distance(reflected(picture, size_t{y} * kWidth + x), right) > 0.3 ? 1 : 0;
                ++pixels;
            }
        EXPECT_GT(pixels, 10000);
        return double(wrong) / pixels;
    };
    const double marched = wrongShare(true, Settings().probes.steps);
    const double proxied = wrongShare(true, 0);
    RecordProperty("marched", std::to_string(marched));
    RecordProperty("proxied", std::to_string(proxied));
    // Measured: 0.028 and 0.174. The remaining errors are silhouettes, and rays that pass behind the ball. It was 0.041
    // where texels that mix two surfaces were shown, and where the wall's end between two steps was stepped over.
    EXPECT_LT(marched, 0.035);
    EXPECT_GT(proxied, 0.15); // the test detects the effect of distances
    EXPECT_EQ(wrongShare(false, Settings().probes.steps), proxied);
}

TEST_F(ProbesTest, whatIsNearItsReflectionIsSharper) {
    constexpr uint32_t kMips = 5;
    const TestEnvironment cube = TestEnvironment::make(
        gpu(), 64, kMips, [](const glm::dvec3&, uint32_t mip) { return glm::vec3(static_cast<float>(mip)); });
    const SyntheticCamera camera = {.position = {0.3, 1.2, 1.5}, .target = {0, 0, -0.5}, .fovY = 1};
    for (const ProbeProxy proxy : {ProbeProxy::Box, ProbeProxy::Sphere, ProbeProxy::Infinite})
        for (const float roughness : {0.f, 0.3f, 0.6f, 1.f}) {
            Probe probe = probeOf(cube);
            probe.capturePositionWS = {-0.4f, 1, 0.2f};
            probe.influence = {{0, 0, 0}, {0, 0, 0, 1}, {50, 50, 50}};
            probe.proxy = proxy;
            probe.proxyVolume = {{0.2f, 0.5f, 0}, {0, 0, 0, 1}, {8, 7, 9}};
            const SyntheticScene floor = mirrorFloor(roughness);
            const Picture picture = look({probe}, floor, camera, 24, 18, probesAlone());
            for (uint32_t y = 0; y < 18; ++y)
                for (uint32_t x = 0; x < 24; ++x) {
                    const glm::dvec3 direction = camera.rayThrough(x, y, 24, 18);
                    const auto surface = floor(camera.position, direction);
                    if (!surface || surface->distance > 6)
                        continue;
                    const glm::dvec3 at = camera.position + direction * surface->distance;
                    const glm::dvec3 r = {direction.x, -direction.y, direction.z};
                    double sharper = roughness;
                    if (proxy != ProbeProxy::Infinite) {
                        const double toHit = oracle::proxyDistance(probe, at, r);
                        const double fromCapture =
                            glm::distance(at + r * toHit, oracle::toDvec(probe.capturePositionWS));
                        const double scaled = std::clamp(toHit / fromCapture * roughness, 0.0, double(roughness));
                        sharper = scaled + (roughness - scaled) * roughness;
                    }
                    EXPECT_NEAR(reflected(picture, y * 24 + x).r, sharper * (kMips - 1), 0.02)
                        << "proxy " << static_cast<int>(proxy) << ", roughness " << roughness;
                }
        }
}

// ---------------------------------------------------------------- how much

/// Probes of all kinds, scattered over a floor of 12 m.
std::vector<Probe> scattered(const std::vector<TestEnvironment>& cubes, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0, 1);
    const auto between = [&](float low, float high) { return low + (high - low) * unit(random); };
    std::vector<Probe> probes;
    for (const TestEnvironment& cube : cubes) {
        Probe probe = probeOf(cube);
        probe.shape = unit(random) < 0.4f ? ProbeShape::Sphere : ProbeShape::Box;
        probe.influence.centerWS = {between(-6, 6), between(-0.5f, 1), between(-6, 6)};
        probe.influence.halfExtents = {between(0.5f, 5), between(0.5f, 3), between(0.5f, 5)};
        const glm::quat q = glm::normalize(glm::quat(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)));
        probe.influence.rotation = {q.x, q.y, q.z, q.w};
        for (size_t face = 0; face < 6; ++face) {
            probe.blendDistance[face] = between(0.1f, 1.5f);
            probe.blendNormalDistance[face] = unit(random) < 0.3f ? between(0, 0.5f) : 0;
            probe.faceFade[face] = unit(random) < 0.5f ? 1 : unit(random);
        }
        probe.capturePositionWS = {probe.influence.centerWS[0], 1, probe.influence.centerWS[2]};
        probe.weight = unit(random) < 0.5f ? 1 : unit(random);
        probe.proxy = ProbeProxy::Infinite;
        probes.push_back(probe);
    }
    return probes;
}

TEST_F(ProbesTest, weightsAreThoseOfTheFormulas) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    const SyntheticCamera camera = {.position = {1, 6, 8}, .target = {0, 0, 0}, .fovY = 1};
    constexpr uint32_t kWidth = 64, kHeight = 48;
    for (const size_t count : {1, 3, 40}) {
        std::vector<TestEnvironment> cubes;
        std::vector<glm::vec3> radiances;
        for (size_t i = 0; i < count; ++i) {
            radiances.emplace_back(unit(random), unit(random), 1.f); // blue is the sum of the weights
            cubes.push_back(constantCube(gpu(), radiances.back()));
        }
        std::vector<Probe> probes = scattered(cubes, random);
        if (count == 1) {
            probes[0].influence.centerWS = {0, 0, 0};
            probes[0].influence.halfExtents = {4, 3, 5};
        }
        const SyntheticScene floor = mirrorFloor();
        const Picture picture = look(probes, floor, camera, kWidth, kHeight, probesAlone());
        int partial = 0;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const glm::dvec3 direction = camera.rayThrough(x, y, kWidth, kHeight);
                const auto surface = floor(camera.position, direction);
                if (!surface)
                    continue;
                const glm::dvec3 at = camera.position + direction * surface->distance;
                const std::vector<double> shares =
                    oracle::probeShares(probes, at, {0, 1, 0}, {direction.x, -direction.y, direction.z});
                glm::dvec3 expected(0);
                for (size_t i = 0; i < count; ++i)
                    expected += shares[i] * glm::dvec3(radiances[i]);
                const glm::dvec3 found = reflected(picture, size_t{y} * kWidth + x);
                EXPECT_LT(glm::length(found - expected), 4e-3) << count << " probes, at " << x << ", " << y;
                partial += expected.b > 0.01 && expected.b < 0.99 ? 1 : 0;
            }
        EXPECT_GT(partial, 50) << count;
    }
}

TEST_F(ProbesTest, aWhiteFurnaceIsNeverAboveOne) {
    std::mt19937 random(3);
    std::vector<TestEnvironment> cubes;
    for (int i = 0; i < 30; ++i)
        cubes.push_back(constantCube(gpu(), glm::vec3(1), 5));
    const TestEnvironment sky = constantCube(gpu(), glm::vec3(1), 5);
    std::vector<Probe> probes = scattered(cubes, random);
    for (Probe& probe : probes)
        probe.proxy = probe.shape == ProbeShape::Box ? ProbeProxy::Box : ProbeProxy::Sphere;
    const SyntheticCamera camera = {.position = {1, 6, 8}, .target = {0, 0, 0}, .fovY = 1};
    for (const float roughness : {0.f, 0.3f, 1.f})
        for (const bool screen : {false, true}) {
            Settings settings = plainSettings();
            settings.screen.enabled = screen;
            const SyntheticScene white = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
                auto surface = mirrorFloor(roughness)(origin, direction);
                const double toWall = (-5 - origin.z) / direction.z;
                if (toWall > 0 && (!surface || toWall < surface->distance))
                    surface = SyntheticSurface{toWall, {0, 0, 1}, glm::vec3(0), 0, glm::vec3(1)};
                else if (surface)
                    surface->radiance = glm::vec3(0);
                return surface;
            };
            const Picture picture = look(probes, white, camera, 48, 36, settings, sky.map);
            for (size_t i = 0; i < picture.pixels(); ++i) {
                EXPECT_LE(reflected(picture, i).r, 1.001);
                EXPECT_LE(picture.color(i).r, 1.005) << "roughness " << roughness;
            }
            const double middle = reflected(picture, size_t{30} * 48 + 24).r;
            EXPECT_NEAR(middle, 1, 2e-3); // and the sky takes the remaining weight
        }
}

/// A white metal floor before an emissive white wall, in white surroundings.
TEST_F(ProbesTest, everyCombinationOfSourcesStaysAtOne) {
    SurfaceScene scene;
    scene.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.1f));
    scene.addQuad({-4, 0, -3}, {8, 0, 0}, {0, 2, 0}, emitting(glm::vec3(1)));
    SurfaceScene::World world = scene.build(gpu(), library(), RayBackend::Bvh);
    run([&](VkCommandBuffer commands) {
        world.rays.record(commands);
        world.surfaces.record(commands);
    });
    const SyntheticCamera camera = {.position = {0, 1.2, 4}, .target = {0, 0.3, 0}};
    SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene), camera, 48, 36);
    const TestEnvironment white = constantCube(gpu(), glm::vec3(1), 5);
    std::vector<Probe> list(3, probeOf(white));
    for (size_t i = 0; i < list.size(); ++i) {
        list[i].influence = {{static_cast<float>(i) * 1.5f - 1.5f, 0, 0}, {0, 0, 0, 1}, {2, 2, 3}};
        list[i].blendDistance.fill(1);
        list[i].proxyVolume = {{0, 2, 0}, {0, 0, 0, 1}, {6, 3, 6}};
    }
    Probes probes = must(Probes::create(library(), {list}));
    run([&](VkCommandBuffer commands) { probes.record(commands); });
    Settings settings = plainSettings();
    settings.rays.enabled = true;
    Reflections reflections = LibraryTest::reflections(48, 36, settings);
    must(reflections.setInputs(g.gbuffer, white.map));
    must(reflections.setRays(world.rays, world.surfaces));
    must(reflections.setProbes(probes));
    for (uint32_t on = 0; on < 16; ++on) {
        settings.screen.enabled = (on & 1) != 0;
        settings.rays.enabled = (on & 2) != 0;
        settings.rays.lobe = RayLobe::Mirror;
        settings.probes.enabled = (on & 4) != 0;
        settings.sky.enabled = (on & 8) != 0;
        must(reflections.setSettings(settings));
        const Picture picture = trace(reflections, camera.view(48, 36));
        for (size_t i = 0; i < picture.pixels(); ++i) {
            ASSERT_LE(reflected(picture, i).r, 1.002) << "sources " << on << ", pixel " << i;
            if ((on & 8) != 0 && picture.composite[i * 4 + 3] > 0 && reflected(picture, i).r > 0) {
                ASSERT_NEAR(reflected(picture, i).r, 1, 2e-3)
                    << "sources " << on << ", pixel " << i; // the sky takes the remaining weight
            }
        }
        EXPECT_EQ(ran(picture, "probes/reflect"), (on & 4) != 0);
    }
}

TEST_F(ProbesTest, noProbesCostNothing) {
    const SyntheticCamera camera = {.position = {0, 1, 3}, .target = {0, 0, 0}};
    const TestEnvironment sky = constantCube(gpu(), glm::vec3(0.5f));
    Settings settings = probesAlone();
    settings.sky.enabled = true;
    const Picture none = look({}, mirrorFloor(), camera, 32, 24, settings, sky.map);
    const Picture without = trace(mirrorFloor(), camera, 32, 24, settings, sky.map);
    EXPECT_EQ(none.composite, without.composite);
    EXPECT_FALSE(ran(none, "probes/reflect"));
    Probe probe = probeOf(sky);
    EXPECT_TRUE(ran(look({probe}, mirrorFloor(), camera, 32, 24, settings, sky.map), "probes/reflect"));
    settings.probes.enabled = false;
    const Picture off = look({probe}, mirrorFloor(), camera, 32, 24, settings, sky.map);
    EXPECT_EQ(off.composite, without.composite);
    EXPECT_FALSE(ran(off, "probes/reflect"));
}

// ---------------------------------------------------------------- filtering

TEST_F(ProbesTest, cubesAreFilteredForEveryRoughness) {
    // Light from above, dark below; and texels that are no valid radiance.
    const TestEnvironment raw = TestEnvironment::make(gpu(), 32, 1, [](const glm::dvec3& direction, uint32_t) {
        const bool broken = std::abs(direction.x - 0.2) < 0.01;
        return broken ? glm::vec3(std::numeric_limits<float>::quiet_NaN()) : glm::vec3(direction.y > 0 ? 1.f : 0.f);
    });
    Probe probe = probeOf(raw);
    probe.prefiltered = false;
    Probes probes = must(Probes::create(library(), {{&probe, 1}, 64}));
    run([&](VkCommandBuffer commands) { probes.record(commands); });
    EXPECT_EQ(probes.cube(0).width, 64u);
    EXPECT_EQ(probes.cubeMips(0), 4u); // 64 to 8
    const HostImage cube = probes.cube(0);
    gpu::ResourceState state;
    state.layout = cube.layout;
    gpu::Image borrowed = gpu::Image::borrow(
        cube.image, cube.view,
        {"cube", cube.format, cube.width, cube.height, probes.cubeMips(0), 6, gpu::ImageShape::Flat, 0}, state);
    double lastBand = 0;
    for (uint32_t mip = 0; mip < 4; ++mip) {
        double band = 0; // texels of the +Z face that are neither dark nor bright
        const std::vector<float> texels = must(gpu::downloadImageAsFloats(gpu(), borrowed, mip, 4));
        for (size_t i = 0; i < texels.size(); i += 4) {
            EXPECT_TRUE(texels[i] >= 0 && texels[i] <= 1.001f) << texels[i];
            band += texels[i] > 0.1f && texels[i] < 0.9f ? 4.0 / static_cast<double>(texels.size()) : 0;
        }
        if (mip > 0) {
            EXPECT_GT(band, lastBand) << "mip " << mip;
        }
        lastBand = band;
    }
}

TEST_F(ProbesTest, aCubeThatTheHostDrewAnewIsFilteredAnew) {
    const SyntheticCamera camera = {.position = {0, 1, 3}, .target = {0, 0, 0}};
    TestEnvironment cube = constantCube(gpu(), glm::vec3(0.25f));
    Probe probe = probeOf(cube);
    probe.prefiltered = false;
    probe.influence.halfExtents = {1000, 1000, 1000};
    Probes probes = must(Probes::create(library(), {{&probe, 1}}));
    SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), mirrorFloor(), camera, 8, 8);
    Reflections reflections = LibraryTest::reflections(8, 8, probesAlone());
    must(reflections.setInputs(g.gbuffer));
    must(reflections.setProbes(probes));
    const auto floorShows = [&] {
        run([&](VkCommandBuffer commands) { probes.record(commands); });
        return reflected(trace(reflections, camera.view(8, 8)), 7 * 8 + 4).r;
    };
    EXPECT_NEAR(floorShows(), 0.25, 1e-3);
    run([&](VkCommandBuffer commands) {
        gpu::Frame frame(gpu(), commands);
        frame.clear(cube.cube, {{0.75f, 0.75f, 0.75f, 1}});
        frame.hand(cube.cube, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                               VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    });
    EXPECT_NEAR(floorShows(), 0.25, 1e-3); // until the change is declared
    probes.refilter(0);
    EXPECT_NEAR(floorShows(), 0.75, 1e-3);
    probe.strength = 2;
    must(probes.setVolumes({&probe, 1}));
    EXPECT_NEAR(floorShows(), 1.5, 1e-2);
}

// ---------------------------------------------------------------- errors

TEST_F(ProbesTest, whatCannotBeIsNamed) {
    const TestEnvironment cube = constantCube(gpu(), glm::vec3(1));
    const auto errorOf = [&](const std::function<void(Probe&)>& spoil, uint32_t faceSize = 0) {
        std::vector<Probe> probes(2, probeOf(cube));
        spoil(probes[1]);
        const auto made = Probes::create(library(), {probes, faceSize});
        return made ? std::string() : made.error().message;
    };
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(errorOf([](Probe&) {}), "");
    EXPECT_THAT(errorOf([](Probe& p) { p.influence.rotation = {0, 0, 0, 0}; }), testing::HasSubstr("unit quaternion"));
    EXPECT_THAT(errorOf([](Probe& p) { p.influence.halfExtents[1] = 0; }), testing::HasSubstr("probe 1"));
    EXPECT_THAT(errorOf([](Probe& p) { p.influence.centerWS[2] = kNan; }), testing::HasSubstr("centre"));
    EXPECT_THAT(errorOf([](Probe& p) { p.proxyVolume.halfExtents[0] = -1; }), testing::HasSubstr("proxy"));
    EXPECT_THAT(errorOf([](Probe& p) { p.capturePositionWS[0] = kNan; }), testing::HasSubstr("capture"));
    EXPECT_THAT(errorOf([](Probe& p) { p.blendDistance[5] = -1; }), testing::HasSubstr("blend"));
    EXPECT_THAT(errorOf([](Probe& p) { p.faceFade[0] = 2; }), testing::HasSubstr("fade"));
    EXPECT_THAT(errorOf([](Probe& p) { p.strength = kNan; }), testing::HasSubstr("strength"));
    EXPECT_THAT(errorOf([](Probe& p) { p.cube = {}; }), testing::HasSubstr("cube"));
    EXPECT_THAT(errorOf([](Probe& p) { p.cube.layout = VK_IMAGE_LAYOUT_GENERAL; }), testing::HasSubstr("READ_ONLY"));
    EXPECT_THAT(errorOf([](Probe&) {}, 48), testing::HasSubstr("power of two"));
    // Unused fields are not checked.
    EXPECT_EQ(errorOf([](Probe& p) {
                  p.proxy = ProbeProxy::Infinite;
                  p.proxyVolume.halfExtents[0] = kNan;
              }),
              "");
    Probe one = probeOf(cube);
    Probes probes = must(Probes::create(library(), {{&one, 1}}));
    const std::vector<Probe> two(2, one);
    EXPECT_FALSE(probes.setVolumes(two));
}

} // namespace probes_test
} // namespace glint::test
