// denoise.hitMotion: things that move in reflections leave no trail in the mean over frames, whether rays or the screen
// find them, and keep their history.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"
#include "gpu/support/surface_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::test {
namespace hit_motion_test {

constexpr uint32_t kWidth = 72;
constexpr uint32_t kHeight = 48;
constexpr uint32_t kFrames = 20;
constexpr float kStep = 0.06f; ///< metres a frame

/// How the card's movement is described to the library.
enum class Told : uint8_t { Transform, Vertices, MotionImage, MotionWithDepth };

/// A bright card before a dark wall slides over a rough metal floor: sideways or, where motion tells of depth, towards
/// the camera.
class HitMotionTest : public LibraryTest, public testing::WithParamInterface<Told> {
protected:
    static constexpr glm::vec3 kCard = {-0.4f, 0.3f, -1.5f};
    static constexpr uint32_t kCardInstance = 2;

    static glm::vec3 along(float way) {
        return GetParam() == Told::MotionWithDepth ? glm::vec3(0, 0, way) : glm::vec3(way, 0, 0);
    }

    static SurfaceScene scene(float way) {
        SurfaceScene made;
        made.addQuad({-6, 0, 4}, {12, 0, 0}, {0, 0, -8}, whiteMetal(0.3f));
        made.addQuad({-6, 0, -3}, {12, 0, 0}, {0, 4, 0}, emitting(glm::vec3(0.2f)));
        made.addQuad(kCard + along(way), {0.8f, 0, 0}, {0, 0.7f, 0}, emitting(glm::vec3(2)));
        return made;
    }

    static Settings settings(Told told, bool hitMotion) {
        Settings settings = plainSettings();
        const bool screen = told == Told::MotionImage || told == Told::MotionWithDepth;
        settings.screen.enabled = screen;
        settings.rays.enabled = !screen;
        settings.denoise.enabled = true;
        settings.denoise.antilag = Antilag::Off;
        settings.denoise.hitMotion = hitMotion;
        settings.denoise.maxRadius = 0;
        settings.reuse.rate = RayRate::Full;
        settings.reflect.maxRoughness = settings.reflect.roughnessFadeStart = 1;
        return settings;
    }

    /// The scene as the host shows it. The card moves by `step` a frame.
    struct Shown {
        SyntheticGBuffer host;
        gpu::Image motion;
    };
    static Shown show(const SyntheticCamera& camera, const SurfaceScene& now, float step) {
        Shown shown = {SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(now), camera, kWidth, kHeight), {}};
        std::vector<glm::vec4> texels; // in UV and metres
        for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
            const glm::dvec3 eye = camera.originThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const glm::dvec3 way = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const auto hit = SurfaceScene::seenBy(now)(eye, way);
            glm::dvec2 moved(0);
            double nearer = 0;
            if (hit && hit->radiance.r > 1) {
                const glm::dvec3 place = eye + way * hit->distance;
                const glm::dvec3 before = place - glm::dvec3(along(step));
                moved = camera.project(before, kWidth, kHeight) - camera.project(place, kWidth, kHeight);
                nearer = dot(before - place, glm::normalize(camera.target - camera.position));
            }
            texels.emplace_back(moved / glm::dvec2(kWidth, kHeight), nearer, 0);
        }
        shown.motion =
            uploadTestImage(gpu(), "test/motion", VK_FORMAT_R32G32B32A32_SFLOAT, kWidth, kHeight, bytesOf(texels));
        shown.host.gbuffer.motion = asHostImage(shown.motion);
        return shown;
    }

    /// The last of `frames` frames; the card ends at `x`. `depthScale`: Conventions::motionDepthScale.
    Picture play(const Settings& chosen, uint32_t frames, float x, float step, float depthScale = 1) {
        const Told told = GetParam();
        const SyntheticCamera camera = {.position = {0, 0.9, 3}, .target = {0, 0.35, -0.5}};
        SurfaceScene first = scene(0);
        first.triangles.meshes[kCardInstance].deforms = told == Told::Vertices;
        SurfaceScene::World world = first.build(gpu(), library(), RayBackend::Bvh);
        Reflections made = reflections(kWidth, kHeight, chosen);
        if (chosen.rays.enabled)
            must(made.setRays(world.rays, world.surfaces));
        Picture last;
        for (uint32_t i = 0; i < frames; ++i) {
            const float at = x - step * static_cast<float>(frames - 1 - i);
            const SurfaceScene now = scene(at);
            if (told == Told::Vertices)
                deform(world, now, scene(i == 0 ? at : at - step));
            else
                place(world, first, at);
            run([&](VkCommandBuffer commands) {
                world.rays.record(commands);
                world.surfaces.record(commands);
            });
            Shown shown = show(camera, now, i == 0 ? 0 : step);
            if (told == Told::MotionWithDepth)
                shown.host.gbuffer.conventions.motionDepthScale = depthScale;
            must(made.setInputs(shown.host.gbuffer));
            View view = camera.view(kWidth, kHeight);
            view.frameIndex = i;
            last = trace(made, view);
        }
        return last;
    }

    static void place(SurfaceScene::World& world, const SurfaceScene& first, float x) {
        std::vector<RayInstance> instances = first.triangles.instances;
        const glm::vec3 offset = along(x);
        std::copy_n(&offset.x, 3, &instances[kCardInstance].localToWorld[12]);
        std::vector<SurfaceInstance> surfaces;
        for (uint32_t i = 0; i < instances.size(); ++i)
            surfaces.push_back({instances[i].mesh, i, instances[i].localToWorld});
        must(world.rays.setInstances(instances));
        must(world.surfaces.setInstances(surfaces));
    }

    void deform(SurfaceScene::World& world, const SurfaceScene& now, const SurfaceScene& before) {
        const std::vector<glm::vec3>& positions = now.triangles.meshes[kCardInstance].positions;
        must(world.rays.deform(kCardInstance, &positions.data()->x, static_cast<uint32_t>(positions.size())));
        const auto upload = [&](const auto& list) {
            world.buffers.push_back(must(
                gpu::uploadBuffer(gpu(), "test/stream", list,
                                  VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT)));
            return world.buffers.back().address();
        };
        std::vector<SurfaceMesh> meshes;
        for (size_t i = 0; i < now.triangles.meshes.size(); ++i) {
            SurfaceMesh mesh;
            mesh.positions = {upload(now.triangles.meshes[i].positions), sizeof(glm::vec3)};
            mesh.indices = upload(now.triangles.meshes[i].indices);
            if (i == kCardInstance)
                mesh.previousPositions = {upload(before.triangles.meshes[i].positions), sizeof(glm::vec3)};
            meshes.push_back(mesh);
        }
        must(world.surfaces.setMeshes(meshes));
    }

    /// The share of the light that the reflection has left behind: 1 where the picture still shows `then`, 0 where it
    /// shows `now`. Counts pixels that changed between `then` and `since`, and not after.
    static double ghost(const Picture& moving, const Picture& now, const Picture& since, const Picture& then) {
        double along = 0;
        double square = 0;
        for (size_t i = 0; i < now.reflection.size(); i += 4) {
            const double change = then.reflection[i] - now.reflection[i];
            if (change < 0.2 || std::abs(since.reflection[i] - now.reflection[i]) > 0.05)
                continue;
            along += (moving.reflection[i] - now.reflection[i]) * change;
            square += change * change;
        }
        EXPECT_GT(square, 1);
        return along / square;
    }

    static double error(const Picture& a, const Picture& b) {
        double sum = 0;
        for (size_t i = 0; i < a.reflection.size(); i += 4)
            sum += std::pow(a.reflection[i] - b.reflection[i], 2);
        return std::sqrt(sum / static_cast<double>(a.pixels()));
    }
};

