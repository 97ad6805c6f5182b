// The promises of march proxy alone: the hit that its volume predicts, at one lookup a ray, and no answer where that
// lookup shows that the volume must be wrong.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include "reflect/trace/outcomes.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace glint::test {
namespace proxy_test {

constexpr uint32_t kWidth = 192;
constexpr uint32_t kHeight = 128;

/// A room of 4 x 3 x 5 m.
constexpr glm::dvec3 kRoomCenter = {0.5, 1.5, -1};
constexpr glm::dvec3 kRoomHalf = {2, 1.5, 2.5};
/// Off the room's middle, so that no reflection is correct by symmetry.
const SyntheticCamera kInRoom = {.position = {1.7, 2.2, 1.2}, .target = {0.1, 0, -1.6}, .fovY = 1.1};

/// Where a ray from inside leaves the room, and through which face.
struct Wall {
    glm::dvec3 position;
    glm::dvec3 normal;
};

Wall wallOf(const glm::dvec3& origin, const glm::dvec3& direction) {
    double t = 1e30;
    glm::dvec3 normal(0);
    for (int axis = 0; axis < 3; ++axis) {
        const double side = std::copysign(1.0, direction[axis]);
        const double toFace = (kRoomCenter[axis] + side * kRoomHalf[axis] - origin[axis]) / direction[axis];
        if (direction[axis] != 0 && toFace < t) {
            t = toFace;
            normal = glm::dvec3(0);
            normal[axis] = -side;
        }
    }
    return {origin + direction * t, normal};
}

const glm::dvec3 kShown = {3, 1, 4.5}; ///< added to positions that are shown as colours, so that no channel is negative

/// The floor is a mirror; the walls' colour is their position.
std::optional<SyntheticSurface> room(const glm::dvec3& origin, const glm::dvec3& direction) {
    const Wall wall = wallOf(origin, direction);
    const bool floor = wall.normal.y > 0;
    return SyntheticSurface{glm::length(wall.position - origin), wall.normal, glm::vec3(floor ? 1 : 0), 0,
                            floor ? glm::vec3(0) : glm::vec3(wall.position + kShown)};
}

Probe roomVolume() {
    Probe probe;
    probe.influence = {{0.5f, 1.5f, -1}, {0, 0, 0, 1}, {3, 2, 4}};
    probe.proxyVolume = {{0.5f, 1.5f, -1}, {0, 0, 0, 1}, {2, 1.5f, 2.5f}};
    return probe;
}

/// A mirror floor under a dome.
constexpr double kRadius = 3;
const glm::dvec3 kDomeCenter = {0.2, -0.5, -0.3};

double toDome(const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 p = origin - kDomeCenter;
    const double b = glm::dot(p, direction);
    return std::sqrt(b * b - glm::dot(p, p) + kRadius * kRadius) - b;
}

std::optional<SyntheticSurface> dome(const glm::dvec3& origin, const glm::dvec3& direction) {
    const double toFloor = -origin.y / direction.y;
    const double distance = toDome(origin, direction);
    if (toFloor > 1e-9 && toFloor < distance)
        return SyntheticSurface{.distance = toFloor, .f0 = glm::vec3(1)};
    const glm::dvec3 at = origin + direction * distance;
    return SyntheticSurface{distance, (kDomeCenter - at) / kRadius, glm::vec3(0), 0, glm::vec3(at + kShown)};
}

Probe domeVolume() {
    Probe probe;
    probe.influence.halfExtents = {10, 10, 10};
    probe.proxy = ProbeProxy::Sphere;
    probe.proxyVolume = {{0.2f, -0.5f, -0.3f}, {0, 0, 0, 1}, {kRadius, 1, 1}};
    return probe;
}

class ProxyTest : public LibraryTest {
protected:
    static Settings settings() { return plainSettings(March::Proxy); }

    static Picture show(const std::vector<Probe>& volumes, const SyntheticScene& scene, const SyntheticCamera& camera,
                        const Settings& settings = ProxyTest::settings()) {
        return traceWithin(volumes, scene, camera, kWidth, kHeight, settings);
    }

