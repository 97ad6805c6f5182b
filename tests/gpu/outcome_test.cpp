// Every outcome of a ray, each caused by a scene in which no other can occur, pixel by pixel; for each marcher.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include "reflect/trace/outcomes.hpp"
#include "reflect/trace/technique.hpp"

namespace glint::test {
namespace outcome_test {

constexpr uint32_t kWidth = 121;
constexpr uint32_t kHeight = 67;

/// A camera ray's mirror reflection at the surface that it hits.
struct MirrorRay {
    glm::dvec3 start;
    glm::dvec3 direction;
};

class OutcomeTest : public LibraryTest, public testing::WithParamInterface<size_t> {
protected:
    static Settings settings() { return plainSettings(reflect::techniques()[GetParam()].march); }
    static const reflect::Technique& technique() { return reflect::techniques()[GetParam()]; }
    static March march() { return reflect::techniques()[GetParam()].march; }

    static std::optional<MirrorRay> mirrorRay(const SyntheticScene& scene, const SyntheticCamera& camera, uint32_t i) {
        const uint32_t x = i % kWidth;
        const uint32_t y = i / kWidth;
        const glm::dvec3 origin = camera.originThrough(x, y, kWidth, kHeight);
        const glm::dvec3 direction = camera.rayThrough(x, y, kWidth, kHeight);
        const auto surface = scene(origin, direction);
        if (!surface || surface->f0.x == 0)
            return std::nullopt;
        return MirrorRay{origin + direction * surface->distance, glm::reflect(direction, surface->normalWS)};
    }

    static bool onScreen(const glm::dvec2& px, double margin) {
        return px.x > margin && px.y > margin && px.x < kWidth - margin && px.y < kHeight - margin;
    }

    /// In the volume that fits a wall at z = -3.
    static Picture show(const SyntheticScene& scene, const SyntheticCamera& camera, const Settings& settings) {
        return traceWithin({wallVolume()}, scene, camera, kWidth, kHeight, settings);
    }

    /// Where the pixel there shows the floor that the ray leaves, one lookup cannot detect objects that stand on it.
    static bool tells(const SyntheticScene& scene, const SyntheticCamera& camera, const glm::dvec2& px) {
        if (technique().walks || !onScreen(px, 0))
            return true;
        const auto x = static_cast<uint32_t>(px.x);
        const auto y = static_cast<uint32_t>(px.y);
        const auto shown = scene(camera.originThrough(x, y, kWidth, kHeight), camera.rayThrough(x, y, kWidth, kHeight));
        return !shown || shown->f0.x == 0;
    }

