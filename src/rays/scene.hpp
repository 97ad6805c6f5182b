// Implementation of glint::RayScene: checks the host's lists, owns one of the two back ends, and measures the build. A
// host's own acceleration structure has neither lists nor build.
#pragma once

#include "glint/ray_scene.hpp"
#include "gpu/progress.hpp"
#include "gpu/timers.hpp"
#include "rays/adopted_scene.hpp"
#include "rays/bounds.hpp"
#include "rays/bvh_scene.hpp"
#include "rays/query_scene.hpp"

#include <optional>
#include <variant>

namespace glint::rays {

class Scene : gpu::KeepsContext {
public:
    static Result<std::unique_ptr<Scene>> create(gpu::Context& context, const RaySceneDesc& desc);

    /// Errors: Unsupported, InvalidArgument.
    static Result<std::unique_ptr<Scene>> adopt(gpu::Context& context, const HostAccelerationStructure& host);

    RayBackend backend() const { return backend_; }
    /// Constants of every pipeline that traces this scene, for shaders/rays/query.glsl.
    std::vector<gpu::SpecConstant> constants() const;
    uint32_t instanceCount() const {
        return adopted_ ? adopted_->instanceCount() : static_cast<uint32_t>(instances_.size());
    }
    /// How many triangles of an instance rays of this mask can hit; 0 also where the host does not tell.
    uint32_t trianglesSeen(uint32_t instance, uint32_t mask) const;
    /// World-space bounds of an instance that transmits light; empty if no ray can intersect it. A host's own structure
    /// has the same bounds for all of them.
    Bounds instanceBounds(uint32_t instance) const;
    Result<void> setAccelerationStructure(const HostAccelerationStructure& host);
    Result<void> setInstances(std::span<const RayInstance> instances);
    Result<void> updateInstances(uint32_t first, std::span<const RayInstance> instances);
    Result<void> deform(uint32_t mesh, const float* positions, uint32_t vertexCount, uint32_t vertexStride);
    void record(VkCommandBuffer commands);
    void releaseStaging();
    RaySceneTimes times();

    /// Binds the scene to the pass, as shaders/rays/query.glsl or bvh.glsl of the same back end declares it:
    ///   scene.bind(frame.pass(pipeline)).read("...", ...).dispatch(...)
    gpu::Pass& bind(gpu::Pass& pass);
    gpu::Pass& bind(gpu::Pass&& pass) { return bind(pass); } ///< valid as long as the expression

private:
    explicit Scene(gpu::Context& context) : KeepsContext(context), context_(context) {}
    Result<void> checkOwn(const char* call) const;
    /// `first`: the number of the first one in the list, for messages.
    Result<void> checkMeshes(std::span<const RayInstance> instances, size_t first) const;
    Result<void> check(std::span<const RayInstance> instances) const;

    /// What RayBackend::Auto takes for this scene's meshes.
    RayBackend fasterBackend() const;

    gpu::Context& context_;
    RayBackend backend_ = RayBackend::Bvh;
    std::optional<AdoptedScene> adopted_; ///< if present, all below is empty
    std::variant<std::unique_ptr<BvhScene>, std::unique_ptr<QueryScene>> scene_;
    std::unique_ptr<gpu::Timers> timers_;
    gpu::Progress progress_;
    RaySceneTimes times_;
    std::vector<uint32_t> deformable_; ///< by mesh: its vertex count if it deforms, else 0
    uint32_t maxInstances_ = 0;
    std::vector<uint32_t> meshTriangles_; ///< by mesh: how many it has
    std::vector<Bounds> meshBounds_;      ///< by mesh, in its own space
    std::vector<RayInstance> instances_;
    bool recorded_ = false; ///< buffers hold a scene; traversing garbage could hang the GPU
};

} // namespace glint::rays
