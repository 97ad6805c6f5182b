// What paths of rays show beyond their last surface: as much light as paths that go on would bring, and none from
// behind what the surface stands on. Scenes of mirrors, whose paths are followed here to their ends.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <cmath>

namespace glint::test {
namespace path_end_test {

constexpr uint32_t kWidth = 40;
constexpr uint32_t kHeight = 30;
constexpr uint32_t kFrames = 8; // each adds the bounces of a path

using Radiance = std::function<glm::vec3(const glm::dvec3& direction)>;

SurfaceMaterial metal(float reflectance) {
    SurfaceMaterial material = whiteMetal(0);
    material.baseColorFactor = {reflectance, reflectance, reflectance, 1};
    return material;
}

class PathEndTest : public LibraryTest {
protected:
    static Settings raySettings(int bounces) {
        Settings settings;
        settings.screen.enabled = false;
        settings.denoise.enabled = false;
        settings.rays.enabled = true;
        settings.rays.bounces = bounces;
        return settings;
    }

    /// The light that comes to the eye along a pixel's ray, by a path without an end. Schlick 1994 as in shaders/lib.
    static double exact(const SyntheticScene& scene, glm::dvec3 origin, glm::dvec3 direction, const Radiance& around) {
        double light = 0;
        double share = 1;
        for (int i = 0; i < 400 && share > 1e-6; ++i) {
            const auto surface = scene(origin, direction);
            if (!surface)
                return light + share * double(around(direction).g);
            light += share * double(surface->radiance.g);
            const double f0 = surface->f0.g;
            if (f0 <= 0)
                return light;
            share *= f0 + (1 - f0) * std::pow(1 + glm::dot(direction, surface->normalWS), 5);
            origin += direction * surface->distance + surface->normalWS * 1e-6;
            direction = glm::reflect(direction, surface->normalWS);
        }
        return light;
    }

    /// The last of some frames.
    static Picture look(const SurfaceScene& scene, const SyntheticScene& seen, const SyntheticCamera& camera,
                        const Settings& settings, const EnvironmentMap& environment, uint32_t frames = kFrames) {
        SurfaceScene::World world = scene.build(gpu(), library(), RayBackend::Bvh);
        SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), seen, camera, kWidth, kHeight);
        Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings);
        must(reflections.setInputs(g.gbuffer, environment));
        must(reflections.setRays(world.rays, world.surfaces));
        run([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
        });
        View view = camera.view(kWidth, kHeight);
        for (; view.frameIndex + 1 < frames; ++view.frameIndex)
            run([&](VkCommandBuffer commands) { reflections.record(commands, view); });
        return trace(reflections, view);
    }

    static TestEnvironment environmentOf(const Radiance& radiance) {
        return TestEnvironment::make(gpu(), 16, 5,
                                     [&](const glm::dvec3& direction, uint32_t) { return radiance(direction); });
    }

    struct Compared {
        double energy;  // shown / exact
        double darkest; // radiance of a pixel
        double brightest;
    };
    static Compared compare(const Picture& picture, const SurfaceScene& scene, const SyntheticCamera& camera,
                            const Radiance& around) {
        const SyntheticScene seen = SurfaceScene::seenBy(scene);
        double shown = 0;
        double truth = 0;
        Compared result = {0, 1e9, 0};
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const glm::dvec3 direction = camera.rayThrough(x, y, kWidth, kHeight);
                if (!seen(camera.position, direction))
                    continue;
                const double here = picture.color(size_t{y} * kWidth + x).g;
                shown += here;
                truth += exact(seen, camera.position, direction, around);
                result.darkest = std::min(result.darkest, here);
                result.brightest = std::max(result.brightest, here);
            }
        result.energy = shown / truth;
        return result;
    }
};

/// Mirrors at both ends of a closed room, whose walls glow.
SurfaceScene roomOfMirrors() {
    SurfaceScene room;
    room.addQuad({-1, -1, 1}, {0, 0, -2}, {0, 2, 0}, metal(0.85f));
    room.addQuad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}, metal(0.85f));
    room.addQuad({-1, -1, 1}, {2, 0, 0}, {0, 0, -2}, emitting(glm::vec3(0.3f)));
    room.addQuad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, emitting(glm::vec3(1.5f)));
    room.addQuad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, emitting(glm::vec3(0.6f)));
    room.addQuad({1, -1, 1}, {-2, 0, 0}, {0, 2, 0}, emitting(glm::vec3(0.4f)));
    return room;
}