    /// `predict(ray)` returns the outcome, or none where it is a close call. Returns how many were predicted. Where
    /// `orElse` is given a marcher may report that outcome as well.
    template <class Predict>
    static size_t check(const SyntheticScene& scene, const SyntheticCamera& camera, const Settings& settings,
                        Predict predict, std::optional<uint32_t> orElse = std::nullopt) {
        const Picture picture = show(scene, camera, settings);
        size_t named = 0;
        std::array<uint64_t, shared::kOutcomeCount> counts = {};
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            ++counts[picture.outcome(i)];
            const std::optional<MirrorRay> ray = mirrorRay(scene, camera, i);
            if (!ray)
                continue;
            if (const std::optional<uint32_t> expected = predict(*ray)) {
                ++named;
                if (picture.outcome(i) != orElse) {
                    EXPECT_EQ(reflect::kOutcomeNames[picture.outcome(i)], reflect::kOutcomeNames[*expected])
                        << "pixel " << i % kWidth << "," << i / kWidth;
                }
                EXPECT_EQ(picture.weight[i * 4] > 0, picture.answered(i)) << i;
                if (HasFailure())
                    return named;
            }
        }
        for (uint32_t outcome = 0; outcome < shared::kOutcomeCount; ++outcome)
            EXPECT_EQ(picture.counted(reflect::kOutcomeNames[outcome]), counts[outcome])
                << "statistics count what the picture shows: " << reflect::kOutcomeNames[outcome];
        return named;
    }
};

/// For marchers that sample depths along the whole ray.
class WalkingOutcomeTest : public OutcomeTest {};

TEST_P(OutcomeTest, hit) {
    const SyntheticCamera camera;
    const Stage scene = floorAndWall();
    EXPECT_GT(check(scene, camera, settings(),
                    [&](const MirrorRay& ray) -> std::optional<uint32_t> {
                        const auto t = scene.cards[0].distance(ray.start, ray.direction);
                        const glm::dvec2 end =
                            t ? camera.project(ray.start + ray.direction * *t, kWidth, kHeight) : glm::dvec2(-1);
                        if (!onScreen(end, 1.5) || !tells(scene, camera, end))
                            return std::nullopt;
                        return shared::kOutcomeHit;
                    }),
              1000u);
}

TEST_P(OutcomeTest, offScreen) {
    SyntheticCamera camera;
    camera.target = {0, 0, 0.5};
    const Stage scene = floorAndWall();
    for (const bool clip : {true, false}) {
        Settings changed = settings();
        changed.screen.clipToFrustum = clip;
        EXPECT_GT(check(scene, camera, changed,
                        [&](const MirrorRay& ray) -> std::optional<uint32_t> {
                            const auto t = scene.cards[0].distance(ray.start, ray.direction);
                            const glm::dvec2 from = camera.project(ray.start, kWidth, kHeight);
                            // Some pixels of the ray are on screen, else rounding decides on its only sample.
                            if (!t || !onScreen(from, 3) ||
                                onScreen(camera.project(ray.start + ray.direction * *t, kWidth, kHeight), -1.5))
                                return std::nullopt;
                            return shared::kOutcomeOffScreen;
                        }),
                  100u);
    }
}

TEST_P(WalkingOutcomeTest, skyAndMaxDistance) {
    Stage scene;
    scene.floorEndZ = -1;
    for (const float length : {0.8f, 1000.0f}) { // cut short, or so long that rays end at their vanishing points
        SyntheticCamera camera;
        camera.target.y = length > 1 ? 1 : 0.5; // that is on screen
        Settings changed = settings();
        changed.screen.maxDistance = length;
        const double metres = static_cast<double>(length);
        size_t sky = 0;
        size_t floor = 0;
        check(scene, camera, changed, [&](const MirrorRay& ray) -> std::optional<uint32_t> {
            const glm::dvec3 end = ray.start + ray.direction * metres;
            if (!onScreen(camera.project(end, kWidth, kHeight), 1.5))
                return std::nullopt;
            const glm::dvec3 toEnd = glm::normalize(end - camera.position);
            const double floorZ = camera.position.z - toEnd.z * camera.position.y / toEnd.y;
            if (toEnd.y < 0 && floorZ > -0.8)
                return ++floor, shared::kOutcomeMaxDistance;
            if (toEnd.y > 0 || floorZ < -1.3)
                return ++sky, length > 1 ? shared::kOutcomeSky : shared::kOutcomeMaxDistance;
            return std::nullopt;
        });
        EXPECT_GT(sky, 30u);
        EXPECT_EQ(floor > 200, length < 1);
    }
}

/// A ball over a mirror floor.
std::optional<SyntheticSurface> ballOverFloor(const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 center(0, 0.5, 0);
    const double radius = 0.4;
    const double b = glm::dot(direction, center - origin);
    const double root = b * b - glm::dot(center - origin, center - origin) + radius * radius;
    const double toFloor = direction.y < 0 ? -origin.y / direction.y : 1e9;
    SyntheticSurface hit;
    if (root > 0 && b > std::sqrt(root) && b - std::sqrt(root) < toFloor) {
        hit.distance = b - std::sqrt(root);
        hit.normalWS = (origin + direction * hit.distance - center) / radius;
        hit.radiance = glm::vec3(1);
        return hit;
    }
    hit.distance = toFloor;
    hit.f0 = glm::vec3(1);
    return toFloor < 50 ? std::optional(hit) : std::nullopt;
}

TEST_P(WalkingOutcomeTest, roundThingsEndAtTheirRim) {
    const SyntheticCamera camera;
    for (const auto& [thickness, lean] : {std::pair(0.0f, 0.0), std::pair(0.3f, 0.0), std::pair(0.3f, 0.3)}) {
        // The normals at the rim of coarse meshes, interpolated, lean away from the eye.
        const auto ball = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
            std::optional<SyntheticSurface> hit = ballOverFloor(origin, direction);
            if (hit && hit->radiance.x > 0)
                hit->normalWS = glm::normalize(hit->normalWS + lean * direction);
            return hit;
        };
        Settings changed = settings();
        changed.screen.thicknessMode = ThicknessMode::Constant;
        changed.screen.thickness = thickness;
        const Picture picture = show(ball, camera, changed);
        size_t hits = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            const std::optional<MirrorRay> ray = mirrorRay(ball, camera, i);
            if (!ray || !picture.hit(i))
                continue;
            ++hits;
            const glm::dvec3 met = ray->start + ray->direction * static_cast<double>(picture.hitDistance[i * 4]);
            // Its planes are those of pixels: at the rim one reaches out by half of what it rises there.
            EXPECT_LT(glm::distance(met, glm::dvec3(0, 0.5, 0)), 0.4 + 0.15 + static_cast<double>(thickness))
                << "pixel " << i % kWidth << "," << i / kWidth;
        }
        EXPECT_GT(hits, 100u);
    }
}

