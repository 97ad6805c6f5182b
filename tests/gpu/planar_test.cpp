// The source `planar` from a host's side: images that the host provides, the pixels that they answer, and errors.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <gmock/gmock.h>

#include <limits>

namespace glint::test {
namespace planar_test {

/// A room whose walls' colour is their position; its floor, y = 0, is a mirror.
constexpr glm::dvec3 kCenter = {0.5, 1.5, -1};
constexpr glm::dvec3 kHalf = {2, 1.5, 2.5};
const glm::dvec3 kShown = {2.5, 1, 4.5}; ///< added, so that no channel is negative

glm::dvec3 wallPoint(const glm::dvec3& origin, const glm::dvec3& direction) {
    double t = 1e30;
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0)
            t = std::min(t, (kCenter[axis] + std::copysign(kHalf[axis], direction[axis]) - origin[axis]) /
                                direction[axis]);
    return origin + direction * t;
}

std::optional<SyntheticSurface> room(const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 at = wallPoint(origin, direction);
    const bool floor = at.y < 1e-9;
    return SyntheticSurface{glm::length(at - origin), floor ? glm::dvec3(0, 1, 0) : -direction,
                            glm::vec3(floor ? 1.f : 0.f), 0, glm::vec3(0)};
}

PlanarMirror floorMirror() {
    return {{0.5f, 0, -1}, {0, 1, 0}, {1, 0, 0}, {2, 2.5f}, 0};
}

class PlanarSourceTest : public LibraryTest {
protected:
    /// A host's rendering of the room in this view: radiance and device depth.
    struct Drawn {
        gpu::Image radiance;
        gpu::Image depth;
        PlanarPicture picture;
    };
    static Drawn draw(const View& view, uint32_t width, uint32_t height) {
        const glm::dmat4 worldToClip =
            glm::dmat4(glm::make_mat4(view.viewToClip.data())) * glm::dmat4(glm::make_mat4(view.worldToView.data()));
        const glm::dmat4 clipToWorld = glm::inverse(worldToClip);
        std::vector<glm::vec4> radiance;
        std::vector<float> depth;
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                const glm::dvec2 ndc((x + 0.5) / width * 2 - 1, 1 - (y + 0.5) / height * 2);
                const glm::dvec4 near = clipToWorld * glm::dvec4(ndc, 1, 1);
                const glm::dvec4 far = clipToWorld * glm::dvec4(ndc, 0.01, 1);
                const glm::dvec3 from = glm::dvec3(near) / near.w;
                const glm::dvec3 direction = glm::normalize(glm::dvec3(far) / far.w - from);
                // The eye is below the floor: surfaces above the floor are visible.
                const glm::dvec3 start = direction.y > 0 ? from - direction * (from.y / direction.y) : from;
                const glm::dvec3 at = wallPoint(start + direction * 1e-6, direction);
                const glm::dvec4 clip = worldToClip * glm::dvec4(at, 1);
                radiance.emplace_back(glm::vec3(at + kShown), 1);
                depth.push_back(direction.y > 0 ? static_cast<float>(clip.z / clip.w) : 0);
            }
        Drawn drawn;
        drawn.radiance =
            uploadTestImage(gpu(), "test/mirror", VK_FORMAT_R32G32B32A32_SFLOAT, width, height, bytesOf(radiance));
        drawn.depth = uploadTestImage(gpu(), "test/mirrorDepth", VK_FORMAT_R32_SFLOAT, width, height, bytesOf(depth));
        drawn.picture = {hostImage(drawn.radiance), hostImage(drawn.depth), view};
        return drawn;
    }
    static HostImage hostImage(const gpu::Image& image) {
        return {image.handle(), image.view(), image.desc().format, image.width(), image.height()};
    }
    static Settings planarAlone() {
        Settings settings;
        settings.screen.enabled = false;
        settings.sky.enabled = false;
        return settings;
    }
    static PlanarMirrors mirrors(const std::vector<PlanarMirror>& list, uint32_t width = kWidth,
                                 uint32_t height = kHeight) {
        return must(PlanarMirrors::create(library(), {list, width, height, {}}));
    }

