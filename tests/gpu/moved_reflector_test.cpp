// A rough reflector that moves: the denoiser finds its history where it was, by the host's motion on screen and in
// depth.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <glm/glm.hpp>

namespace glint::test {
namespace moved_reflector_test {

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 32;
constexpr uint32_t kFrames = 10;
constexpr float kStep = 0.06f; ///< metres a frame

/// A rough metal panel that reflects a bright wall behind the camera, and comes nearer.
class MovedReflectorTest : public LibraryTest {
protected:
    static SurfaceScene scene(float way) {
        SurfaceScene made;
        made.addQuad({-4, -3, -2 + way}, {8, 0, 0}, {0, 6, 0}, whiteMetal(0.3f));
        made.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, emitting(glm::vec3(0.5f)));
        return made;
    }

    static Settings settings() {
        Settings settings = plainSettings();
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.denoise.enabled = true;
        settings.denoise.antilag = Antilag::Off;
        settings.reuse.rate = RayRate::Full;
        settings.reflect.maxRoughness = settings.reflect.roughnessFadeStart = 1;
        return settings;
    }

    /// Frames in the mean of the last frame, in the mean over the picture. `stated`: what the host states of the
    /// movement, times what is true.
    static double framesKept(const glm::vec3& stated) {
        const SyntheticCamera camera = {.position = {0, 0, 3}, .target = {0, 0, -1}};
        const SurfaceScene first = scene(0);
        SurfaceScene::World world = first.build(gpu(), library(), RayBackend::Bvh);
        Reflections made = reflections(kWidth, kHeight, settings());
        must(made.setRays(world.rays, world.surfaces));
        SyntheticGBuffer host; // the last frame's is read with its views
        gpu::Image motion;
        for (uint32_t frame = 0; frame < kFrames; ++frame) {
            const float way = kStep * static_cast<float>(frame);
            std::vector<RayInstance> instances = first.triangles.instances;
            instances.front().localToWorld[14] = way;
            std::vector<SurfaceInstance> surfaces;
            for (uint32_t i = 0; i < instances.size(); ++i)
                surfaces.push_back({instances[i].mesh, i, instances[i].localToWorld});
            must(world.rays.setInstances(instances));
            must(world.surfaces.setInstances(surfaces));
            run([&](VkCommandBuffer commands) {
                world.rays.record(commands);
                world.surfaces.record(commands);
            });
            const SurfaceScene placed = scene(way);
            const SyntheticScene now = SurfaceScene::seenBy(placed);
            host = SyntheticGBuffer::render(gpu(), now, camera, kWidth, kHeight);
            std::vector<glm::vec4> texels;
            for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
                const glm::dvec3 eye = camera.originThrough(i % kWidth, i / kWidth, kWidth, kHeight);
                const glm::dvec3 ray = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
                const glm::dvec3 place = eye + ray * now(eye, ray)->distance;
                const glm::dvec3 before = place - glm::dvec3(0, 0, frame == 0 ? 0 : kStep);
                const glm::dvec2 moved =
                    (camera.project(before, kWidth, kHeight) - camera.project(place, kWidth, kHeight)) /
                    glm::dvec2(kWidth, kHeight);
                texels.emplace_back(glm::vec3(moved, camera.viewZ(before) - camera.viewZ(place)) * stated, 0);
            }
            motion =
                uploadTestImage(gpu(), "test/motion", VK_FORMAT_R32G32B32A32_SFLOAT, kWidth, kHeight, bytesOf(texels));
            host.gbuffer.motion = asHostImage(motion);
            host.gbuffer.conventions.motionDepthScale = stated.z != 0 ? 1.0f : 0.0f;
            must(made.setInputs(host.gbuffer));
            View view = camera.view(kWidth, kHeight);
            view.frameIndex = frame;
            trace(made, view);
        }
        const std::vector<float> frames = readView(made, "historyFrames");
        double sum = 0;
        for (size_t i = 0; i < frames.size(); i += 4)
            sum += frames[i];
        return sum / (kWidth * kHeight);
    }
};

TEST_F(MovedReflectorTest, isFoundWhereItWas) {
    EXPECT_GT(framesKept({1, 1, 1}), 0.8 * kFrames);
    EXPECT_LT(framesKept({1, 1, -1}), 1.5) << "no surface was there";
}

TEST_F(MovedReflectorTest, isLostWithoutItsDepth) {
    // It moves by less than half a pixel on screen, and so counts as at rest: what was there lies behind its plane.
    EXPECT_LT(framesKept({1, 1, 0}), 1.5);
}

} // namespace moved_reflector_test
} // namespace glint::test