TEST_P(OutcomeTest, behindCamera) {
    // A mirror that faces the camera, whose near plane is far from the eye: rays return and hit that plane.
    SyntheticCamera camera;
    camera.position = {0, 1, 3};
    camera.target = {0, 1, 0};
    camera.near = 2;
    Stage scene;
    scene.floor = false;
    scene.cards.push_back({.z = -3, .f0 = 1});
    EXPECT_GT(check(scene, camera, settings(),
                    [&](const MirrorRay& ray) -> std::optional<uint32_t> {
                        const glm::dvec3 end = ray.start + ray.direction * ((1.0 - ray.start.z) / ray.direction.z);
                        const bool inside = onScreen(camera.project(end, kWidth, kHeight), 1.5);
                        return inside ? std::optional(shared::kOutcomeBehindCamera) : std::nullopt;
                    }),
              100u);
}

TEST_P(WalkingOutcomeTest, outOfSteps) {
    const SyntheticCamera camera;
    const Stage scene = floorAndWall();
    Settings changed = settings();
    if (!technique().canRunOut) { // its steps are spread over the whole ray, however few there are
        changed.adaptive.steps = 1;
        changed.adaptive.pixelSpacing = 64;
        EXPECT_EQ(trace(scene, camera, kWidth, kHeight, changed).counted("outOfSteps"), 0u);
        return;
    }
    // Four pixels of linear's; the one cell of 16 pixels with which hiz begins.
    const bool hiz = march() == March::Hiz;
    limitIterations(changed, hiz ? 1 : 4);
    EXPECT_GT(check(scene, camera, changed,
                    [&](const MirrorRay& ray) -> std::optional<uint32_t> {
                        const glm::dvec3 hit = ray.start + ray.direction * ((-3 - ray.start.z) / ray.direction.z);
                        const glm::dvec2 px = camera.project(hit, kWidth, kHeight);
                        const glm::dvec2 from = camera.project(ray.start, kWidth, kHeight);
                        const double steps = std::max(std::abs(px.x - from.x), std::abs(px.y - from.y));
                        if (!onScreen(px, 1.5) || steps < (hiz ? 18 : 8))
                            return std::nullopt;
                        return shared::kOutcomeOutOfSteps;
                    }),
              500u);
}