    struct Seen {
        size_t hits = 0;
        size_t behind = 0;
        size_t offScreen = 0;
        double worstPX = 0;    ///< of hits, from the place predicted
        double worstColor = 0; ///< metres between the position that a hit shows and the correct one
    };

    /// Every mirror pixel against `end(start, direction)`, the hit of its ray.
    template <class End>
    static Seen check(const Picture& picture, const SyntheticScene& scene, const SyntheticCamera& camera, End end) {
        Seen seen;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            const glm::dvec3 direction = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const auto surface = scene(camera.position, direction);
            if (!surface || surface->f0.x == 0)
                continue;
            const glm::dvec3 start = camera.position + direction * surface->distance;
            const glm::dvec3 place = end(start, glm::reflect(direction, surface->normalWS));
            const double depth = camera.viewZ(place);
            if (std::abs(depth - camera.near) < 0.01)
                continue;
            if (depth < camera.near) {
                ++seen.behind;
                EXPECT_EQ(reflect::kOutcomeNames[picture.outcome(i)], "behindCamera") << i;
                EXPECT_EQ(picture.lookups[i * 4], 0) << i;
                continue;
            }
            const glm::dvec2 expected = camera.project(place, kWidth, kHeight);
            const glm::dvec2 inside = glm::min(expected, glm::dvec2(kWidth, kHeight) - expected);
            const double border = std::min(inside.x, inside.y);
            if (border < -0.1) {
                ++seen.offScreen;
                EXPECT_EQ(reflect::kOutcomeNames[picture.outcome(i)], "offScreen") << i;
                EXPECT_EQ(picture.lookups[i * 4], 0) << i;
            }
            if (border < 0.1)
                continue;
            const glm::dvec3 toPixel = camera.rayThrough(static_cast<uint32_t>(expected.x),
                                                         static_cast<uint32_t>(expected.y), kWidth, kHeight);
            const auto shown = scene(camera.position, toPixel);
            EXPECT_EQ(picture.lookups[i * 4], 1) << i;
            if (!shown || shown->f0.x > 0)
                continue; // the centre of that pixel shows the mirror itself
            ++seen.hits;
            EXPECT_EQ(reflect::kOutcomeNames[picture.outcome(i)], "hit") << i;
            EXPECT_EQ(picture.weight[i * 4], 1) << i;
            EXPECT_NEAR(picture.hitDistance[i * 4], glm::distance(start, place), 2e-3 * glm::distance(start, place));
            seen.worstPX = std::max(seen.worstPX, glm::distance(picture.hitPX(i), expected));
            const glm::dvec3 found(picture.reflection[i * 4], picture.reflection[i * 4 + 1],
                                   picture.reflection[i * 4 + 2]);
            const glm::dvec2 inTexel = expected - glm::floor(expected) - 0.5;
            if (std::max(std::abs(inTexel.x), std::abs(inTexel.y)) < 0.45) // otherwise it may be the neighbour's texel
                seen.worstColor = std::max(seen.worstColor, glm::distance(found, glm::dvec3(shown->radiance)));
            if (HasFailure())
                break;
        }
        return seen;
    }
};

// ---------------------------------------------------------------- where

