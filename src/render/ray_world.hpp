// The scene as rays go through it: a host's RayScene and its surface table, filled from what the renderer draws.
#pragma once

#include "glint/ray_scene.hpp"
#include "glint/surface_table.hpp"
#include "render/gpu_scene.hpp"
#include "shared/light.h"

namespace glint::render {

class RayWorld {
public:
    /// Opaque and alpha-tested triangles, as the G-buffer has them. `library` is the device as the library adopted it;
    /// `gpuScene`, whose buffers and textures stay in use, shows `scene` posed as `pose`.
    /// Errors: as RayScene and SurfaceTable give them.
    static Result<RayWorld> create(Context& library, GpuScene& gpuScene, const scene::Scene& scene,
                                   const scene::Pose& pose, std::span<const shared::Light> lights, RayBackend backend);

    /// Before the first frame and after changes.
    void record(VkCommandBuffer commands) {
        rays_.record(commands);
        surfaces_.record(commands);
    }
    /// Once the GPU is done with the first record.
    void releaseStaging() { rays_.releaseStaging(); }
    Result<void> setLights(std::span<const shared::Light> lights);

    RayScene& rays() { return rays_; }
    SurfaceTable& surfaces() { return surfaces_; }

private:
    RayWorld(RayScene&& rays, SurfaceTable&& surfaces) : rays_(std::move(rays)), surfaces_(std::move(surfaces)) {}

    RayScene rays_;
    SurfaceTable surfaces_;
};

} // namespace glint::render