TEST_P(WalkingOutcomeTest, hiddenAndTooThick) {
    // A card floats before the rays' ends; the gap decides. Rays begin behind the card and never cross it.
    const SyntheticCamera camera;
    Settings changed = settings();
    Stage scene = floorAndWall();
    scene.cards.push_back({.low = {-0.5, 0.25}, .high = {0.5, 0.9}, .z = 1});
    const auto gapAt = [&](const glm::dvec3& p) -> std::optional<double> { // metres behind the card, along the axis
        const glm::dvec3 d = glm::normalize(p - camera.position);
        const auto t = scene.cards[1].distance(camera.position, d);
        if (!t)
            return std::nullopt;
        return camera.viewZ(p) - camera.viewZ(camera.position + d * *t);
    };
    for (const bool tooThick : {false, true}) {
        // The floor visible below the card lies up to 0.7 metres behind it.
        changed.screen.thickness = tooThick ? 0.3f : 0.05f;
        changed.screen.maxDistance = tooThick ? 0.25f : 1.0f;
        const double length = changed.screen.maxDistance;
        const double t = static_cast<double>(changed.screen.thickness);
        EXPECT_GT(check(
                      scene, camera, changed,
                      [&](const MirrorRay& ray) -> std::optional<uint32_t> {
                          // Along the whole path behind the card, and a little beside it.
                          double least = 1e9;
                          double most = 0;
                          for (int i = 1; i <= 200; ++i) {
                              const glm::dvec3 p = ray.start + ray.direction * (length * i / 200);
                              if (const auto gap = gapAt(p)) {
                                  least = std::min(least, *gap);
                                  most = std::max(most, *gap);
                              }
                          }
                          const glm::dvec3 end = ray.start + ray.direction * length;
                          const glm::dvec2 px = camera.project(end, kWidth, kHeight);
                          const bool clear = gapAt(end + glm::dvec3(0.03, 0.03, 0)) && gapAt(end) &&
                                             gapAt(end - glm::dvec3(0.03, 0.03, 0)) && onScreen(px, 1.5);
                          if (!clear || most == 0)
                              return std::nullopt;
                          if (tooThick ? least > 1.05 * t && most < 1.95 * t : least > 2.1 * t)
                              return tooThick ? shared::kOutcomeTooThick : shared::kOutcomeHidden;
                          return std::nullopt;
                      },
                      // Where hiz passes behind the slabs of large cells, it does not test single pixels.
                      march() == March::Hiz ? std::optional(shared::kOutcomeHidden) : std::nullopt),
                  20u)
            << (tooThick ? "too thick" : "hidden");
    }
}

TEST_P(WalkingOutcomeTest, backFace) {
    // A card floats before a mirror: rays that return towards the camera enter its slab from behind. They come about
    // 0.2 metres nearer per pixel.
    SyntheticCamera camera;
    camera.target = {0, 1, 0};
    Stage scene;
    scene.floor = false;
    scene.cards.push_back({.z = -3, .f0 = 1});
    scene.cards.push_back({.low = {0.5, 0.4}, .high = {1.8, 1.6}, .z = 0.5});
    Settings changed = settings();
    changed.screen.thickness = 0.75f;
    EXPECT_GT(check(scene, camera, changed,
                    [&](const MirrorRay& ray) -> std::optional<uint32_t> {
                        const auto t = scene.cards[1].distance(ray.start, ray.direction);
                        if (!t)
                            return std::nullopt;
                        const glm::dvec2 inside = ray.start + ray.direction * *t;
                        const bool clear = inside.x > 0.6 && inside.x < 1.7 && inside.y > 0.5 && inside.y < 1.5;
                        return clear ? std::optional(shared::kOutcomeBackFace) : std::nullopt;
                    }),
              50u);
}

/// A card floats between the camera and the places on the wall where rays hit it.
Stage wallBehindCard() {
    Stage scene = floorAndWall();
    scene.cards.push_back({.low = {-1, 0.35}, .high = {1, 0.8}, .z = -1});
    return scene;
}

/// Where the ray hits the wall, if the card surely hides that place and the ray passes far behind the card.
std::optional<glm::dvec3> crossesUnseen(const Stage& scene, const SyntheticCamera& camera, const MirrorRay& ray) {
    const auto t = scene.cards[0].distance(ray.start, ray.direction);
    if (!t || ray.start.z > -1.15)
        return std::nullopt;
    const glm::dvec3 crossing = ray.start + ray.direction * *t;
    for (const glm::dvec3& off : {glm::dvec3(0.1, 0, 0), {-0.1, 0, 0}, {0, 0.1, 0}, {0, -0.1, 0}})
        if (!scene.cards[1].distance(camera.position, glm::normalize(crossing + off - camera.position)))
            return std::nullopt;
    return crossing;
}

