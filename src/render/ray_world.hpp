// The scene as rays go through it: a host's RayScene and its surface table, filled from what the renderer draws.
#pragma once

#include "glint/ray_scene.hpp"
#include "glint/surface_table.hpp"
#include "gpu/pass.hpp"
#include "render/gpu_scene.hpp"
#include "shared/light.h"

namespace glint::render {

class RayWorld {
public:
    /// Opaque and alpha-tested triangles, as the G-buffer has them. `library` is the device of `context` as the library
    /// adopted it; `gpuScene`, whose buffers and textures stay in use, shows `scene` posed as `pose`. Errors: as
    /// RayScene and SurfaceTable give them.
    static Result<RayWorld> create(gpu::Context& context, Context& library, GpuScene& gpuScene,
                                   const scene::Scene& scene, const scene::Pose& pose,
                                   std::span<const shared::Light> lights, RayBackend backend);

    /// Before the first frame and after changes.
    void record(VkCommandBuffer commands) {
        rays_.record(commands);
        surfaces_.record(commands);
    }
    /// Once the GPU is done with the first record.
    void releaseStaging() { rays_.releaseStaging(); }
    Result<void> setLights(std::span<const shared::Light> lights);

    RayBackend backend() const { return rays_.backend(); }
    /// Gives a raster pass what shaders/render/shadow_geometry.glsl and the back end of the ray seam declare.
    void bindForShadows(gpu::Pass& pass);

    RayScene& rays() { return rays_; }
    SurfaceTable& surfaces() { return surfaces_; }

private:
    RayWorld(RayScene&& rays, SurfaceTable&& surfaces, gpu::Buffer&& items)
        : rays_(std::move(rays)), surfaces_(std::move(surfaces)), items_(std::move(items)) {}

    RayScene rays_;
    SurfaceTable surfaces_;
    gpu::Buffer items_; ///< uint32: by the ray scene's instances, the draw's
};

} // namespace glint::render