TEST_F(ProxyTest, aBoxRoomIsReflectedInItsPlaceAtOneLookup) {
    const auto end = [](const glm::dvec3& p, const glm::dvec3& d) { return wallOf(p, d).position; };
    const Picture picture = show({roomVolume()}, room, kInRoom);
    const Seen seen = check(picture, room, kInRoom, end);
    EXPECT_GT(seen.hits, 4000u);
    EXPECT_GT(seen.offScreen, 1000u);
    EXPECT_LT(seen.worstPX, 0.05);
    EXPECT_LT(seen.worstColor, 0.01) << "halves";
    EXPECT_EQ(picture.statistics.lookups95, 1u);
    RecordProperty("worstPX", std::to_string(seen.worstPX));

    // The same room in other axes: turned by a quarter about y, x and z swap.
    Probe turned = roomVolume();
    const float s = std::sqrt(0.5f);
    turned.influence.rotation = turned.proxyVolume.rotation = {0, s, 0, s};
    turned.influence.halfExtents = {4, 2, 3};
    turned.proxyVolume.halfExtents = {2.5f, 1.5f, 2};
    EXPECT_LT(check(show({turned}, room, kInRoom), room, kInRoom, end).worstPX, 0.05);

    // The error is the volume's error: a wall half a metre farther off moves the hit.
    Probe larger = roomVolume();
    larger.proxyVolume.halfExtents[2] += 0.5f;
    const Picture wrong = show({larger}, room, kInRoom);
    double worst = 0;
    for (uint32_t i = 0; i < wrong.pixels(); ++i)
        if (wrong.hit(i) && picture.hit(i))
            worst = std::max(worst, glm::distance(wrong.hitPX(i), picture.hitPX(i)));
    EXPECT_GT(worst, 5);
}

TEST_F(ProxyTest, aDomeIsReflectedInItsPlace) {
    const SyntheticCamera camera = {.position = {0.5, 1.1, 1.2}, .target = {0.1, 0.2, -1}, .fovY = 1.1};
    const Seen seen = check(show({domeVolume()}, dome, camera), dome, camera,
                            [](const glm::dvec3& p, const glm::dvec3& d) { return p + d * toDome(p, d); });
    EXPECT_GT(seen.hits, 4000u);
    EXPECT_LT(seen.worstPX, 0.05);
    EXPECT_LT(seen.worstColor, 0.01);
}

TEST_F(ProxyTest, raysThatComeBackEndBehindTheCamera) {
    // A mirror on the far wall shows the room behind the camera, which no frame shows, and the room's sides.
    const SyntheticScene mirror = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto surface = room(origin, direction);
        surface->f0 = glm::vec3(surface->normalWS.z > 0 ? 1 : 0);
        return surface;
    };
    const SyntheticCamera camera = {.position = {0.9, 1.2, 0.3}, .target = {0.6, 1.3, -2}, .fovY = 1.2};
    const Seen seen = check(show({roomVolume()}, mirror, camera), mirror, camera,
                            [](const glm::dvec3& p, const glm::dvec3& d) { return wallOf(p, d).position; });
    EXPECT_GT(seen.behind, 500u);
    EXPECT_GT(seen.offScreen, 100u);
}

TEST_F(ProxyTest, withoutAProxyTheDirectionAloneCounts) {
    const SyntheticCamera camera;
    const Stage stage = floorAndWall();
    Probe noProxy = wallVolume();
    noProxy.proxy = ProbeProxy::Infinite;
    Probe elsewhere = wallVolume();
    elsewhere.influence = {{0, -5, 0}, {0, 0, 0, 1}, {100, 1, 100}};
    Probe silent = wallVolume();
    silent.weight = 0;
    Settings infinite = settings();
    infinite.screen.maxDistance = 7; // a direction has no length
    const Picture alone = trace(stage, camera, kWidth, kHeight, infinite);
    for (const Probe& probe : {noProxy, elsewhere, silent})
        EXPECT_EQ(show({probe}, stage, camera, infinite).hitUV, alone.hitUV);
    size_t hits = 0;
    for (uint32_t i = 0; i < alone.pixels(); ++i) {
        const glm::dvec3 direction = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const auto surface = stage(camera.position, direction);
        if (surface->f0.x == 0)
            continue;
        const glm::dvec3 far = camera.position + glm::reflect(direction, surface->normalWS) * 1e7;
        const glm::dvec2 expected = camera.project(far, kWidth, kHeight);
        const glm::dvec2 inside = glm::min(expected, glm::dvec2(kWidth, kHeight) - expected);
        if (std::min(inside.x, inside.y) < 0.1)
            continue;
        const double startZ = camera.viewZ(camera.position + direction * surface->distance);
        const glm::dvec3 toPixel =
            camera.rayThrough(static_cast<uint32_t>(expected.x), static_cast<uint32_t>(expected.y), kWidth, kHeight);
        const auto shown = stage(camera.position, toPixel);
        if (camera.viewZ(camera.position + toPixel * shown->distance) < startZ * 1.01)
            continue; // nearer than all of the ray
        ASSERT_TRUE(alone.hit(i)) << i << ": " << reflect::kOutcomeNames[alone.outcome(i)];
        ASSERT_LT(glm::distance(alone.hitPX(i), expected), 0.05) << i;
        ASSERT_NEAR(alone.hitDistance[i * 4], 7, 0.01) << "what fades and filters take it for";
        ++hits;
    }
    EXPECT_GT(hits, 1000u);

    SyntheticCamera orthographic;
    orthographic.orthoHeight = 3; // no orthographic frame shows what is infinitely far in another direction
    const Picture parallel = trace(stage, orthographic, kWidth, kHeight, settings());
    EXPECT_EQ(parallel.counted("offScreen"), parallel.statistics.rays);
    EXPECT_GT(parallel.statistics.rays, 1000u);
}

