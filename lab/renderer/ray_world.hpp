// The scene that rays are traced through: a host's RayScene and its surface table, filled from the draws of the
// renderer.
#pragma once

#include "glint/ray_scene.hpp"
#include "glint/surface_table.hpp"
#include "gpu/pass.hpp"
#include "lab/renderer/gpu_scene.hpp"
#include "shared/light.h"

#include <vector>

namespace glint::render {

class RayWorld {
public:
    /// Contains opaque and alpha-tested triangles, as the G-buffer does. `library` is the device of `context` as
    /// adopted by the library. `gpuScene` shows `scene` posed as `pose`; its buffers and textures stay in use. Errors:
    /// those of RayScene and SurfaceTable.
    static Result<RayWorld> create(gpu::Context& context, Context& library, GpuScene& gpuScene,
                                   const scene::Scene& scene, const scene::Pose& pose,
                                   std::span<const shared::Light> lights, RayBackend backend);

    /// Sets another pose of the same scene, which `gpuScene` must already show: moves instances and refits the
    /// hierarchies of deformed geometry. Returns false if the parts of the scene have changed; then a new RayWorld must
    /// be created. Errors: OutOfMemory.
    Result<bool> setPose(GpuScene& gpuScene, const scene::Scene& scene, const scene::Pose& pose);

    /// Call after GpuScene::setMaterials has returned true. Errors: OutOfMemory.
    Result<void> setMaterials(GpuScene& gpuScene, const scene::Scene& scene, const scene::Pose& pose);

    /// Call before the first frame and after changes.
    void record(VkCommandBuffer commands) {
        rays_.record(commands);
        surfaces_.record(commands);
    }
    /// Call once the GPU has finished the first record.
    void releaseStaging() { rays_.releaseStaging(); }
    Result<void> setLights(std::span<const shared::Light> lights);

    RayBackend backend() const { return rays_.backend(); }
    /// Binds what lab/shaders/render/shadow_geometry.glsl and the ray back end declare to a raster pass.
    void bindForShadows(gpu::Pass& pass);

    RayScene& rays() { return rays_; }
    SurfaceTable& surfaces() { return surfaces_; }

private:
    /// A mesh of the ray scene.
    struct Part {
        const scene::Geometry* geometry; ///< valid while it is drawn
        bool deforms;                    ///< its Geometry differs from pose to pose
        size_t vertices;
        size_t indices;
    };
    struct Gathered;
    static Gathered gather(GpuScene& gpuScene, const scene::Scene& scene, const scene::Pose& pose);

    RayWorld(RayScene&& rays, SurfaceTable&& surfaces, gpu::Buffer&& items)
        : rays_(std::move(rays)), surfaces_(std::move(surfaces)), items_(std::move(items)) {}

    RayScene rays_;
    SurfaceTable surfaces_;
    gpu::Buffer items_;                 ///< uint32: the draw of each instance of the ray scene
    std::vector<uint32_t> itemNumbers_; ///< the content of items_
    std::vector<Part> parts_;
};

} // namespace glint::render