TEST_P(HitMotionTest, whatMovesLeavesNoGhost) {
    const Told told = GetParam();
    constexpr float kEnd = 0.5f;
    Settings truth = settings(told, true);
    truth.denoise.historySeconds = 4;
    const auto ago = [&](float frames) { return play(truth, 64, kEnd - kStep * frames, 0); };
    const Picture now = ago(0);
    const Picture since = ago(4);
    const Picture then = ago(10);
    const auto moving = [&](const Settings& chosen, float depthScale = 1) {
        return play(chosen, kFrames, kEnd, kStep, depthScale);
    };
    const Picture followed = moving(settings(told, true));
    const Picture ignored = moving(settings(told, false));
    Settings forgets = settings(told, true);
    forgets.denoise.historySeconds = 0;
    const Picture fresh = moving(forgets);
    EXPECT_LT(error(followed, now), 0.75 * error(fresh, now)) << "it has a history";
    if (told == Told::MotionWithDepth) {
        // The picture of what approaches changes less, and differently in every frame's noise.
        const Picture flat = moving(settings(told, true), 0);
        EXPECT_GT(ghost(flat, now, since, then), 0.5) << "motion on screen alone says little";
        EXPECT_LT(ghost(followed, now, since, then), 0.2 * ghost(flat, now, since, then));
        EXPECT_LT(ghost(followed, now, since, then), ghost(fresh, now, since, then)) << "which remembers nothing";
        EXPECT_LT(error(followed, now), error(flat, now));
        return;
    }
    EXPECT_LT(ghost(followed, now, since, then), 0.02);
    EXPECT_GT(ghost(ignored, now, since, then), 0.3);
    EXPECT_LT(error(followed, now), 0.5 * error(ignored, now));
}

TEST_P(HitMotionTest, whatRestsKeepsItsBits) {
    const Told told = GetParam();
    EXPECT_EQ(play(settings(told, true), 6, 0.2f, 0).composite, play(settings(told, false), 6, 0.2f, 0).composite);
}

std::string nameOf(const testing::TestParamInfo<Told>& told) {
    constexpr std::array kNames = {"Transform", "Vertices", "MotionImage", "MotionWithDepth"};
    return kNames.at(static_cast<size_t>(told.param));
}

INSTANTIATE_TEST_SUITE_P(By, HitMotionTest,
                         testing::Values(Told::Transform, Told::Vertices, Told::MotionImage, Told::MotionWithDepth),
                         nameOf);

} // namespace hit_motion_test
} // namespace glint::test