TEST_F(ProxyTest, aHostWithoutProbesIsToldOnce) {
    using testing::Contains;
    using testing::HasSubstr;
    Reflections made = reflections(kWidth, kHeight, plainSettings(March::Hiz));
    EXPECT_THAT(made.notes(), Not(Contains(HasSubstr("march proxy"))));
    must(made.setSettings(settings()));
    EXPECT_THAT(made.notes(), Contains(HasSubstr("march proxy without probes")));
    const TestVolumes given = TestVolumes::giveTo(made, gpu(), library(), {wallVolume()});
    EXPECT_THAT(made.notes(), Not(Contains(HasSubstr("march proxy"))));
}

TEST_F(ProxyTest, aProxyFartherThanTheLongestRayIsNotMet) {
    Settings changed = settings();
    changed.screen.maxDistance = 1.5f;
    const Picture picture = show({roomVolume()}, room, kInRoom, changed);
    EXPECT_GT(picture.counted("maxDistance"), 500u);
    EXPECT_GT(picture.counted("hit"), 500u);
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        if (picture.hit(i)) {
            ASSERT_LE(picture.hitDistance[i * 4], 1.5f * 1.001f);
        }
    }
}

TEST_F(ProxyTest, theSmallestVolumeThatInfluencesThePixelCounts) {
    const SyntheticCamera camera;
    const Stage stage = floorAndWall();
    const Picture right = show({wallVolume()}, stage, camera);
    Probe small = wallVolume(); // around the left half of the floor, with a wall of its own
    small.influence = {{-500, 0, 0}, {0, 0, 0, 1}, {500, 100, 100}};
    small.proxyVolume.centerWS[2] += 0.5f;
    const Picture left = show({small}, stage, camera);
    const Picture both = show({wallVolume(), small}, stage, camera);
    size_t pixels[2] = {};
    for (uint32_t i = 0; i < both.pixels(); ++i) {
        const glm::dvec3 direction = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const auto surface = stage(camera.position, direction);
        const double x = camera.position.x + direction.x * surface->distance;
        if (surface->f0.x == 0 || std::abs(x) < 0.01)
            continue;
        const Picture& expected = x < 0 ? left : right;
        ASSERT_EQ(both.hitUV[i * 4 + 1], expected.hitUV[i * 4 + 1]) << i;
        pixels[x < 0] += expected.hit(i) && left.hitUV[i * 4 + 1] != right.hitUV[i * 4 + 1];
    }
    EXPECT_GT(pixels[0], 500u);
    EXPECT_GT(pixels[1], 500u);
}