TEST_P(WalkingOutcomeTest, aWallBehindAnOccluderIsInferred) {
    const SyntheticCamera camera;
    const Stage scene = wallBehindCard();
    for (const float weight : {1.0f, 0.25f, 0.0f}) {
        Settings changed = settings();
        changed.screen.inferred = weight;
        const Picture picture = show(scene, camera, changed);
        size_t unseen = 0;
        size_t inferred = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            const std::optional<MirrorRay> ray = mirrorRay(scene, camera, i);
            const auto crossing = ray ? crossesUnseen(scene, camera, *ray) : std::nullopt;
            if (!crossing)
                continue;
            ++unseen;
            ASSERT_FALSE(picture.hit(i)) << i << ": the place is hidden";
            if (picture.outcome(i) != shared::kOutcomeInferred)
                continue;
            ++inferred;
            const double length = glm::distance(*crossing, ray->start);
            ASSERT_NEAR(picture.hitDistance[i * 4], length, 0.01 * length) << i;
            ASSERT_EQ(picture.weight[i * 4], weight) << i;
            // The answer's pixel shows the wall, near the hidden place.
            const glm::uvec2 px(picture.hitPX(i));
            const glm::dvec3 toPixel = camera.rayThrough(px.x, px.y, kWidth, kHeight);
            ASSERT_FALSE(scene.cards[1].distance(camera.position, toPixel)) << i;
            const auto toWall = scene.cards[0].distance(camera.position, toPixel);
            ASSERT_TRUE(toWall) << i;
            ASSERT_LT(glm::distance(camera.position + toPixel * *toWall, *crossing), 0.75) << i;
        }
        EXPECT_GT(unseen, 100u);
        EXPECT_EQ(inferred, weight > 0 ? unseen : 0);
        EXPECT_EQ(picture.counted("inferred") > 0, weight > 0);
    }
}

TEST_P(WalkingOutcomeTest, theSurfaceCrossedFirstIsInferred) {
    // Behind the card the ray crosses a low wall, which shows under the card, and then a high one, which shows above
    // it.
    const SyntheticCamera camera;
    Stage scene;
    scene.cards.push_back({.low = {-0.7, 0.5}, .high = {0.7, 0.8}, .z = -1});
    scene.cards.push_back({.low = {-100, 0}, .high = {100, 0.6}, .z = -3});
    scene.cards.push_back({.z = -3.5});
    Settings changed = settings();
    changed.screen.inferred = 1;
    const Picture picture = show(scene, camera, changed);
    size_t unseen = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        const std::optional<MirrorRay> ray = mirrorRay(scene, camera, i);
        const auto t = ray && ray->start.z < -1.15 ? scene.cards[1].distance(ray->start, ray->direction) : std::nullopt;
        if (!t)
            continue;
        // The card hides both crossings, and is wider by a pixel and more.
        const glm::dvec3 low = ray->start + ray->direction * *t;
        const glm::dvec3 high =
            ray->start + ray->direction * scene.cards[2].distance(ray->start, ray->direction).value();
        bool hidden = low.y < 0.5;
        for (const glm::dvec3& at : {low, high})
            for (const double off : {-0.08, 0.08})
                for (const glm::dvec3& moved : {at + glm::dvec3(off, 0, 0), at + glm::dvec3(0, off, 0)})
                    hidden =
                        hidden && scene.cards[0].distance(camera.position, glm::normalize(moved - camera.position));
        if (!hidden)
            continue;
        ++unseen;
        ASSERT_EQ(picture.outcome(i), shared::kOutcomeInferred) << i;
        ASSERT_NEAR(picture.hitDistance[i * 4], *t, 0.01 * *t) << i;
    }
    EXPECT_GT(unseen, 10u);
}

TEST_P(OutcomeTest, nothingIsInferredWhereNoSurfaceShowsBesideTheOccluder) {
    const SyntheticCamera camera;
    Stage scene = wallBehindCard();
    scene.cards.erase(scene.cards.begin());
    Settings changed = settings();
    changed.screen.inferred = 1;
    EXPECT_EQ(show(scene, camera, changed).counted("inferred"), 0u) << "the card alone";

    // A smaller card that the first hides whole.
    scene = wallBehindCard();
    scene.cards[0].low = {-0.2, 0.3};
    scene.cards[0].high = {0.2, 0.4};
    EXPECT_EQ(show(scene, camera, changed).counted("inferred"), 0u) << "no pixel shows it";
}