    static constexpr uint32_t kWidth = 192;
    static constexpr uint32_t kHeight = 128;
    const SyntheticCamera camera_ = {.position = {1.7, 2.2, 1.2}, .target = {0.1, 0, -1.6}, .fovY = 1.1};
    SyntheticGBuffer g_ = SyntheticGBuffer::render(gpu(), room, camera_, kWidth, kHeight);

    /// Largest distance in metres between the point that a floor pixel shows and the point that a mirror shows there;
    /// -1 if some pixels show none.
    double worst(PlanarMirrors& planar, const Settings& settings = planarAlone()) {
        Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings);
        must(reflections.setInputs(g_.gbuffer, {}));
        must(reflections.setPlanar(planar));
        const Picture picture = LibraryTest::trace(reflections, camera_.view(kWidth, kHeight));
        double worst = 0;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const glm::dvec3 direction = camera_.rayThrough(x, y, kWidth, kHeight);
                const glm::dvec3 floor = wallPoint(camera_.position, direction);
                if (floor.y > 1e-9)
                    continue;
                const size_t i = (size_t{y} * kWidth + x) * 4;
                const glm::dvec3 shown =
                    glm::dvec3(picture.reflection[i], picture.reflection[i + 1], picture.reflection[i + 2]) - kShown;
                if (shown == -kShown)
                    return -1;
                const glm::dvec3 up(direction.x, -direction.y, direction.z);
                worst = std::max(worst, glm::distance(shown, wallPoint(floor + up * 1e-6, up)));
            }
        return worst;
    }
};

TEST_F(PlanarSourceTest, aRoomsFloorShowsWhatIsAboveIt) {
    PlanarMirrors planar = mirrors({floorMirror()});
    EXPECT_EQ(worst(planar), -1); // no image yet
    const View view = camera_.view(kWidth, kHeight);
    ASSERT_TRUE(facesView(floorMirror(), view));
    Drawn drawn = draw(mirroredView(view, floorMirror()), kWidth, kHeight);
    run([&](VkCommandBuffer commands) { must(planar.record(commands, 0, drawn.picture)); });
    const double error = worst(planar);
    EXPECT_GE(error, 0);
    EXPECT_LT(error, 0.01); // halves hold 4 m to 2 mm a channel
    planar.skip(0);
    EXPECT_EQ(worst(planar), -1);
}

TEST_F(PlanarSourceTest, pixelsOffItsOutlineAreNotItsOwn) {
    PlanarMirror small = floorMirror();
    small.halfExtents = {0.2f, 0.2f};
    PlanarMirrors planar = mirrors({small});
    Drawn drawn = draw(mirroredView(camera_.view(kWidth, kHeight), small), kWidth, kHeight);
    run([&](VkCommandBuffer commands) { must(planar.record(commands, 0, drawn.picture)); });
    EXPECT_EQ(worst(planar), -1);
    // Two together, the second one for the remaining weight.
    PlanarMirrors both = mirrors({small, floorMirror()});
    run([&](VkCommandBuffer commands) {
        must(both.record(commands, 0, drawn.picture));
        must(both.record(commands, 1, drawn.picture));
    });
    EXPECT_LT(worst(both), 0.01);
    // The mirror has moved: its image is from the old place.
    must(both.setMirrors(std::vector<PlanarMirror>{small, floorMirror()}));
    EXPECT_EQ(worst(both), -1);
}

TEST_F(PlanarSourceTest, coarserPicturesAreOnlyCoarser) {
    PlanarMirrors planar = mirrors({floorMirror()}, kWidth / 2, kHeight / 2);
    Drawn drawn = draw(mirroredView(camera_.view(kWidth, kHeight), floorMirror()), kWidth / 2, kHeight / 2);
    run([&](VkCommandBuffer commands) { must(planar.record(commands, 0, drawn.picture)); });
    const double error = worst(planar);
    EXPECT_GE(error, 0);
    EXPECT_LT(error, 0.15); // a texel at the room's end spans 6 cm, more where walls are seen at a slant
}