TEST_F(PathEndTest, FacingMirrorsKeepTheirLightWithAnyNumberOfBounces) {
    const SurfaceScene room = roomOfMirrors();
    const SyntheticCamera camera = {.position = {-0.6, 0.2, 0.75}, .target = {0.9, -0.1, -0.3}, .fovY = 1.2};
    const Radiance none = [](const glm::dvec3&) { return glm::vec3(0); };
    for (const int bounces : {1, 2, 4, 8}) {
        const Compared compared =
            compare(look(room, SurfaceScene::seenBy(room), camera, raySettings(bounces), {}), room, camera, none);
        EXPECT_NEAR(compared.energy, 1, 0.05) << bounces;
        EXPECT_GT(compared.darkest, 0) << bounces;
    }
}

/// A floor and a wall that mirror each other, before a sky and over a ground that is much brighter.
TEST_F(PathEndTest, NothingShinesThroughWhatASurfaceStandsOn) {
    const Radiance sky = [](const glm::dvec3& direction) { return glm::vec3(direction.y > -0.3 ? 1.f : 50.f); };
    TestEnvironment environment = environmentOf(sky);
    SurfaceScene corner;
    corner.addQuad({-60, 0, 60}, {120, 0, 0}, {0, 0, -120}, metal(0.7f));
    corner.addQuad({-1, 0, -1}, {2, 0, 0.1f}, {0, 1.5f, 0}, metal(0.7f));
    corner.addQuad({-1, 0, 0.7f}, {0, 0, -1.7f}, {0, 1.5f, 0}, metal(0.7f));
    const SyntheticCamera camera = {.position = {0.5, 0.9, 2.5}, .target = {-0.2, 0.2, 0}, .fovY = 0.7};
    for (const int bounces : {1, 2, 4}) {
        const Compared compared =
            compare(look(corner, SurfaceScene::seenBy(corner), camera, raySettings(bounces), environment.map), corner,
                    camera, sky);
        EXPECT_LE(compared.brightest, 1.2) << bounces;
        EXPECT_NEAR(compared.energy, 1, 0.05) << bounces;
    }
}

/// White mirrors that face each other, so that many paths are long.
TEST_F(PathEndTest, AWhiteFurnaceStaysWhiteWithAnyNumberOfBounces) {
    const Radiance white = [](const glm::dvec3&) { return glm::vec3(1); };
    TestEnvironment environment = environmentOf(white);
    SurfaceScene valley;
    valley.addQuad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, metal(1));
    valley.addQuad({-0.5f, 0, 2}, {0, 0, -4}, {0, 2, 0}, metal(1));
    valley.addQuad({0.5f, 0, -2}, {0, 0, 4}, {0, 2, 0}, metal(1));
    const SyntheticCamera camera = {.position = {0.1, 1.4, 2.5}, .target = {0, 0.2, 0}, .fovY = 0.8};
    const SyntheticScene seen = SurfaceScene::seenBy(valley);
    for (const uint32_t frames : {1u, kFrames})
        for (const int bounces : {1, 2, 3, 5, 8}) {
            const Compared compared = compare(look(valley, seen, camera, raySettings(bounces), environment.map, frames),
                                              valley, camera, white);
            EXPECT_GE(compared.darkest, 0.97) << bounces << " bounces, frame " << frames;
            EXPECT_LE(compared.brightest, 1.01) << bounces << " bounces, frame " << frames;
        }
}

/// Paths of the mean over frames go on by chance once little is left of them; that changes no mean.
TEST_F(PathEndTest, TheReferenceFollowsPathsToTheirEnd) {
    const SurfaceScene room = roomOfMirrors();
    const SyntheticCamera camera = {.position = {-0.6, 0.2, 0.75}, .target = {0.9, -0.1, -0.3}, .fovY = 1.2};
    const SyntheticScene seen = SurfaceScene::seenBy(room);
    Settings settings = raySettings(64);
    settings.rays.accumulate = true;
    settings.rays.samples = 4;
    const Picture picture = look(room, seen, camera, settings, {}, 4);
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const glm::dvec3 direction = camera.rayThrough(x, y, kWidth, kHeight);
            const double truth =
                exact(seen, camera.position, direction, [](const glm::dvec3&) { return glm::vec3(0); });
            EXPECT_NEAR(picture.color(size_t{y} * kWidth + x).g, truth, 0.02 * truth + 0.002) << x << ", " << y;
        }
}