TEST_P(WalkingOutcomeTest, aWallThatLeavesTheScreenIsInferredCloseBeyondTheBorder) {
    const SyntheticCamera camera;
    const Stage scene = floorAndWall();
    for (const bool fades : {false, true}) {
        Settings changed = settings();
        changed.screen.inferred = 1;
        if (fades)
            changed.fade.border = FadeBorder::Smooth;
        const Picture picture = show(scene, camera, changed);
        size_t close = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            const std::optional<MirrorRay> ray = mirrorRay(scene, camera, i);
            const auto t = ray ? scene.cards[0].distance(ray->start, ray->direction) : std::nullopt;
            if (!t)
                continue;
            const glm::dvec2 px = camera.project(ray->start + ray->direction * *t, kWidth, kHeight);
            const bool isClose = !onScreen(px, -0.5) && onScreen(px, -7);
            const bool isFar = !onScreen(px, -9);
            if (!isClose && !isFar)
                continue;
            close += isClose;
            ASSERT_EQ(picture.outcome(i), isClose && !fades ? shared::kOutcomeInferred : shared::kOutcomeOffScreen)
                << i;
            if (!isClose || fades)
                continue;
            ASSERT_NEAR(picture.hitDistance[i * 4], *t, 0.01 * *t) << i;
            const glm::dvec2 border = glm::clamp(px, glm::dvec2(0.5), glm::dvec2(kWidth, kHeight) - 0.5);
            ASSERT_LT(glm::distance(picture.hitPX(i), border), 1.0) << i;
        }
        EXPECT_GT(close, 50u);
    }
}

TEST_P(OutcomeTest, unseenSidesFade) {
    // The wall's normal faces away, as on an object's hidden side. A ray that ends behind the wall ended in its slab
    // (backFace) or, where its samples miss the slab, farther behind (hidden).
    const SyntheticCamera camera;
    Stage scene = floorAndWall();
    scene.cards[0].normalWS = {0, 0, -1};
    Settings changed = settings();
    changed.screen.maxDistance = 5;
    for (const bool fade : {false, true}) {
        changed.fade.backface = fade;
        const Picture picture = show(scene, camera, changed);
        size_t behind = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            const std::optional<MirrorRay> ray = mirrorRay(scene, camera, i);
            const auto t = ray ? scene.cards[0].distance(ray->start, ray->direction) : std::nullopt;
            if (!t || *t > 4.9 || !onScreen(camera.project(ray->start + ray->direction * 5.0, kWidth, kHeight), 2.5))
                continue; // a ray that leaves the image behind the wall is offScreen
            ++behind;
            const uint32_t outcome = picture.outcome(i);
            ASSERT_TRUE(outcome == shared::kOutcomeBackFace || outcome == shared::kOutcomeHidden)
                << i << ": " << reflect::kOutcomeNames[outcome];
            ASSERT_EQ(picture.weight[i * 4], outcome == shared::kOutcomeBackFace && !fade ? 1 : 0) << i;
        }
        EXPECT_GT(behind, 1000u);
        EXPECT_GT(picture.counted("backFace"), behind / 2);
    }
}

TEST_P(OutcomeTest, notTraced) {
    const SyntheticCamera camera;
    Stage scene = floorAndWall();
    const auto all = [&](uint32_t outcome) { return [outcome](const MirrorRay&) { return std::optional(outcome); }; };
    scene.floorF0 = 0.04f;
    Settings changed = settings();
    changed.reflect.threshold = 0.04f;
    EXPECT_GT(check(scene, camera, changed, all(shared::kOutcomeBelowThreshold)), 1000u);

    scene.floorF0 = 1;
    scene.floorRoughness = 0.7f;
    EXPECT_GT(check(scene, camera, settings(), all(shared::kOutcomeTooRough)), 1000u);

    SyntheticCamera facing;
    facing.position = {0, 1, 3};
    facing.target = {0, 1, 0};
    Stage mirror;
    mirror.floor = false;
    mirror.cards.push_back({.z = -3, .f0 = 1});
    changed = settings();
    changed.fade.facingCamera = true;
    EXPECT_GT(check(mirror, facing, changed,
                    [](const MirrorRay& ray) -> std::optional<uint32_t> {
                        const glm::dvec3 toEye(-ray.direction.x, -ray.direction.y, ray.direction.z);
                        return glm::dot(toEye, ray.direction) > 0.51 ? std::optional(shared::kOutcomeFacingCamera)
                                                                     : std::nullopt;
                    }),
              1000u);
}