TEST_F(PlanarSourceTest, noMirrorsCostNothing) {
    PlanarMirrors none = mirrors({});
    Reflections reflections = LibraryTest::reflections(kWidth, kHeight, planarAlone());
    must(reflections.setInputs(g_.gbuffer, {}));
    must(reflections.setPlanar(none));
    for (const PassTime& time : LibraryTest::trace(reflections, camera_.view(kWidth, kHeight)).passTimes)
        EXPECT_NE(time.name, "planar/reflect");
}

/// Half of the room's floor is a mirror with an image; rays hit an emissive ceiling.
class RaysAfterMirrorsTest : public PlanarSourceTest {
protected:
    /// The screen's weight is below 1 on the floor, and rays replace its hits on the walls, which are emissive. The
    /// walls are too rough for rays of their own.
    static std::optional<SyntheticSurface> roughRoom(const glm::dvec3& origin, const glm::dvec3& direction) {
        std::optional<SyntheticSurface> surface = room(origin, direction);
        const bool floor = surface->f0.x > 0;
        surface->f0 = glm::vec3(floor ? 1 : 0.04f);
        surface->perceptualRoughness = floor ? 0.3f : 0.45f;
        return surface;
    }
    static SurfaceScene ceiling() {
        SurfaceScene scene;
        scene.addQuad({-10, 3, -10}, {20, 0, 0}, {0, 0, 20}, emitting({0.5f, 0.25f, 0.125f}));
        return scene;
    }
    static PlanarMirror halfFloor() {
        PlanarMirror half = floorMirror();
        half.centerWS[0] -= 1;
        half.halfExtents[0] = 1;
        return half;
    }
    static Settings raysAnd(bool screen, bool planar) {
        Settings settings = plainSettings();
        settings.screen.enabled = screen;
        settings.reflect.roughnessFadeStart = 0;
        settings.planar.enabled = planar;
        settings.sky.enabled = false;
        settings.rays.enabled = true;
        settings.rays.maxRoughness = 0.4f;
        return settings;
    }
    Picture look(const Settings& settings) {
        must(reflections_.setSettings(settings));
        return LibraryTest::trace(reflections_, camera_.view(kWidth, kHeight));
    }
    void SetUp() override {
        PlanarSourceTest::SetUp();
        run([&](VkCommandBuffer commands) {
            must(planar_.record(commands, 0, drawn_.picture));
            world_.rays.record(commands);
            world_.surfaces.record(commands);
        });
        must(reflections_.setInputs(rough_.gbuffer));
        must(reflections_.setPlanar(planar_));
        must(reflections_.setRays(world_.rays, world_.surfaces));
        Settings alone = raysAnd(false, true);
        alone.rays.enabled = false;
        mirror_ = look(alone);
        for (size_t i = 0; i < mirror_.pixels(); ++i)
            (isInMirror(i) ? inMirror_ : beside_) += 1;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x)
                if (wallPoint(camera_.position, camera_.rayThrough(x, y, kWidth, kHeight)).y > 1e-9)
                    --beside_;
    }
    bool isInMirror(size_t pixel) const { return mirror_.reflection[pixel * 4] > 0; } ///< its image is nowhere black
    /// The mirror's pixels equal, to the bit, those of the mirror alone; the other pixels equal those of `others`.
    void expectMirrorIn(const Picture& picture, const Picture& others) const {
        for (size_t i = 0; i < picture.pixels(); ++i)
            for (size_t c = 0; c < 4; ++c) {
                const Picture& expected = isInMirror(i) ? mirror_ : others;
                ASSERT_EQ(picture.reflection[i * 4 + c], expected.reflection[i * 4 + c]) << i;
                ASSERT_EQ(picture.composite[i * 4 + c], expected.composite[i * 4 + c]) << i;
            }
    }

    const PlanarMirror half_ = halfFloor();
    SyntheticGBuffer rough_ = SyntheticGBuffer::render(gpu(), roughRoom, camera_, kWidth, kHeight);
    Drawn drawn_ = draw(mirroredView(camera_.view(kWidth, kHeight), half_), kWidth, kHeight);
    PlanarMirrors planar_ = mirrors({half_});
    SurfaceScene scene_ = ceiling();
    SurfaceScene::World world_ = scene_.build(gpu(), library(), RayBackend::Bvh);
    Reflections reflections_ = reflections(kWidth, kHeight);
    Picture mirror_;      ///< planar mirrors alone
    size_t inMirror_ = 0; ///< pixels
    size_t beside_ = 0;   ///< of the floor
};