TEST_F(ProxyTest, volumesThatTheHostMovesMoveAlong) {
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), floorAndWall(), camera, kWidth, kHeight);
    Reflections made = reflections(kWidth, kHeight, settings());
    must(made.setInputs(host.gbuffer));
    TestVolumes given = TestVolumes::giveTo(made, gpu(), library(), {wallVolume()});
    const Picture before = trace(made, camera.view(kWidth, kHeight));
    Probe moved = wallVolume();
    moved.proxyVolume.centerWS[2] += 0.5f;
    must(given.probes.setVolumes({&moved, 1}));
    run([&](VkCommandBuffer commands) { given.probes.record(commands); });
    EXPECT_EQ(trace(made, camera.view(kWidth, kHeight)).hitUV, show({moved}, floorAndWall(), camera).hitUV);
    must(given.probes.setVolumes({std::array{wallVolume()}}));
    run([&](VkCommandBuffer commands) { given.probes.record(commands); });
    EXPECT_EQ(trace(made, camera.view(kWidth, kHeight)).hitUV, before.hitUV);
}

// ---------------------------------------------------------------- what the lookup rejects

/// Pixels of the floor whose ray ends, in the volume of the wall at z = -3, where the frame shows a surface for which
/// `is` returns true.
template <class Is>
size_t countWhere(const Picture& picture, const Stage& stage, const SyntheticCamera& camera, uint32_t outcome, Is is) {
    size_t count = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        const glm::dvec3 direction = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const auto surface = stage(camera.position, direction);
        if (!surface || surface->f0.x == 0)
            continue;
        const glm::dvec3 start = camera.position + direction * surface->distance;
        const glm::dvec3 up = glm::reflect(direction, surface->normalWS);
        const glm::dvec2 px = camera.project(start + up * ((-3 - start.z) / up.z), kWidth, kHeight);
        if (!(px.x > 0 && px.y > 0 && px.x < kWidth && px.y < kHeight))
            continue;
        const glm::dvec3 toPixel =
            camera.rayThrough(static_cast<uint32_t>(px.x), static_cast<uint32_t>(px.y), kWidth, kHeight);
        if (!is(start, stage(camera.position, toPixel), toPixel))
            continue;
        EXPECT_EQ(reflect::kOutcomeNames[picture.outcome(i)], reflect::kOutcomeNames[outcome]) << i;
        EXPECT_EQ(picture.weight[i * 4] > 0, outcome == shared::kOutcomeHit) << i;
        ++count;
    }
    return count;
}

TEST_F(ProxyTest, backgroundIsSky) {
    const SyntheticCamera camera;
    Stage stage;
    stage.cards.push_back({.high = {1e9, 0.8}, .z = -3});
    const Picture picture = show({wallVolume()}, stage, camera);
    EXPECT_GT(countWhere(picture, stage, camera, shared::kOutcomeSky,
                         [](const glm::dvec3&, const auto& shown, const glm::dvec3&) { return !shown; }),
              200u);
}

TEST_F(ProxyTest, whatIsNearerThanAllOfTheRayIsNotMet) {
    const SyntheticCamera camera;
    for (const bool nearer : {true, false}) { // a card between camera and wall, nearer than the floor below it or not
        Stage stage = floorAndWall();
        const double cardZ = nearer ? 1 : 0;
        stage.cards.push_back({.low = {-0.5, 0.25}, .high = {0.5, 1.6}, .z = cardZ});
        const Picture picture = show({wallVolume()}, stage, camera);
        // Where the card is in the ray's path, the ray may have hit it.
        const uint32_t outcome = nearer ? shared::kOutcomeHidden : shared::kOutcomeHit;
        const auto showsCard = [&](const glm::dvec3& start, const auto& shown, const glm::dvec3& toPixel) {
            const glm::dvec3 at = camera.position + toPixel * (shown ? shown->distance : 0);
            const double gap = camera.viewZ(at) / camera.viewZ(start) - 1;
            return std::abs(at.z - cardZ) < 1e-6 && (nearer ? gap < -0.01 : gap > 0.01);
        };
        EXPECT_GT(countWhere(picture, stage, camera, outcome, showsCard), 200u);
    }
}