TEST_P(OutcomeTest, orthographicMirrorLandsWithinOnePixel) {
    SyntheticCamera camera;
    camera.orthoHeight = 3;
    const Stage scene = floorAndWall();
    const Picture picture = show(scene, camera, settings());
    size_t predicted = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        const std::optional<MirrorRay> ray = mirrorRay(scene, camera, i);
        if (!ray)
            continue;
        const glm::dvec3 end = ray->start + ray->direction * ((-3 - ray->start.z) / ray->direction.z);
        const glm::dvec2 expected = camera.project(end, kWidth, kHeight);
        const double way = glm::length(expected - camera.project(ray->start, kWidth, kHeight));
        if (!onScreen(expected, 1.5) || !tells(scene, camera, expected) ||
            way < 2) // selfCollisionSkip skips the first sample
            continue;
        ++predicted;
        ASSERT_TRUE(picture.hit(i)) << i << ": " << reflect::kOutcomeNames[picture.outcome(i)] << " expected "
                                    << expected.x << " " << expected.y;
        ASSERT_LT(glm::length(picture.hitPX(i) - expected), 1) << i;
        ASSERT_NEAR(picture.hitDistance[i * 4], glm::length(end - ray->start), 0.05);
    }
    EXPECT_GT(predicted, 500u);
}

TEST_P(OutcomeTest, hitDistanceIsThatInTheWorld) {
    const SyntheticCamera camera;
    const Stage scene = floorAndWall();
    const Picture picture = show(scene, camera, settings());
    size_t hits = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        const std::optional<MirrorRay> ray = mirrorRay(scene, camera, i);
        if (!ray || !picture.hit(i))
            continue;
        ++hits;
        const double expected = (-3 - ray->start.z) / ray->direction.z;
        ASSERT_NEAR(picture.hitDistance[i * 4], expected, 0.01 * expected + 0.01) << i;
    }
    EXPECT_GT(hits, 1000u);
}

TEST_F(LibraryTest, viewRayDirWSIsTheDirectionOfTheMirrorRay) {
    SyntheticCamera camera;
    camera.position = {1, 1.2, 3};
    camera.target = {-0.5, 0.6, 0};
    Stage scene = floorAndWall();
    scene.cards.push_back(
        {.low = {-1, 0.2}, .high = {0.5, 1}, .z = 0.5, .normalWS = glm::normalize(glm::dvec3(1, 2, 3))});
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, camera, kWidth, kHeight);
    Reflections made = reflections(kWidth, kHeight);
    must(made.setInputs(host.gbuffer));
    HostImage image;
    run([&](VkCommandBuffer commands) {
        made.record(commands, camera.view(kWidth, kHeight));
        image = must(made.recordView(commands, "rayDirWS"));
    });
    const std::vector<float> shown = download(gpu(), image);
    const auto surfaces = seen(scene, camera, kWidth, kHeight);
    size_t background = 0;
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        glm::dvec3 expected(0);
        if (surfaces[i])
            expected = glm::reflect(camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight), surfaces[i]->normalWS);
        else
            ++background;
        // Normals are stored in sixteen bits a component.
        ASSERT_LT(glm::distance(glm::dvec3(shown[i * 4], shown[i * 4 + 1], shown[i * 4 + 2]), expected), 3e-4)
            << "pixel " << i % kWidth << "," << i / kWidth;
    }
    EXPECT_LT(background, size_t{kWidth} * kHeight / 2);
}