/// A floor that its normals do not follow: a map bends them, by up to 50 degrees.
SyntheticScene bumpyFloor() {
    return [](const glm::dvec3& origin, const glm::dvec3& direction) -> std::optional<SyntheticSurface> {
        const double distance = -origin.y / direction.y;
        const glm::dvec3 met = origin + direction * distance;
        if (!(distance > 0) || std::abs(met.x) > 2 || std::abs(met.z) > 2)
            return {};
        const glm::dvec2 lean = 1.2 * glm::dvec2(std::sin(7 * met.x + 3 * met.z), std::sin(5 * met.z - 2 * met.x));
        return SyntheticSurface{distance, glm::normalize(glm::dvec3(lean.x, 1, lean.y)), glm::vec3(1), 0, glm::vec3(0)};
    };
}

/// Below the floor it is dark: what shows that is no reflection.
TEST_F(PathEndTest, BentNormalsReflectNothingFromBelowTheirSurface) {
    TestEnvironment environment =
        environmentOf([](const glm::dvec3& direction) { return glm::vec3(direction.y > 0 ? 1.f : 0.f); });
    SurfaceScene floor;
    floor.addQuad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, metal(1));
    const SyntheticCamera camera = {.position = {0, 0.7, 4}, .target = {0, 0, 0}, .fovY = 0.7};
    const SyntheticScene seen = bumpyFloor();
    for (const bool rays : {false, true}) {
        Settings settings = raySettings(1);
        settings.rays.enabled = rays;
        const Picture picture = look(floor, seen, camera, settings, environment.map, 1);
        size_t dark = 0;
        size_t shown = 0;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                if (!seen(camera.position, camera.rayThrough(x, y, kWidth, kHeight)))
                    continue;
                ++shown;
                dark += picture.color(size_t{y} * kWidth + x).g < 0.45f; // half of a lookup at the horizon is dark
            }
        EXPECT_GT(shown, 200u);
        EXPECT_LE(dark, shown / 100) << (rays ? "rays" : "sky");
    }
}

/// Normals that follow their surface are kept to the last bit, up to its outline.
TEST_F(PathEndTest, NormalsOfSmoothSurfacesAreKept) {
    const SyntheticScene ball = [](const glm::dvec3& origin,
                                   const glm::dvec3& direction) -> std::optional<SyntheticSurface> {
        const double along = -glm::dot(origin, direction);
        const double root = along * along - glm::dot(origin, origin) + 1;
        if (root > 0)
            return SyntheticSurface{along - std::sqrt(root), origin + direction * (along - std::sqrt(root)),
                                    glm::vec3(1), 0, glm::vec3(0)};
        const double distance = -(origin.y + 1) / direction.y;
        if (!(distance > 0))
            return {};
        return SyntheticSurface{distance, {0, 1, 0}, glm::vec3(1), 0, glm::vec3(0)};
    };
    const SyntheticCamera camera = {.position = {0, 0.4, 3.2}, .target = {0, -0.2, 0}, .fovY = 0.9};
    Settings settings;
    settings.denoise.enabled = false;
    SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), ball, camera, kWidth, kHeight);
    Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings);
    must(reflections.setInputs(g.gbuffer, {}));
    trace(reflections, camera.view(kWidth, kHeight));
    const std::vector<float> normals = readView(reflections, "normal");
    const auto surfaces = seen(ball, camera, kWidth, kHeight);
    for (size_t i = 0; i < surfaces.size(); ++i)
        if (surfaces[i]) {
            const glm::dvec3 shown = glm::dvec3(normals[4 * i], normals[4 * i + 1], normals[4 * i + 2]);
            EXPECT_LT(glm::distance(shown, surfaces[i]->normalWS), 1e-3) << i % kWidth << ", " << i / kWidth;
        }
}

} // namespace path_end_test
} // namespace glint::test