TEST_F(ProxyTest, aMirrorIsNotItsOwnReflection) {
    // A volume that ends long before the wall: low in the image the frame shows the floor there.
    const SyntheticCamera camera;
    const Stage stage = floorAndWall();
    Probe small = wallVolume();
    small.proxyVolume.centerWS[2] += 1.5f;
    const Picture picture = show({small}, stage, camera);
    size_t own = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.answered(i))
            own += picture.outcome(i) == shared::kOutcomeHidden;
        else // walls are blue
            ASSERT_EQ(picture.reflection[i * 4 + 2], 1) << i;
    }
    EXPECT_GT(own, 200u);
}

// ---------------------------------------------------------------- the inspector

TEST_F(ProxyTest, theInspectorNamesTheProxyAndHowFarItIs) {
    // A pixel whose ray ends well inside the image.
    glm::uvec2 pixel(0);
    glm::dvec3 start(0);
    glm::dvec3 end(0);
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const glm::dvec3 direction = kInRoom.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const Wall floor = wallOf(kInRoom.position, direction);
        start = floor.position;
        end = wallOf(start, glm::reflect(direction, glm::dvec3(0, 1, 0))).position;
        const glm::dvec2 px = kInRoom.project(end, kWidth, kHeight);
        pixel = {i % kWidth, i / kWidth};
        if (floor.normal.y > 0 && glm::distance(start, end) > 0.5 && px.x > 20 && px.y > 5 && px.x < kWidth - 20)
            break;
    }
    const auto inspected = [&](const std::vector<Probe>& volumes, March march) {
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), room, kInRoom, kWidth, kHeight);
        Settings settings = plainSettings(march);
        Reflections made = must(Reflections::create(library(), {kWidth, kHeight, settings, true, true, true}));
        must(made.setInputs(host.gbuffer));
        const TestVolumes given = TestVolumes::giveTo(made, gpu(), library(), volumes);
        run([&](VkCommandBuffer commands) {
            made.record(commands, kInRoom.view(kWidth, kHeight));
            must(made.recordInspection(commands, pixel.x, pixel.y));
        });
        return made.inspection();
    };
    Probe far = roomVolume();
    far.influence.centerWS = {50, 0, 0};
    const RayInspection box = inspected({far, roomVolume()}, March::Proxy);
    ASSERT_TRUE(box.projection);
    EXPECT_EQ(box.projection->probe, 1u) << "as the host counts";
    EXPECT_EQ(box.projection->proxy, "box");
    EXPECT_TRUE(box.hit && box.sameAsFrame);
    EXPECT_EQ(box.lookups, 1u);
    ASSERT_EQ(box.samples.size(), 1u);
    EXPECT_EQ(box.samples[0].decision, "hit");
    EXPECT_NEAR(box.projection->distance, glm::distance(start, end), 1e-3);
    EXPECT_NEAR(box.end.depth, kInRoom.viewZ(end), 1e-3);
    const glm::dvec2 px = kInRoom.project(end, kWidth, kHeight);
    EXPECT_NEAR(box.end.px[0], px.x, 0.02);
    EXPECT_NEAR(box.end.px[1], px.y, 0.02);
    EXPECT_NEAR(box.start.px[0], pixel.x + 0.5, 1e-3);
    EXPECT_NEAR(box.start.depth, kInRoom.viewZ(start), 1e-3);

    Probe sphere = domeVolume();
    sphere.proxyVolume.halfExtents[0] = 9;
    EXPECT_EQ(inspected({sphere}, March::Proxy).projection->proxy, "sphere");
    const RayInspection none = inspected({far}, March::Proxy);
    EXPECT_FALSE(none.projection->probe);
    EXPECT_EQ(none.projection->proxy, "none");
    EXPECT_TRUE(std::isinf(none.projection->distance));
    EXPECT_FALSE(inspected({roomVolume()}, March::Hiz).projection) << "others look for themselves";
}

} // namespace proxy_test
} // namespace glint::test
