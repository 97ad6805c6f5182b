// Frames of triangles with materials at rest, for tests of what rays find and of what the denoiser makes of it.
#pragma once

#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

namespace glint::test {

class TracedSurfacesTest : public LibraryTest {
protected:
    /// The last of `frames` square pictures: rays go through `scene`, the camera sees `shown`.
    static Picture lastFrame(const SurfaceScene& scene, const SyntheticScene& shown, const SyntheticCamera& camera,
                             uint32_t size, const Settings& settings, uint32_t frames) {
        SurfaceScene::World world = scene.build(gpu(), library(), RayBackend::Bvh);
        run([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
        });
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), shown, camera, size, size);
        Reflections made = reflections(size, size, settings);
        must(made.setInputs(host.gbuffer));
        must(made.setRays(world.rays, world.surfaces));
        View view = camera.view(size, size);
        for (; view.frameIndex + 1 < frames; ++view.frameIndex)
            run([&](VkCommandBuffer commands) { made.record(commands, view); });
        return trace(made, view);
    }
};

} // namespace glint::test
