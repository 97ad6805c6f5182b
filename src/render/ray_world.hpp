// The scene as rays go through it: a host's RayScene and its surface table, filled from what the renderer draws.
#pragma once

#include "glint/ray_scene.hpp"
#include "glint/surface_table.hpp"
#include "gpu/pass.hpp"
#include "render/gpu_scene.hpp"
#include "shared/light.h"

#include <vector>

namespace glint::render {

class RayWorld {
public:
    /// Opaque and alpha-tested triangles, as the G-buffer has them. `library` is the device of `context` as the library
    /// adopted it; `gpuScene`, whose buffers and textures stay in use, shows `scene` posed as `pose`. Errors: as
    /// RayScene and SurfaceTable give them.
    static Result<RayWorld> create(gpu::Context& context, Context& library, GpuScene& gpuScene,
                                   const scene::Scene& scene, const scene::Pose& pose,
                                   std::span<const shared::Light> lights, RayBackend backend);

    /// Another moment of the scene that it was made for, which `gpuScene` shows by now: instances are placed anew, and
    /// hierarchies fitted to geometry that has changed its shape. False: the scene has other parts by now, and a world
    /// has to be made for them. Errors: OutOfMemory.
    Result<bool> setPose(GpuScene& gpuScene, const scene::Scene& scene, const scene::Pose& pose);

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
    /// A mesh of the ray scene.
    struct Part {
        const scene::Geometry* geometry; ///< while it is drawn
        bool deforms;                    ///< it is another Geometry in each pose
        size_t vertices;
        size_t indices;
    };
    struct Gathered;
    static Gathered gather(GpuScene& gpuScene, const scene::Scene& scene, const scene::Pose& pose);

    RayWorld(RayScene&& rays, SurfaceTable&& surfaces, gpu::Buffer&& items)
        : rays_(std::move(rays)), surfaces_(std::move(surfaces)), items_(std::move(items)) {}

    RayScene rays_;
    SurfaceTable surfaces_;
    gpu::Buffer items_;                 ///< uint32: by the ray scene's instances, the draw's
    std::vector<uint32_t> itemNumbers_; ///< what is in it
    std::vector<Part> parts_;
};

} // namespace glint::render