TEST_F(LibraryTest, coarseCellsAnswerForSurfacesAlone) {
    // Posts before a wall: cells of several pixels show both, and the air between.
    SyntheticCamera camera;
    camera.position = {0.3, 1, 3};
    Stage scene = floorAndWall();
    for (int i = -4; i <= 4; ++i)
        scene.cards.push_back({.low = {0.5 * i, 0}, .high = {0.5 * i + 0.1, 1.2}, .z = -0.5});
    for (const int minLevel : {1, 2, 3}) {
        Settings settings = plainSettings(March::Hiz);
        settings.screen.thicknessMode = ThicknessMode::Constant;
        settings.screen.thickness = 0;
        settings.hiz.depthBias = 0;
        settings.hiz.minLevel = minLevel;
        const Picture picture = trace(scene, camera, kWidth, kHeight, settings);
        size_t hits = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            const glm::dvec3 origin = camera.originThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const glm::dvec3 direction = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const auto surface = scene(origin, direction);
            if (!surface || surface->f0.x == 0 || !picture.hit(i))
                continue;
            ++hits;
            const glm::dvec3 reflected = glm::reflect(direction, surface->normalWS);
            const double z =
                (origin + direction * surface->distance + reflected * static_cast<double>(picture.hitDistance[i * 4]))
                    .z;
            ASSERT_TRUE(std::abs(z + 0.5) < 0.05 || std::abs(z + 3) < 0.05)
                << "in mid-air at z = " << z << ", pixel " << i % kWidth << "," << i / kWidth << ", level " << minLevel;
        }
        EXPECT_GT(hits, 1000u) << minLevel;
    }
}

TEST_F(LibraryTest, whereAWallMirrorMeetsTheFloorItShowsIt) {
    // Cells in the corner show both surfaces: rays that leave one close above the other hit it at once.
    constexpr uint32_t kAcross = 320;
    constexpr uint32_t kDown = 180;
    const SyntheticScene scene = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        const double toFloor = direction.y < 0 ? -origin.y / direction.y : 1e9;
        const double toWall = direction.x < 0 ? (-1.5 - origin.x) / direction.x : 1e9;
        SyntheticSurface hit;
        hit.distance = std::min(toFloor, toWall);
        hit.normalWS = toFloor < toWall ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        hit.f0 = glm::vec3(toFloor < toWall ? 0 : 1);
        return hit.distance < 20 ? std::optional(hit) : std::nullopt;
    };
    for (const double height : {0.9, 1.2, 1.5, 2.0}) {
        SyntheticCamera camera;
        camera.position = {0.2, height, 3.2};
        camera.target = camera.position + glm::dvec3(-0.146, -0.132, -0.98);
        camera.fovY = 0.87;
        const Picture picture = trace(scene, camera, kAcross, kDown, plainSettings(March::Hiz));
        size_t met = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            const glm::dvec3 direction = camera.rayThrough(i % kAcross, i / kAcross, kAcross, kDown);
            const auto surface = scene(camera.position, direction);
            if (!surface || surface->f0.x == 0 || direction.y >= 0)
                continue;
            const glm::dvec3 start = camera.position + direction * surface->distance;
            const glm::dvec3 reflected(-direction.x, direction.y, direction.z);
            const glm::dvec3 onFloor = start - reflected * (start.y / reflected.y);
            const glm::dvec2 end = camera.project(onFloor, kAcross, kDown);
            if (onFloor.z < -3) // farther away a step from pixel to pixel may be an edge
                continue;
            if (end.x < 2 || end.y < 2 || end.x > kAcross - 2 || end.y > kDown - 2)
                continue;
            ++met;
            EXPECT_TRUE(picture.hit(i)) << reflect::kOutcomeNames[picture.outcome(i)] << " at " << i % kAcross << ","
                                        << i / kAcross << ", eye at " << height;
        }
        EXPECT_GT(met, 1000u);
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, WalkingOutcomeTest,
                         testing::ValuesIn(techniquesWith([](const reflect::Technique& technique) {
                             return technique.walks;
                         })),
                         [](const auto& test) { return std::string(reflect::techniques()[test.param].name); });
INSTANTIATE_TEST_SUITE_P(Registry, OutcomeTest, testing::Range<size_t>(0, reflect::techniques().size()),
                         [](const auto& test) { return std::string(reflect::techniques()[test.param].name); });

} // namespace outcome_test
} // namespace glint::test