TEST_F(RaysAfterMirrorsTest, raysAreTracedOnlyBesideTheMirror) {
    ASSERT_GT(inMirror_, 1000u);
    ASSERT_GT(beside_, 1000u);
    for (const bool screen : {false, true}) {
        const Picture without = look(raysAnd(screen, false));
        EXPECT_EQ(without.statistics.scene.pixels, inMirror_ + beside_);
        const Picture with = look(raysAnd(screen, true));
        EXPECT_EQ(with.statistics.scene.pixels, beside_);
        EXPECT_EQ(with.statistics.scene.rays, beside_);
        expectMirrorIn(with, without);
    }
}

TEST_F(RaysAfterMirrorsTest, hostsShadeNoHitsInTheMirror) {
    must(reflections_.setRays(world_.rays, [](VkCommandBuffer, const RayHits&) {}));
    EXPECT_EQ(look(raysAnd(true, false)).statistics.scene.pixels, inMirror_ + beside_);
    EXPECT_EQ(look(raysAnd(true, true)).statistics.scene.pixels, beside_);
}

TEST_F(RaysAfterMirrorsTest, raysThatComeBeforeAreTracedForAll) {
    Settings settings = raysAnd(true, true);
    settings.order.rays = 0;
    EXPECT_EQ(look(settings).statistics.scene.pixels, inMirror_ + beside_);
}

/// Between screen and rays: the screen's answer is replaced although the mirror leaves no weight for rays.
TEST_F(RaysAfterMirrorsTest, aMirrorGetsWhatRaysTakeBackFromTheScreen) {
    Settings settings = raysAnd(true, true);
    settings.order.screen = 0;
    const Picture picture = look(settings);
    EXPECT_EQ(picture.statistics.scene.pixels, beside_);
    EXPECT_GT(picture.statistics.scene.replaced, 0u);
    expectMirrorIn(picture, look(raysAnd(true, false)));
}

TEST_F(RaysAfterMirrorsTest, framesThatAreAddedUpLeaveTheMirrorAlone) {
    Settings settings = raysAnd(true, true);
    settings.rays.accumulate = true;
    Settings others = raysAnd(true, false);
    others.rays.accumulate = true;
    const auto secondFrame = [&](const Settings& asked) {
        look(asked);
        return LibraryTest::trace(reflections_, camera_.view(kWidth, kHeight));
    };
    const Picture without = secondFrame(others);
    const Picture with = secondFrame(settings);
    EXPECT_LE(with.statistics.scene.pixels, beside_); // some get no ray, because it would go below the surface
    expectMirrorIn(with, without);
}

TEST_F(RaysAfterMirrorsTest, neitherAreRaysTracedWhereProbesOrTheSkyComeFirst) {
    const Settings byDefault = raysAnd(true, false);
    TestEnvironment sky = TestEnvironment::make(gpu(), 4, 1, [](const auto&, uint32_t) { return glm::vec3(1); });
    Probe probe;
    probe.influence = probe.proxyVolume = {{0.5f, 1.5f, -1}, {0, 0, 0, 1}, {3, 3, 3}};
    must(reflections_.setInputs(rough_.gbuffer, sky.map));
    const TestVolumes probes = TestVolumes::giveTo(reflections_, gpu(), library(), {probe});
    const auto pixels = [&](const Settings& settings) { return look(settings).statistics.scene.pixels; };
    EXPECT_EQ(pixels(byDefault), inMirror_ + beside_);
    Settings settings = byDefault;
    settings.order.probes = 0;
    EXPECT_EQ(pixels(settings), 0u);
    settings.probes.enabled = false;
    EXPECT_EQ(pixels(settings), inMirror_ + beside_);
    settings.sky.enabled = true;
    settings.order.sky = 0;
    EXPECT_EQ(pixels(settings), 0u);
}

TEST_F(RaysAfterMirrorsTest, raysBehindTheSkyTakeNothingBackFromTheScreen) {
    TestEnvironment sky = TestEnvironment::make(gpu(), 4, 1, [](const auto&, uint32_t) { return glm::vec3(1); });
    must(reflections_.setInputs(rough_.gbuffer, sky.map));
    Settings settings = raysAnd(true, false);
    settings.sky.enabled = true;
    settings.order.screen = 0;
    settings.order.sky = 1;
    const Picture with = look(settings);
    EXPECT_EQ(with.statistics.scene.pixels, 0u);
    settings.rays.enabled = false;
    EXPECT_EQ(with.reflection, look(settings).reflection);
}

TEST_F(PlanarSourceTest, whatCannotBeIsNamed) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const auto errorOf = [&](const std::function<void(PlanarMirror&)>& spoil, uint32_t width = 8) {
        std::vector<PlanarMirror> list(2, floorMirror());
        spoil(list[1]);
        const auto made = PlanarMirrors::create(library(), {list, width, 8, {}});
        return made ? std::string() : made.error().message;
    };
    EXPECT_EQ(errorOf([](PlanarMirror&) {}), "");
    EXPECT_THAT(errorOf([](PlanarMirror& m) { m.centerWS[1] = kNan; }), testing::HasSubstr("mirror 1: its centre"));
    EXPECT_THAT(errorOf([](PlanarMirror& m) { m.normalWS = {0, 2, 0}; }), testing::HasSubstr("unit vectors"));
    EXPECT_THAT(errorOf([](PlanarMirror& m) { m.tangentWS = {0, 1, 0}; }), testing::HasSubstr("across"));
    EXPECT_THAT(errorOf([](PlanarMirror& m) { m.halfExtents[0] = 0; }), testing::HasSubstr("half extents"));
    EXPECT_THAT(errorOf([](PlanarMirror& m) { m.tolerance = -1; }), testing::HasSubstr("tolerance"));
    EXPECT_THAT(errorOf([](PlanarMirror&) {}, 0), testing::HasSubstr("0x8"));
    const std::vector<PlanarMirror> many(kMaxPlanarMirrors + 1, floorMirror());
    EXPECT_FALSE(PlanarMirrors::create(library(), {many, 8, 8, {}}));

    PlanarMirrors planar = mirrors({floorMirror()}, 8, 8);
    EXPECT_FALSE(planar.setMirrors(std::vector<PlanarMirror>(2, floorMirror())));
    Drawn drawn = draw(mirroredView(camera_.view(8, 8), floorMirror()), 8, 8);
    Drawn other = draw(mirroredView(camera_.view(8, 4), floorMirror()), 8, 4);
    const auto refused = [&](uint32_t mirror, const PlanarPicture& picture) {
        std::string message;
        run([&](VkCommandBuffer commands) {
            const auto recorded = planar.record(commands, mirror, picture);
            message = recorded ? "" : recorded.error().message;
        });
        return message;
    };
    EXPECT_THAT(refused(1, drawn.picture), testing::HasSubstr("mirror 1: there are 1"));
    EXPECT_THAT(refused(0, {{}, drawn.picture.depth, drawn.picture.view}), testing::HasSubstr("radiance"));
    EXPECT_THAT(refused(0, {drawn.picture.radiance, {}, drawn.picture.view}), testing::HasSubstr("depth"));
    EXPECT_THAT(refused(0, {drawn.picture.radiance, other.picture.depth, drawn.picture.view}),
                testing::HasSubstr("8x8, its depth 8x4"));
}

} // namespace planar_test
} // namespace glint::test
